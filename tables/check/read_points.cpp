// Files without words for cells: raw meshes of tetrahedra, and points alone.
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "tables/check/malformed.hpp"
#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are stored");

namespace hexatlas::check {

namespace {

constexpr std::string_view kMagic("HXTET\0\0\1", 8);
constexpr std::size_t kHeader = 24;
constexpr std::uint64_t kPointBytes = 3 * sizeof(double);
constexpr std::uint64_t kWeightedBytes = 4 * sizeof(double);
constexpr std::uint64_t kTetrahedronBytes = 4 * sizeof(std::uint32_t);

/// Whole points from the beginning of `bytes`.
std::vector<Point> raw_points(const std::string& name, std::string_view bytes,
                              std::uint64_t count) {
  std::vector<Point> points(count);
  if (count != 0) std::memcpy(points.data(), bytes.data(), count * kPointBytes);
  for (std::uint64_t i = 0; i < count; ++i) {
    for (const double value : points[i]) {
      if (!std::isfinite(value)) {
        throw Malformed(name, 0, "a coordinate of point " + std::to_string(i) + " is not finite");
      }
    }
  }
  return points;
}

void check_indices(const std::string& name, const Draft& draft) {
  for (std::size_t t = 0; t < draft.tetrahedra.size(); ++t) {
    for (const std::uint32_t vertex : draft.tetrahedra[t]) {
      if (vertex >= draft.points.size()) {
        throw Malformed(name, 0,
                        "tetrahedron " + std::to_string(t) + ": point " + std::to_string(vertex) +
                            " is not among the " + std::to_string(draft.points.size()) + " points");
      }
    }
  }
}

}  // namespace

bool begins_like_hxtet(std::string_view bytes) { return bytes.starts_with(kMagic); }

Draft parse_hxtet(const std::string& name, std::string_view bytes, Wanted wanted) {
  if (!begins_like_hxtet(bytes)) throw Malformed(name, 0, "does not begin like a .hxtet file");
  std::uint64_t points = 0;
  std::uint64_t tetrahedra = 0;
  if (bytes.size() < kHeader) throw Malformed(name, 0, "the file ends too early");
  std::memcpy(&points, bytes.data() + 8, 8);
  std::memcpy(&tetrahedra, bytes.data() + 16, 8);
  bytes.remove_prefix(kHeader);
  // More points would need wider indices, and a file larger than any that is read.
  if (points > std::numeric_limits<std::uint32_t>::max() || points > bytes.size() / kPointBytes ||
      tetrahedra > bytes.size() / kTetrahedronBytes ||
      points * kPointBytes + tetrahedra * kTetrahedronBytes != bytes.size()) {
    throw Malformed(name, 0,
                    "the size of the file is not that of " + std::to_string(points) +
                        " points and " + std::to_string(tetrahedra) + " tetrahedra");
  }
  Draft draft(wanted);
  draft.points = raw_points(name, bytes, points);
  draft.tetrahedra.resize(tetrahedra);
  if (tetrahedra != 0) {
    std::memcpy(draft.tetrahedra.data(), bytes.data() + points * kPointBytes,
                tetrahedra * kTetrahedronBytes);
  }
  check_indices(name, draft);
  return draft;
}

std::vector<Point> parse_xyz(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes, '#');
  std::vector<Point> points;
  for (auto words = in.line_of_words(); !words.empty(); words = in.line_of_words()) {
    if (words.size() < 3) in.fail("a line has not three numbers");
    points.push_back({in.real_from(words[0]), in.real_from(words[1]), in.real_from(words[2])});
  }
  return points;
}

std::vector<Point> parse_bin(const std::string& name, std::string_view bytes) {
  if (bytes.size() % kPointBytes != 0) {
    throw Malformed(name, 0, "the size of the file is no multiple of 24 bytes");
  }
  return raw_points(name, bytes, bytes.size() / kPointBytes);
}

WeightedPoints parse_weighted_xyz(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes, '#');
  WeightedPoints result;
  for (auto words = in.line_of_words(); !words.empty(); words = in.line_of_words()) {
    if (words.size() < 4) in.fail("a line has not four numbers");
    result.points.push_back(
        {in.real_from(words[0]), in.real_from(words[1]), in.real_from(words[2])});
    result.weights.push_back(in.real_from(words[3]));
  }
  return result;
}

WeightedPoints parse_weighted_bin(const std::string& name, std::string_view bytes) {
  if (bytes.size() % kWeightedBytes != 0) {
    throw Malformed(name, 0, "the size of the file is no multiple of 32 bytes");
  }
  WeightedPoints result;
  for (; !bytes.empty(); bytes.remove_prefix(kWeightedBytes)) {
    std::array<double, 4> numbers{};
    std::memcpy(numbers.data(), bytes.data(), kWeightedBytes);
    for (const double value : numbers) {
      if (std::isfinite(value)) continue;
      throw Malformed(
          name, 0, "a number of point " + std::to_string(result.points.size()) + " is not finite");
    }
    result.points.push_back({numbers[0], numbers[1], numbers[2]});
    result.weights.push_back(numbers[3]);
  }
  return result;
}

}  // namespace hexatlas::check
