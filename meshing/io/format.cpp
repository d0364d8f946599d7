#include "meshing/io/format.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "enum/core/errors.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

constexpr std::array kFormats{FileFormat::obj, FileFormat::off,   FileFormat::vtk,
                              FileFormat::vtu, FileFormat::medit, FileFormat::gmsh};

std::string known_extensions() {
  std::string list;
  for (const FileFormat format : kFormats) {
    list += list.empty() ? "" : " ";
    list += extension_of(format);
  }
  return list;
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
  }
  throw core::PreconditionViolated("extension_of: the format is one of the enumerators");
}

bool holds_hexahedra(FileFormat format) {
  return format != FileFormat::obj && format != FileFormat::off;
}

FileFormat format_of_path(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::size_t dot = path.find_last_of('.');
  if (dot != std::string::npos && (slash == std::string::npos || dot > slash)) {
    const std::string extension = lower(path.substr(dot));
    for (const FileFormat format : kFormats)
      if (extension == extension_of(format)) return format;
  }
  throw core::InvalidInput(
      path, "the extension names no known mesh format (known: " + known_extensions() + ")");
}

FileFormat detect_format(std::string_view bytes, const std::string& file) {
  const std::string_view text = without_byte_order_mark(bytes);
  if (text.empty()) throw core::InvalidInput(file, "is empty");
  if (text.starts_with("# vtk")) return FileFormat::vtk;
  Scanner scanner(text, file, '#');
  if (!scanner.at_end()) {
    const std::string_view first = scanner.word("a format");
    if (first.starts_with("<")) return FileFormat::vtu;
    if (first.starts_with("$")) return FileFormat::gmsh;
    if (first.starts_with("MeshVersion")) return FileFormat::medit;
    if (first.ends_with("OFF")) return FileFormat::off;
    if (is_obj_keyword(first)) return FileFormat::obj;
  }
  throw core::InvalidInput(file,
                           "begins like no known mesh format (known: " + known_extensions() + ")");
}

}  // namespace hexatlas::io
