#include "tables/build/catalogues.hpp"

#include "enum/core/checks.hpp"

namespace hexatlas::build {
namespace {

format::CatalogueClass class_of(const complex::Triangulation& triangulation,
                                std::uint64_t automorphisms) {
  format::CatalogueClass entry;
  entry.triangulation = triangulation;
  entry.automorphisms = automorphisms;
  const complex::ShellingAnswer shelling = complex::search_shelling(triangulation);
  entry.shelled = shelling.outcome == complex::ShellingSearch::found;
  if (entry.shelled)
    for (std::size_t i = 0; i < shelling.order.size(); ++i)
      entry.triangulation.tetrahedra[i] = triangulation.tetrahedra[shelling.order[i]];
  return entry;
}

}  // namespace

format::Catalogue catalogue_of(const complex::Cell& cell, const std::string& name,
                               const balls::CensusOptions& options, const balls::Census& census) {
  core::expects(options.keep_classes, "catalogue_of: the census kept its classes");
  format::Catalogue catalogue;
  catalogue.name = name;
  catalogue.vertices = cell.vertices + options.interior;
  catalogue.interior = options.interior;
  catalogue.cell = cell;
  catalogue.boundary_tetrahedra = options.boundary_tetrahedra;
  catalogue.symmetries = census.symmetries;
  catalogue.labelled = census.total().labelled;
  catalogue.exhaustive = census.exhaustive;
  for (const balls::TriangulationClass& entry : census.classes)
    catalogue.classes.push_back(class_of(entry.canonical, entry.automorphisms));
  return catalogue;
}

format::Catalogue catalogue_of(const std::vector<balls::Ball>& list, int vertices) {
  format::Catalogue catalogue;
  catalogue.name = "balls-" + std::to_string(vertices);
  catalogue.vertices = vertices;
  for (const balls::Ball& ball : list)
    catalogue.classes.push_back(class_of(ball.triangulation, ball.automorphisms));
  return catalogue;
}

format::Catalogue part_of(const format::Catalogue& catalogue, std::size_t number) {
  core::expects(number <= catalogue.classes.size(), "part_of: no such class");
  if (number == 0) return catalogue;
  format::Catalogue part = catalogue;
  part.classes = {catalogue.classes[number - 1]};
  part.labelled = part.symmetries / part.classes.front().automorphisms;
  part.exhaustive = false;
  return part;
}

}  // namespace hexatlas::build
