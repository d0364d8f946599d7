#pragma once
/// \file
/// The cavity of docs/formats/table.md: an ordered list of quads from which hexahedra are taken
/// off one by one.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::format {

class Cavity {
 public:
  explicit Cavity(const complex::Quadrangulation& boundary);

  struct Step {
    std::uint8_t bottom = 0;  ///< place in the list
    std::uint8_t sides = 0;   ///< bit i: side i
  };

  /// Takes the hexahedron of the step off; nullopt if the step is no patch.
  [[nodiscard]] std::optional<complex::Hexahedron> take_off(Step step);

  /// The step that takes off this hexahedron, or nullopt if its quads in the list are no patch.
  /// Its vertices that are not in the list must be new.
  [[nodiscard]] std::optional<Step> step_for(const complex::Hexahedron& cell) const;

  /// The last hexahedron if the list is the six quads of one.
  [[nodiscard]] std::optional<complex::Hexahedron> last() const;

  [[nodiscard]] std::uint32_t vertices() const noexcept { return vertices_; }

 private:
  struct Prism {
    complex::BoundaryQuad bottom{}, top{};
    std::vector<std::size_t> consumed;  ///< places, the bottom first
  };
  [[nodiscard]] std::optional<Prism> prism_of(Step step) const;

  std::vector<complex::BoundaryQuad> quads_;
  std::uint32_t vertices_;
};

}  // namespace hexatlas::format
