#pragma once
/// \file
/// Pillows: a layer of hexahedra, one below each quad of a part of a cavity's boundary.
/// Source: S. A. Mitchell, T. J. Tautges, "Pillowing doublets" (1995).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "enum/flips/peeling.hpp"

namespace hexatlas::flips {

/// A set of numbers that is emptied at no cost.
class Marks {
 public:
  void clear() { ++now_; }
  [[nodiscard]] bool has(std::uint32_t i) const { return i < stamp_.size() && stamp_[i] == now_; }
  /// Whether it is new.
  bool add(std::uint32_t i) {
    if (i >= stamp_.size()) stamp_.resize(2 * std::size_t{i} + 1, 0);
    if (stamp_[i] == now_) return false;
    stamp_[i] = now_;
    return true;
  }

 private:
  std::vector<std::uint32_t> stamp_;
  std::uint32_t now_ = 1;
};

/// Of a hexahedron of a layer: the quad that it was below, and the one that has come up, whose
/// sides are below those of the former.
struct LayerQuads {
  std::uint32_t above = 0, below = 0;
};

/// Takes a layer off, flip by flip. Below a disc it is joined at the rim to the quads outside,
/// which it takes away; so these are a ring around the disc, a zone (reducing.hpp), or it fails.
/// Below a disc with holes there is a zone for each of these as well.
/// Below all quads it leaves a cavity whose quads are joined to each other as before, on new
/// vertices, and nothing relates these but the quads themselves. Gives the quads given with those
/// that have come up, in the order in which they were taken; nullopt if the strict rule forbids a
/// flip: then nothing is changed. Requires different live quads, all, or those of a disc, which may
/// have holes. Cost: linear in the quads.
std::optional<std::vector<LayerQuads>> take_layer(Peeling& peeling,
                                                  std::span<const std::uint32_t> quads);

}  // namespace hexatlas::flips
