#pragma once
/// \file
/// From a sphere of any size to the codes by which tables know small ones, and back.

#include <cstddef>
#include <optional>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quad_surface.hpp"
#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::hexahedrize {

/// The sphere as codes need it; nullopt above complex::kMaxQuads quads.
[[nodiscard]] std::optional<complex::Quadrangulation> small_form(const complex::QuadSphere& sphere);

/// A mesh with a boundary in canonical labels, in that boundary's own vertices: canonical label
/// form.label[v] is v. Right-handed if it was. Requires that the boundary's labels come first.
[[nodiscard]] complex::HexComplex carried_over(complex::HexComplex mesh,
                                               const canon::CanonicalForm& form,
                                               std::size_t boundary_vertices);

}  // namespace hexatlas::hexahedrize
