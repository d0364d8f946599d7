#include "meshing/delaunay/builder.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <tuple>

#include "enum/core/checks.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "meshing/delaunay/division.hpp"
#include "meshing/delaunay/parts.hpp"
#include "meshing/delaunay/space_order.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::delaunay {
namespace {

using exact::Point3;
using exact::Sign;

constexpr std::size_t kCellsPerPoint = 7;    // of many points in general position, a little more
constexpr std::size_t kFewPerThread = 500;   // fewer are not worth a pass
constexpr std::size_t kWorthGiving = 16000;  // to a thread that waits: a third is at the new border
constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kKeysPerInsertion = 64;  // in the same time
constexpr std::size_t kSpareCells = 1U << 16;  // for each thread, besides those of its points

bool are_collinear(const Point3& a, const Point3& b, const Point3& c) {
  // In each of three projections, seen from a point that is not in their plane.
  return exact::sign_of_orientation({a.x, a.y, 0}, {b.x, b.y, 0}, {c.x, c.y, 0}, {0, 0, 1}) ==
             Sign::zero &&
         exact::sign_of_orientation({0, a.y, a.z}, {0, b.y, b.z}, {0, c.y, c.z}, {1, 0, 0}) ==
             Sign::zero &&
         exact::sign_of_orientation({a.x, 0, a.z}, {b.x, 0, b.z}, {c.x, 0, c.z}, {0, 1, 0}) ==
             Sign::zero;
}

/// The points that are at the place of another that counts, with the same weight if there are
/// weights. For those that span no space.
std::size_t count_equal(std::span<const mesh::Point> points, std::span<const double> weights) {
  std::vector<std::tuple<double, double, double, double>> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    sorted.emplace_back(points[i].x, points[i].y, points[i].z, weights.empty() ? 0.0 : weights[i]);
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(sorted.end() - std::unique(sorted.begin(), sorted.end()));
}

}  // namespace

template <class Index, bool kIsWeighted>
Builder<Index, kIsWeighted>::Builder(std::span<const mesh::Point> points,
                                     std::span<const double> weights, std::uint64_t seed,
                                     int threads) {
  core::expects(threads >= 1, "at least one thread");
  core::expects(weights.size() == (kIsWeighted ? points.size() : 0), "a weight for each point");
  const std::size_t sites = points.size() + kFirstSite;
  sites_.resize(sites);
  points_.resize(sites);
  claims_.resize(sites);
  if constexpr (kIsWeighted) weights_.resize(sites);
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  sites_[kNone] = sites_[kGhost] = {kNowhere, kNowhere, kNowhere, 0};
  SpaceOrder order = space_order(points, seed, threads);
  std::vector<CommonUnit> units(static_cast<std::size_t>(threads));
  for_each_part(threads, points.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    CommonUnit unit;
    for (std::size_t i = begin; i < end; ++i) {
      const Placed& placed = order.points[i];
      const mesh::Point& p = points[placed.point];
      sites_[i + kFirstSite] = {p.x, p.y, p.z, placed.key};
      unit.include(sites_[i + kFirstSite]);
      points_[i + kFirstSite] = placed.point;
      if constexpr (kIsWeighted) weights_[i + kFirstSite] = weights[placed.point];
    }
    units[part] = unit;
  });
  PlacedList().swap(order.points);  // before the cells come: no memory for both
  curves_ = order.curves;
  for (const CommonUnit& unit : units) unit_.include(unit);
  const Site centre = mean_of_some();
  for (int t = 0; t < threads; ++t) {
    inserters_.emplace_back(cells_, sites_.data(), claims_.data(), weights_.data());
    inserters_.back().walk().look_from(centre);
    inserters_.back().use(unit_);
  }
  std::array<Index, 4> first{};
  if (!find_first_four(first)) {
    duplicates_ = count_equal(points, weights);
    return;
  }
  cells_.reserve(kCellsPerPoint * sites);
  inserters_.front().begin(first);
  insert_rounds(order.rounds, first);
}

/// Inside of the hull.
template <class Index, bool kIsWeighted>
Site Builder<Index, kIsWeighted>::mean_of_some() const noexcept {
  constexpr std::size_t kSome = 64;
  Site mean{};
  for (std::size_t i = 0; i < kSome && points() > 0; ++i) {
    const Site& site = sites_[kFirstSite + i * points() / kSome];
    mean.x += site.x / kSome;
    mean.y += site.y / kSome;
    mean.z += site.z / kSome;
  }
  return mean;
}

/// Sets the dimension.
template <class Index, bool kIsWeighted>
bool Builder<Index, kIsWeighted>::find_first_four(std::array<Index, 4>& first) {
  const auto at = [&](Index s) { return sites_[s].point(); };
  const auto end = static_cast<Index>(points_.size());
  std::size_t found = 0;
  for (Index s = kFirstSite; s < end && found < 4; ++s) {
    const bool is_independent =
        found == 0 || (found == 1 && !sites_[s].is_at(sites_[first[0]])) ||
        (found == 2 && !are_collinear(at(first[0]), at(first[1]), at(s))) ||
        (found == 3 &&
         exact::sign_of_orientation(at(first[0]), at(first[1]), at(first[2]), at(s)) != Sign::zero);
    if (is_independent) first[found++] = s;
  }
  dimension_ = static_cast<int>(found) - 1;
  if (found < 4) return false;
  if (exact::sign_of_orientation(at(first[0]), at(first[1]), at(first[2]), at(first[3])) ==
      Sign::negative)
    std::swap(first[0], first[1]);
  return true;
}

template <class Index, bool kIsWeighted>
void Builder<Index, kIsWeighted>::insert_rounds(std::span<const std::size_t> rounds,
                                                const std::array<Index, 4>& first) {
  for (std::size_t r = 0; r + 1 < rounds.size(); ++r) {
    use_curve(0, rounds[r] + kFirstSite);
    std::vector<Index> sites;
    sites.reserve(rounds[r + 1] - rounds[r]);
    for (std::size_t i = rounds[r]; i < rounds[r + 1]; ++i)
      if (const auto s = static_cast<Index>(i + kFirstSite);
          std::find(first.begin(), first.end(), s) == first.end())
        sites.push_back(s);
    if (inserters_.size() == 1)
      insert_here(sites);
    else
      insert_in_parts(std::move(sites), rounds[r + 1] + kFirstSite);
  }
}

template <class Index, bool kIsWeighted>
void Builder<Index, kIsWeighted>::insert_here(std::span<const Index> sites) {
  for (const Index s : sites)
    if (inserter().insert(s) == Outcome::duplicate) note_duplicate(s, inserter().twin());
}

/// Of sites before `end`. Ends: a pass that inserts less than one of as many sites as there are
/// threads is the last. With two threads further passes cut the same curve elsewhere, since most
/// of a border is then inside; with more they need another curve, which costs a look at all sites.
template <class Index, bool kIsWeighted>
void Builder<Index, kIsWeighted>::insert_in_parts(std::vector<Index> pending, std::size_t end) {
  const std::size_t threads = inserters_.size();
  const unsigned passes_per_curve = threads == 2 ? 3 : 1;
  std::vector<std::uint64_t> cuts;  // of two passes
  bool is_worth_it = true;
  for (unsigned pass = 0; is_worth_it && pending.size() >= kFewPerThread * threads; ++pass) {
    const unsigned curve = pass / passes_per_curve, on_curve = pass % passes_per_curve;
    if (curve > 0 && kKeysPerInsertion * (threads - 1) * pending.size() < end) break;
    if (on_curve == 0) {
      use_curve(curve, end);
      if (curve > 0) sort_by_keys(pending);
    }
    const Division<Index> division(sites_.data(), curves_.key_bits(curve_), pending);
    if (on_curve == 0) cuts = division.cuts(threads);
    cells_.reserve(cells_.size() + kCellsPerPoint * pending.size() + kSpareCells * threads);
    auto stretches = on_curve < 2
                         ? division.between(std::span(cuts).subspan(on_curve * threads, threads))
                         : division.crosswise();
    // Given away in a later pass, the sites of a border that is within now would be at one.
    std::vector<Index> left = inserted(std::move(stretches), on_curve == 0 ? kWorthGiving : kNever);
    is_worth_it = left.size() <= pending.size() - pending.size() / threads;
    pending = std::move(left);
  }
  insert_here(pending);
}

/// For the keys of the sites before `end`.
template <class Index, bool kIsWeighted>
void Builder<Index, kIsWeighted>::use_curve(unsigned curve, std::size_t end) {
  if (curve == curve_) return;
  const std::size_t count = end - kFirstSite;
  for_each_part(static_cast<int>(inserters_.size()), count,
                [&](std::size_t, std::size_t from, std::size_t to) {
                  for (std::size_t i = from; i < to; ++i) {
                    Site& site = sites_[i + kFirstSite];
                    site.key = curves_.key_of({site.x, site.y, site.z}, curve);
                  }
                });
  curve_ = curve;
}

template <class Index, bool kIsWeighted>
void Builder<Index, kIsWeighted>::sort_by_keys(std::vector<Index>& pending) const {
  PlacedList placed;
  placed.reserve(pending.size());
  for (const Index s : pending) placed.push_back({sites_[s].key, static_cast<std::uint32_t>(s)});
  sort_by_key(placed, curves_.key_bits(curve_), static_cast<int>(inserters_.size()));
  for (std::size_t i = 0; i < placed.size(); ++i) pending[i] = placed[i].point;
}

/// The sites that were not inserted, by ascending keys again unless the stretches are crosswise.
template <class Index, bool kIsWeighted>
std::vector<Index> Builder<Index, kIsWeighted>::inserted(std::vector<Stretch<Index>> stretches,
                                                         std::size_t worth_giving) {
  for (auto& [region, sites, start] : stretches)
    start = inserter().walk().cell_within(region, sites);
  Index in_use = inserter().walk().start();
  Handover<Index> handover;
  std::deque<Worker<Index, kIsWeighted>> workers;
  for (auto& each : inserters_) workers.emplace_back(each, sites_.data(), handover, worth_giving);
  parallel::parallel_for(static_cast<int>(workers.size()), workers.size(), [&](std::size_t t) {
    typename Handover<Index>::Seat seat(handover);
    workers[t].work(stretches[t], seat);
  });
  using Piece = typename Worker<Index, kIsWeighted>::Piece;
  std::vector<const Piece*> pieces;
  for (std::size_t t = 0; t < workers.size(); ++t) {
    if (workers[t].has_inserted()) in_use = inserters_[t].walk().start();
    for (const Piece& piece : workers[t].pieces()) pieces.push_back(&piece);
    for (const auto& [site, twin] : workers[t].duplicates()) note_duplicate(site, twin);
  }
  inserter().walk().start_at(in_use);
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece* a, const Piece* b) { return a->first < b->first; });
  std::vector<Index> left;
  for (const Piece* piece : pieces) left.insert(left.end(), piece->left.begin(), piece->left.end());
  const auto has_less = [&](Index a, Index b) {
    return std::pair(sites_[a].key, a) < std::pair(sites_[b].key, b);
  };
  std::rotate(left.begin(), std::is_sorted_until(left.begin(), left.end(), has_less), left.end());
  return left;
}

template <class Index, bool kIsWeighted>
typename Builder<Index, kIsWeighted>::Added Builder<Index, kIsWeighted>::add(
    const mesh::Point& point, double weight) {
  core::expects(dimension_ == 3, "the points so far span space");
  core::expects(mesh::is_finite(point), "finite coordinates");
  core::expects(kIsWeighted ? std::isfinite(weight) : weight == 0, "a finite weight, if any");
  const std::size_t site = points_.size();
  if (site == sites_.capacity()) sites_.resize(site + site / 4 + 1);
  sites_[site] = {point.x, point.y, point.z, 0};
  points_.push_back(static_cast<mesh::Index>(site - kFirstSite));
  claims_.push_back({});
  if constexpr (kIsWeighted) weights_.push_back(weight);
  sites_of_points_.clear();
  inserter().use(sites_.data(), claims_.data(), weights_.data());
  unit_.include(sites_[site]);
  inserter().use(unit_);
  const auto added = static_cast<Index>(site);
  const Outcome outcome = inserter().insert(added);
  if (outcome == Outcome::duplicate) {
    note_duplicate(added, inserter().twin());
    return {outcome, inserter().twin()};
  }
  return {outcome, outcome == Outcome::hidden ? Index{kNone} : added};
}

/// The vertex is called by the least number of the points at its place, whichever came first.
template <class Index, bool kIsWeighted>
void Builder<Index, kIsWeighted>::note_duplicate(Index site, Index twin) {
  if constexpr (kIsWeighted)
    twins_.emplace_back(site, twin);
  else
    ++duplicates_;
  if (points_[site] < points_[twin]) std::swap(points_[site], points_[twin]);
}

/// By sites.
template <class Index, bool kIsWeighted>
std::vector<bool> Builder<Index, kIsWeighted>::vertices() const {
  std::vector<bool> result(points_.size());
  for (std::size_t c = 1; c < cells_.size(); ++c)
    if (const auto& cell = cells_[static_cast<Index>(c)]; cell.is_used())
      for (const Index v : cell.vertices) result[v] = true;
  return result;
}

/// A vertex may have been hidden since it was met again.
template <class Index, bool kIsWeighted>
std::size_t Builder<Index, kIsWeighted>::duplicates() const {
  if (!kIsWeighted || dimension_ < 3) return duplicates_;
  const std::vector<bool> is_vertex = vertices();
  return static_cast<std::size_t>(std::count_if(
      twins_.begin(), twins_.end(), [&](const auto& twins) { return is_vertex[twins.second]; }));
}

template <class Index, bool kIsWeighted>
std::vector<mesh::Index> Builder<Index, kIsWeighted>::hidden() const {
  std::vector<mesh::Index> result;
  if (!kIsWeighted) return result;
  const std::vector<bool> is_vertex = vertices();
  std::vector<bool> is_seen = is_vertex;
  for (const auto& [site, twin] : twins_) is_seen[site] = is_vertex[twin];
  for (std::size_t s = kFirstSite; s < points_.size(); ++s)
    if (!is_seen[s]) result.push_back(points_[s]);
  std::sort(result.begin(), result.end());
  return result;
}

template <class Index, bool kIsWeighted>
Index Builder<Index, kIsWeighted>::site_of(mesh::Index point) {
  if (sites_of_points_.empty()) {
    sites_of_points_.resize(points());
    for (std::size_t s = kFirstSite; s < points_.size(); ++s)
      sites_of_points_[points_[s]] = static_cast<Index>(s);
  }
  return sites_of_points_[point];
}

template <class Index, bool kIsWeighted>
std::size_t Builder<Index, kIsWeighted>::refine(const Wish& wish, std::size_t most) {
  const auto wish_for = [&](Index c) -> std::optional<mesh::Point> {
    const Cell<Index>& cell = cells_[c];
    if (!cell.is_tetrahedron()) return std::nullopt;
    std::array<mesh::Point, 4> corners{};
    for (unsigned i = 0; i < 4; ++i) {
      const Site& site = sites_[cell.vertices[i]];
      corners[i] = {site.x, site.y, site.z};
    }
    return wish(corners);
  };
  std::vector<Index> waiting(cells_.size());
  std::iota(waiting.rbegin(), waiting.rend(), Index{0});
  std::size_t inserted = 0;
  while (!waiting.empty() && inserted < most) {
    const Index cell = waiting.back();
    waiting.pop_back();
    const std::optional<mesh::Point> place = wish_for(cell);
    if (!place) continue;
    inserter().walk().start_at(cell);
    if (add(*place, 0).outcome != Outcome::inserted) continue;
    ++inserted;
    const auto made = inserter().made();
    waiting.insert(waiting.end(), made.begin(), made.end());
  }
  return inserted;
}

template <class Index, bool kIsWeighted>
std::size_t Builder<Index, kIsWeighted>::bytes() const noexcept {
  return cells_.bytes() +
         points_.size() * (sizeof(Site) + sizeof(mesh::Index) + sizeof(claims_.front())) +
         weights_.size() * sizeof(double);
}

template class Builder<std::uint32_t, false>;
template class Builder<std::uint64_t, false>;
template class Builder<std::uint32_t, true>;
template class Builder<std::uint64_t, true>;

}  // namespace hexatlas::delaunay
