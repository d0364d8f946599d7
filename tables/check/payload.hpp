#pragma once
/// \file
/// Internal to the judge: the payload of an entry of a table, replayed into hexahedra.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

/// The mesh of an entry. Boundary vertices have their canonical labels.
struct Filling {
  std::vector<Hexahedron> cells;
  std::uint64_t vertex_count = 0;
  std::vector<std::uint32_t> removal_order;  ///< of encoding 0; else empty
};

/// `boundary` is the canonical list of quads of the key; `hexahedra` and `interior` are what the
/// index says. Returns what is wrong with the payload, or nothing. Not promised: that the hexahedra
/// are a mesh, or that their boundary is `boundary`.
[[nodiscard]] std::string read_payload(std::string_view payload, std::span<const Quad> boundary,
                                       std::uint32_t hexahedra, std::uint32_t interior,
                                       Filling& filling);

}  // namespace hexatlas::check
