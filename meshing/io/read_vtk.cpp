// VTK legacy files, ASCII. Source: "VTK File Formats for VTK version 4.2", section "Simple Legacy
// Formats", and the VTK documentation for version 5.1, where a list of cells is an array of
// offsets and an array of indices. Points count from 0; keywords are case-insensitive.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

/// Cells of one list: cell i is connectivity[begin[i] .. begin[i + 1]).
struct CellList {
  std::vector<mesh::Index> connectivity;
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> line;

  [[nodiscard]] std::size_t size() const { return line.size(); }
  [[nodiscard]] std::span<const mesh::Index> cell(std::size_t i) const {
    return std::span(connectivity).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

std::string upper(std::string_view word) {
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

class VtkReader {
 public:
  VtkReader(std::string_view bytes, MeshBuilder& builder)
      : scanner_(bytes, builder.file()), builder_(builder) {}

  void read() {
    read_header();
    read_dataset();
    while (!scanner_.at_end()) {
      const std::string keyword = upper(scanner_.word("a section"));
      // Attributes come last; they are ignored.
      if (keyword == "POINT_DATA" || keyword == "CELL_DATA") break;
      read_section(keyword);
    }
    if (cells_ && !types_read_) scanner_.fail_cut("CELL_TYPES");
    // Where cells are wanted, their lack or their indices tell.
    if (builder_.wanted() == Wanted::points && !points_read_) scanner_.fail_cut("POINTS");
  }

 private:
  void read_header() {
    constexpr std::string_view kMagic = "# vtk DataFile Version ";
    constexpr std::array<std::string_view, 6> kVersions{"2.0", "3.0", "4.0", "4.1", "4.2", "5.1"};
    const std::string_view first = scanner_.rest_of_line();
    if (!first.starts_with(kMagic)) scanner_.fail("'# vtk DataFile Version x.y' is expected");
    std::string_view version = first.substr(kMagic.size());
    version = version.substr(0, version.find_last_not_of(" \t") + 1);
    if (std::find(kVersions.begin(), kVersions.end(), version) == kVersions.end())
      scanner_.fail("unsupported version " + in_quotes(version));
    has_offsets_ = version == "5.1";
    static_cast<void>(scanner_.rest_of_line());  // the title
    const std::string encoding = upper(scanner_.word("ASCII"));
    if (encoding == "BINARY") scanner_.fail("binary VTK legacy file; save as ASCII");
    if (encoding != "ASCII") scanner_.fail("ASCII is expected, not " + in_quotes(encoding));
    scanner_.refuse_nul();
  }

  void read_dataset() {
    std::string keyword = upper(scanner_.word("DATASET"));
    if (keyword == "FIELD") {
      skip_field();
      keyword = upper(scanner_.word("DATASET"));
    }
    if (keyword != "DATASET") scanner_.fail("DATASET is expected, not " + in_quotes(keyword));
    const std::string_view type = scanner_.word("the type of the data set");
    is_poly_data_ = upper(type) == "POLYDATA";
    if (!is_poly_data_ && upper(type) != "UNSTRUCTURED_GRID")
      scanner_.fail("data set of type " + in_quotes(type) +
                    "; UNSTRUCTURED_GRID or POLYDATA is expected");
  }

  void read_section(const std::string& keyword) {
    if (keyword == "POINTS") return read_points();
    if (keyword == "FIELD") return skip_field();
    if (keyword == "METADATA") return skip_metadata();
    if (is_poly_data_) {
      if (keyword == "VERTICES") return add_all(read_cells(), *vtk_cell_type(2));
      if (keyword == "LINES") return add_all(read_cells(), *vtk_cell_type(4));
      if (keyword == "TRIANGLE_STRIPS") return add_all(read_cells(), *vtk_cell_type(6));
      if (keyword == "POLYGONS") return add_all(read_cells(), *vtk_cell_type(7));
    } else if (keyword == "CELLS") {
      if (cells_) scanner_.fail("second section CELLS");
      cells_ = read_cells();
      return;
    } else if (keyword == "CELL_TYPES") {
      return read_cell_types();
    }
    scanner_.fail("unknown section " + in_quotes(keyword));
  }

  void read_points() {
    if (std::exchange(points_read_, true)) scanner_.fail("second section POINTS");
    constexpr std::size_t kPointBytes = 6;  // "0 0 0" and a separator
    const std::int64_t announced = scanner_.integer("the number of points");
    check_number_type();
    const std::size_t count = scanner_.to_count(announced, kPointBytes);
    builder_.reserve_points(count);
    for (std::size_t i = 0; i < count; ++i) {
      mesh::Point point;
      for (double* coordinate : {&point.x, &point.y, &point.z})
        *coordinate = scanner_.real("a coordinate");
      builder_.add_point(point, scanner_.line());
    }
  }

  void check_number_type() { expect_number_type(scanner_.word("a type of numbers")); }

  void expect_number_type(std::string_view type) {
    constexpr std::array<std::string_view, 15> kTypes{
        "DOUBLE",         "FLOAT",         "INT",           "UNSIGNED_INT",
        "LONG",           "UNSIGNED_LONG", "VTKTYPEINT64",  "SHORT",
        "CHAR",           "BIT",           "UNSIGNED_CHAR", "VTKIDTYPE",
        "UNSIGNED_SHORT", "VTKTYPEUINT64", "VTKTYPEINT32"};
    if (std::find(kTypes.begin(), kTypes.end(), upper(type)) == kTypes.end())
      scanner_.fail("unknown type of numbers " + in_quotes(type));
  }

  [[nodiscard]] CellList read_cells() {
    return has_offsets_ ? read_offset_cells() : read_counted_cells();
  }

  /// "n size", then for each cell its number of vertices and the vertices.
  [[nodiscard]] CellList read_counted_cells() {
    const std::size_t count = scanner_.count("the number of cells", 2);
    std::size_t left = scanner_.count("the size of the list of cells", 2);
    CellList list;
    list.begin.reserve(count + 1);
    list.line.reserve(count);
    if (left >= count) list.connectivity.reserve(left - count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t vertices = scanner_.integer("the number of vertices of a cell");
      if (vertices < 0 || left == 0 || static_cast<std::uint64_t>(vertices) > left - 1)
        scanner_.fail("a cell of " + std::to_string(vertices) +
                      " vertices exceeds the size of the list of cells");
      left -= static_cast<std::size_t>(vertices) + 1;
      list.line.push_back(static_cast<std::uint32_t>(scanner_.line()));
      for (std::int64_t k = 0; k < vertices; ++k) list.connectivity.push_back(scanner_.index(0));
      list.begin.push_back(list.connectivity.size());
    }
    if (left != 0) scanner_.fail("the list of cells is shorter than its announced size");
    return list;
  }

  /// "offsets size", then OFFSETS (one more than there are cells) and CONNECTIVITY.
  [[nodiscard]] CellList read_offset_cells() {
    const std::size_t offsets = scanner_.count("the number of offsets", 2);
    const std::size_t size = scanner_.count("the size of the connectivity", 2);
    CellList list;
    if (offsets == 0 && size == 0) return list;
    expect("OFFSETS");
    list.begin.clear();
    list.begin.reserve(offsets);
    for (std::size_t i = 0; i < offsets; ++i) {
      const std::int64_t offset = scanner_.integer("an offset");
      const std::size_t least = list.begin.empty() ? 0 : list.begin.back();
      if (offset < 0 || static_cast<std::uint64_t>(offset) < least ||
          static_cast<std::uint64_t>(offset) > size || (i == 0 && offset != 0))
        scanner_.fail("offset " + std::to_string(offset) + " is not in order");
      list.begin.push_back(static_cast<std::size_t>(offset));
    }
    if (list.begin.empty() || list.begin.back() != size)
      scanner_.fail("the last offset is not the size of the connectivity");
    expect("CONNECTIVITY");
    list.line.reserve(offsets - 1);
    list.connectivity.reserve(size);
    for (std::size_t i = 0; i + 1 < offsets; ++i) {
      for (std::size_t k = list.begin[i]; k < list.begin[i + 1]; ++k) {
        list.connectivity.push_back(scanner_.index(0));
        if (k == list.begin[i]) list.line.push_back(static_cast<std::uint32_t>(scanner_.line()));
      }
      if (list.begin[i] == list.begin[i + 1])
        list.line.push_back(static_cast<std::uint32_t>(scanner_.line()));
    }
    return list;
  }

  void expect(const std::string& keyword) {
    const std::string_view word = scanner_.word(keyword.c_str());
    if (upper(word) != keyword) scanner_.fail(keyword + " is expected, not " + in_quotes(word));
    check_number_type();
  }

  void read_cell_types() {
    if (!cells_) scanner_.fail("CELL_TYPES before CELLS");
    if (std::exchange(types_read_, true)) scanner_.fail("second section CELL_TYPES");
    const std::size_t count = scanner_.count("the number of cell types", 2);
    if (count != cells_->size())
      scanner_.fail(std::to_string(count) + " cell types for " + std::to_string(cells_->size()) +
                    " cells");
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t number = scanner_.integer("a cell type");
      const auto type = vtk_cell_type(number);
      if (!type) scanner_.fail("cell of unknown type " + std::to_string(number));
      builder_.add_cell(*type, cells_->cell(i), cells_->line[i]);
    }
  }

  void add_all(const CellList& list, const CellType& type) {
    for (std::size_t i = 0; i < list.size(); ++i)
      builder_.add_cell(type, list.cell(i), list.line[i]);
  }

  /// "FIELD name n", then n arrays "name components tuples type" with their numbers.
  void skip_field() {
    static_cast<void>(scanner_.word("the name of the field"));
    const std::size_t arrays = scanner_.count("the number of arrays", 8);
    for (std::size_t i = 0; i < arrays; ++i) {
      std::string_view name = scanner_.word("the name of an array");
      while (upper(name) == "METADATA") {
        skip_metadata();
        name = scanner_.word("the name of an array");
      }
      const std::size_t components = scanner_.count("the number of components", 1);
      const std::size_t tuples = scanner_.count("the number of tuples", 1);
      const std::string_view type = scanner_.word("a type of numbers");
      const bool is_text = upper(type) == "STRING";
      if (!is_text) expect_number_type(type);
      if (tuples != 0 && components > (scanner_.bytes_left() + 1) / (is_text ? 1 : 2) / tuples)
        scanner_.fail("the array " + in_quotes(name) + " is larger than the file");
      if (is_text) {  // each in a line of its own, after that of the heading
        for (std::size_t k = 0; k <= components * tuples; ++k)
          static_cast<void>(scanner_.rest_of_line());
        continue;
      }
      for (std::size_t k = 0; k < components * tuples; ++k)
        static_cast<void>(scanner_.real("a number of the field"));
    }
  }

  /// Ends with an empty line.
  void skip_metadata() {
    static_cast<void>(scanner_.rest_of_line());
    while (scanner_.bytes_left() > 0)
      if (scanner_.rest_of_line().find_first_not_of(" \t") == std::string_view::npos) return;
  }

  Scanner scanner_;
  MeshBuilder& builder_;
  std::optional<CellList> cells_;
  bool has_offsets_ = false;
  bool is_poly_data_ = false;
  bool points_read_ = false;
  bool types_read_ = false;
};

}  // namespace

void read_vtk(std::string_view bytes, MeshBuilder& builder) { VtkReader(bytes, builder).read(); }

}  // namespace hexatlas::io
