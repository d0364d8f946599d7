// Points alone: .xyz, lines of three coordinates, and .bin, coordinates in binary
// (docs/formats/points.md). And .hxtet, whose points come first (docs/formats/hxtet.md).
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "enum/core/errors.hpp"
#include "meshing/io/hxtet.hpp"
#include "meshing/io/little_endian.hpp"
#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

constexpr std::size_t kPointBytes = 3 * sizeof(double);

/// The points in these bytes, whose number is bytes.size() / kPointBytes.
void read_coordinates(std::string_view bytes, MeshBuilder& builder) {
  const std::size_t count = bytes.size() / kPointBytes;
  if (count > mesh::kMostPoints)
    throw core::InvalidInput(builder.file(), std::to_string(count) + " points; at most " +
                                                 std::to_string(mesh::kMostPoints) +
                                                 " are possible");
  builder.reserve_points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto xyz = load_little<std::array<double, 3>>(bytes.substr(i * kPointBytes));
    if (!std::all_of(xyz.begin(), xyz.end(), [](double x) { return std::isfinite(x); }))
      throw core::InvalidInput(
          builder.file(), "point " + std::to_string(i) +
                              ", counted from 0, has a coordinate that is not a finite number");
    builder.add_point({xyz[0], xyz[1], xyz[2]}, 0);
  }
}

}  // namespace

void read_xyz(std::string_view bytes, MeshBuilder& builder) {
  constexpr std::size_t kLeastLine = 6;  // "0 0 0" and the end of the line
  Scanner scanner(bytes, builder.file(), '#');
  scanner.refuse_nul();
  const auto lines = static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n'));
  builder.reserve_points(std::min(lines, bytes.size() / kLeastLine) + 1);
  std::vector<std::string_view> words;
  while (scanner.next_line(words)) {
    if (words.size() < 3)
      scanner.fail("line of " + std::to_string(words.size()) +
                   (words.size() == 1 ? " column" : " columns") + "; x y z are expected");
    builder.add_point(
        {scanner.to_real(words[0]), scanner.to_real(words[1]), scanner.to_real(words[2])},
        scanner.line());
  }
}

void read_raw(std::string_view bytes, MeshBuilder& builder) {
  if (bytes.size() % kPointBytes != 0)
    throw core::InvalidInput(builder.file(),
                             "has " + std::to_string(bytes.size()) +
                                 " bytes, which is not a multiple of 24, three doubles per point");
  read_coordinates(bytes, builder);
}

void read_hxtet(std::string_view bytes, MeshBuilder& builder) {
  const auto fail = [&](const std::string& reason) {
    throw core::InvalidInput(builder.file(), reason);
  };
  if (!bytes.starts_with(kHxtetMagic)) fail("does not begin as a file .hxtet of version 1");
  if (bytes.size() < kHxtetHeaderBytes) fail("ends within its header");
  const auto points = load_little<std::uint64_t>(bytes.substr(8));
  const auto tetrahedra = load_little<std::uint64_t>(bytes.substr(16));
  bytes.remove_prefix(kHxtetHeaderBytes);
  if (points > bytes.size() / kHxtetPointBytes)
    fail("count " + std::to_string(points) + " of points is too large: only " +
         std::to_string(bytes.size()) + " bytes follow");
  read_coordinates(bytes.substr(0, points * kHxtetPointBytes), builder);
  bytes.remove_prefix(points * kHxtetPointBytes);
  if (bytes.size() % kHxtetTetrahedronBytes != 0 ||
      tetrahedra != bytes.size() / kHxtetTetrahedronBytes)
    fail("count " + std::to_string(tetrahedra) + " of tetrahedra, but " +
         std::to_string(bytes.size()) + " bytes follow the points");
  builder.reserve_cells(kTetrahedron, tetrahedra);
  for (; !bytes.empty(); bytes.remove_prefix(kHxtetTetrahedronBytes))
    builder.add_cell(kTetrahedron, load_little<std::array<mesh::Index, 4>>(bytes), 0);
}

}  // namespace hexatlas::io
