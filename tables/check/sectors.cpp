#include "tables/check/sectors.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <utility>
#include <vector>

#include "tables/check/incidence.hpp"
#include "tables/check/judge_cells.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/text_lines.hpp"

namespace hexatlas::check {

namespace {

constexpr std::string_view kFirstWords = "hexatlas sectors ";
constexpr std::uint64_t kMostHexahedra = 1000;
constexpr std::uint32_t kSurfaceVertices = 28;

struct Sector {
  std::size_t line = 0;  ///< of the file, on which it begins
  std::uint32_t vertices = 0;
  std::vector<Hexahedron> hexahedra;
};

std::uint64_t number(LineWords& line, std::uint64_t least, std::uint64_t most) {
  const std::uint64_t value = line.natural();
  if (value < least || value > most) {
    line.fail("the number " + std::to_string(value) + " must be from " + std::to_string(least) +
              " to " + std::to_string(most));
  }
  return value;
}

Sector read_sector(TextLines& lines) {
  Sector sector;
  LineWords head = lines.next();
  sector.line = head.number();
  head.expect("sector");
  const std::uint64_t hexahedra = number(head, 1, kMostHexahedra);
  sector.vertices =
      static_cast<std::uint32_t>(number(head, kSurfaceVertices + 1, 8 * kMostHexahedra));
  if (sector.vertices > 8 * hexahedra) head.fail("there are more vertices than corners");
  head.expect_end();
  for (std::uint64_t i = 0; i < hexahedra; ++i) {
    LineWords line = lines.next();
    Hexahedron corners{};  // in the order of the file
    for (std::uint32_t& vertex : corners) {
      vertex = static_cast<std::uint32_t>(number(line, 0, sector.vertices - 1));
    }
    line.expect_end();
    Hexahedron& hexahedron = sector.hexahedra.emplace_back();
    for (std::size_t c = 0; c < 8; ++c) hexahedron[c] = corners[kCornerBits[c]];
  }
  return sector;
}

std::vector<Sector> read_sectors(std::string_view bytes, const std::string& name) {
  TextLines lines(name, bytes);
  LineWords first = lines.next();
  for (const std::string_view word : {"hexatlas", "sectors", "1"}) first.expect(word);
  first.expect_end();
  if (lines.at_end()) throw Malformed(name, lines.number(), "there is no sector");
  std::vector<Sector> sectors;
  while (!lines.at_end()) sectors.push_back(read_sector(lines));
  return sectors;
}

/// The quads of the surface, counter-clockwise from outside the sector.
std::vector<Quad> surface_of_sector() {
  constexpr std::uint32_t kApex = 15;
  // p and r of a corner; only white corners have an r.
  const auto p = [](std::uint32_t corner) { return 6 + 3 * (corner / 2) + corner % 2; };
  const auto r = [p](std::uint32_t corner) { return p(corner) + 1; };
  std::vector<Quad> quads = {{0, 1, 2, 3}, {0, 3, 4, 5}};
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    const bool is_odd = i % 2 == 1;
    const std::uint32_t b = is_odd ? next : i;
    const std::uint32_t w = is_odd ? i : next;
    const std::uint32_t y = 16 + 2 * i;
    const std::uint32_t z = y + 1;
    for (const Quad& quad : {Quad{w, p(w), y, b}, Quad{p(w), r(w), z, y},
                             Quad{r(w), kApex, p(b), z}, Quad{p(b), b, y, z}}) {
      quads.push_back(is_odd ? quad : reversed(quad));
    }
  }
  return quads;
}

/// Pairs of vertices of the surface; u, v and v, u are both in it.
using Pairs = std::array<std::bitset<kSurfaceVertices>, kSurfaceVertices>;

template <class VertexList>
void insert_pairs(const VertexList& vertices, Pairs& pairs) {
  for (const std::uint32_t u : vertices) {
    for (const std::uint32_t v : vertices) {
      if (u < kSurfaceVertices && v < kSurfaceVertices) pairs[u].set(v);
    }
  }
}

std::size_t count_scars(const Sector& sector, const Pairs& of_surface) {
  Pairs pairs;
  for (const Hexahedron& hexahedron : sector.hexahedra) insert_pairs(hexahedron, pairs);
  std::size_t scars = 0;
  for (std::size_t v = 0; v < kSurfaceVertices; ++v) scars += (pairs[v] & ~of_surface[v]).count();
  return scars / 2;
}

/// Law 1. If only the proof of ball is missing, the verdict is `undecided`.
Verdict judge_sector(const Sector& sector, const std::vector<Quad>& sorted_surface) {
  std::vector<Quad> boundary;
  Verdict verdict = judge_cells(sector.hexahedra, sector.vertices, {}, {}, boundary);
  if (!verdict.accepted && !verdict.undecided) return verdict;
  boundary = sorted_cycles(boundary_quads(incidence_of(sector.hexahedra, sector.vertices)));
  if (boundary == sorted_surface) return verdict;
  verdict.accepted = verdict.undecided = false;
  verdict.reason = "of the quads of the surface and those of the sector: " +
                   difference(boundary, sorted_surface);
  return verdict;
}

}  // namespace

bool is_sectors(std::string_view bytes) noexcept { return bytes.starts_with(kFirstWords); }

SectorsVerdict check_sectors_bytes(std::string_view bytes, const std::string& name) {
  const std::vector<Sector> sectors = read_sectors(bytes, name);
  const std::vector<Quad> surface = sorted_cycles(surface_of_sector());
  Pairs of_surface;
  for (const Quad& quad : surface) insert_pairs(quad, of_surface);
  SectorsVerdict verdict;
  verdict.sectors = sectors.size();
  verdict.least = verdict.most = sectors.front().hexahedra.size();
  std::size_t scarless = 0;  // hexahedra
  for (const Sector& sector : sectors) {
    const std::size_t hexahedra = sector.hexahedra.size();
    verdict.least = std::min(verdict.least, hexahedra);
    verdict.most = std::max(verdict.most, hexahedra);
    const std::size_t scars = count_scars(sector, of_surface);
    verdict.scars += scars;
    if (scars == 0) scarless = scarless == 0 ? hexahedra : std::min(scarless, hexahedra);
  }
  for (const Sector& sector : sectors) {
    const Verdict judged = judge_sector(sector, surface);
    if (judged.accepted || (judged.undecided && verdict.undecided)) continue;
    verdict.fault = "the sector of line " + std::to_string(sector.line) + ": " + judged.reason;
    verdict.undecided = judged.undecided;
    if (!judged.undecided) return verdict;
  }
  if (scarless == 0) {
    verdict.undecided = false;
    verdict.fault = "no sector is without scars";
  }
  verdict.accepted = verdict.fault.empty();
  if (verdict.accepted) verdict.least_without_scars = scarless;
  return verdict;
}

}  // namespace hexatlas::check
