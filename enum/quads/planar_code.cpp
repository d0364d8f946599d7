#include "enum/quads/planar_code.hpp"

#include <array>
#include <bitset>
#include <optional>
#include <vector>

#include "enum/core/errors.hpp"

namespace hexatlas::quads {
namespace {

using complex::Dart;
using complex::Quadrangulation;
using complex::QuadVertices;
using complex::Vertex;

/// Reads one file; what() of its errors names the graph that it is at.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {
    if (rest_.starts_with(kPlanarCodeHeader)) rest_.remove_prefix(kPlanarCodeHeader.size());
  }

  std::optional<Quadrangulation> next() {
    if (rest_.empty()) return std::nullopt;
    ++graph_;
    vertices_ = byte();
    constexpr int kLeast = 4;
    if (vertices_ < kLeast || vertices_ > complex::kMaxVertices)
      fail("the number of vertices must be from 4 to " + std::to_string(complex::kMaxVertices) +
           ", here it is " + std::to_string(vertices_));
    for (int v = 0; v < vertices_; ++v) read_neighbours(v);
    expect_symmetry();
    const std::vector<QuadVertices> quads = faces();
    if (const auto law = complex::broken_law(quads)) fail(law->reason);
    return Quadrangulation::from_quads(quads);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw core::InvalidInput(name_, "graph " + std::to_string(graph_) + ": " + reason);
  }

  int byte() {
    if (rest_.empty()) fail("the file ends inside this graph");
    const int value = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    return value;
  }

  void read_neighbours(int v) {
    auto& after = after_[static_cast<std::size_t>(v)];
    after.fill(kNone);
    const std::string who = "vertex " + std::to_string(v + 1);
    int first = kNone;
    int last = kNone;
    while (const int number = byte()) {
      const int w = number - 1;
      if (w >= vertices_) fail(who + " has the neighbour " + std::to_string(number));
      if (w == v) fail(who + " is its own neighbour");
      if (after[static_cast<std::size_t>(w)] != kNone || w == last)
        fail(who + " has the neighbour " + std::to_string(number) + " twice");
      if (last == kNone)
        first = w;
      else
        after[static_cast<std::size_t>(last)] = w;
      last = w;
    }
    if (last == kNone) fail(who + " has no neighbour");
    after[static_cast<std::size_t>(last)] = first;
  }

  [[nodiscard]] int after(int v, int neighbour) const {
    return after_[static_cast<std::size_t>(v)][static_cast<std::size_t>(neighbour)];
  }

  void expect_symmetry() const {
    for (int v = 0; v < vertices_; ++v)
      for (int w = 0; w < vertices_; ++w)
        if (after(v, w) != kNone && after(w, v) == kNone)
          fail("vertex " + std::to_string(w + 1) + " is a neighbour of vertex " +
               std::to_string(v + 1) + " but not the other way round");
  }

  /// The faces, each on the left of its edges: from u to v goes on to the neighbour clockwise after
  /// u.
  [[nodiscard]] std::vector<QuadVertices> faces() const {
    std::vector<QuadVertices> quads;
    std::array<std::bitset<complex::kMaxVertices>, complex::kMaxVertices> met;
    for (int u = 0; u < vertices_; ++u)
      for (int v = 0; v < vertices_; ++v) {
        if (after(u, v) == kNone || met[static_cast<std::size_t>(u)][static_cast<std::size_t>(v)])
          continue;
        QuadVertices quad{};
        int a = u;
        int b = v;
        for (Vertex& corner : quad) {
          met[static_cast<std::size_t>(a)].set(static_cast<std::size_t>(b));
          corner = static_cast<Vertex>(a);
          const int c = after(b, a);
          a = b;
          b = c;
        }
        if (a != u || b != v)
          fail("the face left of the edge from vertex " + std::to_string(u + 1) + " to vertex " +
               std::to_string(v + 1) + " is no quad");
        quads.push_back(quad);
      }
    return quads;
  }

  static constexpr int kNone = -1;
  std::string_view rest_;
  const std::string& name_;
  std::size_t graph_ = 0;
  int vertices_ = 0;
  /// after_[v][w]: the neighbour of v clockwise after w.
  std::array<std::array<int, complex::kMaxVertices>, complex::kMaxVertices> after_{};
};

}  // namespace

void append_planar_code(const Quadrangulation& q, std::string& bytes) {
  const auto head = [&q](Dart d) { return q.origin(Quadrangulation::next(d)); };
  constexpr int kNone = -1;
  std::array<int, complex::kMaxVertices> first{};
  first.fill(kNone);
  for (int i = 0; i < q.darts(); ++i) {
    const auto d = static_cast<Dart>(i);
    int& least = first[q.origin(d)];
    if (least == kNone || head(d) < head(static_cast<Dart>(least))) least = i;
  }
  bytes.push_back(static_cast<char>(q.vertices()));
  for (int v = 0; v < q.vertices(); ++v) {
    const auto start = static_cast<Dart>(first[static_cast<std::size_t>(v)]);
    Dart d = start;
    do {
      bytes.push_back(static_cast<char>(head(d) + 1));
      d = q.turn_right(d);
    } while (d != start);
    bytes.push_back('\0');
  }
}

void for_each_in_planar_code(std::string_view bytes, const std::string& name,
                             const std::function<void(const Quadrangulation&)>& visit) {
  Reader reader(bytes, name);
  while (const auto q = reader.next()) visit(*q);
}

}  // namespace hexatlas::quads
