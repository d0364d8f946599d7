#include "enum/complex/brown.hpp"

#include <cstddef>
#include <optional>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::complex {
namespace {

/// The form on what remains of a basis while summands are split off.
class Splitting {
 public:
  explicit Splitting(QuadraticForm form) : form_(std::move(form)), is_live_(form_.q.size(), true) {}

  /// A basis vector with an odd q.
  [[nodiscard]] std::optional<std::size_t> odd() const {
    for (std::size_t i = 0; i < form_.q.size(); ++i)
      if (is_live_[i] && form_.q[i] % 2 == 1) return i;
    return std::nullopt;
  }
  [[nodiscard]] std::optional<std::size_t> any() const {
    for (std::size_t i = 0; i < form_.q.size(); ++i)
      if (is_live_[i]) return i;
    return std::nullopt;
  }
  [[nodiscard]] std::size_t partner_of(std::size_t i) const {
    std::size_t j = 0;
    while (j < form_.q.size() && !(is_live_[j] && form_.product[i][j])) ++j;
    core::expects(j < form_.q.size(), "the form is nondegenerate");
    return j;
  }
  [[nodiscard]] int q(std::size_t i) const { return form_.q[i]; }

  /// Makes all others orthogonal to `x`, which has an odd q, and removes it.
  void split(std::size_t x) {
    is_live_[x] = false;
    for (std::size_t v = 0; v < form_.q.size(); ++v)
      if (is_live_[v] && form_.product[v][x]) add(v, x);
  }
  /// The same with two vectors of even q and product 1.
  void split(std::size_t x, std::size_t y) {
    is_live_[x] = is_live_[y] = false;
    for (std::size_t v = 0; v < form_.q.size(); ++v) {
      if (!is_live_[v]) continue;
      const bool with_x = form_.product[v][x];
      if (form_.product[v][y]) add(v, x);
      if (with_x) add(v, y);
    }
  }

 private:
  /// v += w
  void add(std::size_t v, std::size_t w) {
    form_.q[v] = (form_.q[v] + form_.q[w] + (form_.product[v][w] ? 2 : 0)) % 4;
    for (std::size_t u = 0; u < form_.q.size(); ++u)
      if (u != v) {
        form_.product[v][u] = form_.product[v][u] != form_.product[w][u];
        form_.product[u][v] = form_.product[v][u];
      }
    form_.product[v][v] = form_.q[v] % 2 == 1;
  }

  QuadraticForm form_;
  std::vector<bool> is_live_;
};

}  // namespace

int brown_invariant(QuadraticForm form) {
  Splitting left(std::move(form));
  int result = 0;
  while (const auto x = left.odd()) {
    result += left.q(*x) == 1 ? 1 : 7;
    left.split(*x);
  }
  while (const auto x = left.any()) {
    const std::size_t y = left.partner_of(*x);
    if (left.q(*x) == 2 && left.q(y) == 2) result += 4;
    left.split(*x, y);
  }
  return result % 8;
}

}  // namespace hexatlas::complex
