#pragma once
/// \file
/// Catalogues of triangulations: the data, the reader and the writer of docs/formats/catalogue.md.
///
/// The reader takes a file at its word as far as the words are well-formed; the laws are tested by
/// tables/check. Cost: linear in the bytes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "enum/complex/cell.hpp"
#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"

namespace hexatlas::format {

struct CatalogueClass {
  /// In the order of the class line: a shelling, unless `shelled` is false.
  complex::Triangulation triangulation;
  std::uint64_t automorphisms = 1;
  bool shelled = true;
  /// By condition; nullopt: not asked.
  std::array<std::optional<certificate::Answer>, certificate::kConditions.size()> answers;
};

struct Catalogue {
  std::string name;  ///< [a-z0-9-]+
  int vertices = 0;  ///< interior ones included
  int interior = 0;
  std::optional<complex::Cell> cell;  ///< none: a list of balls
  bool boundary_tetrahedra = false;
  std::uint64_t symmetries = 1;  ///< order of the group of the cell
  std::uint64_t labelled = 0;    ///< sum of symmetries / automorphisms
  bool exhaustive = false;
  std::vector<CatalogueClass> classes;
};

/// SHA-256 of docs/theory/triangulation-definition.txt, in lower-case hexadecimal.
[[nodiscard]] std::string_view definition_digest();

/// The bytes of the file; frame.hpp compresses them.
[[nodiscard]] std::string catalogue_bytes(const Catalogue& catalogue);

/// Throws InvalidInput with file and line. `bytes` may be compressed.
[[nodiscard]] Catalogue catalogue_from(std::string_view bytes, const std::string& file);

}  // namespace hexatlas::format
