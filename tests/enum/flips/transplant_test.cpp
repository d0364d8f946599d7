// Claim. Donors are meshes of the boundaries that are alike to a target, of all of them, with the
// hexahedra that must go; transplants are meshes of the target with as many faults as they say, no
// more than asked for and none too large, the least strict one first, the same for any number of
// threads.
// Oracle. Faults, boundaries and hexahedra by sets; alike boundaries by what is left of each of two
// when a disc is cut off, whatever the disc.
#include "enum/flips/transplant.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/flips/circles.hpp"
#include "enum/flips/donors.hpp"
#include "enum/flips/numbered_boundary.hpp"
#include "tests/enum/flips/faults.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using complex::Quadrangulation;
using Corners = std::array<int, 4>;

flips::MeshSource least_of(const flips::Beam& beam) {
  return [&beam](const canon::Code& code, int below) -> std::optional<complex::HexComplex> {
    const auto least = beam.smallest(code);
    if (!least || beam.level_of(*least) + 1 >= below) return std::nullopt;
    return flips::filling_of(beam, *least).mesh;
  };
}

flips::TransplantOptions limits(int below, std::size_t count) {
  return {.max_circle = 8,
          .max_gained = 7,
          .max_interior = 2,
          .tries = 1'000,
          .wanted = {.price = 1, .below = below, .count = count},
          .seed = 1,
          .threads = 1};
}

using Quads = std::set<std::set<std::uint32_t>>;

template <typename List>
Quads sets_of(const List& quads) {
  Quads result;
  for (const auto& quad : quads) result.emplace(quad.begin(), quad.end());
  return result;
}

/// The quads in order of a walk from each side of each of them, the least of all lists: the same
/// for two discs if and only if one is the other or its mirror image.
std::vector<Corners> form_of(const std::vector<Corners>& quads) {
  std::map<std::pair<int, int>, std::pair<std::size_t, std::size_t>> side_along;
  for (std::size_t k = 0; k < quads.size(); ++k)
    for (std::size_t s = 0; s < 4; ++s) side_along[{quads[k][s], quads[k][(s + 1) % 4]}] = {k, s};
  std::vector<Corners> least;
  for (const bool mirrored : {false, true})
    for (std::size_t first = 0; first < quads.size(); ++first)
      for (std::size_t side = 0; side < 4; ++side) {
        std::map<int, int> number;
        std::vector<Corners> form, corners;
        std::vector<bool> has_come(quads.size());
        const auto take = [&](std::size_t k, std::size_t from) {
          has_come[k] = true;
          form.emplace_back();
          corners.emplace_back();
          for (std::size_t i = 0; i < 4; ++i) {
            const int v = quads[k][(mirrored ? from + 4 - i : from + i) % 4];
            corners.back()[i] = v;
            form.back()[i] = number.try_emplace(v, static_cast<int>(number.size())).first->second;
          }
        };
        take(first, side);
        // Next the quads across the edges of those that have come, in their order.
        for (std::size_t at = 0; at < form.size(); ++at)
          for (std::size_t i = 0; i < 4; ++i) {
            const int from = corners[at][(i + 1) % 4], to = corners[at][i];
            const auto across =
                side_along.find(mirrored ? std::pair(to, from) : std::pair(from, to));
            if (across == side_along.end() || has_come[across->second.first]) continue;
            const auto [k, s] = across->second;
            take(k, mirrored ? (s + 1) % 4 : s);
          }
        if (least.empty() || form < least) least = form;
      }
  return least;
}

/// What is left of a boundary without the discs that `is_cut_off` includes, by their quads and
/// the vertices inside.
std::set<std::vector<Corners>> rests_of(const canon::Code& code, auto&& is_cut_off) {
  const Quadrangulation q = canon::decode(code).value();
  std::set<std::vector<Corners>> result;
  for (const int length : {4, 6, 8})
    for (const auto& circle : flips::circles(flips::graph_of(q), q.vertices(), length)) {
      const auto left = flips::left_of(q, circle);
      for (const bool side : {true, false}) {
        std::vector<Corners> rest;
        int cut_off = 0;
        for (int k = 0; k < q.quads(); ++k) {
          const auto own = q.vertices_of(k);
          if (left[static_cast<std::size_t>(k)] == side)
            ++cut_off;
          else
            rest.push_back({own[0], own[1], own[2], own[3]});
        }
        if (rest.size() >= 4 && is_cut_off(cut_off, cut_off - length / 2 + 1))
          result.insert(form_of(rest));
      }
    }
  return result;
}

TEST(Transplant, KnowsAllDonors) {
  const auto beam = support::grown(18, 4, 1'500, 14);
  std::vector<canon::Code> codes = beam.codes();
  std::erase_if(codes, [](const canon::Code& code) { return code.quads > 16; });
  std::map<canon::Code, std::set<std::vector<Corners>>> without_lost;
  for (const auto& code : codes)
    without_lost[code] = rests_of(code, [](int, int interior) { return interior <= 2; });
  std::size_t targets = 0, donors = 0;
  for (const auto& target : codes) {
    if (target.quads != 12 && target.quads != 14) continue;
    ++targets;
    const auto rests = rests_of(target, [](int quads, int) { return quads <= 7; });
    std::set<canon::Code> expected;
    for (const auto& code : codes)
      if (code != target && std::any_of(rests.begin(), rests.end(), [&](const auto& rest) {
            return without_lost[code].contains(rest);
          }))
        expected.insert(code);
    std::set<canon::Code> found;
    const auto q = canon::decode(target).value();
    for (const auto& donor : flips::donors_of(target, least_of(beam), limits(1'000, 1))) {
      ++donors;
      // Its boundary is the target's with one disc in place of another one.
      Quads quads = sets_of(q.list_of_quads());
      for (const auto& quad : sets_of(donor.gained)) EXPECT_EQ(quads.erase(quad), 1U);
      const Quads lost = sets_of(donor.lost);
      for (const auto& quad : lost) EXPECT_TRUE(quads.insert(quad).second);
      const auto cells = support::cells_of(donor.mesh);
      EXPECT_EQ(sets_of(oracle::boundary(cells)), quads);
      // Those with a quad of the disc, or at a vertex inside it.
      std::vector<std::uint32_t> torn;
      for (std::uint32_t c = 0; c < cells.size(); ++c) {
        const auto facets = support::facets_of(cells[c]);
        const auto& cell = donor.mesh.hexahedra[c];
        if (std::any_of(lost.begin(), lost.end(),
                        [&](const auto& quad) { return facets.contains(quad); }) ||
            std::any_of(cell.begin(), cell.end(), [&](complex::VertexId v) {
              return v >= static_cast<complex::VertexId>(q.vertices()) &&
                     std::any_of(lost.begin(), lost.end(),
                                 [&](const auto& quad) { return quad.contains(v); });
            }))
          torn.push_back(c);
      }
      EXPECT_EQ(donor.torn, torn);
      const auto boundary = flips::three_connected_boundary(boundary_of(donor.mesh));
      found.insert(canon::canonical_form(boundary.value().boundary).code);
    }
    EXPECT_EQ(found, expected) << canon::to_text(target);
  }
  EXPECT_EQ(targets, 5U);
  EXPECT_GT(donors, 80U);
}

TEST(Transplant, KnowsItsFaults) {
  const auto beam = support::grown(20, 10, 1'000, 24);
  std::size_t faulty = 0, strict = 0;
  for (const auto& code : beam.codes()) {
    if (code.quads != 20) continue;
    auto options = limits(*beam.first_level(code) + 1 + 20, 12);
    options.max_gained = 10;
    const auto meshes = flips::transplants(beam, least_of(beam), code, options);
    EXPECT_LE(meshes.size(), options.wanted.count);
    support::expect_faulty_meshes(meshes, code, options.wanted, 0);
    for (const auto& mesh : meshes) ++(mesh.faults == 0 ? strict : faulty);
    options.threads = 3;
    support::expect_same(flips::transplants(beam, least_of(beam), code, options), meshes);
    if (faulty > 60 && strict > 10) break;
  }
  EXPECT_GT(faulty, 40U);
  EXPECT_GT(strict, 10U);
}

TEST(Transplant, GivesTheLeastStrictOneFirst) {
  const auto beam = support::grown(20, 10, 1'000, 24);
  std::size_t found = 0;
  for (const auto& code : beam.codes()) {
    if (code.quads != 16) continue;
    const auto options = limits(*beam.first_level(code) + 1 + 12, 500);
    const auto all = flips::transplants(beam, least_of(beam), code, options);
    std::optional<std::size_t> least;
    for (const auto& mesh : all)
      if (mesh.faults == 0) least = std::min(least.value_or(1'000), mesh.mesh.hexahedra.size());
    if (!least) continue;
    EXPECT_EQ(all.front().faults, 0);
    EXPECT_EQ(all.front().mesh.hexahedra.size(), *least);
    if (++found == 5) break;
  }
  EXPECT_EQ(found, 5U);
}

TEST(Transplant, NeedsDonors) {
  const auto beam = support::grown(14, 2, 400, 8);
  const auto none = [](const canon::Code&, int) -> std::optional<complex::HexComplex> {
    return std::nullopt;
  };
  for (const auto& code : beam.codes())
    EXPECT_TRUE(flips::transplants(beam, none, code, limits(1'000, 5)).empty());
}

}  // namespace
