#include "tables/check/edge_lemma.hpp"

#include <algorithm>

#include "tables/check/circuits.hpp"
#include "tables/check/triangulation_laws.hpp"

namespace hexatlas::check {

namespace {

/// 0 if the sign of these four is not among them.
int sign_of(const SignedBracket& bracket, const std::vector<DeniedSign>& denied) {
  const VertexBits four = bracket.four();
  const auto found = std::find_if(denied.begin(), denied.end(),
                                  [four](const DeniedSign& one) { return one.four == four; });
  return found == denied.end() ? 0 : bracket.factor * parity_of(bracket.corners) * found->sign;
}

struct EdgeSigns {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  int wanted = 0;  ///< of y0 |x1| + y1 |x0|; 0 if nothing is said
};

EdgeSigns signs_of(const EdgeCase& edge, const std::vector<DeniedSign>& denied) {
  EdgeSigns signs{sign_of(edge.x0, denied), sign_of(edge.x1, denied), sign_of(edge.y0, denied),
                  sign_of(edge.y1, denied), 0};
  if (signs.x0 * signs.x1 == -1) signs.wanted = sign_of(edge.turn, denied) * signs.x0;
  return signs;
}

}  // namespace

VertexBits SignedBracket::four() const noexcept {
  unsigned bits = 0;
  for (const std::uint8_t corner : corners) bits |= 1U << corner;
  return static_cast<VertexBits>(bits);
}

std::optional<EdgeCase> edge_case(std::uint64_t tail, std::uint64_t axis, std::uint64_t apex,
                                  std::uint64_t side) {
  if (tail > 7 || axis > 2 || apex > 7 || side < 1 || side > 2) return std::nullopt;
  if ((tail >> axis & 1U) != 0) return std::nullopt;
  std::uint64_t turning = std::uint64_t{1} << (axis + 1) % 3;
  std::uint64_t other = std::uint64_t{1} << (axis + 2) % 3;
  const std::uint64_t head = tail | std::uint64_t{1} << axis;
  if (apex != (tail ^ turning ^ other) && apex != (head ^ turning ^ other)) return std::nullopt;
  if (side == 2) std::swap(turning, other);
  const auto bracket = [&](std::uint64_t third, std::uint64_t fourth, int factor) {
    const auto corner = [](std::uint64_t v) { return static_cast<std::uint8_t>(v); };
    return SignedBracket{{corner(tail), corner(head), corner(third), corner(fourth)}, factor};
  };
  const int x = (tail & turning) != 0 ? -1 : 1;
  const int y = (tail & other) != 0 ? -1 : 1;
  return EdgeCase{bracket(tail ^ turning, apex, x), bracket(head ^ turning, apex, x),
                  bracket(tail ^ other, apex, y), bracket(head ^ other, apex, y),
                  bracket(tail ^ turning, head ^ turning, side == 1 ? -1 : 1)};
}

bool contradicts_edge(const std::vector<DeniedSign>& denied) {
  for (std::uint64_t tail = 0; tail < 8; ++tail) {
    for (std::uint64_t axis = 0; axis < 3; ++axis) {
      for (std::uint64_t apex = 0; apex < 8; ++apex) {
        for (const std::uint64_t side : {1U, 2U}) {
          const auto edge = edge_case(tail, axis, apex, side);
          if (!edge) continue;
          const EdgeSigns signs = signs_of(*edge, denied);
          if (signs.wanted != 0 && signs.y0 == -signs.wanted && signs.y1 == -signs.wanted) {
            return true;
          }
        }
      }
    }
  }
  return false;
}

bool implies_larger(const EdgeCase& edge, const std::vector<DeniedSign>& denied,
                    std::uint64_t larger) {
  const EdgeSigns signs = signs_of(edge, denied);
  if (signs.wanted == 0) return false;
  const int right = larger == 1 ? signs.y0 : signs.y1;
  const int wrong = larger == 1 ? signs.y1 : signs.y0;
  return right == signs.wanted && wrong == -signs.wanted;
}

}  // namespace hexatlas::check
