#include "tables/format/record.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "enum/core/checks.hpp"
#include "tables/format/bytes.hpp"
#include "tables/format/cavity.hpp"

namespace hexatlas::format {
namespace {

using complex::Hexahedron;
using complex::HexComplex;
using complex::VertexId;

constexpr char kFlips = 0;
constexpr char kCells = 1;
constexpr VertexId kUnset = 0xFFFFFFFF;

/// Numbers the top vertices of a mesh hexahedron as the record does: `made` is the same
/// hexahedron there, its corners 0 .. 3 being the bottom.
void number_top(const Hexahedron& cell, const Hexahedron& made, std::vector<VertexId>& number) {
  Hexahedron known{};
  for (std::size_t v = 0; v < 8; ++v) known[v] = number[cell[v]];
  const auto is_bottom = [&](VertexId v) {
    return std::find(made.begin(), made.begin() + 4, v) != made.begin() + 4;
  };
  for (std::size_t k = 0; k < 4; ++k) {
    const auto at =
        static_cast<std::size_t>(std::find(known.begin(), known.end(), made[k]) - known.begin());
    for (const std::size_t axis : {1U, 2U, 4U})
      if (at < 8 && !is_bottom(known[at ^ axis])) number[cell[at ^ axis]] = made[k + 4];
  }
}

/// The steps that take the hexahedra off in this order, or nullopt if it is no shelling.
std::optional<std::string> flips(const HexComplex& mesh, const complex::Quadrangulation& boundary,
                                 const std::vector<std::uint32_t>& order) {
  Cavity cavity(boundary);
  std::string payload(1, kFlips);
  std::vector<VertexId> number(mesh.vertices, kUnset);  // in the record; interior: as they appear
  std::iota(number.begin(), number.begin() + boundary.vertices(), 0U);
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const Hexahedron& cell = mesh.hexahedra[order[i]];
    Hexahedron known{};
    for (std::size_t v = 0; v < 8; ++v) known[v] = number[cell[v]];
    const auto step = cavity.step_for(known);
    if (!step) return std::nullopt;
    const auto made = cavity.take_off(*step);
    if (!made) return std::nullopt;
    number_top(cell, *made, number);
    put(payload, step->bottom);
    put(payload, step->sides);
  }
  if (!cavity.last()) return std::nullopt;
  return payload;
}

std::optional<HexComplex> decode_flips(std::string_view steps,
                                       const complex::Quadrangulation& boundary, int hexahedra) {
  if (hexahedra < 1 || steps.size() != 2 * static_cast<std::size_t>(hexahedra - 1))
    return std::nullopt;
  Cavity cavity(boundary);
  HexComplex mesh;
  mesh.hexahedra.reserve(static_cast<std::size_t>(hexahedra));
  for (std::size_t i = 0; i < steps.size(); i += 2) {
    const auto cell = cavity.take_off(
        {static_cast<std::uint8_t>(steps[i]), static_cast<std::uint8_t>(steps[i + 1])});
    if (!cell) return std::nullopt;
    mesh.hexahedra.push_back(*cell);
  }
  const auto last = cavity.last();
  if (!last) return std::nullopt;
  mesh.hexahedra.push_back(*last);
  mesh.vertices = cavity.vertices();
  return mesh;
}

std::optional<HexComplex> decode_cells(std::string_view bytes,
                                       const complex::Quadrangulation& boundary, int hexahedra) {
  if (hexahedra < 1 || bytes.size() != 16 * static_cast<std::size_t>(hexahedra))
    return std::nullopt;
  HexComplex mesh{static_cast<std::uint32_t>(boundary.vertices()), {}};
  for (std::size_t at = 0; at < bytes.size(); at += 16) {
    Hexahedron cell{};
    for (std::size_t v = 0; v < 8; ++v) {
      cell[v] = get<std::uint16_t>(bytes, at + 2 * v);
      mesh.vertices = std::max(mesh.vertices, cell[v] + 1);
    }
    mesh.hexahedra.push_back(cell);
  }
  return mesh;
}

}  // namespace

std::string encode_record(const HexComplex& mesh, const complex::Quadrangulation& boundary) {
  core::expects(mesh.vertices < 65'536 && !mesh.hexahedra.empty() &&
                    mesh.vertices >= static_cast<std::uint32_t>(boundary.vertices()),
                "a record has a hexahedron and fewer than 65,536 vertices");
  std::vector<std::uint32_t> order(mesh.hexahedra.size());
  std::iota(order.begin(), order.end(), 0U);
  if (auto payload = flips(mesh, boundary, order)) return *payload;
  if (const auto shelling = complex::shelling_of(mesh))
    if (auto payload = flips(mesh, boundary, *shelling)) return *payload;
  std::string payload(1, kCells);
  for (const Hexahedron& cell : mesh.hexahedra)
    for (const VertexId v : cell) put(payload, static_cast<std::uint16_t>(v));
  return payload;
}

std::optional<HexComplex> decode_record(std::string_view payload,
                                        const complex::Quadrangulation& boundary, int hexahedra) {
  if (payload.empty()) return std::nullopt;
  const std::string_view rest = payload.substr(1);
  if (payload.front() == kFlips) return decode_flips(rest, boundary, hexahedra);
  if (payload.front() == kCells) return decode_cells(rest, boundary, hexahedra);
  return std::nullopt;
}

}  // namespace hexatlas::format
