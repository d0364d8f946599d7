// The points of PLY files, ASCII and little-endian binary (G. Turk, "The PLY polygon file format",
// 1994, with the sized names of types that came later). Elements before the vertices are passed
// over; what follows the vertices is not read.
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "tables/check/malformed.hpp"
#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"

namespace hexatlas::check {

namespace {

enum class Kind : std::uint8_t { kSigned, kUnsigned, kReal };

struct Type {
  std::size_t size;
  Kind kind;
};

constexpr std::array<std::pair<std::string_view, Type>, 16> kTypes = {
    {{"char", {1, Kind::kSigned}},
     {"int8", {1, Kind::kSigned}},
     {"uchar", {1, Kind::kUnsigned}},
     {"uint8", {1, Kind::kUnsigned}},
     {"short", {2, Kind::kSigned}},
     {"int16", {2, Kind::kSigned}},
     {"ushort", {2, Kind::kUnsigned}},
     {"uint16", {2, Kind::kUnsigned}},
     {"int", {4, Kind::kSigned}},
     {"int32", {4, Kind::kSigned}},
     {"uint", {4, Kind::kUnsigned}},
     {"uint32", {4, Kind::kUnsigned}},
     {"float", {4, Kind::kReal}},
     {"float32", {4, Kind::kReal}},
     {"double", {8, Kind::kReal}},
     {"float64", {8, Kind::kReal}}}};

struct Property {
  std::string_view name;
  Type type;
  std::optional<Type> count;  ///< of a list
};

struct Element {
  std::string_view name;
  std::uint64_t count;
  std::vector<Property> properties;
};

Type type_named(const Scanner& in, std::string_view name) {
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  in.fail("unknown type " + in_quotes(name));
}

/// The numbers of the body.
class Numbers {
 public:
  Numbers(Scanner& text, std::string_view bytes, bool binary)
      : text_(text), bytes_(bytes), binary_(binary) {}

  [[nodiscard]] double next(Type type) {
    if (!binary_) return text_.real();
    if (bytes_.size() < type.size) text_.fail("the file ends too early");
    const char* const at = bytes_.data();
    bytes_.remove_prefix(type.size);
    if (type.kind == Kind::kReal) return real_at(at, type.size);
    std::uint32_t bits = 0;
    std::memcpy(&bits, at, type.size);
    const unsigned unused = 32 - 8 * static_cast<unsigned>(type.size);
    if (type.kind == Kind::kUnsigned) return bits;
    return static_cast<std::int32_t>(bits << unused) >> unused;
  }

  /// The length of a list.
  [[nodiscard]] std::uint64_t next_count(Type type) {
    const double count = next(type);
    if (type.kind == Kind::kReal || count < 0 || count != std::floor(count) || count > 0x1p32) {
      text_.fail("a list has no proper length");
    }
    return static_cast<std::uint64_t>(count);
  }

 private:
  static double real_at(const char* at, std::size_t size) {
    float narrow = 0;
    double wide = 0;
    if (size == sizeof narrow) {
      std::memcpy(&narrow, at, size);
      return static_cast<double>(narrow);
    }
    std::memcpy(&wide, at, size);
    return wide;
  }

  Scanner& text_;
  std::string_view bytes_;
  bool binary_;
};

struct Header {
  bool binary = false;
  std::vector<Element> elements;
};

void read_property(Scanner& in, const std::vector<std::string_view>& words, Header& header) {
  if (header.elements.empty()) in.fail("a property belongs to no element");
  auto& properties = header.elements.back().properties;
  if (words.size() == 3) {
    properties.push_back({words[2], type_named(in, words[1]), std::nullopt});
  } else if (words.size() == 5 && words[1] == "list") {
    properties.push_back({words[4], type_named(in, words[3]), type_named(in, words[2])});
  } else {
    in.fail("a property has a type and a name");
  }
}

Header read_header(Scanner& in) {
  Header header;
  bool has_format = false;
  for (auto words = in.line_of_words(); words.empty() || words[0] != "end_header";
       words = in.line_of_words()) {
    if (words.empty()) in.fail("the file ends too early");
    if (words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "format" && words.size() == 3 && words[2] == "1.0") {
      header.binary = words[1] == "binary_little_endian";
      if (!header.binary && words[1] != "ascii") in.fail("unknown format " + in_quotes(words[1]));
      has_format = true;
    } else if (words[0] == "element" && words.size() == 3) {
      header.elements.push_back({words[1], in.natural_from(words[2]), {}});
    } else if (words[0] == "property") {
      read_property(in, words, header);
    } else {
      in.fail("unknown line of the header, " + in_quotes(words[0]));
    }
  }
  if (!has_format) in.fail("there is no line 'format'");
  return header;
}

/// Which coordinate a property is; three if none.
std::size_t axis_of(const Property& property) {
  constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
  std::size_t axis = 0;
  while (axis < 3 && (property.name != kNames[axis] || property.count)) ++axis;
  return axis;
}

void read_element(Numbers& numbers, const Element& element, Point& point) {
  for (const Property& property : element.properties) {
    if (property.count) {
      for (std::uint64_t left = numbers.next_count(*property.count); left > 0; --left) {
        static_cast<void>(numbers.next(property.type));
      }
      continue;
    }
    const double value = numbers.next(property.type);
    if (const std::size_t axis = axis_of(property); axis < 3) point[axis] = value;
  }
}

}  // namespace

std::vector<Point> parse_ply(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes);
  in.expect("ply");
  const Header header = read_header(in);
  const std::size_t last_line = bytes.find("\nend_header");
  if (last_line == std::string_view::npos) in.fail("'end_header' does not begin its line");
  const std::size_t end = bytes.find('\n', last_line + 1);
  const std::string_view body = end == std::string_view::npos ? "" : bytes.substr(end + 1);
  Numbers numbers(in, body, header.binary);
  for (const Element& element : header.elements) {
    const bool wanted = element.name == "vertex";
    if (element.count > body.size() && (wanted || !element.properties.empty())) {
      in.fail("there are too many elements " + in_quotes(element.name));
    }
    std::vector<Point> points;
    if (wanted) {
      std::array<int, 3> seen{};
      for (const Property& property : element.properties) {
        if (const std::size_t axis = axis_of(property); axis < 3) ++seen[axis];
      }
      if (seen != std::array{1, 1, 1}) in.fail("a vertex has not the coordinates x, y, z");
      points.resize(element.count);
    }
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      Point point{};
      read_element(numbers, element, point);
      if (!wanted) continue;
      for (const double value : point) {
        if (!std::isfinite(value)) in.fail("a coordinate is not finite");
      }
      points[i] = point;
    }
    if (wanted) return points;
  }
  throw Malformed(name, 0, "there is no element 'vertex'");
}

}  // namespace hexatlas::check
