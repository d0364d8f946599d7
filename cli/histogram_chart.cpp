#include "cli/histogram_chart.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hexatlas::cli {
namespace {

constexpr double kWidth = 720, kHeight = 300;
constexpr double kLeft = 66, kTop = 30;  // of the plot
constexpr double kPlotWidth = 644, kPlotHeight = 206;
constexpr double kSlot = kPlotWidth / static_cast<double>(quality::kHistogramBins);
constexpr double kBar = 0.78 * kSlot;

/// Such a step of 1, 2 or 5 times a power of ten that five reach `most`.
std::size_t step_for(std::size_t most) {
  for (std::size_t power = 1;; power *= 10)
    for (const std::size_t digit : {1U, 2U, 5U})
      if (most <= 5 * digit * power) return digit * power;
}

std::string text(double x, double y, const char* anchor, const char* kind,
                 const std::string& words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>\n",
                     x, y, anchor, kind, words);
}

std::string bar(double x, double top, double height, const char* kind) {
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"{:.1f}\" height=\"{:.2f}\" class=\"{}\"/>\n", x, top,
      kBar, height, kind);
}

std::string axes(std::size_t most, double unit) {
  std::string svg;
  const std::size_t step = step_for(most);
  for (std::size_t tick = 0; tick <= most; tick += step) {
    const double y = kTop + kPlotHeight - unit * static_cast<double>(tick);
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" class=\"{3}\"/>\n",
        kLeft, y, kLeft + kPlotWidth, tick == 0 ? "axis" : "grid");
    svg += text(kLeft - 8, y + 4, "end", "label", std::to_string(tick));
  }
  const double middle = kTop + kPlotHeight / 2;
  svg += text(kLeft + kPlotWidth / 2, kHeight - 10, "middle", "label", "scaled Jacobian");
  svg += fmt::format(
      "<text x=\"14\" y=\"{0:.1f}\" text-anchor=\"middle\" class=\"label\" "
      "transform=\"rotate(-90 14 {0:.1f})\">hexahedra</text>\n",
      middle);
  return svg;
}

std::string key() {
  const double y = 12, right = kLeft + kPlotWidth;
  const auto square = [&](double x, const char* kind) {
    return fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"10\" height=\"10\" class=\"{}\"/>\n", x, y - 9,
        kind);
  };
  return square(right - 176, "inverted") + text(right - 161, y, "start", "label", "inverted") +
         square(right - 90, "bar") + text(right - 75, y, "start", "label", "not inverted");
}

/// As histogram_bin(), shorter.
std::string under_bar(std::size_t bin) {
  if (bin == 0) return histogram_bin(bin);
  if (bin + 1 == quality::kHistogramBins) return fmt::format("0.{}\u20131", bin);
  return fmt::format("0.{}\u20130.{}", bin, bin + 1);
}

std::string described(const quality::Report& report) {
  std::string words = "Hexahedra by scaled Jacobian";
  for (std::size_t bin = 0; bin < report.histogram.size(); ++bin)
    words +=
        fmt::format("{} {}: {}", bin == 0 ? ":" : ",", histogram_bin(bin), report.histogram[bin]);
  return words + ".";
}

}  // namespace

std::string histogram_bin(std::size_t bin) {
  if (bin == 0) return "below 0.1";
  if (bin + 1 == quality::kHistogramBins) return fmt::format("0.{} to 1", bin);
  return fmt::format("0.{} to 0.{}", bin, bin + 1);
}

std::string histogram_chart(const quality::Report& report, const std::string& id) {
  const auto& counts = report.histogram;
  const std::size_t most =
      std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  const double unit = kPlotHeight / static_cast<double>(most);
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-labelledby=\"{}-title {}-words\">\n"
      "<title id=\"{}-title\">Histogram of the scaled Jacobian</title>\n"
      "<desc id=\"{}-words\">{}</desc>\n",
      kWidth, kHeight, id, id, id, id, described(report));
  svg += axes(most, unit);
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    const double slot = kLeft + kSlot * static_cast<double>(bin);
    const double x = slot + (kSlot - kBar) / 2;
    const double base = kTop + kPlotHeight;
    const double height = unit * static_cast<double>(counts[bin]);
    const double inverted =
        bin == 0 ? unit * static_cast<double>(std::min(report.inverted, counts[0])) : 0;
    if (height > inverted) svg += bar(x, base - height, height - inverted, "bar");
    if (inverted > 0) svg += bar(x, base - inverted, inverted, "inverted");
    if (counts[bin] > 0)
      svg +=
          text(slot + kSlot / 2, base - height - 6, "middle", "count", std::to_string(counts[bin]));
    svg += text(slot + kSlot / 2, base + 18, "middle", "label", under_bar(bin));
  }
  if (report.inverted > 0) svg += key();
  return svg + "</svg>\n";
}

}  // namespace hexatlas::cli
