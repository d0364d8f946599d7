#pragma once
/// \file
/// Internal to the judge: a catalogue of triangulations as it is written, before any law is tested.
/// Refutations stay text until they are judged.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexatlas::check {

inline constexpr int kMostCatalogueVertices = 16;

/// Bit v is set if v is a member, v < 16.
using VertexBits = std::uint16_t;
/// Words with four bits each.
using Tetrahedra = std::vector<VertexBits>;
/// Three or four vertices, counter-clockwise from outside.
using CellFacet = std::vector<std::uint8_t>;
using LatticePoint = std::array<std::int64_t, 3>;

enum class Condition : std::uint8_t { kEmbedded, kConvex, kJacobian };

struct RefutationText {
  std::string_view lines;  ///< between the line of the property and `qed`
  std::size_t first = 0;   ///< number of the first of them
};

struct Property {
  enum class Answer : std::uint8_t { kOpen, kPoints, kRefuted };
  Condition condition = Condition::kEmbedded;
  Answer answer = Answer::kOpen;
  std::vector<LatticePoint> points;
  RefutationText refutation;
};

struct CatalogueClass {
  std::uint64_t number = 0;
  std::uint64_t automorphisms = 0;
  bool shelled = true;
  Tetrahedra tetrahedra;  ///< in the order of the line
  std::vector<Property> properties;
};

struct CatalogueText {
  std::string definition;
  bool is_cell = false;
  std::string name;
  int vertices = 0;
  int interior = 0;
  bool boundary_tetrahedra = false;
  std::vector<CellFacet> facets;  ///< vertices below vertices - interior
  std::uint64_t symmetries = 0;
  std::uint64_t classes = 0;
  std::uint64_t labelled = 0;
  bool exhaustive = false;
  std::vector<CatalogueClass> list;
  bool digest_holds = false;
};

/// Reads the text; everything in it is as the format says, but nothing is checked that
/// CatalogueLaw names. `text` and `file` must outlive the result. Errors: Malformed.
[[nodiscard]] CatalogueText read_catalogue(std::string_view text, const std::string& file);

}  // namespace hexatlas::check
