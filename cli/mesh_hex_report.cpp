#include "cli/mesh_hex_report.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "cli/output.hpp"
#include "enum/core/errors.hpp"

namespace hexatlas::cli {
namespace {

Account what_was_given(const MeshHexOptions& options, const MeshHexAccount& given) {
  Account account{"What was given", {}};
  account.add("surface", shown_name(options.input, "standard input"));
  account.add("quads", given.surface.quads.size());
  account.add("points", given.surface.points.size());
  for (const std::string& note : given.notes) account.add("note", note);
  return account;
}

void add_method(Account& account, const hexahedrize::Hexahedrized& made, std::size_t quads) {
  if (made.method == hexahedrize::Method::table) {
    account.add("method", "look-up in the table");
    account.add("table entry", made.code);
    return;
  }
  if (made.peeling) {
    const bool by_zones = made.method == hexahedrize::Method::zones;
    account.add("method", by_zones ? "peeling by zones" : "peeling by flips");
    account.add("hexahedra taken off", made.peeling->peeled);
    account.add("layers among them", made.peeling->layers);
    account.add("quads of the rest", made.peeling->cavity);
    account.add("the rest filled by", words_for(made.peeling->rest));
  } else {
    account.add("method", "linear construction by sectors");
  }
  if (made.construction.sectors.empty()) return;
  for (const auto& sector : made.construction.sectors)
    account.add(fmt::format("sector of {}", counted(sector.hexahedra, "hexahedron", "hexahedra")),
                fmt::format("used {}", counted(sector.times, "time", "times")));
  const std::size_t filled = made.peeling ? made.peeling->cavity : quads;
  const std::size_t bound = made.construction.hexahedra_bound;
  account.add(made.peeling ? "proven bound for the rest" : "proven bound",
              fmt::format("{:g} hexahedra per quad: {} here", per_quad(bound, filled), bound));
}

Account what_was_done(const MeshHexOptions& options, const hexahedrize::Hexahedrized& made,
                      std::size_t quads, double seconds) {
  Account account{"What was done", {}};
  add_method(account, made, quads);
  const std::size_t hexahedra = made.mesh.hexahedra.size();
  account.add("hexahedra", hexahedra);
  account.add("hexahedra per quad", fmt::format("{:.2f}", per_quad(hexahedra, quads)));
  account.add("interior vertices", made.interior_vertices);
  account.add("mesh written", shown_name(options.output, "standard output"));
  account.add_seconds(seconds);
  return account;
}

}  // namespace

const char* words_for(hexahedrize::Rest rest) {
  switch (rest) {
    case hexahedrize::Rest::table:
      return "the table";
    case hexahedrize::Rest::layer:
      return "one layer";
    case hexahedrize::Rest::sectors:
      return "sectors";
  }
  throw core::InternalError("a rest without words");
}

double per_quad(std::size_t hexahedra, std::size_t quads) {
  return static_cast<double>(hexahedra) / static_cast<double>(quads);
}

MeshReport report_of(const MeshHexOptions& options, const MeshHexAccount& account,
                     const quality::Report& quality, double seconds) {
  Account judged = judgement(account.verdict);
  judged.add("boundary", "the given one: points bit for bit, quads one for one");
  return {shown_name(options.input, "standard input"),
          {what_was_given(options, account),
           what_was_done(options, account.made, account.surface.quads.size(), seconds), judged},
          {{"Quality", quality}}};
}

}  // namespace hexatlas::cli
