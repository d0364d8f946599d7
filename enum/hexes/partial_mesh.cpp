#include "enum/hexes/partial_mesh.hpp"

#include <algorithm>

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
    : boundary_vertices_(boundary.vertices()), ball_(ball) {
  core::expects(boundary.is_three_connected(), "the boundary is 3-connected");
  core::expects(boundary_vertices_ <= max_vertices && max_vertices <= kMaxMeshVertices,
                "the vertices fit into one word");
  for (auto& row : at_) row.fill(-1);
  cells_on_.fill({-1, -1});
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
  new_vertices_ = {.all = max_vertices - boundary_vertices_};
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

bool PartialMesh::balance() noexcept {
  const int surplus = (std::popcount(colour_[1]) - std::popcount(colour_[0])) / 2;
  new_vertices_.of_colour = {surplus, 0};
  is_balanced_ = true;
  new_vertices_ = new_vertices(new_vertices_.all);
  return !new_vertices_.are_negative();
}

NewVertices PartialMesh::new_vertices(int most) const noexcept {
  NewVertices result = new_vertices_;
  result.all = std::min(result.all, most);
  if (!is_balanced_) return result;
  const int surplus = result.of_colour[0] - result.of_colour[1];
  const int second = (result.all - surplus) >> 1;
  return {.all = 2 * second + surplus, .of_colour = {second + surplus, second}};
}

void PartialMesh::open(int number) noexcept {
  open_.add(number);
  ++open_count_;
  const Facet& f = facet(number);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vertex u = f[i], v = f[(i + 1) % 4], w = f[(i + 2) % 4];
    beyond_[v][u] |= bit(w);
    beyond_[v][w] |= bit(u);
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
    const Vertex u = f[i], v = f[(i + 1) % 4], w = f[(i + 2) % 4];
    beyond_[v][u] &= ~bit(w);
    beyond_[v][w] &= ~bit(u);
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
  new_vertices_.add(colour, -1);
  ++vertices_;
}

void PartialMesh::remove_vertex(Vertex v) noexcept {
  all_ &= ~bit(v);
  colour_[colour_of_[v]] &= ~bit(v);
  new_vertices_.add(colour_of_[v], 1);
  --vertices_;
}

void PartialMesh::begin(int bottom) noexcept {
  bottom_ = bottom;
  tops_ = 0;
}

VertexSet PartialMesh::next_tops(const NewVertices& new_vertices) const noexcept {
  VertexSet tops = tops_over(bottom_, tops_);
  if (may_be_new(tops_, without_new_tops(new_vertices)))
    tops |= bit(static_cast<std::size_t>(vertices_));
  return fitting_tops(tops_, tops);
}

/// Whether there may be a new vertex above corner i of the bottom; it has edges to none that is
/// saturated.
bool PartialMesh::may_be_new(std::size_t i, const NewVertices& left) const noexcept {
  return may_be_new_over(facet(bottom_)[i], left) && (i == 0 || !is_saturated(top_[i - 1])) &&
         (i < 3 || !is_saturated(top_[0]));
}

int PartialMesh::weight_on(int facet_number, const NewVertices& new_vertices, int limit) noexcept {
  begin(facet_number);
  Tops tops{};
  for (std::size_t i = 0; i < tops.size(); ++i) tops[i] = tops_over(facet_number, i);
  const int weight =
      weight_of_tops(0, tops, {.left = new_vertices, .each = kHexahedronWeight}, limit);
  bottom_ = -1;
  return weight;
}

int PartialMesh::weight_of_tops(std::size_t i, const Tops& tops, const NewTops& then,
                                int limit) noexcept {
  const VertexSet a_new_one =
      may_be_new(i, then.left) ? bit(static_cast<std::size_t>(vertices_)) : 0;
  VertexSet left = fitting_tops(i, tops[i] | a_new_one);
  NewTops next{.left = then.left, .each = then.each / 2};
  next.left.add(other_colour(facet(bottom_)[i]), -1);
  const bool has_new = (left & a_new_one) != 0;
  left &= ~a_new_one;
  if (i == 3) return then.each * std::popcount(left) + (has_new ? next.each : 0);
  int weight = 0;
  for (; left != 0 && weight < limit; left &= left - 1) {
    top_[i] = static_cast<Vertex>(std::countr_zero(left));
    weight += weight_of_tops(i + 1, tops, then, limit - weight);
  }
  if (has_new && weight < limit) {
    top_[i] = static_cast<Vertex>(vertices_ + next.left.all);
    weight += weight_of_tops(i + 1, tops, next, limit - weight);
  }
  return weight;
}

Vertex PartialMesh::opposite(int number, Vertex v) const noexcept {
  const Facet& f = facet(number);
  std::size_t at = 0;
  while (f[at] != v) ++at;
  return f[(at + 2) % 4];
}

/// The vertices w for which a facet with from, corner, w in a row would have a diagonal that is
/// one of a facet already, but not of an open one with these three.
VertexSet PartialMesh::bent_at(Vertex from, Vertex corner) const noexcept {
  return diagonals_from(from) & ~beyond_[corner][from];
}

/// The vertices that complete p, q, r to a facet: that of the open facet with these three in a row,
/// or any that have no facet diagonal with q. Requires that r is not bent_at(p, q).
VertexSet PartialMesh::closing(Vertex p, Vertex q, Vertex r) const noexcept {
  const int number = at_[p][r];
  return number >= 0 ? bit(opposite(number, q)) : ~diagonals_from(q);
}

VertexSet PartialMesh::tops_over(int number, std::size_t i) const noexcept {
  const Facet& b = facet(number);
  const Vertex after = b[(i + 1) % 4], before = b[(i + 3) % 4];
  const VertexSet barred = no_edge_from(b[i]) | not_diagonal_[after] | not_diagonal_[before] |
                           related_[b[(i + 2) % 4]] | bent_at(after, b[i]) | bent_at(before, b[i]) |
                           barred_tops_[static_cast<std::size_t>(number)][i];
  return ~barred & (ball_ ? of_other_colour(b[i]) & open_vertices_ : all_);
}

/// Those of the vertices that may be above corner i that fit the tops before it.
VertexSet PartialMesh::fitting_tops(std::size_t i, VertexSet tops) const noexcept {
  if (i == 0) return tops;
  const Facet& b = facet(bottom_);
  tops &= ~(bit(top_[i - 1]) | no_edge_from(top_[i - 1])) & closing(top_[i - 1], b[i - 1], b[i]);
  if (i == 1) return tops;
  tops &= ~(bit(top_[i - 2]) | not_diagonal_[top_[i - 2]]);
  if (i == 2) return tops & ~bent_at(top_[0], top_[1]);
  return tops & ~(bit(top_[0]) | no_edge_from(top_[0])) & closing(top_[0], b[0], b[3]) &
         closing(top_[0], top_[1], top_[2]);
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

void PartialMesh::put(Vertex top) {
  const std::size_t i = tops_;
  top_[i] = top;
  Step step{.top = top, .is_new = top == vertices_};
  if (step.is_new) add_vertex(top, other_colour(facet(bottom_)[i]));
  relate(i, top, step);
  steps_.push_back(step);
  if (i == 3)
    complete();
  else
    ++tops_;
}

/// next_tops() has seen to it that each of the facets is a new one or an open one.
void PartialMesh::complete() {
  Cell cell{};
  const Facet& b = facet(bottom_);
  for (std::size_t i = 0; i < 4; ++i) {
    cell[i] = b[i];
    cell[4 + i] = top_[i];
  }
  Completed done{.bottom = bottom_, .facets = facet_count_};
  const auto cell_number = static_cast<std::int16_t>(cells_.size());
  const auto close_one = [&](int number) {
    close(number);
    auto& cells = cells_on_[static_cast<std::size_t>(number)];
    cells[cells[0] < 0 ? 0 : 1] = cell_number;
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
    cells_on_[static_cast<std::size_t>(facet_count_)] = {cell_number, -1};
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
  for (int k = 0; k < done.closed_count; ++k) {
    const int number = done.closed[static_cast<std::size_t>(k)];
    auto& cells = cells_on_[static_cast<std::size_t>(number)];
    cells[cells[1] < 0 ? 0 : 1] = -1;
    open(number);
  }
  bottom_ = done.bottom;
  for (std::size_t i = 0; i < 4; ++i) top_[i] = cells_.back()[4 + i];
  tops_ = 3;
  for (const Vertex v : cells_.back()) --cells_at_[v];
  cells_.pop_back();
  completed_.pop_back();
}

NewVertices PartialMesh::without_new_tops(NewVertices new_vertices) const noexcept {
  for (std::size_t i = 0; i < tops_; ++i)
    if (steps_[steps_.size() - tops_ + i].is_new)
      new_vertices.add(other_colour(facet(bottom_)[i]), -1);
  return new_vertices;
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
