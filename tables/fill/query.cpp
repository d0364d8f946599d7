#include "tables/fill/query.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/flips/cut.hpp"
#include "enum/flips/meeting.hpp"
#include "tables/fill/filled.hpp"

namespace hexatlas::fill {
namespace {

class TableBalls final : public flips::BallSource {
 public:
  explicit TableBalls(const format::Table& table) : table_(table) {}

  [[nodiscard]] std::optional<int> least_with(const canon::Code& boundary) const override {
    const auto ordinal = table_.find(boundary);
    if (!ordinal) return std::nullopt;
    return static_cast<int>(table_.entry(*ordinal).hexahedra);
  }
  [[nodiscard]] std::vector<flips::KnownBall> balls_with(
      const canon::Code& boundary) const override {
    const auto ordinal = table_.find(boundary);
    if (!ordinal) return {};
    const complex::HexComplex mesh = table_.mesh(*ordinal);
    return {{static_cast<int>(mesh.hexahedra.size()),
             flips::scars_of(mesh, canon::decode(boundary).value())}};
  }

  [[nodiscard]] flips::Layers layers_of(const canon::Code& boundary,
                                        std::size_t /*the only one*/) const override {
    complex::HexComplex mesh = mesh_in(table_, table_.find(boundary).value(), table_.path());
    flips::Layers layers;
    // A record takes hexahedra off; layers are put on.
    std::reverse(mesh.hexahedra.begin(), mesh.hexahedra.end());
    layers.hexahedra = std::move(mesh.hexahedra);
    layers.vertices = mesh.vertices;
    layers.rim.resize(static_cast<std::size_t>(boundary.quads) + 2);
    std::iota(layers.rim.begin(), layers.rim.end(), 0U);
    return layers;
  }

 private:
  const format::Table& table_;
};

}  // namespace

std::optional<complex::HexComplex> fill_through(const format::Table& table,
                                                const canon::Code& boundary,
                                                const QueryOptions& options) {
  core::expects(boundary.quads % 2 == 0 && boundary.quads <= flips::kMaxSearchQuads,
                "a query has an even number of at most 26 quads");
  const TableBalls balls(table);
  std::optional<complex::HexComplex> mesh;
  if (options.apart.size() == 0) mesh = flips::best_cut(balls, boundary, {});
  flips::MeetingOptions meeting;
  if (mesh) meeting.below = static_cast<int>(mesh->hexahedra.size());
  meeting.max_collar = options.max_collar;
  meeting.first = true;
  meeting.apart = options.apart;
  meeting.collars.max_quads = flips::kMaxSearchQuads;  // some have no flip that adds less than 4
  meeting.collars.fronts_per_level = options.collars_per_level;
  meeting.collars.seed = options.seed;
  meeting.collars.threads = options.threads;
  if (auto filling = flips::best_meeting(balls, boundary, meeting)) mesh = std::move(filling->mesh);
  if (mesh) ensure_fills(*mesh, boundary);
  return mesh;
}

}  // namespace hexatlas::fill
