#include "meshing/hexahedrize/pairing.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>

#include "enum/core/errors.hpp"

namespace hexatlas::hexahedrize {

using complex::VertexId;

Sides sides_of(const complex::QuadSphere& sphere) {
  struct Half {
    VertexId low, high;
    std::uint32_t quad, side;
  };
  std::vector<Half> halves;
  halves.reserve(4 * sphere.quads.size());
  for (std::uint32_t q = 0; q < sphere.quads.size(); ++q)
    for (std::uint32_t s = 0; s < 4; ++s) {
      const VertexId a = sphere.quads[q][s];
      const VertexId b = sphere.quads[q][(s + 1) % 4];
      halves.push_back({std::min(a, b), std::max(a, b), q, s});
    }
  std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
    return std::array{a.low, a.high, a.quad} < std::array{b.low, b.high, b.quad};
  });
  Sides result(sphere.quads.size());
  for (std::uint32_t i = 0; i + 1 < halves.size(); i += 2) {
    result[halves[i].quad][halves[i].side] = {halves[i + 1].quad, i / 2};
    result[halves[i + 1].quad][halves[i + 1].side] = {halves[i].quad, i / 2};
  }
  return result;
}

std::vector<std::uint32_t> partners(const Sides& sides) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  Graph dual(sides.size());
  for (std::uint32_t q = 0; q < sides.size(); ++q)
    for (const Side& side : sides[q])
      if (q < side.quad) boost::add_edge(q, side.quad, dual);
  std::vector<Graph::vertex_descriptor> mate(sides.size());
  boost::edmonds_maximum_cardinality_matching(dual, mate.data());
  std::vector<std::uint32_t> result(sides.size());
  for (std::size_t q = 0; q < sides.size(); ++q) {
    if (mate[q] == Graph::null_vertex())
      throw core::InternalError("the quads of a 3-connected quadrangulation are not paired");
    result[q] = static_cast<std::uint32_t>(mate[q]);
  }
  return result;
}

}  // namespace hexatlas::hexahedrize
