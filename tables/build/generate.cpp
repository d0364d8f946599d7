#include "tables/build/generate.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "enum/core/checks.hpp"
#include "enum/flips/meeting.hpp"

namespace hexatlas::build {
namespace {

complex::BoundaryQuad from_least(complex::BoundaryQuad quad) {
  std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
  return quad;
}

/// A mesh leaves the search only if it obeys the laws and has the boundary asked for.
void ensure_fills(const complex::HexComplex& mesh, const canon::Code& code) {
  if (const auto law = complex::validate(mesh))
    throw core::InternalError("a mesh found for " + canon::to_text(code) +
                              " breaks a law: " + law->reason);
  std::set<complex::BoundaryQuad> wanted, got;
  const auto boundary = canon::decode(code).value();
  for (int q = 0; q < boundary.quads(); ++q) {
    const auto v = boundary.vertices_of(q);
    wanted.insert(from_least({v[0], v[1], v[2], v[3]}));
  }
  for (const auto& quad : complex::boundary_of(mesh)) got.insert(from_least(quad));
  core::ensures(wanted == got, "a mesh found has the boundary it was found for");
}

flips::Beam grow_balls(const GenerateOptions& options,
                       const std::function<void(const Progress&)>& report) {
  const auto total = static_cast<std::size_t>(options.max_ball);
  flips::Beam balls(flips::canonical_state(flips::single_hexahedron()).state, options.balls);
  while (balls.level() + 1 < options.max_ball) {
    report({"growing balls", static_cast<std::size_t>(balls.level()) + 1, total});
    if (balls.expand_level() == 0) break;
  }
  report({"growing balls", total, total});
  return balls;
}

using Meshes = std::map<canon::Code, complex::HexComplex>;

void try_round(const flips::Beam& balls, const canon::Code& code, const CollarRound& round,
               const GenerateOptions& options, Meshes& meshes) {
  flips::MeetingOptions meeting;
  meeting.collars = options.balls;
  meeting.collars.max_quads = round.max_quads;
  meeting.collars.fronts_per_class = round.fronts_per_class;
  meeting.collars.fronts_per_level = round.fronts_per_level;
  meeting.max_collar = round.max_collar;
  const auto known = meshes.find(code);
  if (known != meshes.end()) meeting.below = static_cast<int>(known->second.hexahedra.size());
  if (auto filling = flips::best_meeting(balls, code, meeting)) {
    ensure_fills(filling->mesh, code);
    meshes[code] = std::move(filling->mesh);
  }
}

}  // namespace

std::vector<canon::Code> three_connected_codes(int max_quads) {
  core::expects(max_quads <= 18, "flips list boundaries of up to 18 quads");
  std::set<canon::Code> known{canon::canonical_form(complex::Quadrangulation::cube()).code};
  std::vector<canon::Code> todo(known.begin(), known.end());
  while (!todo.empty()) {
    const flips::Front front = flips::front_of({todo.back(), {}});
    todo.pop_back();
    flips::for_each_glueable(
        front, max_quads + 6, [&](flips::Flip flip, const flips::Prism& prism) {
          const auto next = flips::flipped(front.boundary, flip, prism).quadrangulation;
          const canon::Code code = canon::canonical_form(next).code;
          if (known.insert(code).second) todo.push_back(code);
        });
  }
  std::vector<canon::Code> result;
  for (const canon::Code& code : known)
    if (code.quads <= max_quads) result.push_back(code);
  return result;
}

GenerateOptions default_generate_options() {
  GenerateOptions options;
  options.balls.max_quads = 22;
  options.balls.fronts_per_class = 20;
  options.balls.fronts_per_level = 200'000;
  options.max_ball = 56;
  options.rounds = {{10, 22, 20, 3'000}, {16, 22, 20, 10'000}, {20, 24, 20, 20'000}};
  return options;
}

Generated generate(const std::vector<canon::Code>& boundaries, const GenerateOptions& options,
                   const std::function<void(const Progress&)>& report) {
  const flips::Beam balls = grow_balls(options, report);
  Meshes meshes;
  for (std::size_t r = 0; r < options.rounds.size(); ++r) {
    std::vector<canon::Code> todo;
    for (const canon::Code& code : boundaries)
      if (r < options.rounds_for_all || !meshes.contains(code)) todo.push_back(code);
    const std::string phase = "collars, round " + std::to_string(r + 1);
    for (std::size_t i = 0; i < todo.size(); ++i) {
      report({phase, i, todo.size()});
      try_round(balls, todo[i], options.rounds[r], options, meshes);
    }
    report({phase, todo.size(), todo.size()});
  }
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
