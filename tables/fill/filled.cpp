#include "tables/fill/filled.hpp"

#include <string>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"

namespace hexatlas::fill {

std::optional<std::string> reason_against(const complex::HexComplex& mesh,
                                          const canon::Code& code) {
  if (const auto law = complex::validate(mesh)) return law->reason;
  std::vector<complex::BoundaryQuad> wanted;
  const auto boundary = canon::decode(code).value();
  for (int q = 0; q < boundary.quads(); ++q) {
    const auto v = boundary.vertices_of(q);
    wanted.push_back({v[0], v[1], v[2], v[3]});
  }
  if (!complex::has_boundary(mesh, std::move(wanted))) return "its boundary is another one";
  return std::nullopt;
}

void ensure_fills(const complex::HexComplex& mesh, const canon::Code& code) {
  if (const auto reason = reason_against(mesh, code))
    throw core::InternalError("a mesh found for " + canon::to_text(code) +
                              " breaks a law: " + *reason);
}

complex::HexComplex mesh_in(const format::Table& table, std::size_t ordinal,
                            const std::string& name) {
  complex::HexComplex mesh = table.mesh(ordinal);
  const canon::Code code = table.entry(ordinal).code;
  if (const auto reason = reason_against(mesh, code))
    throw core::InvalidInput(
        name, "holds a mesh of " + canon::to_text(code) + " that breaks a law: " + *reason);
  return mesh;
}

}  // namespace hexatlas::fill
