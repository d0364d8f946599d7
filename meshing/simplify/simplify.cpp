#include "meshing/simplify/simplify.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/core/random.hpp"
#include "meshing/simplify/cavity.hpp"
#include "meshing/simplify/edited_mesh.hpp"
#include "meshing/simplify/known_balls.hpp"

namespace hexatlas::simplify {
namespace {

using complex::HexComplex;

class Simplifier {
 public:
  Simplifier(const HexComplex& mesh, const format::Table* table, const Options& options)
      : options_(options),
        random_(options.seed),
        known_(table),
        edited_(mesh),
        cavity_(edited_, known_, &options_.apart),
        best_(mesh),
        least_(edited_.size()) {}

  Simplified run() {
    const std::size_t patience = std::max<std::size_t>(options_.tries / 8, 1000);
    std::size_t last = 0;  // try that gave the least mesh, or that began with it again
    Simplified result;
    std::size_t& tries = result.tries;
    for (; tries < options_.tries && least_ > 1; ++tries) {
      if (options_.stop != nullptr && options_.stop->load()) {
        result.is_stopped = true;
        break;
      }
      if (options_.progress && tries % 64 == 0)
        options_.progress(tries, static_cast<std::size_t>(least_));
      const int before = least_;
      if (auto exchange = exchange_somewhere()) {
        make(*std::move(exchange));
        ++result.exchanges;
      }
      if (least_ < before) last = tries;
      if (edited_.size() > least_ && tries - last > patience) {
        edited_ = EditedMesh(best_);
        last = tries;
      }
    }
    if (edited_.size() == least_) best_ = edited_.mesh();
    result.mesh = std::move(best_);
    return result;
  }

 private:
  /// Grows one cavity and finds the first exchange that helps; otherwise, where it can, one that
  /// adds few hexahedra or none.
  std::optional<Exchange> exchange_somewhere() {
    const int more = climb();
    cavity_.restart(random_);
    std::optional<Exchange> sideways;
    while (cavity_.grow(random_)) {
      if (cavity_.size() == edited_.size() && !options_.whole) break;
      if (cavity_.quads() > options_.max_cavity) continue;
      const bool may_go_sideways = !sideways && random_.below(8) == 0;
      auto found = exchange(may_go_sideways ? cavity_.size() + more : cavity_.size() - 1);
      cavity_.remember(random_);
      if (!found) continue;
      if (found->instead.size() < found->cells.size()) return found;
      sideways = std::move(found);
    }
    return sideways;
  }

  /// How many hexahedra an exchange may add: mostly none.
  int climb() {
    constexpr std::size_t kMost = 3;
    const int room = least_ + static_cast<int>(options_.uphill) - edited_.size();
    if (random_.below(4) != 0) return 0;
    return std::min(room, 1 + static_cast<int>(random_.below(kMost)));
  }

  /// An exchange of the cavity for one of the least balls that fit, if they have fewer hexahedra,
  /// or for one with at most `most`, with as many where there are any: few are larger than others,
  /// and would hardly ever be chosen among all.
  std::optional<Exchange> exchange(int most) {
    std::vector<Fit> fits = cavity_.fits(most);
    if (fits.empty()) return std::nullopt;
    const auto by_size = [](const Fit& a, const Fit& b) {
      return a.ball->hexahedra() < b.ball->hexahedra();
    };
    const auto [least, largest] = std::minmax_element(fits.begin(), fits.end(), by_size);
    const int wanted =
        (least->ball->hexahedra() < cavity_.size() ? least : largest)->ball->hexahedra();
    std::erase_if(fits, [wanted](const Fit& fit) { return fit.ball->hexahedra() != wanted; });
    return cavity_.exchange_for(fits[random_.below(fits.size())]);
  }

  void make(Exchange exchange) {
    const auto after = edited_.size() - static_cast<int>(exchange.cells.size()) +
                       static_cast<int>(exchange.instead.size());
    if (edited_.size() == least_ && after > least_) best_ = edited_.mesh();
    edited_.make(std::move(exchange));
    least_ = std::min(least_, after);
  }

  const Options& options_;
  core::Random random_;
  KnownBalls known_;
  EditedMesh edited_;
  Cavity cavity_;
  HexComplex best_;
  int least_;
};

}  // namespace

Simplified simplified(const HexComplex& mesh, const format::Table* table, const Options& options) {
  core::expects(options.max_cavity <= flips::kMaxSearchQuads, "a cavity has at most 26 quads");
  const auto boundary_vertices = static_cast<int>(complex::boundary_of(mesh).size()) + 2;
  Simplified result = Simplifier(mesh, table, options).run();
  if (result.mesh.hexahedra.size() < mesh.hexahedra.size())
    result.mesh = complex::compacted(std::move(result.mesh), boundary_vertices);
  else
    result.mesh = mesh;
  return result;
}

}  // namespace hexatlas::simplify
