#pragma once
/// \file
/// Verdicts of realize/exact in the words of this layer. Private to meshing/quality.

#include "enum/core/errors.hpp"
#include "meshing/quality/hexahedron.hpp"
#include "realize/exact/jacobian.hpp"

namespace hexatlas::quality {

[[nodiscard]] inline Validity validity_from(exact::Positivity positivity) {
  switch (positivity) {
    case exact::Positivity::positive:
      return Validity::valid;
    case exact::Positivity::not_positive:
      return Validity::invalid;
    case exact::Positivity::undecided:
      return Validity::undecided;
  }
  throw core::InternalError("quality: unknown positivity");
}

[[nodiscard]] inline Verdict verdict_from(const exact::JacobianVerdict& verdict, bool exact) {
  return {validity_from(verdict.positivity), verdict.corner_not_positive, exact};
}

}  // namespace hexatlas::quality
