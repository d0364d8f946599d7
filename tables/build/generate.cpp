#include "tables/build/generate.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "enum/core/checks.hpp"
#include "enum/flips/meeting.hpp"

namespace hexatlas::build {
namespace {

/// A mesh leaves the search only if it obeys the laws and has the boundary asked for.
void ensure_fills(const complex::HexComplex& mesh, const canon::Code& code) {
  if (const auto law = complex::validate(mesh))
    throw core::InternalError("a mesh found for " + canon::to_text(code) +
                              " breaks a law: " + law->reason);
  std::vector<complex::BoundaryQuad> wanted;
  const auto boundary = canon::decode(code).value();
  for (int q = 0; q < boundary.quads(); ++q) {
    const auto v = boundary.vertices_of(q);
    wanted.push_back({v[0], v[1], v[2], v[3]});
  }
  core::ensures(complex::has_boundary(mesh, std::move(wanted)),
                "a mesh found has the boundary it was found for");
}

using Report = std::function<void(const Progress&)>;
using Meshes = std::map<canon::Code, complex::HexComplex>;

flips::Beam grow_balls(const Stage& stage, const std::string& name, const Report& report) {
  const auto total = static_cast<std::size_t>(stage.max_ball);
  flips::Beam balls(flips::canonical_state(flips::single_hexahedron()).state, stage.balls);
  while (balls.level() + 1 < stage.max_ball) {
    report({name + ", balls", static_cast<std::size_t>(balls.level()) + 1, total});
    if (balls.expand_level() == 0) break;
  }
  return balls;
}

void improve(const flips::Beam& balls, const Stage& stage, const canon::Code& code,
             Meshes& meshes) {
  flips::MeetingOptions options{.collars = stage.collars, .max_collar = stage.max_collar};
  const auto known = meshes.find(code);
  if (known != meshes.end()) options.below = static_cast<int>(known->second.hexahedra.size());
  if (auto filling = flips::best_meeting(balls, code, options)) {
    ensure_fills(filling->mesh, code);
    meshes[code] = std::move(filling->mesh);
  }
}

void run_stage(const Stage& stage, const std::string& name,
               const std::vector<canon::Code>& boundaries, const Report& report, Meshes& meshes) {
  std::vector<canon::Code> todo;
  for (const canon::Code& code : boundaries)
    if (!stage.only_missing || !meshes.contains(code)) todo.push_back(code);
  if (todo.empty()) return;
  const flips::Beam balls = grow_balls(stage, name, report);
  for (std::size_t i = 0; i < todo.size(); ++i) {
    report({name + ", collars", i, todo.size()});
    improve(balls, stage, todo[i], meshes);
  }
}

flips::BeamOptions limits(int max_quads, std::size_t per_class, std::size_t per_level,
                          std::uint64_t seed, int threads) {
  flips::BeamOptions options;
  options.max_quads = max_quads;
  options.fronts_per_class = per_class;
  options.fronts_per_level = per_level;
  options.seed = seed;
  options.threads = threads;
  return options;
}

}  // namespace

std::vector<canon::Code> three_connected_codes(int max_quads) {
  core::expects(max_quads <= 18, "flips list boundaries of up to 18 quads");
  const int widest = std::max(max_quads + 6, 20);  // 18 misses a boundary of 12 quads
  std::set<canon::Code> known{canon::canonical_form(complex::Quadrangulation::cube()).code};
  std::vector<canon::Code> todo(known.begin(), known.end());
  while (!todo.empty()) {
    const flips::Front front = flips::front_of({todo.back(), {}});
    todo.pop_back();
    flips::for_each_glueable(front, widest, [&](flips::Flip flip, const flips::Prism& prism) {
      const auto next = flips::flipped(front.boundary, flip, prism).quadrangulation;
      const canon::Code code = canon::canonical_form(next).code;
      if (known.insert(code).second) todo.push_back(code);
    });
  }
  constexpr std::array<std::size_t, 7> kNumber{1, 1, 3, 11, 58, 451, 4461};  // A007022(6), (8), ...
  std::array<std::size_t, kNumber.size()> found{};
  std::vector<canon::Code> result;
  for (const canon::Code& code : known)
    if (code.quads <= max_quads) {
      result.push_back(code);
      ++found[static_cast<std::size_t>(code.quads - 6) / 2];
    }
  for (int n = 6; n <= max_quads; n += 2)
    core::ensures(
        found[static_cast<std::size_t>(n - 6) / 2] == kNumber[static_cast<std::size_t>(n - 6) / 2],
        "flips reach every 3-connected even quadrangulation of this size");
  return result;
}

std::vector<Stage> default_stages(std::uint64_t seed, int threads) {
  return {
      {limits(22, 20, 200'000, seed, threads), 72, limits(24, 20, 3'000, seed, threads), 12, false},
      {limits(22, 20, 200'000, seed, threads), 72, limits(24, 30, 60'000, seed, threads), 26, true},
      {limits(24, 200, 3'000'000, seed, threads), 26, limits(24, 200, 300'000, seed, threads), 16,
       false},
  };
}

Generated generate(const std::vector<canon::Code>& boundaries, const std::vector<Stage>& stages,
                   const std::function<void(const Progress&)>& report) {
  Meshes meshes;
  for (std::size_t s = 0; s < stages.size(); ++s)
    run_stage(stages[s], "stage " + std::to_string(s + 1) + " of " + std::to_string(stages.size()),
              boundaries, report, meshes);
  Generated result;
  for (const canon::Code& code : boundaries) {
    const auto mesh = meshes.find(code);
    if (mesh == meshes.end())
      result.without_mesh.push_back(code);
    else
      result.rows.push_back({code, std::move(mesh->second), 1});
  }
  return result;
}

}  // namespace hexatlas::build
