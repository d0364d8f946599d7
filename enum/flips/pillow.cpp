#include "enum/flips/pillow.hpp"

#include <deque>
#include <optional>

namespace hexatlas::flips {
namespace {

using Patch = Peeling::Patch;
using VertexId = Peeling::VertexId;

/// Goes from the rim inwards, or from the first quad on, such that what is left always consists of
/// discs: then each flip takes away a patch.
class Layer {
 public:
  Layer(Peeling& peeling, std::span<const std::uint32_t> quads) : peeling_(peeling), quads_(quads) {
    for (const std::uint32_t q : quads) covered_.add(q);
  }

  std::optional<std::vector<LayerQuads>> take() {
    find_rim();
    std::vector<LayerQuads> taken;
    while (!open_.empty()) {
      const std::uint32_t quad = open_.front();
      open_.pop_front();
      if (!covered_.has(quad) || !peeling_.is_live(quad)) continue;
      const std::optional<Patch> patch = patch_at(quad);
      if (!patch) continue;  // comes up again when a quad beside it is taken
      Peeling::Prism prism;
      if (!peeling_.may_take(*patch, prism)) break;
      for (unsigned i = 0; i < 4; ++i) {
        touched_.add(prism.bottom[i]);
        open_.push_back(peeling_.twin(4 * quad + i) / 4);
      }
      taken.push_back({quad, peeling_.quad_numbers()});
      peeling_.take(*patch, prism);
      is_begun_ = true;
    }
    if (taken.size() == quads_.size()) return taken;
    for (std::size_t i = 0; i < taken.size(); ++i) peeling_.put_back();
    return std::nullopt;
  }

 private:
  void find_rim() {
    for (const std::uint32_t q : quads_)
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t side = peeling_.twin(4 * q + i);
        if (covered_.has(side / 4)) continue;
        touched_.add(peeling_.origin(4 * q + i));
        touched_.add(peeling_.origin(side));
        open_.push_back(q);
      }
    is_begun_ = !open_.empty();
    if (open_.empty() && !quads_.empty()) open_.push_back(quads_.front());
  }

  /// The sides without a quad to be covered are taken with it; nullopt if it meets what is done in
  /// a vertex alone, or not at all.
  [[nodiscard]] std::optional<Patch> patch_at(std::uint32_t quad) const {
    Patch patch{quad, 0};
    for (unsigned i = 0; i < 4; ++i)
      if (!covered_.has(peeling_.twin(4 * quad + i) / 4))
        patch.sides = static_cast<std::uint8_t>(patch.sides | 1U << i);
    if (patch.sides == 0 && is_begun_) return std::nullopt;
    for (unsigned i = 0; i < 4; ++i) {
      const bool is_joined = ((patch.sides | patch.sides << 4U) >> (i + 3) & 3U) != 0;
      if (!is_joined && touched_.has(peeling_.origin(4 * quad + i))) return std::nullopt;
    }
    return patch;
  }

  Peeling& peeling_;
  std::span<const std::uint32_t> quads_;
  Marks covered_;  ///< quads, taken ones included: no quad beside them is one of these any more
  Marks touched_;  ///< vertices of the rim and of quads taken
  std::deque<std::uint32_t> open_;
  bool is_begun_ = false;
};

}  // namespace

std::optional<std::vector<LayerQuads>> take_layer(Peeling& peeling,
                                                  std::span<const std::uint32_t> quads) {
  return Layer(peeling, quads).take();
}

}  // namespace hexatlas::flips
