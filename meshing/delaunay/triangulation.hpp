#pragma once
/// \file
/// The Delaunay triangulation of points in space.
///
/// Definition. The tetrahedra whose vertices are among the points, whose union is the convex hull
/// of the points, and inside whose circumscribed sphere lies no point. Where more than four points
/// lie on an empty sphere there are several such triangulations; the one made here is that of the
/// points lifted to the paraboloid and raised there by infinitely small amounts, the greater the
/// later a point comes in the lexicographic order of its coordinates
/// (docs/theory/delaunay-ties.md). So it depends on the set of points only: not on their order, the
/// seed, or the number of threads. Method: C. Marot, J. Pellerin, J.-F. Remacle, "One machine, one
/// minute, three billion tetrahedra", IJNME 117 (2019); see inserter.hpp and builder.hpp.
///
/// Points at the same place are one vertex, called by the least of their numbers. Signs are exact
/// for all finite doubles.
///
/// With weights w_p, of the dimension of squared lengths and of any sign, it is the regular
/// triangulation: that of the points lifted to |p|^2 - w_p, ties decided in the same way. Power
/// distances |x - p|^2 - w_p take the place of squared distances, orthospheres that of spheres
/// (realize/exact/in_orthosphere.hpp). A point is hidden if it is no vertex, since its power cell
/// is empty or ties are decided so, and no vertex has its place and weight; so is one at the place
/// of a point of greater weight. Duplicates have the place and the weight of a vertex, which is
/// called by the least of their numbers. Equal weights give the Delaunay triangulation. Source: H.
/// Edelsbrunner, N. R. Shah, "Incremental topological flipping works for regular triangulations"
/// (1996); the insertion is the same as without weights.
///
/// Requires: finite coordinates and weights, fewer than 2^32 - 2 points.
/// Errors: ResourceFailure if there is not enough memory.
/// Cost: for points in general position and evenly spread, some microseconds per point, 36 bytes
/// per tetrahedron at most; the number of tetrahedra can be quadratic in that of the points (two
/// skew lines). With weights about twice as long. Not promised: quality of the tetrahedra; any
/// bound for inputs that are made to have huge cavities.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::delaunay {

template <class Index, bool kIsWeighted>
class Builder;

enum class References : std::uint8_t {
  automatic,  ///< the shorter, if the tetrahedra of points in general position can be numbered
  short_,     ///< 32 bits: 2^30 tetrahedra, with those of the hull
  long_       ///< 64 bits, twice the memory
};

struct Options {
  int threads = 1;
  std::uint64_t seed = 0;  ///< of the order of insertion; without effect on the result
  References references = References::automatic;
};

/// Where a point should be inserted because of a tetrahedron with these corners, if anywhere.
using Wish = std::function<std::optional<mesh::Point>(const std::array<mesh::Point, 4>& corners)>;

class Triangulation {
 public:
  using Index = mesh::Index;
  using Tetrahedron = std::array<Index, 4>;  ///< right-handed: det(b - a, c - a, d - a) > 0

  explicit Triangulation(std::span<const mesh::Point> points, const Options& options = {});
  /// Requires a weight for each point.
  Triangulation(std::span<const mesh::Point> points, std::span<const double> weights,
                const Options& options = {});
  Triangulation(const Triangulation&) = delete;
  Triangulation& operator=(const Triangulation&) = delete;
  Triangulation(Triangulation&&) noexcept;
  Triangulation& operator=(Triangulation&&) noexcept;
  ~Triangulation();

  /// Of the affine hull of the points: -1 for none, 0 for one place, 1 for a line, 2 for a plane.
  /// Tetrahedra exist only if it is 3.
  [[nodiscard]] int dimension() const noexcept;
  [[nodiscard]] bool is_weighted() const noexcept;
  [[nodiscard]] std::size_t points() const noexcept;
  /// The points that are at the place of one with a smaller number, and have its weight; of those
  /// that are hidden, none. With weights counted, in linear time.
  [[nodiscard]] std::size_t duplicates() const;
  /// The numbers of hidden points, ascending. Linear. Requires dimension 3.
  [[nodiscard]] std::vector<Index> hidden() const;
  [[nodiscard]] std::size_t size() const;  ///< tetrahedra; counted, in linear time
  /// Of this structure: cells, sites, numbers. The points given are not among them.
  [[nodiscard]] std::size_t bytes() const noexcept;

  /// All of them in lexicographic order, each beginning with its smallest vertex, then the smallest
  /// of the others. Linear.
  [[nodiscard]] std::vector<Tetrahedron> tetrahedra() const;

  // What follows walks through the triangulation: at a cost in the number of tetrahedra between
  // this place and the last one asked for. Requires dimension 3. For one thread at a time.

  /// A tetrahedron that contains the place; nullopt if it is outside of the convex hull.
  [[nodiscard]] std::optional<Tetrahedron> located(const mesh::Point& place);
  /// The tetrahedra at a point's place, each beginning with the vertex there; in no promised order.
  /// None if no vertex is there.
  /// Requires the number of a point.
  [[nodiscard]] std::vector<Tetrahedron> star(Index point);
  /// A further point, which gets the next number. The answer is the vertex at its place: this
  /// number, or a smaller one. Requires finite coordinates, and that there are no weights.
  Index insert(const mesh::Point& place);
  /// The same with a weight; nullopt if the point is hidden. It may hide others, for good. Requires
  /// weights, finite numbers.
  std::optional<Index> insert(const mesh::Point& place, double weight);
  /// Asks for each tetrahedron, old or new, whether a point should be inserted because of it, and
  /// where; until nobody wants one, or `most` were inserted. The answer is their number. The order
  /// of asking depends on the threads that were used before. Requires finite wishes. With weights,
  /// those of the new points are 0; one that would be hidden is not counted, but gets a number.
  std::size_t refine(const Wish& wish, std::size_t most);

 private:
  template <class T, bool kIsWeighted>
  using Owned = std::unique_ptr<Builder<T, kIsWeighted>>;
  std::variant<Owned<std::uint32_t, false>, Owned<std::uint64_t, false>, Owned<std::uint32_t, true>,
               Owned<std::uint64_t, true>>
      builder_;
};

}  // namespace hexatlas::delaunay
