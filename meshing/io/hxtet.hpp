#pragma once
/// \file
/// The first bytes of a file of tetrahedra in binary; the format is docs/formats/hxtet.md.

#include <cstddef>
#include <string_view>

namespace hexatlas::io {

inline constexpr std::string_view kHxtetMagic("HXTET\0\0\1", 8);
inline constexpr std::size_t kHxtetHeaderBytes = 24;       ///< magic, two counts of 8 bytes
inline constexpr std::size_t kHxtetPointBytes = 24;        ///< three doubles
inline constexpr std::size_t kHxtetTetrahedronBytes = 16;  ///< four indices

}  // namespace hexatlas::io
