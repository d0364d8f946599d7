#include <nauty/nausparse.h>
#include <nauty/nauty.h>

#include "enum/canon/nauty/hex_symmetry.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "enum/cells/cube.hpp"
#include "enum/complex/facets.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::canon {
namespace {

static_assert(HAVE_TLS, "nauty must be built with thread-local storage");

/// An undirected graph whose nodes come in colour classes of consecutive numbers.
struct ColouredGraph {
  std::vector<std::size_t> class_sizes;
  std::vector<std::vector<int>> neighbours;

  explicit ColouredGraph(std::vector<std::size_t> sizes) : class_sizes(std::move(sizes)) {
    std::size_t nodes = 0;
    for (const std::size_t size : class_sizes) nodes += size;
    neighbours.resize(nodes);
  }
  void join(std::size_t a, std::size_t b) {
    neighbours[a].push_back(static_cast<int>(b));
    neighbours[b].push_back(static_cast<int>(a));
  }
};

/// nauty gives the order of the group as a product of orbit sizes, one per level of its search;
/// it passes no user pointer, hence the thread-local product.
thread_local std::uint64_t group_order = 1;
thread_local bool group_order_overflows = false;

// nauty calls this once per level with the size of the orbit of the fixed point there.
void multiply_orbit(int* /*lab*/, int* /*ptn*/, int /*level*/, int* /*orbits*/, statsblk* /*stats*/,
                    int /*tv*/, int index, int /*tcellsize*/, int /*numcells*/, int /*childcount*/,
                    int /*n*/) {
  const auto factor = static_cast<std::uint64_t>(index);
  if (group_order > std::numeric_limits<std::uint64_t>::max() / factor)
    group_order_overflows = true;
  else
    group_order *= factor;
}

/// The same graph in nauty's form; owns the arrays that nauty reads.
class InputGraph {
 public:
  explicit InputGraph(const ColouredGraph& coloured) {
    for (const auto& row : coloured.neighbours) {
      first_.push_back(ends_.size());
      degree_.push_back(static_cast<int>(row.size()));
      ends_.insert(ends_.end(), row.begin(), row.end());
    }
    SG_INIT(graph_);
    graph_.nv = static_cast<int>(first_.size());
    graph_.nde = ends_.size();
    graph_.v = first_.data();
    graph_.d = degree_.data();
    graph_.e = ends_.data();
    graph_.vlen = first_.size();
    graph_.dlen = degree_.size();
    graph_.elen = ends_.size();
  }
  InputGraph(const InputGraph&) = delete;
  InputGraph& operator=(const InputGraph&) = delete;
  ~InputGraph() = default;
  [[nodiscard]] sparsegraph* get() noexcept { return &graph_; }

 private:
  std::vector<std::size_t> first_;
  std::vector<int> degree_, ends_;
  sparsegraph graph_{};
};

/// A graph that nauty allocates.
class OutputGraph {
 public:
  OutputGraph() { SG_INIT(graph_); }
  OutputGraph(const OutputGraph&) = delete;
  OutputGraph& operator=(const OutputGraph&) = delete;
  ~OutputGraph() { SG_FREE(graph_); }
  [[nodiscard]] sparsegraph* get() noexcept { return &graph_; }

 private:
  sparsegraph graph_{};
};

GraphForm canonical(const ColouredGraph& coloured) {
  const std::size_t nodes = coloured.neighbours.size();
  std::vector<int> lab(nodes), ptn(nodes, 1), orbits(nodes);
  for (std::size_t i = 0; i < nodes; ++i) lab[i] = static_cast<int>(i);
  std::size_t end = 0;
  for (const std::size_t size : coloured.class_sizes) {
    end += size;
    if (size > 0) ptn[end - 1] = 0;
  }
  static DEFAULTOPTIONS_SPARSEGRAPH(defaults);
  optionblk options = defaults;
  options.getcanon = TRUE;
  options.defaultptn = FALSE;
  options.userlevelproc = multiply_orbit;
  statsblk stats{};
  InputGraph input(coloured);
  OutputGraph output;
  group_order = 1;
  group_order_overflows = false;
  sparsenauty(input.get(), lab.data(), ptn.data(), orbits.data(), &options, &stats, output.get());
  core::ensures(stats.errstatus == 0 && !group_order_overflows,
                "the group order fits into 64 bits");
  sortlists_sg(output.get());
  GraphForm form;
  form.automorphisms = group_order;
  form.certificate.assign(coloured.class_sizes.begin(), coloured.class_sizes.end());
  const sparsegraph& canon = *output.get();
  for (std::size_t v = 0; v < nodes; ++v) {
    form.certificate.push_back(static_cast<std::uint64_t>(canon.d[v]));
    for (int i = 0; i < canon.d[v]; ++i)
      form.certificate.push_back(
          static_cast<std::uint64_t>(canon.e[canon.v[v] + static_cast<std::size_t>(i)]));
  }
  return form;
}

}  // namespace

GraphForm graph_form(const complex::HexComplex& mesh) {
  const std::vector<complex::Facet> facets = complex::sorted_facets(mesh);
  std::size_t quads = 0;
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (i == 0 || facets[i].key != facets[i - 1].key) ++quads;
  ColouredGraph incidence({mesh.vertices, quads, mesh.hexahedra.size()});
  std::size_t quad = mesh.vertices;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const bool is_new = i == 0 || facets[i].key != facets[i - 1].key;
    if (i > 0 && is_new) ++quad;
    if (is_new)
      for (const complex::VertexId v : facets[i].key) incidence.join(v, quad);
    incidence.join(quad, mesh.vertices + quads + facets[i].cell);
  }
  return canonical(incidence);
}

GraphForm graph_form(const complex::Quadrangulation& q) {
  const auto vertices = static_cast<std::size_t>(q.vertices());
  ColouredGraph incidence({vertices});
  for (int i = 0; i < q.darts(); ++i) {
    const auto d = static_cast<complex::Dart>(i);
    if (d < q.twin(d)) incidence.join(q.origin(d), q.origin(q.twin(d)));
  }
  return canonical(incidence);
}

}  // namespace hexatlas::canon
