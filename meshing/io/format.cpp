#include "meshing/io/format.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "enum/core/errors.hpp"
#include "meshing/io/hxtet.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

constexpr std::array kFormats{FileFormat::obj,   FileFormat::off,  FileFormat::vtk, FileFormat::vtu,
                              FileFormat::medit, FileFormat::gmsh, FileFormat::xyz, FileFormat::raw,
                              FileFormat::ply,   FileFormat::hxtet};

/// "(known: .obj .off)" of the formats with this content, or of all.
/// Where there is no name, one tells a format by its first bytes, which a .bin does not have.
std::string known_extensions(std::optional<Content> content, bool is_by_name = true) {
  std::string list;
  for (const FileFormat format : kFormats) {
    if (content && !holds(format, *content)) continue;
    if (!is_by_name && format == FileFormat::raw) continue;
    list += list.empty() ? "(known: " : " ";
    list += extension_of(format);
  }
  return list + ")";
}

std::string name_of(Content content) {
  switch (content) {
    case Content::points:
      return "points";
    case Content::weighted_points:
      return "points with weights";
    case Content::surface:
      return "surfaces";
    case Content::tetrahedra:
      return "tetrahedra";
    case Content::hexahedra:
      return "hexahedra";
    case Content::hybrid:
      return "hybrid meshes";
  }
  throw core::PreconditionViolated("name_of: the content is one of the enumerators");
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

bool is_obj_keyword(std::string_view word) {
  constexpr std::array<std::string_view, 9> kUsual{"v", "vt", "vn",     "f",     "o",
                                                   "g", "s",  "mtllib", "usemtl"};
  return std::find(kUsual.begin(), kUsual.end(), word) != kUsual.end();
}

}  // namespace

std::string_view extension_of(FileFormat format) {
  switch (format) {
    case FileFormat::obj:
      return ".obj";
    case FileFormat::off:
      return ".off";
    case FileFormat::vtk:
      return ".vtk";
    case FileFormat::vtu:
      return ".vtu";
    case FileFormat::medit:
      return ".mesh";
    case FileFormat::gmsh:
      return ".msh";
    case FileFormat::xyz:
      return ".xyz";
    case FileFormat::raw:
      return ".bin";
    case FileFormat::ply:
      return ".ply";
    case FileFormat::hxtet:
      return ".hxtet";
  }
  throw core::PreconditionViolated("extension_of: the format is one of the enumerators");
}

bool holds(FileFormat format, Content content) {
  switch (format) {
    case FileFormat::obj:
    case FileFormat::off:
      return content == Content::points || content == Content::surface;
    case FileFormat::vtk:
    case FileFormat::vtu:
    case FileFormat::medit:
    case FileFormat::gmsh:
      return content != Content::weighted_points;
    case FileFormat::xyz:
    case FileFormat::raw:
      return content == Content::points || content == Content::weighted_points;
    case FileFormat::ply:
      return content == Content::points;
    case FileFormat::hxtet:
      return content == Content::points || content == Content::tetrahedra;
  }
  throw core::PreconditionViolated("holds: the format is one of the enumerators");
}

void expect_holds(FileFormat format, Content content, const std::string& file) {
  if (holds(format, content)) return;
  throw core::InvalidInput(file, "the format " + std::string(extension_of(format)) +
                                     " is not one for " + name_of(content) + " " +
                                     known_extensions(content));
}

FileFormat format_of_path(const std::string& path, std::optional<Content> content) {
  const std::size_t slash = path.find_last_of('/');
  const std::size_t dot = path.find_last_of('.');
  if (dot != std::string::npos && (slash == std::string::npos || dot > slash)) {
    const std::string extension = lower(path.substr(dot));
    for (const FileFormat format : kFormats)
      if (extension == extension_of(format)) return format;
  }
  throw core::InvalidInput(path,
                           "the extension names no known mesh format " + known_extensions(content));
}

FileFormat detect_format(std::string_view bytes, const std::string& file,
                         std::optional<Content> content) {
  const std::string_view text = without_byte_order_mark(bytes);
  if (text.empty()) throw core::InvalidInput(file, "is empty");
  if (text.starts_with("# vtk")) return FileFormat::vtk;
  if (bytes.starts_with(kHxtetMagic)) return FileFormat::hxtet;
  Scanner scanner(text, file, '#');
  if (!scanner.at_end()) {
    const std::string_view first = scanner.word("a format");
    if (first == "ply") return FileFormat::ply;
    if (first.starts_with("<")) return FileFormat::vtu;
    if (first.starts_with("$")) return FileFormat::gmsh;
    if (first.starts_with("MeshVersion")) return FileFormat::medit;
    if (first.ends_with("OFF")) return FileFormat::off;
    if (is_obj_keyword(first)) return FileFormat::obj;
    if (is_number(first)) return FileFormat::xyz;
  }
  throw core::InvalidInput(file,
                           "begins like no known mesh format " + known_extensions(content, false));
}

}  // namespace hexatlas::io
