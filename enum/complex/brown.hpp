#pragma once
/// \file
/// Brown's invariant of a quadratic form with values modulo 4.
///
/// Definition. Let V be a space over Z/2 with a nondegenerate symmetric form x.y. A quadratic
/// enhancement is a map q from V to Z/4 with q(x + y) = q(x) + q(y) + 2 x.y; so q(x) = x.x modulo
/// 2. The sum of i^q(x) over all x of V is a positive number times a power of exp(2 pi i / 8); the
/// exponent is the invariant, modulo 8. It is additive, and 1 for the form of one dimension with
/// q = 1, 4 for that of two dimensions with q = 2 for all of the three vectors other than 0.
///
/// Source. E. H. Brown, Generalizations of the Kervaire invariant, Annals of Mathematics 95 (1972).

#include <vector>

namespace hexatlas::complex {

/// A form by its values at a basis.
struct QuadraticForm {
  std::vector<int> q;                      ///< modulo 4, in [0, 4)
  std::vector<std::vector<bool>> product;  ///< symmetric; product[i][i] is q[i] modulo 2
};

/// In [0, 8). Requires a nondegenerate form. Cost: cubic in the dimension.
[[nodiscard]] int brown_invariant(QuadraticForm form);

}  // namespace hexatlas::complex
