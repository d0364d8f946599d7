#include "tables/check/bound.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "tables/check/bound_file.hpp"
#include "tables/check/bound_partners.hpp"
#include "tables/check/bound_paths.hpp"
#include "tables/check/bound_rules.hpp"
#include "tables/check/bound_sphere.hpp"
#include "tables/check/bound_state.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/zstd_frame.hpp"

namespace hexatlas::check {

namespace {

constexpr std::string_view kFirstWords = "hexatlas-bound ";

enum class Record : std::uint8_t {
  kBranch = 0,
  kFaceBudget = 1,
  kCornerBudget = 2,
  kLink = 3,
  kSymmetry = 4,
  kFacetsApart = 5,
  kPartners = 6,
};

/// Goes through the tree of the log, depth first. Its methods return false, and leave the fault in
/// the verdict, as soon as the log is wrong.
class Replay {
 public:
  Replay(const BoundFile& file, BoundVerdict& verdict)
      : file_(file),
        verdict_(verdict),
        automorphisms_(automorphisms_of(file.quads)),
        state_(file.quads, file.is_ball) {}

  bool run() {
    if (!refute_state()) return false;
    if (at_ == file_.log.size()) return true;
    verdict_.fault = "bytes after the last record";
    return false;
  }

 private:
  bool fail(const std::string& reason) {
    verdict_.fault = "record " + std::to_string(verdict_.records) + ": " + reason;
    return false;
  }
  bool fail_unless(bool holds, const std::string& reason) { return holds || fail(reason); }

  bool read_byte(std::uint8_t& byte) {
    if (at_ == file_.log.size()) return fail("the log ends too early");
    byte = static_cast<std::uint8_t>(file_.log[at_++]);
    return true;
  }

  [[nodiscard]] int left() const {
    return file_.hexahedra - static_cast<int>(state_.hexahedra().size());
  }

  bool refute_state() {
    ++verdict_.records;
    std::uint8_t byte = 0;
    if (!read_byte(byte)) return false;
    const auto record = Record{byte};
    // A ball whose facets are used up is no mesh to find if it has a bad link; else it is one.
    if (state_.open_count() == 0 && !(record == Record::kLink && has_bad_link(state_))) {
      return fail("the hexahedra are a mesh");
    }
    const bool asks_for_tops = record == Record::kBranch || record == Record::kCornerBudget ||
                               record == Record::kFacetsApart;
    if (asks_for_tops) saturate();
    switch (record) {
      case Record::kBranch:
        return refute_children();
      case Record::kFaceBudget:
        return fail_unless(exceeds_face_budget(state_, left()), "the face budget is not exceeded");
      case Record::kCornerBudget:
        return fail_unless(is_negative(within_room(state_, file_.interior, left())),
                           "the corner budget is not exceeded");
      case Record::kLink:
        return fail_unless(has_bad_link(state_), "no link of the last hexahedron is bad");
      case Record::kSymmetry:
        return fail_unless(file_.has_symmetry && has_lesser_image(state_, automorphisms_),
                           "no image of the hexahedra has a lesser path");
      case Record::kFacetsApart:
        return refute_by_facets_apart();
      case Record::kPartners:
        return fail_unless(
            file_.is_ball && partners_of(state_, may_come(state_, file_.interior)).are_too_few,
            "no vertex lacks partners");
    }
    return fail("there is no record " + std::to_string(byte));
  }

  bool read_place(const std::vector<std::uint16_t>& open, std::size_t& facet) {
    std::uint8_t place = 0;
    if (!read_byte(place)) return false;
    if (place >= open.size()) return fail("no open facet has this place");
    facet = open[place];
    return true;
  }

  bool refute_children() {
    ++verdict_.branches;
    if (left() == 0) return fail("no hexahedron may come any more");
    std::size_t facet = 0;
    if (!read_place(state_.open_facets(), facet)) return false;
    const VertexSet saturated = state_.saturated();
    for (const BoundCorners& tops :
         state_.tops_on(facet, within_room(state_, file_.interior, left()))) {
      state_.put(facet, tops);
      if (!refute_state()) return false;
      state_.take_back();
      state_.saturate(saturated);
    }
    return true;
  }

  /// Of the state, what the other rules need to know.
  void saturate() {
    if (!file_.is_ball) return;
    state_.saturate(partners_of(state_, may_come(state_, file_.interior)).saturated);
  }

  bool refute_by_facets_apart() {
    const std::vector<std::uint16_t> open = state_.open_facets();
    std::vector<std::size_t> apart;
    for (int i = 0; i <= left(); ++i) {
      std::size_t facet = 0;
      if (!read_place(open, facet)) return false;
      for (const std::size_t other : apart) {
        if (other == facet) return fail("one facet is given twice");
        if (!are_apart(state_, state_.facets()[std::min(other, facet)],
                       state_.facets()[std::max(other, facet)])) {
          return fail("two facets may be those of one hexahedron");
        }
      }
      apart.push_back(facet);
    }
    return true;
  }

  const BoundFile& file_;
  BoundVerdict& verdict_;
  std::vector<BoundAutomorphism> automorphisms_;
  BoundState state_;
  std::size_t at_ = 0;
};

}  // namespace

bool is_bound(std::string_view bytes) {
  return begins_zstd_frame(bytes) && start_of_frame(bytes, kFirstWords.size()) == kFirstWords;
}

BoundVerdict check_bound_bytes(std::string_view bytes, const std::string& name) {
  std::string text;
  if (!unpack_frame(bytes, kMostBoundBytes, text)) {
    throw Malformed(
        name, 0,
        "is not one Zstandard frame of at most " + std::to_string(kMostBoundBytes) + " bytes");
  }
  const BoundFile file = read_bound(text, name);
  BoundVerdict verdict;
  verdict.code = file.code;
  verdict.is_ball = file.is_ball;
  verdict.hexahedra = file.hexahedra;
  verdict.interior = file.interior;
  // Each mesh has at most 2 H + 1 - N / 2 of them.
  verdict.any_interior =
      2 * file.interior >= 4 * file.hexahedra + 2 - static_cast<int>(file.quads.size());
  verdict.fault = fault_of_boundary(file.quads, file.code);
  if (verdict.fault.empty()) {
    // Some ten thousand bytes of tables: not on the stack.
    verdict.accepted = std::make_unique<Replay>(file, verdict)->run();
  }
  return verdict;
}

}  // namespace hexatlas::check
