#pragma once
/// \file
/// Numbers as text: the shortest decimal form that reads back to the same bits (std::to_chars),
/// whatever the locale.

#include <cstdint>
#include <span>
#include <string>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::io {

void append(std::string& text, double number);
void append(std::string& text, std::uint64_t number);

/// "x y z".
void append(std::string& text, const mesh::Point& point);

/// Each index plus `base`, separated by blanks.
void append(std::string& text, std::span<const mesh::Index> indices, unsigned base);

}  // namespace hexatlas::io
