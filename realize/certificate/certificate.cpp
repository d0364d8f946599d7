#include "realize/certificate/certificate.hpp"

namespace hexatlas::certificate {

std::string_view name_of(Condition condition) {
  switch (condition) {
    case Condition::embedded: return "embedded";
    case Condition::convex: return "convex";
    case Condition::jacobian: return "jacobian";
  }
  return {};
}

}  // namespace hexatlas::certificate
