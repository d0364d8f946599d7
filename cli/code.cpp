#include "enum/canon/code.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/boundary_input.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"

namespace hexatlas::cli {
namespace {

std::string json_line(const complex::Quadrangulation& boundary, const canon::CanonicalForm& form) {
  nlohmann::ordered_json json;
  json["code"] = canon::to_text(form.code);
  json["quads"] = boundary.quads();
  json["automorphisms"] = form.automorphisms;
  json["rotations"] = form.rotations;
  json["three_connected"] = boundary.is_three_connected();
  return to_line(json);
}

}  // namespace

ExitCode code(const CodeOptions& options) {
  std::string lines;
  complex::Quadrangulation boundary;  // the last one
  canon::CanonicalForm form;
  const bool is_list =
      for_each_quadrangulation_in(options.input, [&](const complex::Quadrangulation& found) {
        boundary = found;
        form = canon::canonical_form(boundary);
        lines += options.json ? json_line(boundary, form) : canon::to_text(form.code) + "\n";
      });
  if (!is_list && !options.json)
    lines += fmt::format("{} quads, {} automorphisms of which {} keep the orientation, {}\n",
                         boundary.quads(), form.automorphisms, form.rotations,
                         boundary.is_three_connected() ? "3-connected" : "not 3-connected");
  print(lines);
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
