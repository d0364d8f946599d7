#pragma once
/// \file
/// Internal to the judge: one reader per format, and what they share.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

enum class Shape : std::uint8_t {
  kVertex,
  kLine,
  kTriangle,
  kQuad,
  kTetrahedron,
  kHexahedron,
  kPrism,
  kWedge,  ///< a prism as VTK lists it
  kPyramid,
};
inline constexpr std::size_t kShapes = 9;

/// How a format calls a shape: by a number.
struct ShapeNumber {
  std::uint64_t number;
  Shape shape;
};

[[nodiscard]] std::size_t corner_count(Shape shape);

/// What of a file is wanted, and so which cells are kept, passed over and refused.
enum class Wanted : std::uint8_t {
  kHexahedra,   ///< hexahedra and quads kept, vertices and lines passed over, others refused
  kTetrahedra,  ///< tetrahedra kept, cells of lower dimension passed over, others refused
  kHybrid,      ///< cells of dimension 3 kept, others passed over
  kPoints,      ///< every known cell passed over
};

/// What has been read of a file so far.
class Draft {
 public:
  explicit Draft(Wanted wanted) : wanted_(wanted) {}

  std::vector<Point> points;
  std::vector<Hexahedron> hexahedra;
  std::vector<Quad> quads;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Prism> prisms;
  std::vector<Pyramid> pyramids;

  [[nodiscard]] bool refuses(Shape shape) const;
  /// Keeps a cell or passes it over. Its shape must not be refused.
  void add(Shape shape, std::span<const std::uint32_t> corners);
  /// What a cell is that is refused.
  [[nodiscard]] const char* refusal() const;

 private:
  Wanted wanted_;
};

[[nodiscard]] Draft parse_legacy_vtk(const std::string& name, std::string_view bytes,
                                     Wanted wanted);
[[nodiscard]] Draft parse_vtu(const std::string& name, std::string_view bytes, Wanted wanted);
[[nodiscard]] Draft parse_medit(const std::string& name, std::string_view bytes, Wanted wanted);
[[nodiscard]] Draft parse_gmsh(const std::string& name, std::string_view bytes, Wanted wanted);
[[nodiscard]] Draft parse_hxtet(const std::string& name, std::string_view bytes, Wanted wanted);
/// Whether the bytes begin like a .hxtet file.
[[nodiscard]] bool begins_like_hxtet(std::string_view bytes);
[[nodiscard]] std::vector<Point> parse_xyz(const std::string& name, std::string_view bytes);
[[nodiscard]] std::vector<Point> parse_bin(const std::string& name, std::string_view bytes);
[[nodiscard]] WeightedPoints parse_weighted_xyz(const std::string& name, std::string_view bytes);
[[nodiscard]] WeightedPoints parse_weighted_bin(const std::string& name, std::string_view bytes);
[[nodiscard]] std::vector<Point> parse_ply(const std::string& name, std::string_view bytes);
/// The points alone; records of anything else are not looked at.
[[nodiscard]] std::vector<Point> parse_obj_points(const std::string& name, std::string_view bytes);
[[nodiscard]] std::vector<Point> parse_off_points(const std::string& name, std::string_view bytes);
[[nodiscard]] Surface parse_obj(const std::string& name, std::string_view bytes);
[[nodiscard]] Surface parse_off(const std::string& name, std::string_view bytes);

/// Cells as VTK keeps them: offsets[i] .. offsets[i + 1] - 1 are the places in `connectivity` of
/// the vertices of cell i, whose kind is types[i]; offsets has one element more than types.
struct VtkCells {
  std::vector<std::uint64_t> connectivity;
  std::vector<std::uint64_t> offsets;
  std::vector<std::uint64_t> types;
};

/// Adds `cells` to `draft`, whose points are complete. Says what is wrong by `fail`, which does not
/// return.
void add_vtk_cells(const VtkCells& cells, Draft& draft,
                   const std::function<void(const std::string&)>& fail);

}  // namespace hexatlas::check
