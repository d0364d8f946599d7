// Claim. Splitting off lines and planes gives the exponent of the sum of i^q over the whole space.
// Oracle. That sum, vector by vector, in whole numbers.
#include "enum/complex/brown.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using complex::QuadraticForm;

/// q of the sum of the basis vectors whose bits are set.
int value_at(const QuadraticForm& form, std::size_t vector) {
  int result = 0;
  for (std::size_t i = 0; i < form.q.size(); ++i) {
    if ((vector >> i & 1U) == 0) continue;
    result += form.q[i];
    for (std::size_t j = 0; j < i; ++j)
      if ((vector >> j & 1U) != 0 && form.product[i][j]) result += 2;
  }
  return result % 4;
}

/// The exponent, -1 if the sum is 0, as it is for some forms that are degenerate.
int by_summation(const QuadraticForm& form) {
  std::array<int, 4> with{};
  for (std::size_t v = 0; v < std::size_t{1} << form.q.size(); ++v)
    ++with[static_cast<std::size_t>(value_at(form, v))];
  const int real = with[0] - with[2], imaginary = with[1] - with[3];
  const auto sign = [](int x) { return (x > 0) - (x < 0); };
  constexpr std::array<std::array<int, 3>, 3> kExponent{{{5, 4, 3}, {6, -1, 2}, {7, 0, 1}}};
  return kExponent[static_cast<std::size_t>(sign(real) + 1)]
                  [static_cast<std::size_t>(sign(imaginary) + 1)];
}

bool is_degenerate(const QuadraticForm& form) {
  for (std::size_t x = 1; x < std::size_t{1} << form.q.size(); ++x) {
    bool is_orthogonal_to_all = true;
    for (std::size_t j = 0; j < form.q.size() && is_orthogonal_to_all; ++j) {
      bool product = false;
      for (std::size_t i = 0; i < form.q.size(); ++i)
        product = product != ((x >> i & 1U) != 0 && form.product[i][j]);
      is_orthogonal_to_all = !product;
    }
    if (is_orthogonal_to_all) return true;
  }
  return false;
}

QuadraticForm random_form(std::size_t dimension, support::Random& random) {
  QuadraticForm form{std::vector<int>(dimension),
                     std::vector<std::vector<bool>>(dimension, std::vector<bool>(dimension))};
  for (std::size_t i = 0; i < dimension; ++i) {
    form.q[i] = static_cast<int>(random.below(4));
    form.product[i][i] = form.q[i] % 2 == 1;
    for (std::size_t j = 0; j < i; ++j) form.product[i][j] = form.product[j][i] = random.coin();
  }
  return form;
}

TEST(Brown, IsTheExponentOfTheSum) {
  support::Random random(72);
  std::array<int, 8> met{};
  for (int i = 0; i < 2'000; ++i) {
    const QuadraticForm form = random_form(random.below(8), random);
    if (is_degenerate(form)) continue;
    const int exponent = complex::brown_invariant(form);
    ASSERT_EQ(exponent, by_summation(form));
    ++met[static_cast<std::size_t>(exponent)];
  }
  for (const int times : met) EXPECT_GT(times, 20);
}

TEST(Brown, OfTheSmallestForms) {
  EXPECT_EQ(complex::brown_invariant({}), 0);
  EXPECT_EQ(complex::brown_invariant({{1}, {{true}}}), 1);
  EXPECT_EQ(complex::brown_invariant({{3}, {{true}}}), 7);
  EXPECT_EQ(complex::brown_invariant({{0, 0}, {{false, true}, {true, false}}}), 0);
  EXPECT_EQ(complex::brown_invariant({{2, 2}, {{false, true}, {true, false}}}), 4);
}

}  // namespace
