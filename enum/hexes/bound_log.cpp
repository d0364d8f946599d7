#include "enum/hexes/bound_log.hpp"

#include <mutex>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "enum/search/depth_first.hpp"

namespace hexatlas::hexes {
namespace {

using Root = search::Root<HexSearch::Choice>;

/// Writes the records below a state, or stops at a depth and lists what it left out.
class Writer {
 public:
  /// `has_found`, of all writers: one mesh, and no records matter.
  Writer(const complex::Quadrangulation& boundary, const SearchLimits& limits,
         std::atomic<bool>& has_found, const std::atomic<bool>* stop)
      : search_(boundary, limits, {.barred_tops = false}), has_found_(has_found), stop_(stop) {}

  /// The states with `depth` hexahedra are left out: segments() are the bytes between them.
  void write_top(std::size_t depth) {
    depth_ = depth;
    if (search_.first_quad() >= 0)
      state();
    else
      refutation();
    segments_.push_back(std::move(bytes_));
  }
  /// All records below a state that was left out.
  void write_below(const Root& root) {
    for (const HexSearch::Choice choice : root) (void)search_.apply(choice);
    depth_ = kMaxHexahedra + 1;
    state();
    for (std::size_t i = 0; i < root.size(); ++i) search_.undo();
  }

  [[nodiscard]] std::vector<Root>& left_out() { return left_out_; }
  [[nodiscard]] std::vector<std::string>& segments() { return segments_; }
  [[nodiscard]] std::string& bytes() { return bytes_; }
  [[nodiscard]] std::uint64_t records() const { return records_; }
  [[nodiscard]] bool is_stopped() const { return is_stopped_; }

 private:
  void byte(std::size_t value) {
    core::ensures(value < 256, "a place fits into a byte");
    bytes_.push_back(static_cast<char>(value));
  }

  void branch(std::size_t place) {
    ++records_;
    byte(0);
    byte(place);
  }

  void state() {
    is_stopped_ = is_stopped_ || (stop_ != nullptr && stop_->load(std::memory_order_relaxed));
    if (search_.is_complete()) has_found_ = true;
    if (is_stopped_ || has_found_.load(std::memory_order_relaxed)) return;
    if (search_.mesh().cells().size() == depth_) {
      left_out_.push_back(path_);
      segments_.push_back(std::exchange(bytes_, {}));
      return;
    }
    branch(search_.mesh().open().place_of(search_.mesh().bottom()));
    children();
  }

  void children() {
    for (const HexSearch::Choice choice : search_.choices()) {
      path_.push_back(choice);
      if (!search_.apply(choice)) {
        refutation();
      } else {
        if (search_.mesh().has_just_completed())
          state();
        else
          children();
        search_.undo();
      }
      path_.pop_back();
    }
  }

  void refutation() {
    using Rule = Refutation::Rule;
    const Refutation& why = search_.refutation();
    if (why.rule == Rule::no_candidate) {
      branch(why.places.front());
      return;
    }
    ++records_;
    byte(static_cast<std::size_t>(why.rule));
    if (why.rule == Rule::facets_apart)
      for (const std::size_t place : why.places) byte(place);
  }

  HexSearch search_;
  std::atomic<bool>& has_found_;
  const std::atomic<bool>* stop_;
  std::size_t depth_ = 0;
  Root path_;
  std::string bytes_;
  std::uint64_t records_ = 0;
  std::vector<Root> left_out_;
  std::vector<std::string> segments_;
  bool is_stopped_ = false;
};

}  // namespace

BoundLog bound_log(const complex::Quadrangulation& boundary, const SearchLimits& limits,
                   const BoundLogOptions& options) {
  constexpr std::size_t kDepth = 2;  // hexahedra: some hundreds of parts
  std::atomic<bool> has_found = false;
  Writer top(boundary, limits, has_found, options.stop);
  top.write_top(kDepth);
  const std::vector<Root>& roots = top.left_out();
  BoundLog log;
  log.records = top.records();
  bool is_stopped = top.is_stopped();
  std::vector<std::string> parts(roots.size());
  std::mutex mutex;
  std::size_t done = 0;
  parallel::parallel_for(options.threads, roots.size(), [&](std::size_t i) {
    Writer part(boundary, limits, has_found, options.stop);
    part.write_below(roots[i]);
    parts[i] = std::move(part.bytes());
    const std::lock_guard lock(mutex);
    log.records += part.records();
    is_stopped = is_stopped || part.is_stopped();
    if (options.progress) options.progress(++done, roots.size());
  });
  log.has_found_a_mesh = has_found;
  log.is_complete = !is_stopped && !has_found;
  log.bytes = std::move(top.segments().front());
  for (std::size_t i = 0; i < parts.size(); ++i) log.bytes += parts[i] + top.segments()[i + 1];
  return log;
}

}  // namespace hexatlas::hexes
