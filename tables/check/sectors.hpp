#pragma once
/// \file
/// Checks sectors: meshes of the cell from which the linear construction makes a hexahedral mesh of
/// any ball whose boundary is a 3-connected quadrangulation with an even number of quads.
///
/// Definition, format, laws and claim: docs/formats/sectors.md. What has to be trusted: that the
/// claim follows from the laws, and this checker. It makes the surface of a sector from that text.
///
/// Errors: Malformed, "file:line: reason", for bytes that are not of the format: another first
/// line, no sector, a number outside its limits. All else is judged, the judgement is a value.
/// Cost: that of judge_cells for each sector, of at most 1000 hexahedra each. Not promised: that
/// each ball is shown to be one (ball.hpp; then `undecided` is set).

#include <cstddef>
#include <string>
#include <string_view>

namespace hexatlas::check {

struct SectorsVerdict {
  bool accepted = false;
  bool undecided = false;  ///< a sector was not shown to be a ball; no other law is broken
  std::string fault;       ///< why it is not accepted, empty otherwise
  // What was read.
  std::size_t sectors = 0;
  std::size_t least = 0;  ///< hexahedra of the smallest sector
  std::size_t most = 0;   ///< and of the largest
  std::size_t scars = 0;  ///< of all sectors together
  /// Hexahedra of the smallest sector without scars; half of it is the claim, per quad. 0 unless
  /// the file is accepted.
  std::size_t least_without_scars = 0;
};

/// Told by the first words.
[[nodiscard]] bool is_sectors(std::string_view bytes) noexcept;

/// `name` opens the message of Malformed.
[[nodiscard]] SectorsVerdict check_sectors_bytes(std::string_view bytes, const std::string& name);

}  // namespace hexatlas::check
