#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <pugixml.hpp>

#include "tables/check/malformed.hpp"
#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"
#include "tables/check/vtu_data.hpp"

static_assert(std::endian::native == std::endian::little, "arrays are copied as they are stored");

namespace hexatlas::check {

namespace {

/// The bytes of a file, its XML without the appended data, and the appended data.
class VtuFile {
 public:
  VtuFile(const std::string& name, std::string_view bytes) : name_(name), bytes_(bytes) {
    std::string xml(bytes);
    const std::size_t element = bytes.find("<AppendedData");
    if (element != std::string_view::npos) xml = without_appended(element);
    const pugi::xml_parse_result result = document_.load_buffer(xml.data(), xml.size());
    if (!result) fail(result.offset, std::string("not XML: ") + result.description());
  }

  [[nodiscard]] pugi::xml_node root() const { return document_.child("VTKFile"); }
  [[nodiscard]] std::string_view appended() const { return appended_; }
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Offsets count bytes of the XML, hence of the file for all that precedes the appended data.
  [[nodiscard]] std::size_t line(std::ptrdiff_t offset) const {
    const auto place = std::clamp<std::ptrdiff_t>(
        offset, 0, static_cast<std::ptrdiff_t>(std::min(bytes_.size(), appended_at_)));
    return 1 + static_cast<std::size_t>(std::count(bytes_.begin(), bytes_.begin() + place, '\n'));
  }
  [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& reason) const {
    throw Malformed(name_, line(offset), reason);
  }
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& reason) const {
    fail(node ? node.offset_debug() : 0, reason);
  }

 private:
  /// Raw appended data may hold any byte, so they are cut out before the XML is read. They begin
  /// after the first underscore in the element and end with its last closing tag.
  std::string without_appended(std::size_t element) {
    const std::size_t begin = bytes_.find('>', element);
    const std::size_t end = bytes_.rfind("</AppendedData>");
    const std::size_t mark = begin == std::string_view::npos ? begin : bytes_.find('_', begin);
    if (mark == std::string_view::npos || end == std::string_view::npos || end < mark) {
      fail(static_cast<std::ptrdiff_t>(element), "AppendedData is cut");
    }
    const std::string_view gap = bytes_.substr(begin + 1, mark - begin - 1);
    if (gap.find_first_not_of(" \t\r\n") != std::string_view::npos) {
      fail(static_cast<std::ptrdiff_t>(element), "AppendedData does not begin with '_'");
    }
    appended_at_ = mark;
    appended_ = bytes_.substr(mark + 1, end - mark - 1);
    return std::string(bytes_.substr(0, begin + 1)) + std::string(bytes_.substr(end));
  }

  const std::string& name_;
  std::string_view bytes_;
  std::string_view appended_;
  std::size_t appended_at_ = std::numeric_limits<std::size_t>::max();
  pugi::xml_document document_;
};

class VtuReader {
 public:
  explicit VtuReader(const VtuFile& file) : file_(file), root_(file.root()) {
    const std::string type = root_.attribute("type").value();
    if (type != "UnstructuredGrid") file_.fail(root_, "the type is not UnstructuredGrid");
    const std::string words = root_.attribute("header_type").as_string("UInt32");
    if (words != "UInt32" && words != "UInt64") file_.fail(root_, "unknown header_type");
    word_ = words == "UInt32" ? 4 : 8;
    const std::string compressor = root_.attribute("compressor").value();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
      file_.fail(root_, "unknown compressor " + in_quotes(compressor));
    }
    zlib_ = !compressor.empty();
    const std::string order = root_.attribute("byte_order").as_string("LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian") file_.fail(root_, "unknown byte_order");
    little_ = order == "LittleEndian";
  }

  [[nodiscard]] Draft draft(Wanted wanted) const {
    const pugi::xml_node piece = only_child(only_child(root_, "UnstructuredGrid"), "Piece");
    const std::uint64_t points = number(piece, "NumberOfPoints");
    const std::uint64_t cells = number(piece, "NumberOfCells");
    Draft draft(wanted);
    read_points(only_child(only_child(piece, "Points"), "DataArray"), points, draft.points);
    const pugi::xml_node node = only_child(piece, "Cells");
    VtkCells read;
    read.types = integers(array_named(node, "types"), cells);
    read.offsets = integers(array_named(node, "offsets"), cells);
    read.offsets.insert(read.offsets.begin(), 0);
    const std::uint64_t size = read.offsets.back();
    read.connectivity = integers(array_named(node, "connectivity"), size);
    add_vtk_cells(read, draft, [&](const std::string& reason) { file_.fail(node, reason); });
    return draft;
  }

 private:
  struct Type {
    std::string_view name;
    std::size_t size;
    bool is_signed;
  };
  static constexpr std::array<Type, 8> kIntegers = {{{"Int8", 1, true},
                                                     {"UInt8", 1, false},
                                                     {"Int16", 2, true},
                                                     {"UInt16", 2, false},
                                                     {"Int32", 4, true},
                                                     {"UInt32", 4, false},
                                                     {"Int64", 8, true},
                                                     {"UInt64", 8, false}}};

  pugi::xml_node only_child(const pugi::xml_node& node, const char* name) const {
    const pugi::xml_node child = node.child(name);
    if (!child) file_.fail(node, std::string("there is no element ") + name);
    if (child.next_sibling(name)) {
      file_.fail(child, std::string("more than one element ") + name + " is not supported");
    }
    return child;
  }

  [[nodiscard]] pugi::xml_node array_named(const pugi::xml_node& cells,
                                           const std::string& name) const {
    pugi::xml_node found;
    for (const pugi::xml_node& array : cells.children("DataArray")) {
      if (name != array.attribute("Name").value()) continue;
      if (found) file_.fail(array, "the array " + name + " occurs twice");
      found = array;
    }
    if (!found) file_.fail(cells, "there is no array " + name);
    return found;
  }

  std::uint64_t number(const pugi::xml_node& node, const char* name) const {
    const std::string text = node.attribute(name).value();
    const Scanner in(file_.name(), text, '\0', file_.line(node.offset_debug()));
    const std::uint64_t value = in.natural_from(text);
    if (value >= std::numeric_limits<std::int32_t>::max()) file_.fail(node, "a count is too large");
    return value;
  }

  [[nodiscard]] bool is_ascii(const pugi::xml_node& array) const {
    return std::string_view(array.attribute("format").value()) == "ascii";
  }

  /// A scanner of the text of an ASCII array that must hold `count` numbers.
  [[nodiscard]] Scanner scanner(const pugi::xml_node& array, std::uint64_t count) const {
    const std::string_view text = array.child_value();
    if (count > text.size() / 2 + 1) file_.fail(array, "an array of data ends too early");
    return Scanner(file_.name(), text, '\0', file_.line(array.first_child().offset_debug()));
  }

  [[nodiscard]] std::string bytes(const pugi::xml_node& array, std::uint64_t wanted) const {
    if (!little_) file_.fail(root_, "big-endian data are not supported");
    const std::string_view format = array.attribute("format").value();
    VtuEncoding encoding{.base64 = true, .zlib = zlib_, .word = word_};
    std::string_view stored = array.child_value();
    if (format == "appended") {
      const std::string_view kind = root_.child("AppendedData").attribute("encoding").value();
      if (kind != "raw" && kind != "base64") file_.fail(array, "unknown encoding of AppendedData");
      encoding.base64 = kind == "base64";
      const std::uint64_t offset = number(array, "offset");
      if (offset > file_.appended().size()) file_.fail(array, "the offset is outside the data");
      stored = file_.appended().substr(offset);
    } else if (format != "binary") {
      file_.fail(array, "unknown format of an array");
    }
    return decode_vtu_array(stored, encoding, wanted,
                            [&](const std::string& reason) { file_.fail(array, reason); });
  }

  void read_points(const pugi::xml_node& array, std::uint64_t count,
                   std::vector<Point>& points) const {
    const std::string type = array.attribute("type").value();
    if (type != "Float32" && type != "Float64") file_.fail(array, "points must be Float32 or 64");
    if (number(array, "NumberOfComponents") != 3) file_.fail(array, "points need 3 components");
    if (is_ascii(array)) {
      Scanner in = scanner(array, 3 * count);
      for (std::uint64_t i = 0; i < count; ++i) points.push_back(in.point());
      if (!in.at_end()) in.fail("an array of data is too long");
      return;
    }
    const std::size_t size = type == "Float32" ? 4 : 8;
    const std::string data = bytes(array, 3 * count * size);
    points.resize(count);
    for (std::uint64_t i = 0; i < 3 * count; ++i) {
      const double value = real_at(data, i, size);
      if (!std::isfinite(value)) file_.fail(array, "a coordinate is not finite");
      points[i / 3][i % 3] = value;
    }
  }

  static double real_at(const std::string& data, std::uint64_t index, std::size_t size) {
    float narrow = 0;
    double wide = 0;
    if (size == sizeof narrow) {
      std::memcpy(&narrow, data.data() + index * size, size);
      return static_cast<double>(narrow);
    }
    std::memcpy(&wide, data.data() + index * size, size);
    return wide;
  }

  [[nodiscard]] std::vector<std::uint64_t> integers(const pugi::xml_node& array,
                                                    std::uint64_t count) const {
    const std::string_view name = array.attribute("type").value();
    const auto* const type = std::find_if(kIntegers.begin(), kIntegers.end(),
                                          [&](const Type& known) { return known.name == name; });
    if (type == kIntegers.end()) file_.fail(array, "an array must hold integers");
    if (array.attribute("NumberOfComponents").as_string("1") != std::string_view("1")) {
      file_.fail(array, "an array of integers has one component");
    }
    std::vector<std::uint64_t> values;
    if (is_ascii(array)) {
      Scanner in = scanner(array, count);
      for (std::uint64_t i = 0; i < count; ++i) values.push_back(in.natural());
      if (!in.at_end()) in.fail("an array of data is too long");
      return values;
    }
    if (count > std::numeric_limits<std::uint64_t>::max() / 16) {
      file_.fail(array, "an array of data ends too early");
    }
    const std::string data = bytes(array, count * type->size);
    values.resize(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      std::memcpy(&values[i], data.data() + i * type->size, type->size);
      if (type->is_signed && (values[i] >> (8 * type->size - 1)) != 0) {
        file_.fail(array, "a number is negative");
      }
    }
    return values;
  }

  const VtuFile& file_;
  pugi::xml_node root_;
  std::size_t word_ = 4;
  bool zlib_ = false;
  bool little_ = true;
};

}  // namespace

Draft parse_vtu(const std::string& name, std::string_view bytes, Wanted wanted) {
  const VtuFile file(name, bytes);
  return VtuReader(file).draft(wanted);
}

}  // namespace hexatlas::check
