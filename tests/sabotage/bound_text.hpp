#pragma once
/// \file
/// The text of a certificate of a lower bound (docs/formats/bound.md), for tests, and its frame.

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace hexatlas::sabotage {

using SlowQuad = std::array<int, 4>;
using SlowHex = std::array<int, 8>;
using IntSet = std::set<int>;

struct BoundText {
  std::string code;
  std::vector<SlowQuad> quads;
  bool is_ball = false;
  int hexahedra = 0;
  int interior = 0;
  bool has_symmetry = false;
  std::string log = {};
};

/// Without the frame.
inline std::string text_of(const BoundText& b) {
  std::string text =
      "hexatlas-bound 2\nboundary " + b.code + "\nquads " + std::to_string(b.quads.size()) + "\n";
  for (const SlowQuad& q : b.quads) {
    for (std::size_t i = 0; i < 4; ++i) text += std::to_string(q[i]) + (i < 3 ? " " : "\n");
  }
  return text + "kind " + (b.is_ball ? "ball" : "any") + "\nhexahedra " +
         std::to_string(b.hexahedra) + "\ninterior " + std::to_string(b.interior) + "\nsymmetry " +
         (b.has_symmetry ? "yes" : "no") + "\nlog " + std::to_string(b.log.size()) + "\n" + b.log;
}

/// A Zstandard frame of raw blocks, by hand.
inline std::string framed(const std::string& content) {
  std::string frame = "\x28\xB5\x2F\xFD\xA0";
  for (unsigned i = 0; i < 4; ++i) frame += static_cast<char>(content.size() >> (8 * i) & 255U);
  constexpr std::size_t kBlock = 100'000;
  for (std::size_t at = 0; at == 0 || at < content.size(); at += kBlock) {
    const std::string block = content.substr(at, kBlock);
    const bool is_last = at + kBlock >= content.size();
    const std::size_t head = block.size() << 3U | (is_last ? 1U : 0U);
    for (unsigned i = 0; i < 3; ++i) frame += static_cast<char>(head >> (8 * i) & 255U);
    frame += block;
  }
  return frame;
}

}  // namespace hexatlas::sabotage
