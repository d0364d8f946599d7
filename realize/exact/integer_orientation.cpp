#include "realize/exact/integer_orientation.hpp"

namespace hexatlas::exact {
namespace {

__extension__ using Wide = __int128;

IntegerPoint3 difference(const IntegerPoint3& to, const IntegerPoint3& from) noexcept {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

}  // namespace

Sign sign_of_orientation(const IntegerPoint3& a, const IntegerPoint3& b, const IntegerPoint3& c,
                         const IntegerPoint3& d) noexcept {
  const IntegerPoint3 u = difference(b, a);
  const IntegerPoint3 v = difference(c, a);
  const IntegerPoint3 w = difference(d, a);
  const Wide value = Wide{u[0]} * (v[1] * w[2] - v[2] * w[1]) +
                     Wide{u[1]} * (v[2] * w[0] - v[0] * w[2]) +
                     Wide{u[2]} * (v[0] * w[1] - v[1] * w[0]);
  return static_cast<Sign>((value > 0) - (value < 0));
}

}  // namespace hexatlas::exact
