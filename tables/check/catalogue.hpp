#pragma once
/// \file
/// The judge of catalogues of triangulations (docs/formats/catalogue.md). It checks every law of
/// that format and of docs/theory/triangulation-definition.txt, whose digest it knows by itself:
/// the cell and its group, that each class is a triangulation (a ball by its shelling), that no two
/// classes are equivalent, the orders of the automorphism groups, the sums, all coordinates in
/// integers, and all refutations down to their premises.
///
/// Preconditions: none; any bytes may be judged. Errors: Malformed, with file and line, if the
/// bytes are no text of that format; whatever is one is judged, and the judgement is a value. Cost:
/// classes * |group| * k! * t log t for the order of the classes, or 24 t^2 log t per ball; t^2
/// C(8,5) per list of points; linear in the length of a refutation, up to the lengths of the
/// clauses named as hints. Memory: a small multiple of the file, which must unpack to at most
/// kMostText.
///
/// Not promised: that the list is complete, which is a claim of the file (`claims_exhaustive`);
/// that every true file is accepted: `undecided` is set if all laws that could be tested hold and
/// one could not be tested (see the member).

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hexatlas::check {

/// Bytes of a catalogue that the judge is willing to read, after unpacking.
inline constexpr std::uint64_t kMostText = std::uint64_t{1} << 30;

/// The laws of a catalogue, in the order in which they are tested: those of the file, of the cell,
/// of each class with its properties, of the sums.
enum class CatalogueLaw : std::uint8_t {
  kNone,                ///< no law is broken
  kDigest,              ///< the last line has the digest of the lines before it
  kDefinition,          ///< the definition is the one that this judge checks
  kCell,                ///< the facets are a sphere without double edge on the boundary vertices
  kName,                ///< the name of a known cell is that of this cell
  kSymmetries,          ///< the order of the group of the cell
  kNumbering,           ///< classes are numbered 1, 2, ... and as many as stated
  kTriangles,           ///< no tetrahedron twice, no triangle in three
  kVertices,            ///< every vertex lies in a tetrahedron
  kBall,                ///< the order of the tetrahedra is a shelling (or one was found)
  kBoundary,            ///< the boundary is the cell with one diagonal in each quad
  kBoundaryTetrahedra,  ///< no tetrahedron on one facet, unless allowed
  kAutomorphisms,       ///< the number of automorphisms
  kOrder,               ///< the classes are in ascending order
  kEquivalent,          ///< no two classes are equivalent (cell) or isomorphic (balls)
  kOrientation,         ///< the points orient all tetrahedra as the facets say
  kEmbedded,            ///< any two tetrahedra meet in their common face
  kConvex,              ///< no point is in the convex hull of the others
  kJacobian,            ///< the trilinear map has a positive Jacobian determinant
  kPremise,             ///< each `c` clause is one of the premises
  kPolynomial,          ///< each `f` clause has a final polynomial
  kLemma,               ///< each `l` clause follows by its hints
  kContradiction,       ///< the last lemma, and only it, has no literals
  kLabelled,            ///< the sum of the class sizes
};

/// Numbers of classes.
struct ConditionCounts {
  std::uint64_t realizable = 0;
  std::uint64_t refuted = 0;
  std::uint64_t open = 0;
};

struct CatalogueVerdict {
  bool accepted = false;
  /// No law is broken, but one could not be tested: an `unshelled` ball for which the judge found
  /// no shelling either; more than six interior vertices; a Jacobian determinant neither shown
  /// positive nor shown not to be (the depth of subdivision is bounded); more permutations to be
  /// tried than a judgement may take.
  bool undecided = false;
  CatalogueLaw broken = CatalogueLaw::kNone;  ///< the first broken law, or the first untested one
  std::string reason;                         ///< "class 17: ..." if it concerns a class

  std::string name;
  bool is_cell = false;  ///< else a list of balls
  int vertices = 0;      ///< interior ones included
  int interior = 0;
  bool claims_exhaustive = false;
  std::uint64_t symmetries = 0;  ///< order of the group of the cell; 0 for balls
  // The numbers below are complete if the catalogue is accepted.
  std::uint64_t classes = 0;
  std::uint64_t labelled = 0;                               ///< 0 for balls
  std::array<ConditionCounts, 3> conditions{};              ///< embedded, convex, jacobian
  std::uint64_t premises = 0, polynomials = 0, lemmas = 0;  ///< of all refutations
};

/// SHA-256 of docs/theory/triangulation-definition.txt, in lower-case hexadecimal.
[[nodiscard]] std::string_view judged_definition_digest() noexcept;

/// Whether a file that begins with these bytes (20 are enough) can only be a catalogue: it has the
/// first words of one, or is a Zstandard frame.
[[nodiscard]] bool is_catalogue(std::string_view first_bytes) noexcept;

/// `path` may be "-" for standard input.
[[nodiscard]] CatalogueVerdict check_catalogue(const std::string& path);
/// The same for bytes in memory; `file` is how messages name them.
[[nodiscard]] CatalogueVerdict check_catalogue_bytes(std::string_view bytes,
                                                     const std::string& file);

}  // namespace hexatlas::check
