#include "tables/check/rooted_count.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "tables/check/wide.hpp"

namespace hexatlas::check {

namespace {

/// A power series without its terms above one degree; all have the same number of coefficients.
using Series = std::vector<Wide>;

Wide plus(Wide a, Wide b) {
  Wide sum = 0;
  if (__builtin_add_overflow(a, b, &sum)) throw std::overflow_error("a count is too large");
  return sum;
}

Wide times(Wide a, Wide b) {
  Wide product = 0;
  if (__builtin_mul_overflow(a, b, &product)) throw std::overflow_error("a count is too large");
  return product;
}

void add(Series& to, const Series& series, Wide factor = 1) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = plus(to[i], times(factor, series[i]));
}

Series product(const Series& a, const Series& b) {
  Series result(a.size(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == 0) continue;
    for (std::size_t j = 0; i + j < a.size(); ++j) {
      result[i + j] = plus(result[i + j], times(a[i], b[j]));
    }
  }
  return result;
}

/// 1 / (1 - a). Requires: a has no constant term.
Series geometric(const Series& a) {
  Series result(a.size(), 0);
  result[0] = 1;
  for (std::size_t m = 1; m < a.size(); ++m) {
    for (std::size_t i = 1; i <= m; ++i) result[m] = plus(result[m], times(a[i], result[m - i]));
  }
  return result;
}

/// outer(inner). Requires: neither has a constant term.
Series substituted(const Series& outer, const Series& inner) {
  Series result(inner.size(), 0);
  for (std::size_t j = outer.size(); j-- > 1;) {
    result[0] = plus(result[0], outer[j]);
    result = product(result, inner);
  }
  return result;
}

/// Networks: rooted simple quadrangulations, less the quad of the root. Of n quads there are
/// 2 (3k)! / ((2k+1)! (k+1)!) with k = n - 1.
Series networks(std::size_t terms) {
  Series series(terms, 0);
  Wide count = 1;
  for (std::size_t k = 1; k < terms; ++k) {
    series[k] = count;
    const auto m = static_cast<Wide>(k);
    count = times(count, times(3 * m + 3, times(3 * m + 2, 3 * m + 1)));
    count /= (2 * m + 3) * (2 * m + 2) * (m + 2);
  }
  return series;
}

/// h in D = z + 2 D^2 / (1 + D) + h(D): one term after the other, as D^m begins with z^m.
Series cores(const Series& network) {
  Series negated(network.size(), 0);
  add(negated, network, -1);
  Series rest = network;
  rest[1] -= 1;
  add(rest, product(product(network, network), geometric(negated)), -2);
  Series core(network.size(), 0);
  Series power = network;
  for (std::size_t m = 1; m < network.size(); ++m) {
    core[m] = rest[m];
    add(rest, power, -core[m]);
    power = product(power, network);
  }
  return core;
}

}  // namespace

std::vector<std::uint64_t> rooted_three_connected(std::uint32_t most_quads) {
  const std::size_t terms = std::max<std::size_t>(most_quads + 1, 2);
  const Series core = cores(networks(terms));
  Series one_quad(terms, 0);
  one_quad[1] = 1;
  Series parts(terms, 0);                                // A
  Series with_core(terms, 0);                            // H
  Series without_quad(terms, 0);                         // A^2 / (1 - A)
  for (std::size_t round = 0; round < terms; ++round) {  // each settles one more term
    const Series repeated = geometric(parts);
    without_quad = product(product(parts, parts), repeated);
    Series with_one_quad = product(repeated, repeated);
    with_one_quad[0] -= 1;
    Series in_series = product(one_quad, with_one_quad);
    add(in_series, without_quad);
    Series all = one_quad;
    add(all, in_series, 2);
    add(all, with_core);
    with_core = substituted(core, all);
    parts = in_series;
    add(parts, with_core);
  }
  add(with_core, without_quad, 2);
  std::vector<std::uint64_t> counts(most_quads + 1, 0);
  for (std::size_t n = 1; n < counts.size(); ++n) {
    counts[n] = static_cast<std::uint64_t>(with_core[n - 1]);
  }
  return counts;
}

}  // namespace hexatlas::check
