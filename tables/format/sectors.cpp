#include "tables/format/sectors.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

#include "enum/core/errors.hpp"

namespace hexatlas::format {
namespace {

using complex::BoundaryQuad;
using complex::HexComplex;
using complex::VertexId;

constexpr std::string_view kHeader = "hexatlas sectors 1";
constexpr std::size_t kMostHexahedra = 1000;

/// The lines of a file, each a list of words.
class Lines {
 public:
  Lines(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  [[nodiscard]] bool at_end() const noexcept { return rest_.empty(); }
  [[noreturn]] void fail(const std::string& reason) const {
    throw core::InvalidInput(name_, number_, reason);
  }
  std::string_view line() {
    ++number_;
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) fail(rest_.empty() ? "the file ends early" : "has no end");
    const std::string_view result = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return result;
  }
  /// The next `count` numbers of a line, which then ends.
  template <std::size_t count>
  [[nodiscard]] std::array<VertexId, count> numbers(std::string_view line) const {
    std::array<VertexId, count> result{};
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0 && !line.starts_with(' ')) fail("expected a space and a number");
      if (i > 0) line.remove_prefix(1);
      const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), result[i]);
      if (error != std::errc() || (line[0] == '0' && end != line.data() + 1))
        fail("expected a number");
      line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    }
    if (!line.empty()) fail("expected the end of the line");
    return result;
  }

 private:
  std::string_view rest_;
  const std::string& name_;
  std::size_t number_ = 0;
};

std::vector<SurfacePair> pairs_of(std::span<const VertexId> vertices) {
  std::vector<SurfacePair> result;
  for (const VertexId a : vertices)
    for (const VertexId b : vertices)
      if (a < b && b < kSectorSurface) result.push_back({a, b});
  return result;
}

std::vector<SurfacePair> scars_of(const HexComplex& mesh) {
  std::set<SurfacePair> scars;
  for (const auto& cell : mesh.hexahedra)
    for (const SurfacePair& pair : pairs_of(cell)) scars.insert(pair);
  for (const BoundaryQuad& quad : sector_quads())
    for (const SurfacePair& pair : pairs_of(quad)) scars.erase(pair);
  return {scars.begin(), scars.end()};
}

HexComplex read_mesh(Lines& lines) {
  std::string_view line = lines.line();
  constexpr std::string_view kWord = "sector ";
  if (!line.starts_with(kWord)) lines.fail("expected `sector`");
  line.remove_prefix(kWord.size());
  const auto sizes = lines.numbers<2>(line);
  const VertexId hexahedra = sizes[0];
  const VertexId vertices = sizes[1];
  if (hexahedra < 1 || hexahedra > kMostHexahedra || vertices <= kSectorSurface ||
      vertices > 8 * hexahedra)
    lines.fail("no sector has so many hexahedra or vertices");
  HexComplex mesh{vertices, {}};
  for (std::size_t i = 0; i < hexahedra; ++i) {
    mesh.hexahedra.push_back(lines.numbers<8>(lines.line()));
    const complex::Hexahedron& cell = mesh.hexahedra.back();
    if (std::any_of(cell.begin(), cell.end(), [&](VertexId v) { return v >= vertices; }))
      lines.fail("a vertex is out of range");
  }
  if (const auto law = complex::validate(mesh)) lines.fail("the sector: " + law->reason);
  const auto quads = sector_quads();
  if (!complex::has_boundary(mesh, {quads.begin(), quads.end()}))
    lines.fail("the boundary is not that of a sector");
  return mesh;
}

}  // namespace

std::array<BoundaryQuad, kSectorQuads> sector_quads() {
  std::array<BoundaryQuad, kSectorQuads> result{{{0, 1, 2, 3}, {0, 3, 4, 5}}};
  std::size_t place = 2;
  for (int wall = 0; wall < kSectorCorners; ++wall) {
    const int next = (wall + 1) % kSectorCorners;
    const int black = wall % 2 == 0 ? wall : next;
    const int white = wall % 2 == 0 ? next : wall;
    const auto b = static_cast<VertexId>(black);
    const auto w = static_cast<VertexId>(white);
    const VertexId pb = after_corner(black);
    const VertexId pw = after_corner(white);
    const VertexId rw = before_apex(white);
    const auto [y, z] = inside_wall(wall);
    for (BoundaryQuad quad : {BoundaryQuad{w, pw, y, b}, BoundaryQuad{pw, rw, z, y},
                              BoundaryQuad{rw, kSectorApex, pb, z}, BoundaryQuad{pb, b, y, z}}) {
      if (wall % 2 == 0) std::swap(quad[1], quad[3]);
      result[place++] = quad;
    }
  }
  return result;
}

std::vector<Sector> read_sectors(std::string_view bytes, const std::string& name) {
  Lines lines(bytes, name);
  if (lines.line() != kHeader) lines.fail("is no file of sectors");
  std::vector<Sector> result;
  while (!lines.at_end()) {
    HexComplex mesh = read_mesh(lines);
    std::vector<SurfacePair> scars = scars_of(mesh);
    result.push_back({std::move(mesh), std::move(scars)});
  }
  if (std::all_of(result.begin(), result.end(),
                  [](const Sector& sector) { return !sector.scars.empty(); }))
    throw core::InvalidInput(name, "has no sector without scars");
  std::stable_sort(result.begin(), result.end(), [](const Sector& a, const Sector& b) {
    return a.mesh.hexahedra.size() < b.mesh.hexahedra.size();
  });
  return result;
}

std::string sectors_bytes(std::span<const HexComplex> meshes) {
  std::string text = std::string(kHeader) + '\n';
  for (const HexComplex& mesh : meshes) {
    text += "sector " + std::to_string(mesh.hexahedra.size()) + ' ' +
            std::to_string(mesh.vertices) + '\n';
    for (const auto& cell : mesh.hexahedra)
      for (std::size_t i = 0; i < cell.size(); ++i)
        text += std::to_string(cell[i]) + (i + 1 < cell.size() ? ' ' : '\n');
  }
  return text;
}

}  // namespace hexatlas::format
