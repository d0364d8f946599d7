#pragma once
/// \file
/// The law that a reader must obey on arbitrary bytes: it refuses them with InvalidInput, or its
/// mesh, written in the same format and read again, is the same bit for bit; the points of a mesh
/// are those that the reader of points finds, and are finite; what is read from .hxtet has no other
/// bytes. Used by the libFuzzer targets, by the test that replays their corpus and findings, and by
/// the test of mutations.

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "enum/core/errors.hpp"
#include "meshing/io/mesh_files.hpp"
#include "tests/meshing/io/sample_hybrid.hpp"

namespace hexatlas::fuzz {

struct Outcome {
  bool is_surface = false;
  bool is_hexahedral = false;
  bool is_tetrahedral = false;
  bool is_hybrid = false;
  bool has_points = false;
};

/// Throws std::logic_error, which nothing catches, if the law is broken. `points`: those found by
/// the reader of points, if it found any.
template <class Parse>
bool obeys_round_trip(std::string_view bytes, io::FileFormat format,
                      const std::optional<std::vector<mesh::Point>>& points, const Parse& parse) {
  auto mesh = parse(bytes);
  if (!mesh) return false;
  if (!points || !io_tests::same(*points, mesh->points)) throw std::logic_error("other points");
  for (const io::GmshVersion version : {io::GmshVersion::v2_2, io::GmshVersion::v4_1}) {
    std::string text;
    if constexpr (requires { mesh->quads; })
      text = io::to_text(*mesh, format, version);
    else if constexpr (requires { mesh->prisms; })
      text = io::to_text(*mesh, format);
    else if constexpr (requires { mesh->tetrahedra; })
      text = io::to_text(mesh::TetView{mesh->points, mesh->tetrahedra}, format);
    else
      text = io::to_text(*mesh, format, io::WriteOptions{version, {}});
    const auto again = parse(text);
    if (!again || !io_tests::same(*again, *mesh)) throw std::logic_error("round trip: " + text);
    if (format == io::FileFormat::hxtet && text != bytes) throw std::logic_error("other bytes");
    if (format != io::FileFormat::gmsh) break;
  }
  return true;
}

inline Outcome check_bytes(std::string_view bytes, io::FileFormat format) {
  const auto refusable = [&](auto&& read) {
    return [read](std::string_view text) -> std::optional<decltype(read(text))> {
      try {
        return read(text);
      } catch (const core::InvalidInput& error) {
        const std::string_view message = error.what();
        if (!message.starts_with("input:") || message.find('\n') != std::string_view::npos)
          throw std::logic_error("message: " + std::string(message));
        return std::nullopt;
      }
    };
  };
  const auto points = refusable(
      [&](std::string_view text) { return io::parse_points(text, format, "input"); })(bytes);
  const auto is_finite = [](const mesh::Point& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (points && !std::all_of(points->begin(), points->end(), is_finite))
    throw std::logic_error("a point is not finite");
  const auto obeys = [&](auto&& read) {
    return obeys_round_trip(bytes, format, points, refusable([&, read](std::string_view text) {
                              return read(text, format, "input");
                            }));
  };
  const bool is_tetrahedral = obeys(io::parse_tetrahedra);
  // A model is a tetrahedral mesh; its references may be refused.
  const auto model = refusable(
      [&](std::string_view text) { return io::parse_tet_model(text, format, "input"); })(bytes);
  if (model && !is_tetrahedral) throw std::logic_error("a model of no tetrahedral mesh");
  if (model &&
      (model->colours.size() != model->triangles.size() ||
       (!model->regions.empty() && model->regions.size() != model->mesh.tetrahedra.size())))
    throw std::logic_error("references of a model");
  return {obeys(io::parse_surface), obeys(io::parse_hexahedra), is_tetrahedral,
          obeys(io::parse_hybrid), points.has_value()};
}

}  // namespace hexatlas::fuzz
