// Points alone: .xyz, lines of coordinates, and .bin, coordinates in binary, both also with weights
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

bool wants_weights(const MeshBuilder& builder) {
  return builder.wanted() == Wanted::weighted_points;
}

/// The points in these bytes, kNumbers doubles each: a fourth one is the weight.
template <std::size_t kNumbers>
void read_coordinates(std::string_view bytes, MeshBuilder& builder) {
  static_assert(kNumbers == 3 || kNumbers == 4);
  constexpr std::size_t kPointBytes = kNumbers * sizeof(double);
  const std::size_t count = bytes.size() / kPointBytes;
  if (count > mesh::kMostPoints)
    throw core::InvalidInput(builder.file(), std::to_string(count) + " points; at most " +
                                                 std::to_string(mesh::kMostPoints) +
                                                 " are possible");
  builder.reserve_points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto numbers = load_little<std::array<double, kNumbers>>(bytes.substr(i * kPointBytes));
    const auto* const bad =
        std::find_if(numbers.begin(), numbers.end(), [](double x) { return !std::isfinite(x); });
    if (bad != numbers.end())
      throw core::InvalidInput(builder.file(),
                               "point " + std::to_string(i) + ", counted from 0, has a " +
                                   (bad - numbers.begin() < 3 ? "coordinate" : "weight") +
                                   " that is not a finite number");
    builder.add_point({numbers[0], numbers[1], numbers[2]}, 0);
    if constexpr (kNumbers == 4) builder.add_weight(numbers[3]);
  }
}

template <std::size_t kNumbers>
void read_whole(std::string_view bytes, MeshBuilder& builder) {
  constexpr std::size_t kPointBytes = kNumbers * sizeof(double);
  if (bytes.size() % kPointBytes != 0)
    throw core::InvalidInput(
        builder.file(), "has " + std::to_string(bytes.size()) +
                            " bytes, which is not a multiple of " + std::to_string(kPointBytes) +
                            ", " + (kNumbers == 4 ? "four" : "three") + " doubles per point");
  read_coordinates<kNumbers>(bytes, builder);
}

/// Of old programs: all would be one line.
void refuse_carriage_returns(std::string_view bytes, const std::string& file) {
  for (auto at = bytes.find('\r'); at != bytes.npos; at = bytes.find('\r', at + 1)) {
    if (at + 1 == bytes.size() || bytes[at + 1] == '\n') continue;
    const auto before = bytes.substr(0, at);
    const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    throw core::InvalidInput(file, line, "a carriage return that ends no line; use line feeds");
  }
}

}  // namespace

void read_xyz(std::string_view bytes, MeshBuilder& builder) {
  refuse_carriage_returns(bytes, builder.file());
  constexpr std::size_t kLeastLine = 6;  // "0 0 0" and the end of the line
  const std::size_t columns = wants_weights(builder) ? 4 : 3;
  Scanner scanner(bytes, builder.file(), '#');
  scanner.refuse_nul();
  const auto lines = static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n'));
  builder.reserve_points(std::min(lines, bytes.size() / kLeastLine) + 1);
  std::vector<std::string_view> words;
  while (scanner.next_line(words)) {
    if (words.size() < columns)
      scanner.fail("line of " + std::to_string(words.size()) +
                   (words.size() == 1 ? " column" : " columns") + "; x y z " +
                   (columns == 4 ? "weight " : "") + "are expected");
    builder.add_point(
        {scanner.to_real(words[0]), scanner.to_real(words[1]), scanner.to_real(words[2])},
        scanner.line());
    if (columns == 4) builder.add_weight(scanner.to_real(words[3]));
  }
}

void read_raw(std::string_view bytes, MeshBuilder& builder) {
  if (wants_weights(builder))
    read_whole<4>(bytes, builder);
  else
    read_whole<3>(bytes, builder);
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
  read_coordinates<3>(bytes.substr(0, points * kHxtetPointBytes), builder);
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
