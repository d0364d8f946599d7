#include "meshing/hybrid/hexahedron_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "meshing/quality/edge.hpp"
#include "meshing/quality/hexahedron.hpp"

namespace hexatlas::hybrid {
namespace {

bool are_distinct(const std::array<Index, 8>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t j = i + 1; j < vertices.size(); ++j)
      if (vertices[i] == vertices[j]) return false;
  return true;
}

/// The places of a .. h in the numbering of the cube.
enum Letter : std::uint8_t { kA = 0, kB = 1, kC = 3, kD = 2, kE = 4, kF = 5, kG = 7, kH = 6 };

}  // namespace

std::size_t HexahedronSearch::visit(const Around& around, CandidateList<8>& found) {
  proposals_.clear();
  for (std::uint32_t b = around.first_after(); b < around.degree(); ++b) start_at(around, b);
  return offer(around, found);
}

/// All corners a with b as the least neighbour: two partners of b that are partners.
void HexahedronSearch::start_at(const Around& around, std::uint32_t b) {
  const Index a = around.vertex();
  const auto partners = around.partners(b);
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (partners[i].y < b) continue;
    const auto others = around.partners(partners[i].y);
    std::size_t k = 0;
    for (std::size_t j = i + 1; j < partners.size(); ++j) {
      while (k < others.size() && others[k].y < partners[j].y) ++k;
      if (k == others.size()) break;
      if (others[k].y != partners[j].y) continue;
      const double jacobian =
          determinant(corners_.direction(a, b), corners_.direction(a, partners[i].y),
                      corners_.direction(a, partners[j].y));
      if (std::abs(jacobian) < least_) continue;
      Start start{b, partners[i].y, partners[j].y, partners[i], partners[j], others[k]};
      if (jacobian < 0) {
        std::swap(start.d, start.e);
        std::swap(start.bd, start.be);
        start.de.is_swapped = !start.de.is_swapped;
      }
      join(around, start);
    }
  }
}

void HexahedronSearch::join(const Around& around, const Start& start) {
  const auto gather = [&around](const Partner& partner, std::vector<Side>& sides) {
    sides.clear();
    for (const Fourth& fourth : around.fourths(partner)) {
      if (partner.is_swapped)
        sides.push_back({fourth.z, fourth.at_y, fourth.at_x, true, false});
      else
        sides.push_back({fourth.z, fourth.at_x, fourth.at_y, true, false});
    }
  };
  gather(start.bd, c_);
  gather(start.be, f_);
  gather(start.de, h_);
  if (gather_ends(around.vertex(), start)) join_top(around.vertex(), start);
}

/// For each pair of sides at b, d or e the vertices g that close the quad there, if the corner
/// is good enough; false if one of the three has none at all. A side without any g at one corner
/// is left out at the next.
bool HexahedronSearch::gather_ends(Index a, const Start& start) {
  const auto neighbours = graph_.neighbours(a);
  const auto gather = [&](Index v, std::vector<Side>& one, auto at_one, std::vector<Side>& two,
                          auto at_two, auto jacobian, Ends& ends) {
    bool is_any = false;
    ends.assign(one.size() * two.size(), {});
    for (std::size_t i = 0; i < one.size(); ++i)
      for (std::size_t j = 0; j < two.size(); ++j) {
        if (!one[i].is_open || !two[j].is_open) continue;
        const std::uint32_t x = one[i].*at_one;
        const std::uint32_t y = two[j].*at_two;
        if (x == y || jacobian(corners_.direction(v, x), corners_.direction(v, y)) < least_)
          continue;
        auto& end = ends[i * two.size() + j];
        end = corners_.between(v, x, y);
        while (!end.empty() && end.front().z < a) end = end.subspan(1);
        if (end.empty()) continue;
        is_any = one[i].has_end = two[j].has_end = true;
      }
    for (auto* sides : {&one, &two})
      for (Side& side : *sides) side.is_open = std::exchange(side.has_end, false);
    return is_any;
  };
  const Direction& ab = corners_.direction(a, start.b);
  const Direction& ad = corners_.direction(a, start.d);
  const Direction& ae = corners_.direction(a, start.e);
  const auto first = &Side::at_first;
  const auto second = &Side::at_second;
  return gather(
             neighbours[start.b], c_, first, f_, first,
             [&](const auto& bc, const auto& bf) { return determinant(ab, bc, bf); }, at_b_) &&
         gather(
             neighbours[start.d], c_, second, h_, first,
             [&](const auto& dc, const auto& dh) { return determinant(dc, ad, dh); }, at_d_) &&
         gather(
             neighbours[start.e], f_, second, h_, second,
             [&](const auto& ef, const auto& eh) { return determinant(ef, eh, ae); }, at_e_);
}

void HexahedronSearch::join_top(Index a, const Start& start) {
  const auto neighbours = graph_.neighbours(a);
  std::array<Index, 8> cell{};
  cell[kA] = a;
  cell[kB] = neighbours[start.b];
  cell[kD] = neighbours[start.d];
  cell[kE] = neighbours[start.e];
  for (std::size_t i = 0; i < c_.size(); ++i)
    for (std::size_t j = 0; j < f_.size(); ++j) {
      const auto g_b = at_b_[i * f_.size() + j];
      if (g_b.empty()) continue;
      for (std::size_t k = 0; k < h_.size(); ++k) {
        const auto g_d = at_d_[i * h_.size() + k];
        const auto g_e = at_e_[j * h_.size() + k];
        for (auto one = g_b.begin(), two = g_d.begin(), three = g_e.begin();
             one != g_b.end() && two != g_d.end() && three != g_e.end();) {
          const Index greatest = std::max({one->z, two->z, three->z});
          if (one->z == greatest && two->z == greatest && three->z == greatest) {
            cell[kC] = c_[i].vertex;
            cell[kF] = f_[j].vertex;
            cell[kH] = h_[k].vertex;
            cell[kG] = greatest;
            propose(cell, c_[i], f_[j], h_[k]);
            ++one;
            continue;
          }
          if (one->z < greatest)
            ++one;
          else if (two->z < greatest)
            ++two;
          else
            ++three;
        }
      }
    }
}

/// Tests the four corners at the edges of g.
void HexahedronSearch::propose(const std::array<Index, 8>& cell, const Side& c, const Side& f,
                               const Side& h) {
  if (!are_distinct(cell)) return;
  const auto points = graph_.points();
  const mesh::Point& g = points[cell[kG]];
  const Direction& bc = corners_.direction(cell[kB], c.at_first);
  const Direction& dc = corners_.direction(cell[kD], c.at_second);
  const Direction& bf = corners_.direction(cell[kB], f.at_first);
  const Direction& ef = corners_.direction(cell[kE], f.at_second);
  const Direction& dh = corners_.direction(cell[kD], h.at_first);
  const Direction& eh = corners_.direction(cell[kE], h.at_second);
  const Direction cg = quality::direction(points[cell[kC]], g);
  if (determinant(dc, bc, cg) < least_) return;
  const Direction fg = quality::direction(points[cell[kF]], g);
  if (determinant(ef, fg, bf) < least_) return;
  const Direction hg = quality::direction(points[cell[kH]], g);
  if (determinant(hg, eh, dh) < least_ || determinant(hg, fg, cg) < least_) return;
  proposals_.push_back(cell);
}

/// From the tetrahedron on the inner side of a triangle of the bottom at a: of a b d, and if that
/// leads nowhere, of a b c.
std::optional<Filling> HexahedronSearch::filling(const Around& around,
                                                 const std::array<Index, 8>& cell) {
  const auto from = [&](Letter third, Letter fourth) -> std::optional<Filling> {
    const Around::Beyond* beyond = around.beyond(cell[kB], cell[third]);
    if (beyond == nullptr || beyond->r == cell[fourth]) return std::nullopt;
    return filler_.filling(kHexahedronShape, cell, beyond->tetrahedron);
  };
  if (auto result = from(kD, kC)) return result;
  return from(kC, kD);
}

std::size_t HexahedronSearch::offer(const Around& around, CandidateList<8>& found) {
  std::size_t undecided = 0;
  for (const std::array<Index, 8>& cell : proposals_) {
    const auto filling = this->filling(around, cell);
    if (!filling) continue;
    quality::Corners corners{};
    std::transform(cell.begin(), cell.end(), corners.begin(),
                   [this](Index v) { return graph_.points()[v]; });
    const double quality = quality::scaled_jacobian(corners);
    if (!quality::exceeds(corners, quality, quality_)) continue;
    const auto validity = quality::validity_of_hexahedron(corners);
    if (validity == quality::Validity::undecided) ++undecided;
    if (validity != quality::Validity::valid) continue;
    found.cells.push_back({cell, quality, found.tetrahedra.size(), filling->inner, filling->flat});
    const auto all = filling->all();
    found.tetrahedra.insert(found.tetrahedra.end(), all.begin(), all.end());
  }
  return undecided;
}

}  // namespace hexatlas::hybrid
