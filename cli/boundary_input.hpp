#pragma once
/// \file
/// A boundary named on the command line, or read from a file.

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::cli {

struct NamedBoundary {
  std::string code;                     ///< canonical
  complex::Quadrangulation boundary{};  ///< in canonical labels
};

/// A boundary that is proven to have no mesh: not 3-connected, or an odd number of quads.
struct Unfillable {
  std::size_t quads = 0;
  std::string reason;
};

/// Visits the quadrangulations in a file: the one of a surface of quads, or those of a list in
/// planar_code, which has the header of this format or a name that ends with .planar_code. Returns
/// whether it is a list. Throws InvalidInput, at more than 64 quads too; those before were visited.
bool for_each_quadrangulation_in(const std::string& file,
                                 const std::function<void(const complex::Quadrangulation&)>& visit);

/// A name of build::kNamedBoundaries, a canonical code, or a file with one quadrangulation, as
/// above. Throws InvalidInput: none of these, not canonical, more than 64 quads, several
/// quadrangulations.
[[nodiscard]] std::variant<NamedBoundary, Unfillable> boundary_from(
    const std::string& name_code_or_file);

/// The same for codes only; of one without a mesh it is said why, and there is none.
[[nodiscard]] std::optional<NamedBoundary> fillable_boundary_of_code(const std::string& word);

}  // namespace hexatlas::cli
