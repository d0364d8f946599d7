#include "enum/hexes/shellings.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::hexes {
namespace {

/// A class as it is met by gluing; `met` adds up the weights of the ways that lead to it.
struct Met {
  Word word;
  std::uint32_t automorphisms = 1;
  std::uint32_t met = 0;
};

constexpr auto kByWord = [](const auto& a, const auto& b) { return a.word < b.word; };

/// 48 H / |Aut| of a ball of H hexahedra: its numberings from a start, up to automorphisms. An
/// automorphism that fixes a start is the identity, so the division leaves no remainder.
std::uint32_t starts_up_to_symmetry(int hexahedra, std::uint32_t automorphisms) {
  const auto starts = static_cast<std::uint32_t>(cells::kCubeSymmetries * hexahedra);
  core::ensures(starts % automorphisms == 0, "automorphisms move starts freely");
  return starts / automorphisms;
}

/// A part of the classes with a number of hexahedra, those whose words have some hash. Words that
/// are met often are put together from time to time.
class Shard {
 public:
  void add(const std::vector<Met>& more) {
    list_.insert(list_.end(), more.begin(), more.end());
    if (list_.size() >= next_merge_) merge();
  }
  void merge() {
    std::sort(list_.begin(), list_.end(), kByWord);
    auto last = list_.begin();
    for (auto at = list_.begin(); at != list_.end(); ++at) {
      if (at == list_.begin()) continue;
      if (at->word == last->word)
        last->met += at->met;
      else
        *++last = *at;
    }
    if (last != list_.end()) list_.erase(std::next(last), list_.end());
    next_merge_ = std::max(kFirstMerge, list_.size() + list_.size() / 2);
  }
  [[nodiscard]] std::size_t capacity() const noexcept { return list_.capacity(); }
  [[nodiscard]] std::size_t size() const noexcept { return list_.size(); }
  void move_to(std::vector<Met>& all) {
    all.insert(all.end(), list_.begin(), list_.end());
    list_ = {};
  }

 private:
  static constexpr std::size_t kFirstMerge = 4096;
  std::vector<Met> list_;
  std::size_t next_merge_ = kFirstMerge;
};

constexpr std::size_t kShards = 64;
using Block = std::array<std::vector<Met>, kShards>;

class Run {
 public:
  explicit Run(const ShellingOptions& options) : options_(options) {}

  ShellingCensus census() {
    const Corners only{0, 1, 2, 3, 4, 5, 6, 7};
    const CanonicalWord first = canonical_word(SmallBall({&only, 1}));
    const auto symmetries = static_cast<std::uint32_t>(first.automorphisms);
    ShellingCensus census;
    bool goes_on = finish(1, {Met{first.word, symmetries, 0}}, census);
    for (int h = 2; goes_on && h <= options_.hexahedra; ++h) {
      std::vector<Met> found;
      goes_on = grow(h, census.classes, found) && finish(h, std::move(found), census);
    }
    census.exhaustive = goes_on;
    return census;
  }

 private:
  /// Balls in one part of the work, and parts between two looks at memory and progress: tens of
  /// megabytes of words at once.
  static constexpr std::size_t kBlock = 128;
  static constexpr std::size_t kBlocksAtOnce = 64;

  [[nodiscard]] bool is_stopped() const {
    return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
  }

  /// All that gluing makes of `balls`, which have h - 1 hexahedra each. False if stopped.
  bool grow(int h, const std::vector<ShellableBall>& balls, std::vector<Met>& found) const {
    std::vector<Shard> shards(kShards);
    for (std::size_t first = 0; first < balls.size(); first += kBlock * kBlocksAtOnce) {
      if (options_.progress) options_.progress(h, first, balls.size());
      std::vector<Block> made(kBlocksAtOnce);
      parallel::parallel_for(options_.threads, made.size(), [&](std::size_t i) {
        const std::size_t begin = std::min(balls.size(), first + i * kBlock);
        const std::size_t end = std::min(balls.size(), begin + kBlock);
        for (std::size_t b = begin; b < end && !is_stopped(); ++b) glue_on(h, balls[b], made[i]);
      });
      if (is_stopped()) return false;
      parallel::parallel_for(options_.threads, kShards, [&](std::size_t s) {
        for (const Block& block : made) shards[s].add(block[s]);
      });
      expect_memory(h, balls, shards);
    }
    parallel::parallel_for(options_.threads, kShards, [&](std::size_t s) { shards[s].merge(); });
    std::size_t size = 0;
    for (const Shard& shard : shards) size += shard.size();
    found.reserve(size);
    for (Shard& shard : shards) shard.move_to(found);
    std::sort(found.begin(), found.end(), kByWord);
    return true;
  }

  static void glue_on(int h, const ShellableBall& of, Block& made) {
    const SmallBall ball = ball_of(of.word, h - 1);
    const std::uint32_t weight = starts_up_to_symmetry(h - 1, of.automorphisms);
    for (const Gluing& gluing : gluings(ball)) {
      SmallBall larger = ball;
      larger.glue(gluing);
      const CanonicalWord canonical = canonical_word(larger);
      made[std::hash<Word>{}(canonical.word) % kShards].push_back(
          {canonical.word, static_cast<std::uint32_t>(canonical.automorphisms), weight});
    }
  }

  /// Room is needed for one list of what the shards hold, and twice for the codes of boundaries.
  void expect_memory(int h, const std::vector<ShellableBall>& balls,
                     const std::vector<Shard>& shards) const {
    std::uint64_t bytes = balls.size() * sizeof(ShellableBall);
    for (const Shard& shard : shards)
      bytes +=
          shard.capacity() * sizeof(Met) + shard.size() * (sizeof(Met) + 2 * sizeof(canon::Code));
    if (bytes > options_.max_bytes)
      throw core::ResourceFailure("the balls of " + std::to_string(h) +
                                  " hexahedra need more memory than is allowed");
  }

  /// Checks the law for the classes with h hexahedra, counts them, and has them take the place of
  /// those before. False if stopped.
  bool finish(int h, std::vector<Met> found, ShellingCensus& census) {
    std::vector<canon::Code> codes(found.size());
    std::vector<std::uint64_t> unshellable((found.size() + kBlock - 1) / kBlock);
    parallel::parallel_for(options_.threads, unshellable.size(), [&](std::size_t i) {
      const std::size_t end = std::min(found.size(), (i + 1) * kBlock);
      for (std::size_t c = i * kBlock; c < end && !is_stopped(); ++c) {
        const SmallBall ball = ball_of(found[c].word, h);
        codes[c] = boundary_code(ball);
        if (h > 1) unshellable[i] += check_law(ball, found[c], census.classes);
      }
    });
    if (is_stopped()) return false;
    ShellingCounts counts{.hexahedra = h, .meshes = found.size()};
    for (const std::uint64_t count : unshellable) counts.unshellable_rests += count;
    count_boundaries(std::move(codes), counts);
    census.by_hexahedra.push_back(counts);
    census.classes.clear();
    census.classes.reserve(found.size());
    for (const Met& met : found) census.classes.push_back({met.word, met.automorphisms});
    return true;
  }

  /// For pairs of a ball N of H hexahedra and one of them whose rest is M, the sum of 1 / |Aut N|
  /// over the hexahedra is that of 1 / |Aut M| over the ways to glue that lead to N: both count
  /// pairs up to isomorphism, each weighted by its own symmetries. All is multiplied by 48 H (H-1).
  /// Gives the number of the rests that are not shellable.
  static std::uint64_t check_law(const SmallBall& ball, const Met& met,
                                 const std::vector<ShellableBall>& smaller) {
    std::uint64_t removable = 0, unshellable = 0;
    for (std::size_t c = 0; c < ball.cells().size(); ++c) {
      if (!is_removable(ball, c)) continue;
      const ShellableBall rest{canonical_word(ball.without(c)).word};
      const bool is_known = std::binary_search(smaller.begin(), smaller.end(), rest, kByWord);
      ++(is_known ? removable : unshellable);
    }
    const auto h = static_cast<std::uint64_t>(ball.size());
    core::ensures(
        met.met * h == removable * (h - 1) * starts_up_to_symmetry(ball.size(), met.automorphisms),
        "a class is met as often as hexahedra can be taken off it");
    return unshellable;
  }

  void count_boundaries(std::vector<canon::Code> codes, ShellingCounts& counts) {
    std::sort(codes.begin(), codes.end());
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    std::vector<canon::Code> all;
    std::set_union(seen_.begin(), seen_.end(), codes.begin(), codes.end(), std::back_inserter(all));
    counts.boundaries = codes.size();
    counts.new_boundaries = all.size() - seen_.size();
    seen_ = std::move(all);
  }

  const ShellingOptions& options_;
  std::vector<canon::Code> seen_;  ///< boundaries of all balls finished, ascending
};

/// Takes hexahedra off until one is left, going back where none can be; appends them to `taken`.
bool take_off(const SmallBall& ball, std::vector<Corners>& taken) {
  if (ball.size() == 1) {
    taken.push_back(ball.cell(0));
    return true;
  }
  for (std::size_t c = 0; c < ball.cells().size(); ++c) {
    if (!is_removable(ball, c)) continue;
    taken.push_back(ball.cell(c));
    if (take_off(ball.without(c), taken)) return true;
    taken.pop_back();
  }
  return false;
}

std::string line_of(const ShellableBall& entry, int hexahedra) {
  const SmallBall ball = in_shelling_order(ball_of(entry.word, hexahedra));
  std::string line =
      canon::to_text(boundary_code(ball)) + " " + std::to_string(entry.automorphisms);
  for (const Corners& cell : ball.cells())
    for (const Vertex v : cell) line += " " + std::to_string(v);
  return line + "\n";
}

}  // namespace

ShellingCensus shellable_balls(const ShellingOptions& options) {
  core::expects(options.hexahedra >= 1 && options.hexahedra <= kMaxBallHexahedra,
                "the census of shellable balls has 1 to 12 hexahedra");
  return Run(options).census();
}

canon::Code boundary_code(const SmallBall& ball) {
  const auto quads = complex::boundary_of(complex_of(ball));
  constexpr complex::Vertex kUnset = 0xFF;
  std::array<complex::Vertex, kMaxBallVertices> number{};
  number.fill(kUnset);
  complex::Vertex next = 0;
  std::vector<complex::QuadVertices> renamed(quads.size());
  for (std::size_t q = 0; q < quads.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i) {
      complex::Vertex& name = number[quads[q][i]];
      if (name == kUnset) name = next++;
      renamed[q][i] = name;
    }
  return canon::canonical_form(complex::Quadrangulation::from_quads(renamed).value()).code;
}

SmallBall in_shelling_order(const SmallBall& ball) {
  std::vector<Corners> cells;
  core::expects(take_off(ball, cells), "the ball is shellable");
  std::reverse(cells.begin(), cells.end());
  constexpr Vertex kUnset = 0xFF;
  std::array<Vertex, kMaxBallVertices> number{};
  number.fill(kUnset);
  Vertex next = 0;
  for (Corners& cell : cells)
    for (Vertex& v : cell) {
      if (number[v] == kUnset) number[v] = next++;
      v = number[v];
    }
  return SmallBall(cells);
}

std::string shellings_text(const ShellingCensus& census, int threads) {
  core::expects(census.exhaustive, "a list is written if it is complete");
  const int hexahedra = census.by_hexahedra.back().hexahedra;
  std::vector<std::string> lines(census.classes.size());
  parallel::parallel_for(threads, lines.size(),
                         [&](std::size_t i) { lines[i] = line_of(census.classes[i], hexahedra); });
  std::string text =
      "shellings 1 " + std::to_string(hexahedra) + " " + std::to_string(lines.size()) + "\n";
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace hexatlas::hexes
