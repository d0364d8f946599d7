#pragma once
/// \file
/// A bar chart of how many hexahedra the meshes of a table have.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace hexatlas::sheet {

/// The quadrangulations with one number of quads.
struct Distribution {
  int quads = 0;
  std::map<int, std::size_t> meshes;  ///< by number of hexahedra; positive
  bool is_complete = false;           ///< they are all 3-connected ones

  [[nodiscard]] std::size_t entries() const;
  [[nodiscard]] std::size_t hexahedra() const;  ///< in all meshes together
  /// The mean of the two middle ones if their number is even. Requires entries() > 0.
  [[nodiscard]] double median() const;
};

/// A drawing in SVG: a panel for each distribution, in their order; x is the number of hexahedra,
/// the height of a bar the number of quadrangulations, both on the same scales in all panels. The
/// heights are logarithmic if a bar stands for more than 100, else linear; the caption says which.
/// `title` is text, not markup. Deterministic. Requires entries() > 0 in each; none: an empty
/// chart.
[[nodiscard]] std::string distribution_chart(const std::vector<Distribution>& distributions,
                                             const std::string& title);

}  // namespace hexatlas::sheet
