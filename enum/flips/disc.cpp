#include "enum/flips/disc.hpp"

#include <array>
#include <mutex>
#include <optional>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::flips {
namespace {

using complex::Vertex;
using Circle = std::vector<Vertex>;

/// Fills circles with quads, one circle after the other. The quad at the first edge of a circle is
/// one in each filling, so that no filling comes twice.
class Filler {
 public:
  Filler(int length, int interior) : first_new_(static_cast<Vertex>(length)), left_(interior) {}

  std::vector<Disc> run() {
    Circle circle;
    for (Vertex v = 0; v < first_new_; ++v) circle.push_back(v);
    open_.push_back(std::move(circle));
    next_ = first_new_;
    fill();
    return std::move(result_);
  }

 private:
  void fill() {
    if (open_.empty()) {
      if (left_ == 0) result_.push_back(quads_);
      return;
    }
    const Circle circle = std::move(open_.back());
    open_.pop_back();
    const std::size_t n = circle.size();
    // The quad (0, 1, i, j) of the circle's vertices; n stands for a new one.
    for (std::size_t i = 2; i <= n; i += 2)
      for (std::size_t j = i == n ? 3 : i + 1; j <= n + 1; j += 2) place(circle, i, j < n ? j : n);
    open_.push_back(circle);
  }

  void place(const Circle& circle, std::size_t i, std::size_t j) {
    const std::size_t n = circle.size();
    const int fresh = static_cast<int>(i == n) + static_cast<int>(j == n);
    if (fresh > left_) return;
    const Vertex a = i == n ? next_ : circle[i];
    const Vertex b = j == n ? static_cast<Vertex>(next_ + (i == n ? 1 : 0)) : circle[j];
    const std::size_t open_before = open_.size();
    left_ -= fresh;
    next_ = static_cast<Vertex>(next_ + fresh);
    quads_.push_back({circle[0], circle[1], a, b});
    // What the quad leaves of the circle: beyond its second, third and fourth edge; a new vertex
    // joins the parts on its two sides.
    Circle part(circle.begin() + 1, circle.begin() + 1);
    const auto along = [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k <= end; ++k) part.push_back(circle[k % n]);
    };
    const auto close = [&] {
      if (part.size() > 2) open_.push_back(part);
      part.clear();
    };
    if (i == n && j == n) {
      along(1, n);
      part.push_back(b);
      part.push_back(a);
    } else if (i == n) {
      along(1, j);
      part.push_back(a);
      close();
      along(j, n);
    } else if (j == n) {
      along(1, i);
      close();
      along(i, n);
      part.push_back(b);
    } else {
      along(1, i);
      close();
      along(i, j);
      close();
      along(j, n);
    }
    close();
    fill();
    open_.resize(open_before);
    quads_.pop_back();
    next_ = static_cast<Vertex>(next_ - fresh);
    left_ += fresh;
  }

  Vertex first_new_;
  Vertex next_ = 0;
  int left_;
  std::vector<Circle> open_;
  Disc quads_;
  std::vector<Disc> result_;
};

/// nullopt if a vertex inside has fewer than 3 quads.
std::optional<MarkedDisc> marked(const Disc& disc, std::size_t length) {
  MarkedDisc result{disc};
  std::array<int, kMaxDiscVertices> degree{};
  for (const complex::QuadVertices& quad : disc)
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t v = quad[i];
      const std::size_t w = quad[(i + 1) % 4];
      ++degree[v];
      if (v < length && w < length && (v + 1) % length != w) result.chords |= pair_bit(v, w);
    }
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (v < length && degree[v] == 1) result.narrow |= bit(static_cast<Vertex>(v));
    if (v >= length && (degree[v] == 1 || degree[v] == 2)) return std::nullopt;
  }
  return result;
}

}  // namespace

std::vector<Disc> discs(int length, int interior) {
  core::expects(length >= 4 && length % 2 == 0 && interior >= 0, "a disc has an even boundary");
  return Filler(length, interior).run();
}

const std::vector<MarkedDisc>& marked_discs(std::size_t length, std::size_t interior) {
  struct Lists {
    std::array<std::array<std::once_flag, kMaxDiscInterior + 1>, kMaxDiscCircle + 1> once;
    std::array<std::array<std::vector<MarkedDisc>, kMaxDiscInterior + 1>, kMaxDiscCircle + 1> list;
  };
  static Lists lists;
  std::vector<MarkedDisc>& own = lists.list[length][interior];
  std::call_once(lists.once[length][interior], [&] {
    for (const Disc& disc : discs(static_cast<int>(length), static_cast<int>(interior)))
      if (auto result = marked(disc, length)) own.push_back(*std::move(result));
  });
  return own;
}

Disc placed(Disc disc, std::span<const Vertex> rim, Vertex first_inside) {
  for (complex::QuadVertices& quad : disc)
    for (Vertex& v : quad)
      v = v < rim.size() ? rim[v] : static_cast<Vertex>(first_inside + v - rim.size());
  return disc;
}

}  // namespace hexatlas::flips
