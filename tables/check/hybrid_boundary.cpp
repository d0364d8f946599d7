// Whether two boundaries are the same, a quad standing for two triangles.
#include <algorithm>

#include "tables/check/hybrid_laws.hpp"
#include "tables/check/incidence.hpp"

namespace hexatlas::check {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Numbers of places in space: equal for equal coordinates, -0 being 0.
class Places {
 public:
  Places(const std::vector<Point>& a, const std::vector<Point>& b) {
    all_.reserve(a.size() + b.size());
    all_.insert(all_.end(), a.begin(), a.end());
    all_.insert(all_.end(), b.begin(), b.end());
    std::sort(all_.begin(), all_.end());
    all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
  }
  [[nodiscard]] std::uint32_t of(const Point& point) const {
    return static_cast<std::uint32_t>(std::lower_bound(all_.begin(), all_.end(), point) -
                                      all_.begin());
  }
  [[nodiscard]] const Point& operator[](std::uint32_t place) const { return all_[place]; }

 private:
  std::vector<Point> all_;
};

/// Triangles up to rotation, each as often as it occurs.
class TriangleBag {
 public:
  void add(const Triangle& triangle) { sorted_.push_back(least_first(triangle)); }
  void finish() {
    std::sort(sorted_.begin(), sorted_.end());
    taken_.assign(sorted_.size(), false);
  }
  /// One that was not taken before; the number of all if there is none.
  [[nodiscard]] std::size_t find(const Triangle& triangle) const {
    const Triangle wanted = least_first(triangle);
    auto at = static_cast<std::size_t>(std::lower_bound(sorted_.begin(), sorted_.end(), wanted) -
                                       sorted_.begin());
    while (at < sorted_.size() && sorted_[at] == wanted && taken_[at]) ++at;
    return at < sorted_.size() && sorted_[at] == wanted ? at : sorted_.size();
  }
  [[nodiscard]] bool take(const Triangle& triangle) {
    const std::size_t at = find(triangle);
    if (at == sorted_.size()) return false;
    taken_[at] = true;
    return true;
  }
  /// Both or none.
  [[nodiscard]] bool take(const Triangle& a, const Triangle& b) {
    return find(a) != sorted_.size() && find(b) != sorted_.size() && take(a) && take(b);
  }
  [[nodiscard]] const Triangle* left() const {
    const auto at = std::find(taken_.begin(), taken_.end(), false);
    return at == taken_.end() ? nullptr : &sorted_[static_cast<std::size_t>(at - taken_.begin())];
  }

 private:
  static Triangle least_first(Triangle triangle) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    return triangle;
  }

  std::vector<Triangle> sorted_;
  std::vector<bool> taken_;
};

std::string text_of(const FacetCycle& cycle) {
  return (size_of(cycle) == 3 ? "triangle " : "quad ") +
         listed(std::span(cycle).first(size_of(cycle)));
}

}  // namespace

HybridFinding check_given_boundary(const std::vector<FacetCycle>& boundary,
                                   const std::vector<Point>& points,
                                   const std::vector<FacetCycle>& triangles,
                                   const std::vector<Point>& given_points) {
  const Places places(points, given_points);
  TriangleBag given;
  for (const FacetCycle& cycle : triangles) {
    given.add({places.of(given_points[cycle[0]]), places.of(given_points[cycle[1]]),
               places.of(given_points[cycle[2]])});
  }
  given.finish();
  // Triangles first: they have no choice.
  for (const std::size_t size : {3U, 4U}) {
    for (const FacetCycle& cycle : boundary) {
      if (size_of(cycle) != size) continue;
      std::array<std::uint32_t, 4> at{};
      for (std::size_t i = 0; i < size; ++i) at[i] = places.of(points[cycle[i]]);
      const bool is_there = size == 3
                                ? given.take({at[0], at[1], at[2]})
                                : given.take({at[0], at[1], at[2]}, {at[0], at[2], at[3]}) ||
                                      given.take({at[0], at[1], at[3]}, {at[1], at[2], at[3]});
      if (is_there) continue;
      return HybridFailure{HybridLaw::kGivenBoundary,
                           "boundary " + text_of(cycle) +
                               (size == 3 ? " is no boundary triangle of the given mesh"
                                          : " is no pair of boundary triangles of the given mesh")};
    }
  }
  const Triangle* const left = given.left();
  if (left == nullptr) return std::nullopt;
  std::string text;
  for (const std::uint32_t place : *left) {
    text += text.empty() ? "" : ", ";
    text += listed(places[place]);
  }
  return HybridFailure{HybridLaw::kGivenBoundary, "the boundary triangle of the given mesh at " +
                                                      text + " is not on the boundary"};
}

}  // namespace hexatlas::check
