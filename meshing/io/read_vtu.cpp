// VTK XML unstructured grids. Source: "VTK File Formats", section "XML File Formats". The XML part
// ends where appended data begin, since raw data are no XML; it is parsed by pugixml, which keeps
// the place of each element in the file, hence its line. Points count from 0 in each piece.
#include <algorithm>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "enum/core/errors.hpp"
#include "meshing/io/little_endian.hpp"
#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"
#include "meshing/io/vtu_data.hpp"

namespace hexatlas::io {
namespace {

constexpr std::string_view kAppended = "<AppendedData";
constexpr std::ptrdiff_t kMostTags = 100'000;  // a tree costs far more memory than its text

/// The numbers of a binary array, converted.
template <class Stored, class Number>
void unpack(std::string_view bytes, const Place& place, std::vector<Number>& numbers) {
  if (bytes.size() % sizeof(Stored) != 0) place.fail("array ends within a number");
  numbers.reserve(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(Stored)) {
    const auto value = load_little<Stored>(bytes.substr(i));
    if constexpr (std::is_same_v<Stored, std::uint64_t>)
      if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
        place.fail("integer " + std::to_string(value) + " is too large");
    numbers.push_back(static_cast<Number>(value));
  }
}

void unpack_typed(std::string_view type, std::string_view bytes, const Place& place,
                  std::vector<double>& numbers) {
  if (type == "Float32") return unpack<float>(bytes, place, numbers);
  if (type == "Float64") return unpack<double>(bytes, place, numbers);
  place.fail("coordinates of type " + in_quotes(type));
}

void unpack_typed(std::string_view type, std::string_view bytes, const Place& place,
                  std::vector<std::int64_t>& numbers) {
  if (type == "Int8") return unpack<std::int8_t>(bytes, place, numbers);
  if (type == "UInt8") return unpack<std::uint8_t>(bytes, place, numbers);
  if (type == "Int16") return unpack<std::int16_t>(bytes, place, numbers);
  if (type == "UInt16") return unpack<std::uint16_t>(bytes, place, numbers);
  if (type == "Int32") return unpack<std::int32_t>(bytes, place, numbers);
  if (type == "UInt32") return unpack<std::uint32_t>(bytes, place, numbers);
  if (type == "Int64") return unpack<std::int64_t>(bytes, place, numbers);
  if (type == "UInt64") return unpack<std::uint64_t>(bytes, place, numbers);
  place.fail("integers of type " + in_quotes(type));
}

template <class Number>
[[nodiscard]] Number next_number(Scanner& scanner) {
  if constexpr (std::is_same_v<Number, double>)
    return scanner.real("a number");
  else
    return scanner.integer("a number");
}

template <class Number>
constexpr bool kHasLines = std::is_integral_v<Number>;

/// The numbers of an array, its line, and for integers in ASCII the line of each.
template <class Number>
struct NumberArray {
  std::vector<Number> numbers;
  std::size_t line = 0;
  std::vector<std::uint32_t> lines;

  [[nodiscard]] std::size_t line_of(std::size_t i) const { return lines.empty() ? line : lines[i]; }
};

class VtuReader {
 public:
  VtuReader(std::string_view bytes, MeshBuilder& builder)
      : bytes_(bytes), builder_(builder), file_(builder.file()) {}

  void read() {
    parse_xml();
    const pugi::xml_node root = document_.child("VTKFile");
    if (!root) fail(1, "the element VTKFile is expected");
    read_attributes(root);
    const pugi::xml_node grid = child(root, "UnstructuredGrid");
    for (const pugi::xml_node piece : grid.children("Piece")) read_piece(piece);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& reason) const {
    throw core::InvalidInput(file_, line, reason);
  }

  /// Calls come in the order of the file, so each part of it is searched once.
  [[nodiscard]] std::size_t line_at(std::ptrdiff_t offset) {
    const auto target = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
    if (target < line_offset_) line_offset_ = 0, line_ = 1;
    const std::string_view passed = bytes_.substr(line_offset_, target - line_offset_);
    line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
    line_offset_ = target;
    return line_;
  }

  [[nodiscard]] std::size_t line_of(const pugi::xml_node& node) {
    return line_at(node.offset_debug());
  }

  /// Ends the XML part where appended data begin, and remembers these.
  [[nodiscard]] std::string split_appended() {
    const std::size_t tag = bytes_.find(kAppended);
    const std::size_t tag_end = bytes_.find('>', std::min(tag, bytes_.size()));
    if (tag == std::string_view::npos || tag_end == std::string_view::npos)
      return std::string(bytes_);
    const std::size_t line = line_at(static_cast<std::ptrdiff_t>(tag));
    const std::size_t end = bytes_.rfind("</AppendedData>");
    if (end == std::string_view::npos || end < tag_end ||
        bytes_.find("</VTKFile>", end) == std::string_view::npos)
      fail(line, "the file ends within the appended data");
    const std::string_view data = bytes_.substr(tag_end + 1, end - tag_end - 1);
    const std::size_t mark = data.find_first_not_of(" \t\r\n");
    if (mark == std::string_view::npos || data[mark] != '_')
      fail(line, "appended data must begin with '_'");
    appended_ = data.substr(mark + 1);
    return std::string(bytes_.substr(0, tag_end + 1)) + "</AppendedData></VTKFile>";
  }

  void parse_xml() {
    xml_ = split_appended();
    const std::size_t nul = xml_.find('\0');
    if (nul != std::string::npos)
      fail(line_at(static_cast<std::ptrdiff_t>(nul)), "NUL byte in the XML text");
    if (std::count(xml_.begin(), xml_.end(), '<') > kMostTags)
      fail(0, "more than " + std::to_string(kMostTags) + " XML tags");
    const pugi::xml_parse_result result = document_.load_buffer_inplace(
        xml_.data(), xml_.size(), pugi::parse_minimal | pugi::parse_escapes, pugi::encoding_utf8);
    if (!result)
      fail(line_at(
               std::min<std::ptrdiff_t>(result.offset, static_cast<std::ptrdiff_t>(bytes_.size()))),
           std::string("XML: ") + result.description());
  }

  void read_attributes(const pugi::xml_node& root) {
    const std::size_t line = line_of(root);
    const auto is = [&](const char* name, std::string_view value, std::string_view otherwise) {
      return root.attribute(name).as_string(otherwise.data()) == value;
    };
    if (!is("type", "UnstructuredGrid", ""))
      fail(line, "data set of type " + in_quotes(root.attribute("type").as_string()) +
                     "; UnstructuredGrid is expected");
    const std::string version = root.attribute("version").as_string("0.1");
    if (version != "0.1" && version != "1.0" && !version.starts_with("2."))
      fail(line, "unsupported version " + in_quotes(version));
    if (!is("byte_order", "LittleEndian", "LittleEndian"))
      other_byte_order_ = root.attribute("byte_order").as_string();
    const bool is_wide = is("header_type", "UInt64", "UInt32");
    if (!is_wide && !is("header_type", "UInt32", "UInt32"))
      fail(line, "unknown header_type " + in_quotes(root.attribute("header_type").as_string()));
    header_bytes_ = is_wide ? 8 : 4;
    is_compressed_ = !is("compressor", "", "");
    if (is_compressed_ && !is("compressor", "vtkZLibDataCompressor", ""))
      fail(line, "unsupported compressor " + in_quotes(root.attribute("compressor").as_string()) +
                     "; use vtkZLibDataCompressor or none");
    const pugi::xml_node appended = root.child("AppendedData");
    const std::string_view encoding = appended.attribute("encoding").as_string("base64");
    if (encoding != "raw" && encoding != "base64")
      fail(line_of(appended), "unknown encoding " + in_quotes(encoding));
    is_appended_base64_ = encoding == "base64";
  }

  [[nodiscard]] pugi::xml_node child(const pugi::xml_node& parent, const char* name) {
    const pugi::xml_node found = parent.child(name);
    if (!found)
      fail(line_of(parent),
           std::string(parent.name()) + " without the element " + std::string(name));
    return found;
  }

  [[nodiscard]] pugi::xml_node array_named(const pugi::xml_node& parent, const char* name) {
    const pugi::xml_node found = parent.find_child_by_attribute("DataArray", "Name", name);
    if (!found) fail(line_of(parent), std::string("Cells without the array ") + name);
    return found;
  }

  [[nodiscard]] std::int64_t integer_attribute(const pugi::xml_node& node, const char* name) {
    const std::string_view text = node.attribute(name).as_string();
    const Scanner scanner(text, file_, '\0', line_of(node));
    if (text.empty()) scanner.fail(std::string(node.name()) + " without " + name);
    return scanner.to_integer(text);
  }

  /// A number of points or cells. What is there is compared with it when arrays are read.
  [[nodiscard]] std::size_t count_attribute(const pugi::xml_node& node, const char* name) {
    const std::int64_t count = integer_attribute(node, name);
    if (count < 0 || count > std::numeric_limits<mesh::Index>::max())
      fail(line_of(node), std::string(name) + " " + std::to_string(count) + " is out of range");
    return static_cast<std::size_t>(count);
  }

  template <class Number>
  [[nodiscard]] NumberArray<Number> read_array(const pugi::xml_node& node) {
    const std::string_view format = node.attribute("format").as_string("ascii");
    NumberArray<Number> array;
    array.line = line_of(node);
    if (format == "ascii") {
      read_ascii(node, array);
    } else {
      const Place place{file_, array.line};
      if (!other_byte_order_.empty())
        place.fail("byte order " + in_quotes(other_byte_order_) + "; LittleEndian is expected");
      std::string bytes;
      if (format == "binary") {
        bytes = decode_array(text_of(node), {true, is_compressed_, header_bytes_}, place);
      } else if (format == "appended") {
        bytes = decode_array(appended_.substr(offset_of(node)),
                             {is_appended_base64_, is_compressed_, header_bytes_}, place);
      } else {
        place.fail("unknown format " + in_quotes(format));
      }
      check_total(bytes.size(), place);
      unpack_typed(node.attribute("type").as_string(), bytes, place, array.numbers);
    }
    return array;
  }

  /// Arrays that share their bytes would make much of a small file.
  void check_total(std::size_t size, const Place& place) {
    decoded_bytes_ += size;
    if (decoded_bytes_ > bytes_.size() * (is_compressed_ ? kLargestRatio : 1))
      place.fail("arrays are larger in all than the file can hold");
  }

  [[nodiscard]] std::size_t offset_of(const pugi::xml_node& node) {
    const std::int64_t offset = integer_attribute(node, "offset");
    if (offset < 0 || static_cast<std::uint64_t>(offset) > appended_.size())
      fail(line_of(node), "offset " + std::to_string(offset) + " is outside the appended data");
    return static_cast<std::size_t>(offset);
  }

  /// The text of an array. Comments would split it; no program writes them there.
  [[nodiscard]] pugi::xml_node text_node(const pugi::xml_node& node) {
    pugi::xml_node text;
    for (const pugi::xml_node each : node.children()) {
      if (each.type() != pugi::node_pcdata) continue;
      if (text) fail(line_at(each.offset_debug()), "array with two pieces of text");
      text = each;
    }
    return text;
  }

  [[nodiscard]] std::string_view text_of(const pugi::xml_node& node) {
    return text_node(node).value();
  }

  template <class Number>
  void read_ascii(const pugi::xml_node& node, NumberArray<Number>& array) {
    const pugi::xml_node text = text_node(node);
    if (!text) return;
    const std::string_view words = text.value();
    const std::size_t most = words.size() / 2 + 1;
    array.numbers.reserve(most);
    if constexpr (kHasLines<Number>) array.lines.reserve(most);
    Scanner scanner(words, file_, '\0', line_of(text));
    while (!scanner.at_end()) {
      array.numbers.push_back(next_number<Number>(scanner));
      if constexpr (kHasLines<Number>)
        array.lines.push_back(static_cast<std::uint32_t>(scanner.line()));
    }
  }

  void check_size(const pugi::xml_node& node, const char* name, std::size_t size,
                  std::size_t expected) {
    if (size != expected)
      fail(line_of(node), "the array of " + std::string(name) + " has " + std::to_string(size) +
                              " numbers; " + std::to_string(expected) + " are expected");
  }

  void read_piece(const pugi::xml_node& piece) {
    const std::size_t points = count_attribute(piece, "NumberOfPoints");
    const std::size_t cells = count_attribute(piece, "NumberOfCells");
    const std::size_t first_point = builder_.point_count();
    read_points(child(piece, "Points"), points);
    // A piece of points alone may go without the element.
    if (builder_.wanted() == Wanted::points && cells == 0 && !piece.child("Cells")) return;
    read_cells(child(piece, "Cells"), cells, first_point, points);
  }

  void read_points(const pugi::xml_node& parent, std::size_t count) {
    const pugi::xml_node node = child(parent, "DataArray");
    if (integer_attribute(node, "NumberOfComponents") != 3)
      fail(line_of(node), "points must have 3 components");
    const NumberArray<double> array = read_array<double>(node);
    const std::vector<double>& numbers = array.numbers;
    check_size(node, "points", numbers.size(), 3 * count);
    if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
      fail(array.line, "coordinate that is not a finite number");
    builder_.reserve_points(count);
    for (std::size_t i = 0; i < count; ++i)
      builder_.add_point({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]}, array.line);
  }

  void read_cells(const pugi::xml_node& parent, std::size_t count, std::size_t first_point,
                  std::size_t points) {
    const pugi::xml_node connectivity_node = array_named(parent, "connectivity");
    const pugi::xml_node offsets_node = array_named(parent, "offsets");
    const pugi::xml_node types_node = array_named(parent, "types");
    const auto connectivity = read_array<std::int64_t>(connectivity_node);
    const auto offsets = read_array<std::int64_t>(offsets_node);
    const auto types = read_array<std::int64_t>(types_node);
    check_size(offsets_node, "offsets", offsets.numbers.size(), count);
    check_size(types_node, "types", types.numbers.size(), count);

    std::vector<mesh::Index> corners;
    std::int64_t begin = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t end = offsets.numbers[i];
      if (end < begin || static_cast<std::uint64_t>(end) > connectivity.numbers.size())
        fail(offsets.line_of(i), "offset " + std::to_string(end) + " is not in order");
      const auto type = vtk_cell_type(types.numbers[i]);
      if (!type) fail(types.line_of(i), "cell of unknown type " + std::to_string(types.numbers[i]));
      corners.clear();
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
        const std::int64_t index = connectivity.numbers[k];
        if (index < 0 || static_cast<std::uint64_t>(index) >= points)
          fail(connectivity.line_of(k), "index " + std::to_string(index) +
                                            " is outside the list of " + std::to_string(points) +
                                            " points");
        corners.push_back(static_cast<mesh::Index>(first_point) + static_cast<mesh::Index>(index));
      }
      const std::size_t line =
          begin < end ? connectivity.line_of(static_cast<std::size_t>(begin)) : types.line_of(i);
      builder_.add_cell(*type, corners, line);
      begin = end;
    }
    check_size(connectivity_node, "connectivity", connectivity.numbers.size(),
               static_cast<std::size_t>(begin));
  }

  std::string_view bytes_;
  MeshBuilder& builder_;
  const std::string file_;
  std::string xml_;  ///< holds the text of document_
  pugi::xml_document document_;
  std::string_view appended_;
  std::size_t decoded_bytes_ = 0;
  std::size_t header_bytes_ = 4;
  bool is_compressed_ = false;
  std::string other_byte_order_;  ///< than little-endian: of no meaning in text
  bool is_appended_base64_ = true;
  std::size_t line_offset_ = 0;  ///< line_ is the line of this offset
  std::size_t line_ = 1;
};

}  // namespace

void read_vtu(std::string_view bytes, MeshBuilder& builder) { VtuReader(bytes, builder).read(); }

}  // namespace hexatlas::io
