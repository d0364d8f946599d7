#pragma once
/// \file
/// Searches for hexahedral meshes that are saved and gone on with, and the certificates of those
/// that found nothing.
///
/// A saved search is text (docs/formats/search.md) with a digest. It belongs to one boundary, one
/// set of limits, one shard and one version of the search.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "enum/hexes/bound_log.hpp"
#include "enum/hexes/hexmeshes.hpp"

namespace hexatlas::build {

/// Which part of which search.
struct HexmeshTask {
  complex::Quadrangulation boundary;  ///< in canonical labels
  hexes::SearchLimits limits;
  std::size_t part = 0, parts = 1;
};

[[nodiscard]] std::string to_text(const HexmeshTask& task, const hexes::HexFrontier& frontier);

/// Throws InvalidInput, with the name of the file and a line: no saved search, damaged, or the
/// search of another task, whose first difference is named.
[[nodiscard]] hexes::HexFrontier frontier_from(std::string_view text, const HexmeshTask& task,
                                               const std::string& name);

/// The bytes of a certificate (docs/formats/bound.md) with the log of a search that is complete.
[[nodiscard]] std::string bound_certificate(const complex::Quadrangulation& boundary,
                                            const hexes::SearchLimits& limits,
                                            const hexes::BoundLog& log);

}  // namespace hexatlas::build
