#include "enum/balls/front_search.hpp"

#include "enum/core/checks.hpp"

namespace hexatlas::balls {
namespace {

unsigned bit(std::size_t v) noexcept { return 1U << v; }

}  // namespace

/// A tetrahedron seen from its directed edge p q: it adds the faces p q y and q p x.
struct FrontSearch::Arc {
  std::size_t p, q, x, y;
};

FrontSearch::FrontSearch(std::span<const complex::OrientedTriangle> boundary, int boundary_vertices,
                         int interior, std::span<const complex::VertexSet> forbidden,
                         Prunings prunings)
    : vertices_(static_cast<std::size_t>(boundary_vertices + interior)),
      boundary_vertices_(static_cast<std::size_t>(boundary_vertices)),
      prunings_(prunings) {
  core::expects(vertices_ <= kVertices, "FrontSearch: at most 16 vertices");
  const unsigned all = bit(vertices_) - 1U;
  for (std::size_t a = 0; a < vertices_; ++a)
    for (std::size_t b = 0; b < vertices_; ++b)
      if (a != b) allowed_[a][b] = static_cast<Mask>(all & ~bit(a) & ~bit(b));
  unused_ = static_cast<Mask>(all & ~(bit(boundary_vertices_) - 1U));
  apexes_ = static_cast<Mask>(all ^ (unused_ & (unused_ - 1U)));
  for (const complex::OrientedTriangle& triangle : boundary) {
    open(triangle[0], triangle[1], triangle[2]);
    for (const std::size_t v : triangle) ++facets_at_[v];
  }
  // Around a boundary edge the outside is the path between its two boundary triangles.
  for (std::size_t a = 0; a < vertices_; ++a)
    for (std::size_t b = 0; b < vertices_; ++b)
      if (front_[a][b] != 0)
        mate_[a][b][static_cast<std::size_t>(std::countr_zero(unsigned{front_[a][b]}))] =
            static_cast<Mask>(std::countr_zero(unsigned{front_[b][a]}));
  for (const complex::VertexSet set : forbidden)
    for (std::size_t d = 0; d < vertices_; ++d) {
      if ((set & bit(d)) == 0) continue;
      const unsigned rest = set & ~bit(d);
      for (std::size_t a = 0; a < vertices_; ++a)
        for (std::size_t b = 0; b < vertices_; ++b)
          for (std::size_t c = 0; c < vertices_; ++c)
            if ((bit(a) | bit(b) | bit(c)) == rest)
              forbidden_[a][b][c] = static_cast<Mask>(forbidden_[a][b][c] | bit(d));
    }
  trail_.clear();
}

bool FrontSearch::is_complete() const noexcept { return open_ == 0 && unused_ == 0; }

unsigned FrontSearch::apexes_of(std::size_t a, std::size_t b, std::size_t c) const noexcept {
  return unsigned{allowed_[a][b]} & allowed_[b][c] & allowed_[c][a] & apexes_ &
         ~unsigned{forbidden_[a][b][c]};
}

FrontSearch::Choices FrontSearch::choices() const noexcept {
  Choice best{};
  unsigned best_apexes = 0;
  int fewest = static_cast<int>(kVertices) + 1;
  for (std::size_t a = 0; a < vertices_; ++a) {
    if (front_at_[a] == 0) continue;
    for (std::size_t b = a + 1; b < vertices_; ++b)
      for (unsigned rest = unsigned{front_[a][b]} >> a << a; rest != 0; rest &= rest - 1U) {
        const auto c = static_cast<std::size_t>(std::countr_zero(rest));
        const unsigned apexes = apexes_of(a, b, c);
        const int count = std::popcount(apexes);
        if (count >= fewest) continue;
        fewest = count;
        best_apexes = apexes;
        best = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                static_cast<std::uint8_t>(c), 0};
        if (count == 0 || !prunings_.open_triangles) return {best, apexes};
      }
  }
  return {best, best_apexes};
}

void FrontSearch::set(Mask& word, Mask value) {
  trail_.push_back({&word, word});
  word = value;
}

void FrontSearch::bar(std::size_t a, std::size_t b, std::size_t c) {
  set(allowed_[a][b], static_cast<Mask>(allowed_[a][b] & ~bit(c)));
  set(allowed_[b][c], static_cast<Mask>(allowed_[b][c] & ~bit(a)));
  set(allowed_[c][a], static_cast<Mask>(allowed_[c][a] & ~bit(b)));
}

void FrontSearch::open(std::size_t a, std::size_t b, std::size_t c) {
  bar(a, b, c);
  const std::array<std::size_t, 5> cycle{a, b, c, a, b};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t p = cycle[i], q = cycle[i + 1], r = cycle[i + 2];
    set(front_[p][q], static_cast<Mask>(front_[p][q] | bit(r)));
    set(used_[p][q], static_cast<Mask>(used_[p][q] | bit(r)));
    set(used_[q][p], static_cast<Mask>(used_[q][p] | bit(r)));
    set(front_at_[p], static_cast<Mask>(front_at_[p] + 1U));
  }
  set(open_, static_cast<Mask>(open_ + 1U));
}

void FrontSearch::close(std::size_t a, std::size_t b, std::size_t c) {
  bar(b, a, c);
  const std::array<std::size_t, 5> cycle{a, b, c, a, b};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t p = cycle[i], q = cycle[i + 1], r = cycle[i + 2];
    set(front_[p][q], static_cast<Mask>(front_[p][q] & ~bit(r)));
    set(front_at_[p], static_cast<Mask>(front_at_[p] - 1U));
  }
  set(open_, static_cast<Mask>(open_ - 1U));
}

void FrontSearch::add_face(std::size_t a, std::size_t b, std::size_t c) {
  if ((front_[b][a] & bit(c)) != 0)
    close(b, a, c);
  else
    open(a, b, c);
}

void FrontSearch::bar_edge(std::size_t a, std::size_t b) {
  for (std::size_t c = 0; c < vertices_; ++c) {
    if (c == a || c == b || ((allowed_[a][b] | allowed_[b][a]) & bit(c)) == 0) continue;
    bar(a, b, c);
    bar(b, a, c);
  }
}

bool FrontSearch::closes_one_of_many(const Arc& arc) const noexcept {
  const auto [p, q, x, y] = arc;
  return (front_[p][q] & bit(x)) != 0 && (front_[q][p] & bit(y)) != 0 && mate_[p][q][x] == y &&
         std::popcount(unsigned{front_[p][q]}) > 1;
}

void FrontSearch::add_arc(const Arc& arc) {
  const auto [p, q, x, y] = arc;
  const bool meets_x = (front_[p][q] & bit(x)) != 0;
  const bool meets_y = (front_[q][p] & bit(y)) != 0;
  if (meets_x && meets_y && mate_[p][q][x] == y) return;
  // The ends of the path that the arc becomes part of: q p u and p q w.
  const Mask u = meets_x ? mate_[p][q][x] : static_cast<Mask>(x);
  const Mask w = meets_y ? mate_[q][p][y] : static_cast<Mask>(y);
  set(mate_[q][p][u], w);
  set(mate_[p][q][w], u);
}

bool FrontSearch::link_is_sphere(std::size_t v) const noexcept {
  unsigned neighbours = 0;
  for (std::size_t x = 0; x < vertices_; ++x)
    if (used_[v][x] != 0) neighbours |= bit(x);
  const int outside = v < boundary_vertices_ ? 1 : 0;
  if (2 * (std::popcount(neighbours) + outside) - int{facets_at_[v]} != 4) return false;
  unsigned reached = neighbours & (~neighbours + 1U);
  for (unsigned fresh = reached; fresh != 0;) {
    unsigned next = 0;
    for (; fresh != 0; fresh &= fresh - 1U)
      next |= used_[v][static_cast<std::size_t>(std::countr_zero(fresh))];
    fresh = next & ~reached;
    reached |= next;
  }
  return reached == neighbours;
}

bool FrontSearch::finish_vertex(std::size_t v) {
  if (front_at_[v] != 0 || !prunings_.vertex_links) return true;
  set(apexes_, static_cast<Mask>(apexes_ & ~bit(v)));
  return link_is_sphere(v);
}

bool FrontSearch::apply(Choice choice) {
  const std::size_t a = choice.a, b = choice.b, c = choice.c, d = choice.d;
  if (a >= vertices_ || b >= vertices_ || c >= vertices_ || d >= vertices_ ||
      (front_[a][b] & bit(c)) == 0 || (apexes_of(a, b, c) & bit(d)) == 0)
    return false;
  const std::array<Arc, 6> arcs{
      {{a, b, c, d}, {b, c, a, d}, {c, a, b, d}, {a, d, b, c}, {b, d, c, a}, {c, d, a, b}}};
  if (prunings_.edge_links)
    for (const Arc& arc : arcs)
      if (closes_one_of_many(arc)) return false;
  marks_.push_back(trail_.size());
  tetrahedra_.push_back(static_cast<complex::VertexSet>(bit(a) | bit(b) | bit(c) | bit(d)));
  if ((unused_ & bit(d)) != 0) {
    set(unused_, static_cast<Mask>(unused_ & ~bit(d)));
    set(apexes_, static_cast<Mask>(apexes_ | (unused_ & (~unsigned{unused_} + 1U))));
  }
  for (const Arc& arc : arcs) add_arc(arc);
  for (const std::size_t v : {a, b, c, d})
    set(facets_at_[v], static_cast<Mask>(facets_at_[v] + 1U));
  close(a, b, c);
  add_face(a, b, d);
  add_face(b, c, d);
  add_face(c, a, d);
  if (prunings_.edge_links)
    for (const Arc& arc : arcs)
      if (front_[arc.p][arc.q] == 0) bar_edge(arc.p, arc.q);
  for (const std::size_t v : {a, b, c, d})
    if (!finish_vertex(v)) {
      undo();
      return false;
    }
  return true;
}

void FrontSearch::undo() noexcept {
  for (; trail_.size() > marks_.back(); trail_.pop_back())
    *trail_.back().word = trail_.back().value;
  marks_.pop_back();
  tetrahedra_.pop_back();
}

}  // namespace hexatlas::balls
