#pragma once
/// \file
/// Checks the certificate that a list of triangulations of the hexahedron is complete.
///
/// Definition, formula, format of the file, and the proof that an accepted certificate means what
/// it says: docs/formats/completeness.md. Tetrahedra are 16-bit words, bit v set if vertex v of the
/// cube is a member.
///
/// What has to be trusted: that each clause of the rules holds in every triangulation (the
/// proofs are in the document), and this checker. No solver takes part.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tables/check/lrat.hpp"

namespace hexatlas::check {

/// Tetrahedra with a common vertex that are not all in one triangulation, because their triangles
/// opposite to the vertex form a connected surface that is no part of a disc.
struct Obstruction {
  unsigned vertex = 0;
  std::vector<std::uint16_t> tetrahedra;
};

struct CompletenessInput {
  /// One member of each class, tetrahedra in any order.
  std::vector<std::vector<std::uint16_t>> classes;
  /// Up to symmetry; one may be given more than once.
  std::vector<Obstruction> obstructions;
};

/// Variables of the formula: 1 .. 6 the diagonals, 7 .. 70 the candidate tetrahedra, ascending, 71
/// .. 198 their orientations.
inline constexpr std::size_t kCompletenessVariables = 198;

/// The formula, clause by clause in the order of the document. Throws std::bad_optional_access if
/// a set is no candidate; that the classes are triangulations and the obstructions obstruct is not
/// tested here.
[[nodiscard]] std::vector<Literals> completeness_clauses(const CompletenessInput& input);

/// The formula in the DIMACS format, for any solver and any other checker of proofs.
[[nodiscard]] std::string dimacs_of(const std::vector<Literals>& clauses);

/// Obstructions in a set of tetrahedra that obeys the rules: for each vertex, each connected part
/// of its link that is no part of a disc. Empty if there is none, as in a triangulation.
[[nodiscard]] std::vector<Obstruction> obstructions_in(
    const std::vector<std::uint16_t>& tetrahedra);

struct CompletenessVerdict {
  bool complete = false;
  std::string fault;         ///< why it is not, empty otherwise
  std::size_t classes = 0;   ///< given, and if complete, all there are
  std::size_t labelled = 0;  ///< their members
};

/// Whether the classes are all triangulations of the hexahedron without interior vertex and without
/// boundary tetrahedra, each class once, as proven by the text in the LRAT format from the
/// formula. `file` and `first_line` name the lines of the proof. Throws Malformed if the text is
/// none of that format. Cost: about a second for a text of 20 MB.
[[nodiscard]] CompletenessVerdict check_completeness(const CompletenessInput& input,
                                                     std::string_view proof,
                                                     const std::string& file,
                                                     std::size_t first_line = 1);

/// The same for the bytes of a catalogue and a certificate (docs/formats/completeness.md), with the
/// names by which messages call them. The catalogue must be one of the hexahedron, all its classes
/// are taken; that it obeys the other laws of its format is judged by check_catalogue. Throws
/// Malformed.
[[nodiscard]] CompletenessVerdict check_completeness_bytes(std::string catalogue,
                                                           const std::string& catalogue_name,
                                                           std::string certificate,
                                                           const std::string& certificate_name);

/// The text of a certificate. `definition` is the digest that the catalogue states.
[[nodiscard]] std::string certificate_text(const std::string& definition,
                                           const std::vector<Obstruction>& obstructions,
                                           std::string_view proof);

}  // namespace hexatlas::check
