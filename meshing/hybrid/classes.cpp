#include "meshing/hybrid/classes.hpp"

#include <algorithm>
#include <cstring>

#include "enum/complex/cell.hpp"
#include "enum/core/checks.hpp"
#include "enum/core/random.hpp"
#include "meshing/hybrid/filling.hpp"

namespace hexatlas::hybrid {

std::size_t HexahedronClasses::Hash::operator()(const Key& key) const noexcept {
  std::array<std::uint64_t, 2> words{};
  std::memcpy(words.data(), key.data(), sizeof(key));
  return static_cast<std::size_t>(core::mixed(words[0] ^ core::mixed(words[1])));
}

HexahedronClasses::HexahedronClasses(std::span<const complex::Triangulation> classes)
    : size_(classes.size()) {
  const auto cube = complex::cell_named("hexahedron");
  core::ensures(cube.has_value(), "there is a hexahedron");
  const std::vector<complex::VertexMap> symmetries = complex::symmetries(*cube);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    core::expects(classes[i].tetrahedra.size() <= kMostInside, "at most 15 tetrahedra");
    for (const complex::VertexMap& symmetry : symmetries) {
      const complex::Triangulation image = complex::image_of(classes[i], symmetry);
      Key key{};
      std::transform(image.tetrahedra.begin(), image.tetrahedra.end(), key.begin(),
                     [](complex::VertexSet t) { return static_cast<std::uint8_t>(t); });
      class_of_.emplace(key, i);
    }
  }
}

std::optional<std::size_t> HexahedronClasses::class_of(const TetGraph& graph,
                                                       const CandidateList<8>& hexahedra,
                                                       std::size_t candidate) const {
  const auto& vertices = hexahedra.cells[candidate].vertices;
  Key key{};
  std::size_t count = 0;
  for (const TetIndex t : hexahedra.inside(candidate)) {
    unsigned set = 0;
    for (const Index v : graph[t]) {
      const auto it = std::find(vertices.begin(), vertices.end(), v);
      if (it == vertices.end()) return std::nullopt;
      set |= 1U << static_cast<unsigned>(it - vertices.begin());
    }
    key[count++] = static_cast<std::uint8_t>(set);
  }
  std::sort(key.begin(), key.begin() + static_cast<std::ptrdiff_t>(count));
  const auto it = class_of_.find(key);
  if (it == class_of_.end()) return std::nullopt;
  return it->second;
}

std::vector<std::size_t> HexahedronClasses::counts(const TetGraph& graph,
                                                   const CandidateList<8>& hexahedra) const {
  std::vector<std::size_t> result(size_ + 1);
  for (std::size_t i = 0; i < hexahedra.cells.size(); ++i)
    ++result[class_of(graph, hexahedra, i).value_or(size_)];
  return result;
}

}  // namespace hexatlas::hybrid
