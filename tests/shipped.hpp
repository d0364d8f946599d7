#pragma once
/// \file
/// Where the data are that come with the program.

namespace hexatlas::support {

inline constexpr const char* kShippedFolder = HEXATLAS_SOURCE_DIR "/tables/data";
inline constexpr const char* kShippedTable = HEXATLAS_SOURCE_DIR "/tables/data/hexatlas.hxt";
inline constexpr const char* kShippedSectors = HEXATLAS_SOURCE_DIR "/tables/data/linear-bound.hxs";

}  // namespace hexatlas::support
