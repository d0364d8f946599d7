#pragma once
/// \file
/// Internal to the judge: reads a certificate of a lower bound (docs/formats/bound.md).
/// Errors: Malformed, as in bound.hpp. Cost: linear.

#include <string>
#include <string_view>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

struct BoundFile {
  std::string code;
  std::vector<Quad> quads;  ///< vertices below the number of quads + 2
  bool is_ball = false;
  int hexahedra = 0;
  int interior = 0;
  bool has_symmetry = false;
  std::string_view log;
};

/// `text` is what the frame holds; the log refers to it.
[[nodiscard]] BoundFile read_bound(std::string_view text, const std::string& name);

}  // namespace hexatlas::check
