#include "cli/boundary_input.hpp"

#include <optional>

#include "cli/table_path.hpp"
#include "enum/canon/code.hpp"
#include "enum/core/errors.hpp"
#include "meshing/hexahedrize/hexahedrize.hpp"
#include "meshing/hexahedrize/small_form.hpp"
#include "meshing/io/mesh_files.hpp"
#include "tables/build/named.hpp"

namespace hexatlas::cli {
namespace {

canon::Code code_of_surface(const std::string& file) {
  const complex::QuadSphere sphere = hexahedrize::sphere_of(io::read_surface(file), file);
  const auto boundary = hexahedrize::small_form(sphere);
  if (!boundary) throw core::InvalidInput(file, "has more than 64 quads, too many for a search");
  return canon::canonical_form(*boundary).code;
}

canon::Code code_from(const std::string& text) {
  if (const auto* named = build::named_boundary(text)) return canon::from_text(named->code).value();
  if (const auto code = canon::from_text(text)) return *code;
  if (is_there(text) || text == "-") return code_of_surface(text);
  throw core::InvalidInput(
      text, "is no name of a boundary, no code, and no file; `hexatlas table info` lists names");
}

}  // namespace

void expect_canonical(const std::string& word, const complex::Quadrangulation& boundary) {
  const std::string code = canon::to_text(canon::canonical_form(boundary).code);
  if (word != code)
    throw core::InvalidInput(word, "is not canonical; the code of this boundary is " + code);
}

NamedBoundary boundary_from(const std::string& name_code_or_file) {
  const canon::Code code = code_from(name_code_or_file);
  const auto boundary = canon::decode(code);
  if (!boundary) throw core::InvalidInput(name_code_or_file, "is no code of a quadrangulation");
  const std::string word = canon::to_text(code);
  expect_canonical(word, *boundary);
  if (boundary->quads() % 2 != 0)
    throw core::InvalidInput(name_code_or_file, "has an odd number of quads, so there is no mesh");
  if (!boundary->is_three_connected())
    throw core::InvalidInput(name_code_or_file, "is not 3-connected, so there is no mesh");
  return {word, *boundary};
}

}  // namespace hexatlas::cli
