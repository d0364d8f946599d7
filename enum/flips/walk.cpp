#include "enum/flips/walk.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "enum/flips/draw.hpp"

namespace hexatlas::flips {
namespace {

using complex::HexComplex;

constexpr std::size_t kLayersKept = 10'000;

}  // namespace

const Layers& BallLayers::of(FrontId ball) {
  if (known_.size() >= kLayersKept) known_.clear();
  const auto [at, is_new] = known_.try_emplace(ball);
  if (is_new) at->second = layers_along(balls_, ball, Growth::outward);
  return at->second;
}

Walk::Walk(HexComplex mesh, int quads, const Beam& balls, std::uint64_t seed, int faults)
    : mesh_(std::move(mesh)),
      quads_(quads),
      balls_(balls),
      random_(seed),
      neighbours_(SubBall::neighbours_of(mesh_)),
      ball_(mesh_, neighbours_, 0, widest_on_the_way(balls)),
      faults_(faults) {}

bool Walk::exchange(const Climate& climate, BallLayers& layers, std::optional<Leap> leap) {
  if (ball_.quads() > balls_.options().max_quads) return false;
  const auto drawn = draw(ball_, balls_, climate, leap, random_, sums_);
  if (!drawn) return false;
  HexComplex made = complex::compacted(
      exchanged(mesh_, ball_, layers.of(drawn->fit.ball), drawn->fit), quads_ + 2);
  auto neighbours = SubBall::neighbours_if_complex(made, quads_);
  if (!neighbours) return false;
  mesh_ = std::move(made);
  neighbours_ = *std::move(neighbours);
  faults_ += drawn->faults;
  return true;
}

bool Walk::step(const Climate& climate, BallLayers& layers) {
  ball_.restart(static_cast<std::uint32_t>(random_.below(mesh_.hexahedra.size())));
  const std::size_t size = size_of_exchange(random_);
  const int weight = static_cast<int>(random_.below(5));
  return ball_.grow_to(size, random_, weight) && exchange(climate, layers, std::nullopt);
}

bool Walk::leap(const Climate& climate, BallLayers& layers, int tries, Leap kind) {
  const std::size_t all = mesh_.hexahedra.size();
  const std::size_t least = (all + 1) / 2;  // smaller balls have hardly any of the other parity
  for (int i = 0; i < tries && least < all; ++i) {
    ball_.restart(static_cast<std::uint32_t>(random_.below(all)));
    const std::size_t size = least + random_.below(all - least);
    const int weight = 1 + static_cast<int>(random_.below(8));
    (void)ball_.grow_to(size, random_, weight);  // whatever size it came to
    if (exchange(climate, layers, kind)) return true;
  }
  return false;
}

}  // namespace hexatlas::flips
