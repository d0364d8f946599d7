#include "meshing/delaunay/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "enum/core/checks.hpp"
#include "meshing/delaunay/builder.hpp"

namespace hexatlas::delaunay {
namespace {

using Tetrahedron = Triangulation::Tetrahedron;

/// With the vertex at position i first, right-handed as before.
Tetrahedron beginning_with(const Tetrahedron& t, unsigned i) {
  return {t[i], t[i ^ 1U], t[i ^ 2U], t[i ^ 3U]};
}

Tetrahedron in_order(const Tetrahedron& t) {
  const auto first = std::min_element(t.begin(), t.end()) - t.begin();
  Tetrahedron result = beginning_with(t, static_cast<unsigned>(first));
  std::rotate(result.begin() + 1, std::min_element(result.begin() + 1, result.end()), result.end());
  return result;
}

template <class Index, bool kIsWeighted>
Tetrahedron with_points(const Builder<Index, kIsWeighted>& builder, const Cell<Index>& cell) {
  Tetrahedron result{};
  for (unsigned i = 0; i < 4; ++i) result[i] = builder.point_of(cell.vertices[i]);
  return result;
}

template <class Index, bool kIsWeighted, class Visit>
void for_each_tetrahedron(const Builder<Index, kIsWeighted>& builder, Visit&& visit) {
  if (builder.dimension() < 3) return;
  for (std::size_t c = 1; c < builder.cells().size(); ++c)
    if (const auto& cell = builder.cells()[static_cast<Index>(c)]; cell.is_tetrahedron())
      visit(cell);
}

/// By the first vertex, in linear time; then those few that share it.
void sort(std::vector<Tetrahedron>& tetrahedra, std::size_t points) {
  std::vector<std::size_t> begins(points + 1);
  for (const Tetrahedron& t : tetrahedra) ++begins[t[0] + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<std::array<mesh::Index, 3>> others(tetrahedra.size());
  std::vector<std::size_t> ends(begins.begin(), begins.end() - 1);
  for (const Tetrahedron& t : tetrahedra) others[ends[t[0]]++] = {t[1], t[2], t[3]};
  for (std::size_t p = 0; p < points; ++p) {
    const auto at = [&](std::size_t i) { return others.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(begins[p]), at(begins[p + 1]));
    for (std::size_t i = begins[p]; i < begins[p + 1]; ++i)
      tetrahedra[i] = {static_cast<mesh::Index>(p), others[i][0], others[i][1], others[i][2]};
  }
}

Site site_at(const mesh::Point& p) { return {p.x, p.y, p.z, 0}; }

bool needs_long(std::size_t points, References references) {
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max() / 4 / 8;
  return references == References::long_ || (references == References::automatic && points > kMost);
}

void expect_points(std::span<const mesh::Point> points) {
  core::expects(points.size() < std::numeric_limits<mesh::Index>::max() - 1,
                "fewer than 2^32 - 2 points");
  core::expects(std::all_of(points.begin(), points.end(), mesh::is_finite), "finite coordinates");
}

/// For any alternative of the variant.
template <bool kIsWeighted, class Variant>
void build(Variant& builder, std::span<const mesh::Point> points, std::span<const double> weights,
           const Options& options) {
  expect_points(points);
  if (needs_long(points.size(), options.references))
    builder = std::make_unique<Builder<std::uint64_t, kIsWeighted>>(points, weights, options.seed,
                                                                    options.threads);
  else
    builder = std::make_unique<Builder<std::uint32_t, kIsWeighted>>(points, weights, options.seed,
                                                                    options.threads);
}

}  // namespace

Triangulation::Triangulation(std::span<const mesh::Point> points, const Options& options) {
  build<false>(builder_, points, {}, options);
}

Triangulation::Triangulation(std::span<const mesh::Point> points, std::span<const double> weights,
                             const Options& options) {
  core::expects(
      std::all_of(weights.begin(), weights.end(), [](double w) { return std::isfinite(w); }),
      "finite weights");
  build<true>(builder_, points, weights, options);
}

Triangulation::Triangulation(Triangulation&&) noexcept = default;
Triangulation& Triangulation::operator=(Triangulation&&) noexcept = default;
Triangulation::~Triangulation() = default;

int Triangulation::dimension() const noexcept {
  return std::visit([](const auto& b) { return b->dimension(); }, builder_);
}

bool Triangulation::is_weighted() const noexcept {
  return std::visit([](const auto& b) { return b->is_weighted(); }, builder_);
}

std::size_t Triangulation::points() const noexcept {
  return std::visit([](const auto& b) { return b->points(); }, builder_);
}

std::size_t Triangulation::duplicates() const {
  return std::visit([](const auto& b) { return b->duplicates(); }, builder_);
}

std::vector<Triangulation::Index> Triangulation::hidden() const {
  core::expects(dimension() == 3, "tetrahedra");
  return std::visit([](const auto& b) { return b->hidden(); }, builder_);
}

std::size_t Triangulation::bytes() const noexcept {
  return std::visit([](const auto& b) { return b->bytes(); }, builder_);
}

std::size_t Triangulation::size() const {
  std::size_t count = 0;
  std::visit([&](const auto& b) { for_each_tetrahedron(*b, [&](const auto&) { ++count; }); },
             builder_);
  return count;
}

std::vector<Tetrahedron> Triangulation::tetrahedra() const {
  std::vector<Tetrahedron> result;
  result.reserve(size());
  std::visit(
      [&](const auto& b) {
        for_each_tetrahedron(
            *b, [&](const auto& cell) { result.push_back(in_order(with_points(*b, cell))); });
      },
      builder_);
  sort(result, points());
  return result;
}

std::optional<Tetrahedron> Triangulation::located(const mesh::Point& place) {
  core::expects(dimension() == 3 && mesh::is_finite(place), "a place, and tetrahedra");
  return std::visit(
      [&](auto& b) -> std::optional<Tetrahedron> {
        const auto& cell = b->cells()[b->inserter().walk().located(site_at(place))];
        if (cell.ghost() < 4) return std::nullopt;
        return with_points(*b, cell);
      },
      builder_);
}

std::vector<Tetrahedron> Triangulation::star(Index point) {
  core::expects(dimension() == 3 && point < points(), "a point, and tetrahedra");
  return std::visit(
      [&](auto& b) {
        std::vector<Tetrahedron> result;
        b->for_each_around(point, [&](const auto& cell, unsigned i) {
          if (cell.ghost() == 4) result.push_back(beginning_with(with_points(*b, cell), i));
        });
        return result;
      },
      builder_);
}

Triangulation::Index Triangulation::insert(const mesh::Point& place) {
  core::expects(!is_weighted(), "no weights");
  return std::visit([&](auto& b) { return b->point_of(b->add(place, 0).vertex); }, builder_);
}

std::optional<Triangulation::Index> Triangulation::insert(const mesh::Point& place, double weight) {
  core::expects(is_weighted(), "weights");
  return std::visit(
      [&](auto& b) -> std::optional<Index> {
        const auto added = b->add(place, weight);
        if (added.outcome == Outcome::hidden) return std::nullopt;
        return b->point_of(added.vertex);
      },
      builder_);
}

std::size_t Triangulation::refine(const Wish& wish, std::size_t most) {
  core::expects(dimension() == 3, "tetrahedra");
  return std::visit([&](auto& b) { return b->refine(wish, most); }, builder_);
}

}  // namespace hexatlas::delaunay
