#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

#include "cli/command_line_parts.hpp"

namespace hexatlas::cli {
namespace {

constexpr int kMostPixels = 8192;

/// The whole text as a finite number.
std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

/// Two numbers with a sign between them.
std::optional<std::array<double, 2>> pair_in(std::string_view text, char between) {
  const std::size_t at = text.find(between);
  if (at == std::string_view::npos) return {};
  const auto first = number_in(text.substr(0, at)), second = number_in(text.substr(at + 1));
  if (!first || !second) return {};
  return std::array{*first, *second};
}

[[noreturn]] void refuse(const char* option, const std::string& word, const char* wanted) {
  throw CLI::ValidationError(option, "`" + word + "` is not " + wanted);
}

void add_slice(CLI::App& command, ViewState& state) {
  const auto read = [&state](const std::string& word) {
    const bool has_axis = word.size() > 2 && word[1] == '=' && word[0] >= 'x' && word[0] <= 'z';
    const auto at = has_axis ? number_in(std::string_view(word).substr(2)) : std::nullopt;
    if (!at || *at < 0 || *at > 1) refuse("--slice", word, "x=F, y=F or z=F with F from 0 to 1");
    state.is_sliced = true;
    state.slice_axis = word.substr(0, 1);
    state.slice_at = *at;
  };
  auto* slice = command.add_option_function<std::string>(
      "--slice", read,
      "Hide the cells whose centre is beyond this fraction of the box, as in x=0.5");
  slice->type_name("AXIS=F");
  command.add_flag("--flip", state.is_flipped, "Hide the cells on the other side of the slice")
      ->needs(slice);
}

void add_camera(CLI::App& command, ViewState& state) {
  const auto read = [&state](const std::string& word) {
    const auto angles = pair_in(word, ',');
    if (!angles || std::abs((*angles)[0]) > 360 || std::abs((*angles)[1]) > 90)
      refuse("--camera", word, "AZIMUTH,ELEVATION, with an elevation from -90 to 90");
    state.azimuth = (*angles)[0];
    state.elevation = (*angles)[1];
  };
  command
      .add_option_function<std::string>(
          "--camera", read, "Where one looks from, in degrees around and above; z is up")
      ->type_name("A,E")
      ->default_str("35,25");
}

void add_size(CLI::App& command, ViewOptions& options) {
  const auto read = [&options](const std::string& word) {
    const auto size = pair_in(word, 'x');
    for (const double side : size.value_or(std::array{0.0, 0.0}))
      if (side < 16 || side > kMostPixels || side != std::floor(side))
        refuse("--size", word, "WIDTHxHEIGHT, each from 16 to 8192 pixels");
    options.width = static_cast<int>((*size)[0]);
    options.height = static_cast<int>((*size)[1]);
  };
  command.add_option_function<std::string>("--size", read, "Size of the picture in pixels")
      ->type_name("WxH")
      ->default_str("1200x900");
}

}  // namespace

void add_view(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "view", "Show a mesh in 3D, as a page that needs no network, or as a picture");
  auto options = std::make_shared<ViewOptions>();
  ViewState& state = options->state;
  command
      ->add_option(
          "MESH", options->input,
          "Hexahedral or hybrid mesh or surface of triangles and quads: .vtu .vtk .mesh .msh .obj "
          ".off, or - for standard input")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Page to write (.html), or - for standard output")
      ->check(ends_in({".html", ".htm"}));
  command
      ->add_option("--png", options->png,
                   "Picture to write (.png), or - for standard output; made by Chromium, the "
                   "variable CHROMIUM or in "
                   "PATH")
      ->check(ends_in({".png"}));
  add_slice(*command, state);
  command
      ->add_option("--explode", state.explode,
                   "Move the cells apart, by this part of their "
                   "distance from the middle")
      ->check(number_between(0, 2))
      ->capture_default_str();
  command->add_option("--shrink", state.shrink, "Shrink each cell towards its centre by this part")
      ->check(number_between(0, 0.9))
      ->capture_default_str();
  command->add_option("--peel", state.peel, "Take off so many layers of cells")
      ->check(CLI::Range(0U, 1'000'000'000U))
      ->capture_default_str();
  command
      ->add_option(
          "--colour", state.colour,
          "jacobian, layer or none [jacobian]; of a hybrid mesh shape, layer or none [shape]")
      ->check(CLI::IsMember({"jacobian", "shape", "layer", "none"}))
      ->type_name("WORD");
  command
      ->add_option("--singular", state.singular,
                   "Singular edges to draw: interior, boundary, all or none")
      ->check(CLI::IsMember({"interior", "boundary", "all", "none"}))
      ->type_name("WORD")
      ->capture_default_str();
  add_camera(*command, state);
  add_size(*command, *options);
  command->add_option("--timeout", options->timeout, "Seconds that Chromium may take")
      ->check(CLI::Range(1, 86'400))
      ->capture_default_str();
  command->footer(
      "Examples:\n"
      "  hexatlas view pyramid.vtu -o pyramid.html\n"
      "  hexatlas view pyramid.vtu --png cut.png --slice x=0.5 --singular interior\n");
  command->callback([options, &action] { action = [options] { return view_mesh(*options); }; });
}

}  // namespace hexatlas::cli
