#include "enum/hexes/partial_mesh.hpp"

#include "enum/core/checks.hpp"

namespace hexatlas::hexes {
Facet tops_over(const Cell& cell, const Facet& facet) noexcept {
  Facet tops{};
  for (const TurnedFacet& turned : kTurnedFacets) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        if (cell[turned.facet[k]] == facet[i]) {
          tops[i] = cell[turned.above[k]];
          ++found;
        }
    if (found == 4) break;
  }
  return tops;
}

PartialMesh::PartialMesh(const complex::Quadrangulation& boundary, int max_vertices, bool ball)
    : boundary_vertices_(boundary.vertices()), max_vertices_(max_vertices), ball_(ball) {
  core::expects(boundary.is_three_connected(), "the boundary is 3-connected");
  core::expects(boundary_vertices_ <= max_vertices && max_vertices <= kMaxMeshVertices,
                "the vertices fit into one word");
  for (auto& row : at_) row.fill(-1);
  std::array<int, kMaxMeshVertices> colour{};
  colour.fill(-1);
  colour[0] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int d = 0; d < boundary.darts(); ++d) {
      const auto dart = static_cast<complex::Dart>(d);
      const int from = colour[boundary.origin(dart)];
      int& to = colour[boundary.origin(complex::Quadrangulation::next(dart))];
      if (from < 0 || to >= 0) continue;
      to = 1 - from;
      changed = true;
    }
  }
  for (int v = 0; v < boundary_vertices_; ++v)
    add_vertex(static_cast<Vertex>(v), static_cast<unsigned>(colour[static_cast<std::size_t>(v)]));
  for (int q = 0; q < boundary.quads(); ++q) {
    const Facet facet = boundary.vertices_of(q);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t u = facet[i], v = facet[(i + 1) % 4], w = facet[(i + 2) % 4];
      not_diagonal_[u] |= bit(v);
      not_diagonal_[v] |= bit(u);
      not_edge_[u] |= bit(w);
      related_[u] |= bit(v) | bit(w);
      related_[v] |= bit(u);
      at_[u][w] = static_cast<std::int16_t>(q);
    }
    facets_[static_cast<std::size_t>(q)] = facet;
    open(q);
  }
  facet_count_ = boundary.quads();
  edge_count_ = 2 * boundary.quads();
}

void PartialMesh::open(int number) noexcept {
  open_.add(number);
  ++open_count_;
  const Facet& f = facet(number);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vertex u = f[i], v = f[(i + 1) % 4];
    if (open_at_[u]++ == 0) open_vertices_ |= bit(u);
    open_at_edge_[v][u] = ++open_at_edge_[u][v];
    closed_edge_[u] &= ~bit(v);
    closed_edge_[v] &= ~bit(u);
  }
}

void PartialMesh::close(int number) noexcept {
  open_.remove(number);
  --open_count_;
  const Facet& f = facet(number);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vertex u = f[i], v = f[(i + 1) % 4];
    if (--open_at_[u] == 0) open_vertices_ &= ~bit(u);
    open_at_edge_[v][u] = --open_at_edge_[u][v];
    if (open_at_edge_[u][v] != 0) continue;
    closed_edge_[u] |= bit(v);
    closed_edge_[v] |= bit(u);
  }
}

void PartialMesh::add_vertex(Vertex v, unsigned colour) noexcept {
  const VertexSet self = bit(v);
  not_edge_[v] = not_diagonal_[v] = related_[v] = self;
  all_ |= self;
  colour_[colour] |= self;
  colour_of_[v] = static_cast<std::uint8_t>(colour);
  cells_at_[v] = 0;
  ++vertices_;
}

void PartialMesh::remove_vertex(Vertex v) noexcept {
  all_ &= ~bit(v);
  colour_[colour_of_[v]] &= ~bit(v);
  --vertices_;
}

void PartialMesh::begin(int bottom) noexcept {
  bottom_ = bottom;
  tops_ = 0;
}

VertexSet PartialMesh::next_tops() const noexcept {
  const Facet& b = facet(bottom_);
  VertexSet result = above(b, tops_);
  for (std::size_t j = 0; j < tops_; ++j) {
    const Vertex t = top_[j];
    result &= ~(bit(t) | ((tops_ - j) % 2 == 1 ? no_edge_from(t) : not_diagonal_[t]));
  }
  const bool has_new = vertices_left() > 0 && may_be_new(tops_);
  return has_new ? result | bit(static_cast<std::size_t>(vertices_)) : result;
}

/// Whether a new vertex above corner i of the bottom has edges to none that is saturated.
bool PartialMesh::may_be_new(std::size_t i) const noexcept {
  return !is_saturated(facet(bottom_)[i]) && (i == 0 || !is_saturated(top_[i - 1])) &&
         (i < 3 || !is_saturated(top_[0]));
}

int PartialMesh::weight_on(int facet_number, int new_vertices, int limit) noexcept {
  begin(facet_number);
  const Facet& b = facet(facet_number);
  const int weight = weight_of_tops(0, {above(b, 0), above(b, 1), above(b, 2), above(b, 3)},
                                    {.vertices = new_vertices, .each = kHexahedronWeight}, limit);
  bottom_ = -1;
  return weight;
}

int PartialMesh::weight_of_tops(std::size_t i, const Tops& tops, NewTops left, int limit) noexcept {
  int weight = 0;
  const auto go_on = [&](Vertex top, VertexSet not_edge, VertexSet not_diagonal, NewTops then) {
    top_[i] = top;
    if (!facets_fit(i, top)) return;
    if (i == 3) {
      weight += then.each;
      return;
    }
    Tops rest = tops;
    for (std::size_t j = i + 1; j < 4; ++j) rest[j] &= ~((j - i) == 2 ? not_diagonal : not_edge);
    weight += weight_of_tops(i + 1, rest, then, limit - weight);
  };
  for (VertexSet old = tops[i]; old != 0 && weight < limit; old &= old - 1) {
    const auto top = static_cast<Vertex>(std::countr_zero(old));
    go_on(top, no_edge_from(top), not_diagonal_[top], left);
  }
  if (left.vertices > 0 && weight < limit && may_be_new(i))
    go_on(static_cast<Vertex>(vertices_ + left.vertices - 1), 0, 0,
          {.vertices = left.vertices - 1, .each = left.each / 2});
  return weight;
}

/// If there is a facet with the diagonal, it is open, has `between` next to it, and `opposite`
/// (-1: not known yet) beyond.
bool PartialMesh::diagonal_fits(std::size_t from, std::size_t to, Vertex between,
                                int opposite) const noexcept {
  const int number = at_[from][to];
  if (number < 0) return true;
  if (!open_.has(number)) return false;
  const Facet& f = facet(number);
  for (std::size_t k = 0; k < 4; ++k)
    if (f[k] == between) return opposite < 0 || f[(k + 2) % 4] == opposite;
  return false;
}

/// Whether the side over bottom corners i and j, both tops known, is no facet yet or an open one.
bool PartialMesh::side_fits(const Facet& b, std::size_t i, std::size_t j) const noexcept {
  const int number = at_[b[i]][top_[j]];
  return number == at_[b[j]][top_[i]] && (number < 0 || open_.has(number));
}

bool PartialMesh::facets_fit(std::size_t i, Vertex top) const noexcept {
  const Facet& b = facet(bottom_);
  const std::size_t after = (i + 1) % 4, before = (i + 3) % 4;
  if (!diagonal_fits(b[after], top, b[i], after < i ? top_[after] : -1)) return false;
  if (!diagonal_fits(b[before], top, b[i], before < i ? top_[before] : -1)) return false;
  if (i >= 1 && !side_fits(b, i - 1, i)) return false;
  if (i >= 2 && !diagonal_fits(top_[i - 2], top, top_[i - 1], i == 3 ? top_[0] : -1)) return false;
  return i < 3 || (side_fits(b, 3, 0) && at_[top_[0]][top_[2]] == at_[top_[1]][top_[3]]);
}

void PartialMesh::relate(std::size_t i, Vertex top, Step& step) noexcept {
  const Facet& b = facet(bottom_);
  const VertexSet self = bit(top);
  VertexSet edges = bit(b[i]), diagonals = bit(b[(i + 1) % 4]) | bit(b[(i + 3) % 4]);
  for (std::size_t j = 0; j < i; ++j) ((i - j) % 2 == 1 ? edges : diagonals) |= bit(top_[j]);
  step.edges = edges & ~related_[top];
  step.diagonals = diagonals & ~related_[top];
  edge_count_ += std::popcount(step.edges);
  const VertexSet body = bit(b[(i + 2) % 4]);
  for (VertexSet left = step.edges | body; left != 0; left &= left - 1) {
    const auto u = static_cast<std::size_t>(std::countr_zero(left));
    not_diagonal_[u] |= self;
    related_[u] |= self;
  }
  for (VertexSet left = step.diagonals | body; left != 0; left &= left - 1) {
    const auto u = static_cast<std::size_t>(std::countr_zero(left));
    not_edge_[u] |= self;
    related_[u] |= self;
  }
  not_diagonal_[top] |= step.edges | body;
  not_edge_[top] |= step.diagonals | body;
  related_[top] |= step.edges | step.diagonals | body;
}

void PartialMesh::unrelate(std::size_t i, const Step& step) noexcept {
  const Vertex top = step.top;
  const VertexSet others = ~bit(top);
  const Vertex far = facet(bottom_)[(i + 2) % 4];
  edge_count_ -= std::popcount(step.edges);
  for (VertexSet left = step.edges | step.diagonals | bit(far); left != 0; left &= left - 1) {
    const auto u = static_cast<std::size_t>(std::countr_zero(left));
    not_edge_[u] &= others;
    not_diagonal_[u] &= others;
    related_[u] &= others;
  }
  for (VertexSet left = step.edges; left != 0; left &= left - 1)
    closed_edge_[static_cast<std::size_t>(std::countr_zero(left))] &= others;
  closed_edge_[top] &= ~step.edges;
  not_diagonal_[top] &= ~(step.edges | bit(far));
  not_edge_[top] &= ~(step.diagonals | bit(far));
  related_[top] &= ~(step.edges | step.diagonals | bit(far));
}

bool PartialMesh::put(Vertex top) {
  const std::size_t i = tops_;
  top_[i] = top;
  if (!facets_fit(i, top)) return false;
  Step step{.top = top, .is_new = top == vertices_};
  if (step.is_new) add_vertex(top, 1U - colour_of_[facet(bottom_)[i]]);
  relate(i, top, step);
  steps_.push_back(step);
  if (i == 3)
    complete();
  else
    ++tops_;
  return true;
}

/// facets_fit() has seen to it that each of the facets is a new one or an open one.
void PartialMesh::complete() {
  Cell cell{};
  const Facet& b = facet(bottom_);
  for (std::size_t i = 0; i < 4; ++i) {
    cell[i] = b[i];
    cell[4 + i] = top_[i];
  }
  Completed done{.bottom = bottom_, .facets = facet_count_};
  const auto close_one = [&](int number) {
    close(number);
    done.closed[static_cast<std::size_t>(done.closed_count++)] = number;
  };
  close_one(bottom_);
  for (std::size_t k = 1; k < kTurnedFacets.size(); ++k) {
    const auto& places = kTurnedFacets[k].facet;
    const Facet f{cell[places[0]], cell[places[1]], cell[places[2]], cell[places[3]]};
    const int number = at_[f[0]][f[2]];
    if (number >= 0) {
      close_one(number);
      continue;
    }
    const auto fresh = static_cast<std::int16_t>(facet_count_);
    at_[f[0]][f[2]] = at_[f[2]][f[0]] = at_[f[1]][f[3]] = at_[f[3]][f[1]] = fresh;
    facets_[static_cast<std::size_t>(facet_count_++)] = f;
    open(fresh);
  }
  completed_.push_back(done);
  cells_.push_back(cell);
  for (const Vertex v : cell) ++cells_at_[v];
  bottom_ = -1;
}

/// Back to the hexahedron with four tops; the last one is still related.
void PartialMesh::undo_complete() noexcept {
  const Completed& done = completed_.back();
  while (facet_count_ > done.facets) {
    const Facet& f = facets_[static_cast<std::size_t>(--facet_count_)];
    at_[f[0]][f[2]] = at_[f[2]][f[0]] = at_[f[1]][f[3]] = at_[f[3]][f[1]] = -1;
    close(facet_count_);
  }
  for (int k = 0; k < done.closed_count; ++k) open(done.closed[static_cast<std::size_t>(k)]);
  bottom_ = done.bottom;
  for (std::size_t i = 0; i < 4; ++i) top_[i] = cells_.back()[4 + i];
  tops_ = 3;
  for (const Vertex v : cells_.back()) --cells_at_[v];
  cells_.pop_back();
  completed_.pop_back();
}

int PartialMesh::new_tops() const noexcept {
  int count = 0;
  for (std::size_t i = 0; i < tops_; ++i)
    if (steps_[steps_.size() - 1 - i].is_new) ++count;
  return count;
}

void PartialMesh::take_off() noexcept {
  if (has_just_completed())
    undo_complete();
  else
    --tops_;
  const Step step = steps_.back();
  steps_.pop_back();
  unrelate(tops_, step);
  if (step.is_new) remove_vertex(step.top);
}

}  // namespace hexatlas::hexes
