#pragma once
/// \file
/// Checks certificates of lower bounds: that a boundary has no hexahedral mesh within limits.
///
/// Definition, format, rules and claim: docs/formats/bound.md. What has to be trusted: that each
/// rule holds for every mesh that extends the state, and this checker. It finds the boundary's
/// symmetries and the children of each state itself.
///
/// Errors: Malformed, "file:line: reason", for bytes that are not of the format: no frame, a header
/// or a limit that the format does not know, a log of another size. All else is judged, the
/// judgement is a value. Cost: some microseconds for each record; recursion as deep as there are
/// hexahedra, at most 64.

#include <cstdint>
#include <string>
#include <string_view>

namespace hexatlas::check {

/// Larger content is refused.
inline constexpr std::uint64_t kMostBoundBytes = std::uint64_t{1} << 31;

struct BoundVerdict {
  bool accepted = false;
  std::string fault;  ///< why it is not, empty otherwise
  // The claim, whether it is true or not.
  std::string code;
  bool is_ball = false;       ///< no ball, instead of no mesh at all
  int hexahedra = 0;          ///< at most so many
  int interior = 0;           ///< and at most so many interior vertices
  bool any_interior = false;  ///< that many are no limit
  // What was read, up to the fault if there is one.
  std::uint64_t records = 0;
  std::uint64_t branches = 0;
};

/// Told by the first words, after decompression.
[[nodiscard]] bool is_bound(std::string_view bytes);

/// `name` opens each message.
[[nodiscard]] BoundVerdict check_bound_bytes(std::string_view bytes, const std::string& name);

}  // namespace hexatlas::check
