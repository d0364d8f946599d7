#include "cli/boundary_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "enum/canon/code.hpp"
#include "enum/complex/quad_surface.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/quads/planar_code.hpp"
#include "meshing/hexahedrize/hexahedrize.hpp"
#include "meshing/hexahedrize/small_form.hpp"
#include "meshing/io/mesh_files.hpp"
#include "tables/build/named.hpp"

namespace hexatlas::cli {
namespace {

using complex::Quadrangulation;

Quadrangulation quadrangulation_of(const mesh::SurfaceMesh& surface, const std::string& name) {
  if (const auto boundary = hexahedrize::small_form(hexahedrize::sphere_of(surface, name)))
    return *boundary;
  throw core::InvalidInput(name, "has more than 64 quads, the most that have codes");
}

/// By the name or, of a regular file, by the first bytes.
bool is_list_in_planar_code(const std::string& file) {
  if (file.ends_with(".planar_code")) return true;
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown)) return false;
  std::array<char, quads::kPlanarCodeHeader.size()> first{};
  std::ifstream in(file, std::ios::binary);
  in.read(first.data(), first.size());
  return in && std::equal(first.begin(), first.end(), quads::kPlanarCodeHeader.begin());
}

canon::Code code_of_file(const std::string& file) {
  std::optional<Quadrangulation> first;
  std::size_t count = 0;
  for_each_quadrangulation_in(file, [&](const Quadrangulation& q) {
    if (++count == 1) first = q;
  });
  if (count == 1) return canon::canonical_form(*first).code;
  throw core::InvalidInput(input_name(file),
                           count == 0 ? "has no quadrangulation"
                                      : fmt::format("has {} quadrangulations where one is wanted; "
                                                    "`hexatlas code` gives their codes",
                                                    count));
}

canon::Code code_from(const std::string& text) {
  if (const auto* named = build::named_boundary(text)) return canon::from_text(named->code).value();
  if (const auto code = canon::from_text(text)) return *code;
  if (is_there(text) || text == "-") return code_of_file(text);
  throw core::InvalidInput(
      text, "is no name of a boundary, no code, and no file; `hexatlas table info` lists names");
}

/// As complex::reason_against_filling says it, for words whose graph need not be simple.
std::optional<std::string> reason_against_filling(const Quadrangulation& boundary) {
  const std::vector<complex::QuadVertices> quads = boundary.list_of_quads();
  const bool is_even = quads.size() % 2 == 0;
  if (const auto law = complex::broken_law(quads); law && is_even)
    return "the boundary is not 3-connected: " + law->reason;
  complex::QuadSphere sphere;
  for (const auto& quad : quads) sphere.quads.push_back({quad[0], quad[1], quad[2], quad[3]});
  for (int v = 0; v < boundary.vertices(); ++v)
    sphere.point_of.push_back(static_cast<complex::VertexId>(v));
  return complex::reason_against_filling(sphere);
}

/// The boundary of a code, called `shown` in what is said of it.
std::variant<NamedBoundary, Unfillable> boundary_of(const std::string& shown,
                                                    const canon::Code& code) {
  const auto boundary = canon::decode(code);
  if (!boundary)
    throw core::InvalidInput(shown,
                             "is no code of a quadrangulation; `hexatlas code FILE` gives one");
  if (const auto reason = reason_against_filling(*boundary))
    return Unfillable{code.quads, "no hexahedral mesh exists: " + *reason};
  const canon::Code canonical = canon::canonical_form(*boundary).code;
  if (canonical != code)
    throw core::InvalidInput(
        shown, "is not canonical; the code of this boundary is " + canon::to_text(canonical));
  return NamedBoundary{canon::to_text(code), *boundary};
}

}  // namespace

bool for_each_quadrangulation_in(const std::string& file,
                                 const std::function<void(const Quadrangulation&)>& visit) {
  if (file != "-" && !is_list_in_planar_code(file)) {
    visit(quadrangulation_of(io::read_surface(file), file));
    return false;
  }
  const std::string bytes = core::read_file(file);
  const std::string name = input_name(file);
  if (file == "-" && !bytes.starts_with(quads::kPlanarCodeHeader)) {
    const io::FileFormat format = io::detect_format(bytes, name, io::Content::surface);
    visit(quadrangulation_of(io::parse_surface(bytes, format, name), name));
    return false;
  }
  quads::for_each_in_planar_code(bytes, name, visit);
  return true;
}

std::variant<NamedBoundary, Unfillable> boundary_from(const std::string& name_code_or_file) {
  return boundary_of(name_code_or_file, code_from(name_code_or_file));
}

std::optional<NamedBoundary> fillable_boundary_of_code(const std::string& word) {
  const auto code = canon::from_text(word);
  const auto boundary = boundary_of(word, code ? *code : canon::Code{});
  if (const auto* unfillable = std::get_if<Unfillable>(&boundary)) {
    say(fmt::format("{}: {}", word, unfillable->reason));
    return std::nullopt;
  }
  return std::get<NamedBoundary>(boundary);
}

}  // namespace hexatlas::cli
