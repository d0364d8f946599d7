#pragma once
/// \file
/// Private to meshing/delaunay: how a closed curve is divided among threads.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/delaunay/handover.hpp"
#include "meshing/delaunay/region.hpp"
#include "meshing/delaunay/site.hpp"

namespace hexatlas::delaunay {

/// Of pending sites by ascending keys, which it reorders. Starts are left open.
template <class Index>
class Division {
 public:
  Division(const Site* sites, unsigned key_bits, std::vector<Index>& pending)
      : sites_(sites), keys_(std::uint64_t{1} << key_bits), pending_(pending) {}

  /// The keys that part the curve into as many stretches as there are threads, with as many sites
  /// each; then those in the middle between them.
  [[nodiscard]] std::vector<std::uint64_t> cuts(std::size_t threads) const;
  /// What lies between the cuts. Each stretch has its sites in the order of the curve.
  [[nodiscard]] std::vector<Stretch<Index>> between(std::span<const std::uint64_t> cuts) const;
  /// For two threads: two opposite quarters of the curve each. If the points are evenly spread, all
  /// of the former borders that met in one line are now cut only in one place.
  [[nodiscard]] std::vector<Stretch<Index>> crosswise() const;

 private:
  const Site* sites_;
  std::uint64_t keys_;
  std::vector<Index>& pending_;
};

template <class Index>
std::vector<std::uint64_t> Division<Index>::cuts(std::size_t threads) const {
  std::vector<std::uint64_t> result;
  for (const std::size_t first : {0U, 1U})
    for (std::size_t half = first; half < 2 * threads; half += 2)
      result.push_back(sites_[pending_[half * pending_.size() / (2 * threads)]].key);
  return result;
}

template <class Index>
std::vector<Stretch<Index>> Division<Index>::between(std::span<const std::uint64_t> cuts) const {
  std::vector<std::size_t> begins;
  for (const std::uint64_t cut : cuts) {
    const auto has_less = [&](Index s, std::uint64_t key) { return sites_[s].key < key; };
    const auto begin = std::lower_bound(pending_.begin(), pending_.end(), cut, has_less);
    begins.push_back(static_cast<std::size_t>(begin - pending_.begin()));
  }
  const std::size_t first = begins.front();
  const auto place = [&](std::size_t i) {
    return pending_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::rotate(place(0), place(first), pending_.end());
  begins.push_back(first + pending_.size());
  std::vector<Stretch<Index>> result(cuts.size());
  for (std::size_t t = 0; t < cuts.size(); ++t) {
    result[t].sites =
        std::span<const Index>(pending_).subspan(begins[t] - first, begins[t + 1] - begins[t]);
    // The last region goes on to the first cut: all keys, if there is but one.
    const std::uint64_t length =
        t + 1 < cuts.size() ? cuts[t + 1] - cuts[t] : ((cuts[0] - cuts[t] - 1) & (keys_ - 1)) + 1;
    result[t].region = {cuts[t], length, keys_ - 1};
  }
  return result;
}

template <class Index>
std::vector<Stretch<Index>> Division<Index>::crosswise() const {
  // Opposite keys count as the same: on a circle of half as many a quarter is a half.
  const Region one{keys_ / 8, keys_ / 4, keys_ / 2 - 1};
  const Region other{keys_ / 8 * 3, keys_ / 4, keys_ / 2 - 1};
  const auto middle = std::stable_partition(pending_.begin(), pending_.end(),
                                            [&](Index s) { return one.has(sites_[s]); });
  const auto first = static_cast<std::size_t>(middle - pending_.begin());
  const std::span<const Index> all(pending_);
  return {{one, all.first(first)}, {other, all.subspan(first)}};
}

}  // namespace hexatlas::delaunay
