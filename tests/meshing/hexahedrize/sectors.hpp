#pragma once
/// \file
/// The sectors that come with the program, read once.

#include <vector>

#include "enum/core/files.hpp"
#include "tables/format/sectors.hpp"
#include "tests/shipped.hpp"

namespace hexatlas::support {

inline const std::vector<format::Sector>& sectors() {
  static const auto kSectors = format::read_sectors(core::read_file(kShippedSectors), "sectors");
  return kSectors;
}

}  // namespace hexatlas::support
