#include "tables/sheet/distribution_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tables/sheet/markup.hpp"

namespace hexatlas::sheet {
namespace {

constexpr std::size_t kColumns = 2;
constexpr double kWidth = 460, kHeight = 190;  // of a panel with its margins
constexpr double kPlotWidth = 390, kPlotHeight = 120;
constexpr double kLeft = 58, kTop = 34;   // of the plot in its panel
constexpr double kHead = 66, kFoot = 14;  // above and below all panels
constexpr std::size_t kMostLinear = 100;
constexpr double kLogFloor = 0.5;        // so that a bar for one quadrangulation can be seen
constexpr const char* kBar = "#0072B2";  // Okabe and Ito's blue
constexpr const char* kLine = "#D9D9D9";
constexpr const char* kInk = "#222222";

/// 49957 -> "49,957".
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, ',');
  return digits;
}

std::string text_at(double x, double y, const char* anchor, int size, const std::string& text) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n", x, y,
      anchor, size, escaped(text));
}

std::string line(double x1, double y1, double x2, double y2) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2,
      y2, kLine);
}

/// The scales that all panels share.
struct Scales {
  int most_hexahedra = 1;
  std::size_t most_meshes = 1;

  explicit Scales(const std::vector<Distribution>& distributions) {
    for (const Distribution& d : distributions)
      for (const auto& [hexahedra, count] : d.meshes) {
        most_hexahedra = std::max(most_hexahedra, hexahedra);
        most_meshes = std::max(most_meshes, count);
      }
  }
  [[nodiscard]] bool is_logarithmic() const { return most_meshes > kMostLinear; }
  [[nodiscard]] double bar_width() const { return kPlotWidth / (most_hexahedra + 1); }
  /// The middle of the bar.
  [[nodiscard]] double x(int hexahedra) const { return (hexahedra + 0.5) * bar_width(); }
  [[nodiscard]] double height(std::size_t count) const {
    const auto value = static_cast<double>(count);
    const auto most = static_cast<double>(most_meshes);
    return kPlotHeight * (is_logarithmic()
                              ? std::log(value / kLogFloor) / std::log(most / kLogFloor)
                              : value / most);
  }
  /// Powers of ten, or up to five steps of 1, 2 or 5 times a power of ten.
  [[nodiscard]] std::vector<std::size_t> ticks() const {
    std::vector<std::size_t> result;
    if (is_logarithmic()) {
      for (std::size_t tick = 1; tick <= most_meshes; tick *= 10) result.push_back(tick);
      return result;
    }
    const std::size_t step = step_for(most_meshes);
    for (std::size_t tick = step; tick <= most_meshes; tick += step) result.push_back(tick);
    return result;
  }
  [[nodiscard]] static std::size_t step_for(std::size_t most) {
    for (std::size_t power = 1;; power *= 10)
      for (const std::size_t digit : {1U, 2U, 5U})
        if (most <= 5 * digit * power) return digit * power;
  }
};

std::string heading(const Distribution& d) {
  return fmt::format("{} quads: {} {}{}, median {:g}", d.quads, grouped(d.entries()),
                     d.entries() == 1 ? "quadrangulation" : "quadrangulations",
                     d.is_complete ? " (all)" : "", d.median());
}

std::string panel(const Distribution& d, const Scales& scales, double left, double top) {
  std::string svg = fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n", left, top);
  svg += text_at(0, -10, "start", 14, heading(d));
  for (const std::size_t tick : scales.ticks()) {
    const double y = kPlotHeight - scales.height(tick);
    svg += line(0, y, kPlotWidth, y);
    svg += text_at(-6, y + 4, "end", 12, grouped(tick));
  }
  const auto step = static_cast<int>(
      Scales::step_for(static_cast<std::size_t>(scales.most_hexahedra) * 5 / 8 + 1));
  for (int tick = 0; tick <= scales.most_hexahedra; tick += step)
    svg += text_at(scales.x(tick), kPlotHeight + 16, "middle", 12, std::to_string(tick));
  const double width = std::max(0.8 * scales.bar_width(), 0.5);
  for (const auto& [hexahedra, count] : d.meshes)
    svg += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
        scales.x(hexahedra) - width / 2, kPlotHeight - scales.height(count), width,
        scales.height(count), kBar);
  svg +=
      fmt::format("<line x1=\"0\" y1=\"{0:.1f}\" x2=\"{1:.1f}\" y2=\"{0:.1f}\" stroke=\"{2}\"/>\n",
                  kPlotHeight, kPlotWidth, kInk);
  return svg + "</g>\n";
}

std::string described(const std::vector<Distribution>& distributions) {
  std::string text;
  for (const Distribution& d : distributions)
    text += fmt::format("{}; from {} to {} hexahedra. ", heading(d), d.meshes.begin()->first,
                        d.meshes.rbegin()->first);
  return text;
}

}  // namespace

std::size_t Distribution::entries() const {
  std::size_t sum = 0;
  for (const auto& [hexahedra, count] : meshes) sum += count;
  return sum;
}

std::size_t Distribution::hexahedra() const {
  std::size_t sum = 0;
  for (const auto& [hexahedra, count] : meshes) sum += static_cast<std::size_t>(hexahedra) * count;
  return sum;
}

double Distribution::median() const {
  const std::size_t all = entries();
  const auto number_at = [&](std::size_t place) {
    auto at = meshes.begin();
    for (std::size_t before = at->second; before <= place; before += at->second) ++at;
    return at->first;
  };
  return (number_at((all - 1) / 2) + number_at(all / 2)) / 2.0;
}

std::string distribution_chart(const std::vector<Distribution>& distributions,
                               const std::string& title) {
  const Scales scales(distributions);
  const std::size_t rows = (distributions.size() + kColumns - 1) / kColumns;
  const double width = static_cast<double>(kColumns) * kWidth;
  const double height = kHead + static_cast<double>(rows) * kHeight + kFoot;
  const std::string caption = fmt::format(
      "Hexahedra of the smallest mesh found (across) and number of quadrangulations (up); {} "
      "scale, the same in all panels",
      scales.is_logarithmic() ? "logarithmic" : "linear");
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" role=\"img\" aria-labelledby=\"title desc\" font-family=\"sans-serif\" "
      "fill=\"{2}\">\n<title id=\"title\">{3}</title>\n<desc id=\"desc\">{4}</desc>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#FFFFFF\"/>\n",
      width, height, kInk, escaped(title), escaped(caption + ". " + described(distributions)));
  svg += text_at(kLeft, 28, "start", 18, title);
  svg += text_at(kLeft, 50, "start", 13, caption);
  for (std::size_t i = 0; i < distributions.size(); ++i) {
    const std::size_t column = i % kColumns, row = i / kColumns;
    svg += panel(distributions[i], scales, static_cast<double>(column) * kWidth + kLeft,
                 static_cast<double>(row) * kHeight + kHead + kTop);
  }
  return svg + "</svg>\n";
}

}  // namespace hexatlas::sheet
