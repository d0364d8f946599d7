#include "cli/cell_input.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <variant>
#include <vector>

#include "enum/core/errors.hpp"
#include "meshing/io/mesh_files.hpp"

namespace hexatlas::cli {
namespace {

/// The stem of the file in the letters of a catalogue's name.
std::string name_from(const std::string& file) {
  std::string name;
  for (const unsigned char c : std::filesystem::path(file).stem().string())
    name += std::isalnum(c) != 0 && c < 128 ? static_cast<char>(std::tolower(c)) : '-';
  return name.empty() || name == "-" ? "surface" : name;
}

complex::Cell cell_in(const mesh::FacetMesh& mesh, const std::string& file) {
  std::map<mesh::Index, std::uint8_t> number;
  for (const mesh::Facet& facet : mesh.facets)
    for (std::size_t i = 0; i < facet.size; ++i) number[facet.vertices[i]] = 0;
  if (number.size() > complex::kMaxCellVertices)
    throw core::InvalidInput(file, "has " + std::to_string(number.size()) +
                                       " vertices; a cell has at most " +
                                       std::to_string(complex::kMaxCellVertices));
  std::uint8_t next = 0;
  for (auto& [point, vertex] : number) vertex = next++;
  std::vector<complex::CellFacet> facets;
  for (const mesh::Facet& facet : mesh.facets) {
    complex::CellFacet& of_cell = facets.emplace_back();
    of_cell.size = facet.size;
    for (std::size_t i = 0; i < facet.size; ++i) of_cell.vertex[i] = number[facet.vertices[i]];
  }
  auto cell = complex::cell_of(facets, static_cast<int>(number.size()));
  if (const auto* broken = std::get_if<complex::BrokenLaw>(&cell))
    throw core::InvalidInput(file, broken->cell ? mesh.facets[*broken->cell].line : 0,
                             broken->reason);
  return std::get<complex::Cell>(std::move(cell));
}

}  // namespace

NamedCell cell_from(const std::string& name_or_file) {
  if (auto cell = complex::cell_named(name_or_file)) return {name_or_file, *cell};
  if (name_or_file.find('.') == std::string::npos && name_or_file != "-") {
    std::string names;
    for (const auto name : complex::cell_names()) names += " " + std::string(name);
    throw core::InvalidInput(
        name_or_file, "is no cell; known are" + names + ", or a surface file such as cell.obj");
  }
  NamedCell input{name_from(name_or_file), cell_in(io::read_facets(name_or_file), name_or_file)};
  // A known name promises the known facets, in their numbering.
  if (complex::cell_named(input.name)) input.name = "surface-" + input.name;
  return input;
}

}  // namespace hexatlas::cli
