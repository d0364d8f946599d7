// The points of PLY, ASCII and little-endian binary. Source: G. Turk, The PLY polygon file format
// (1994), and the sized names of types that came later. Elements before the vertices are skipped;
// what follows the vertices is not read.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "enum/core/errors.hpp"
#include "meshing/io/little_endian.hpp"
#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

enum class Scalar : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct NamedScalar {
  std::string_view name;
  Scalar scalar;
};

constexpr std::array kScalars{
    NamedScalar{"char", Scalar::int8},      NamedScalar{"int8", Scalar::int8},
    NamedScalar{"uchar", Scalar::uint8},    NamedScalar{"uint8", Scalar::uint8},
    NamedScalar{"short", Scalar::int16},    NamedScalar{"int16", Scalar::int16},
    NamedScalar{"ushort", Scalar::uint16},  NamedScalar{"uint16", Scalar::uint16},
    NamedScalar{"int", Scalar::int32},      NamedScalar{"int32", Scalar::int32},
    NamedScalar{"uint", Scalar::uint32},    NamedScalar{"uint32", Scalar::uint32},
    NamedScalar{"float", Scalar::float32},  NamedScalar{"float32", Scalar::float32},
    NamedScalar{"double", Scalar::float64}, NamedScalar{"float64", Scalar::float64},
};

/// Calls use(number) with a number of this type.
template <class Use>
decltype(auto) with_type(Scalar scalar, Use&& use) {
  switch (scalar) {
    case Scalar::int8:
      return use(std::int8_t{});
    case Scalar::uint8:
      return use(std::uint8_t{});
    case Scalar::int16:
      return use(std::int16_t{});
    case Scalar::uint16:
      return use(std::uint16_t{});
    case Scalar::int32:
      return use(std::int32_t{});
    case Scalar::uint32:
      return use(std::uint32_t{});
    case Scalar::float32:
      return use(float{});
    case Scalar::float64:
      break;
  }
  return use(double{});
}

std::size_t bytes_of(Scalar scalar) {
  return with_type(scalar, [](auto zero) { return sizeof zero; });
}

bool is_integer(Scalar scalar) { return scalar != Scalar::float32 && scalar != Scalar::float64; }

struct Property {
  std::string_view name;
  Scalar scalar;                       ///< of a list: of its members
  std::optional<Scalar> list_counter;  ///< of a list
};

struct Element {
  std::string_view name;
  std::int64_t count;
  std::size_t line;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, MeshBuilder& builder)
      : scanner_(bytes, builder.file()), builder_(builder) {}

  void read() {
    read_header();
    if (!is_binary_) scanner_.refuse_nul();
    for (const Element& element : elements_) {
      if (element.name == "vertex") return read_vertices(element);
      skip(element);
    }
  }

 private:
  using Words = std::vector<std::string_view>;

  /// The words of the next line of the header.
  void next_line(Words& words) {
    if (scanner_.bytes_left() == 0) scanner_.fail_cut("end_header");
    const std::string_view line = scanner_.rest_of_line();
    Scanner of_line(line, scanner_.file(), '\0', scanner_.line());
    if (!of_line.next_line(words)) scanner_.fail("empty line in the header");
  }

  void read_header() {
    Words words;
    next_line(words);
    if (words.size() != 1 || words[0] != "ply")
      scanner_.fail("'ply' is expected, not " + in_quotes(words[0]));
    next_line(words);
    read_format(words);
    while (true) {
      next_line(words);
      if (words[0] == "end_header") break;
      if (words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "element") {
        read_element(words);
      } else if (words[0] == "property") {
        read_property(words);
      } else {
        scanner_.fail("unknown keyword " + in_quotes(words[0]));
      }
    }
    if (!has_vertices()) scanner_.fail("there is no element vertex");
  }

  [[nodiscard]] bool has_vertices() const {
    return std::any_of(elements_.begin(), elements_.end(),
                       [](const Element& each) { return each.name == "vertex"; });
  }

  void read_format(const Words& words) {
    if (words[0] != "format" || words.size() != 3)
      scanner_.fail("'format' with an encoding and a version is expected");
    if (words[1] == "binary_big_endian")
      scanner_.fail("big-endian binary file; save as binary_little_endian or ascii");
    is_binary_ = words[1] == "binary_little_endian";
    if (!is_binary_ && words[1] != "ascii")
      scanner_.fail("unknown encoding " + in_quotes(words[1]));
    if (words[2] != "1.0") scanner_.fail("unsupported version " + in_quotes(words[2]));
  }

  void read_element(const Words& words) {
    if (words.size() != 3) scanner_.fail("an element has a name and a count");
    if (words[1] == "vertex" && has_vertices()) scanner_.fail("second element vertex");
    elements_.push_back({words[1], scanner_.to_integer(words[2]), scanner_.line(), {}});
    if (elements_.back().count < 0)
      scanner_.fail("count " + std::to_string(elements_.back().count) + " is negative");
  }

  [[nodiscard]] Scalar scalar_of(std::string_view name) const {
    const auto found = std::find_if(kScalars.begin(), kScalars.end(),
                                    [&](const NamedScalar& each) { return each.name == name; });
    if (found == kScalars.end()) scanner_.fail("unknown type " + in_quotes(name));
    return found->scalar;
  }

  void read_property(const Words& words) {
    if (elements_.empty()) scanner_.fail("property before any element");
    const bool is_list = words.size() > 1 && words[1] == "list";
    if (words.size() != (is_list ? 5 : 3))
      scanner_.fail(is_list ? "a list has two types and a name"
                            : "a property has a type and a name");
    Property property{words.back(), scalar_of(words[words.size() - 2]), {}};
    if (is_list) {
      property.list_counter = scalar_of(words[2]);
      if (!is_integer(*property.list_counter))
        scanner_.fail("list counted by " + in_quotes(words[2]));
    }
    Element& element = elements_.back();
    if (element.name == "vertex" && axis_of(property)) {
      if (is_list) scanner_.fail("coordinate " + in_quotes(property.name) + " is a list");
      for (const Property& each : element.properties)
        if (each.name == property.name) scanner_.fail("second property " + in_quotes(each.name));
    }
    element.properties.push_back(property);
  }

  [[nodiscard]] static std::optional<std::size_t> axis_of(const Property& property) {
    if (property.name == "x") return 0;
    if (property.name == "y") return 1;
    if (property.name == "z") return 2;
    return std::nullopt;
  }

  /// The number of objects of the element, which the bytes that follow can hold.
  [[nodiscard]] std::size_t count_of(const Element& element) const {
    constexpr std::size_t kWordBytes = 2;
    std::size_t bytes_each = 0;
    for (const Property& property : element.properties)
      bytes_each +=
          is_binary_ ? bytes_of(property.list_counter.value_or(property.scalar)) : kWordBytes;
    return bytes_each == 0 ? 0 : scanner_.to_count(element.count, bytes_each);
  }

  template <class Number>
  [[nodiscard]] Number binary() {
    return load_little<Number>(scanner_.raw(sizeof(Number)));
  }

  [[nodiscard]] double number(Scalar scalar) {
    if (is_binary_)
      return with_type(scalar, [&](auto zero) -> double { return binary<decltype(zero)>(); });
    return is_integer(scalar) ? static_cast<double>(scanner_.integer("an integer"))
                              : scanner_.real("a number");
  }

  void skip(const Property& property) {
    if (!property.list_counter) return static_cast<void>(number(property.scalar));
    const auto size = static_cast<std::int64_t>(number(*property.list_counter));
    const std::size_t members =
        scanner_.to_count(size, is_binary_ ? bytes_of(property.scalar) : std::size_t{2});
    for (std::size_t i = 0; i < members; ++i) static_cast<void>(number(property.scalar));
  }

  void skip(const Element& element) {
    const std::size_t count = count_of(element);
    for (std::size_t i = 0; i < count; ++i)
      for (const Property& property : element.properties) skip(property);
  }

  void read_vertices(const Element& element) {
    std::size_t axes = 0;
    for (const Property& property : element.properties) axes += axis_of(property) ? 1 : 0;
    if (axes != 3)
      throw core::InvalidInput(builder_.file(), element.line,
                               "vertices need the properties x, y and z");
    const std::size_t count = count_of(element);
    builder_.reserve_points(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::array<double, 3> xyz{};
      for (const Property& property : element.properties) {
        if (const auto axis = axis_of(property))
          xyz[*axis] = number(property.scalar);
        else
          skip(property);
      }
      if (!std::all_of(xyz.begin(), xyz.end(), [](double x) { return std::isfinite(x); }))
        scanner_.fail("vertex " + std::to_string(i) +
                      ", counted from 0, has a coordinate that is not a finite number");
      builder_.add_point({xyz[0], xyz[1], xyz[2]}, scanner_.line());
    }
  }

  Scanner scanner_;
  MeshBuilder& builder_;
  std::vector<Element> elements_;
  bool is_binary_ = false;
};

}  // namespace

void read_ply(std::string_view bytes, MeshBuilder& builder) { PlyReader(bytes, builder).read(); }

}  // namespace hexatlas::io
