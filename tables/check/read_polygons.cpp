#include <algorithm>
#include <array>

#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"

namespace hexatlas::check {

namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t kMostColours = 4;  ///< numbers

/// Records of an OBJ file that say nothing about points and faces.
constexpr std::array<std::string_view, 10> kPassedOver = {"vn", "vt", "vp", "g",      "o",
                                                          "s",  "l",  "p",  "usemtl", "mtllib"};

/// "7", "7/1", "7//2", "7/1/2"; negative numbers count back from the last of the points so far.
std::uint32_t obj_vertex(const Scanner& in, std::string_view word, std::size_t so_far,
                         std::size_t points) {
  const std::int64_t number = in.integer_from(word.substr(0, word.find('/')));
  const auto before = static_cast<std::int64_t>(so_far);
  if (number == 0 || number > static_cast<std::int64_t>(points) || number < -before) {
    in.fail("point " + std::to_string(number) + " is not among the " +
            std::to_string(number < 0 ? so_far : points) + " points");
  }
  return static_cast<std::uint32_t>(number > 0 ? number - 1 : before + number);
}

Point obj_point(const Scanner& in, const Words& words) {
  const std::size_t numbers = words.size() - 1;
  if (numbers != 3 && numbers != 4 && numbers != 6) in.fail("a point has three coordinates");
  for (std::size_t i = 4; i <= numbers; ++i) static_cast<void>(in.real_from(words[i]));
  return {in.real_from(words[1]), in.real_from(words[2]), in.real_from(words[3])};
}

/// The heading with the number of faces, and the points, which may have colours behind them.
std::vector<Point> off_points(Scanner& in, std::uint64_t& faces) {
  in.expect(in.peek() == "COFF" ? "COFF" : "OFF");
  std::vector<Point> points(in.count(6));
  faces = in.count(8);
  // The number of edges may be missing; nobody needs it.
  const std::string_view rest = in.skip_line();
  const std::size_t begin = rest.find_first_not_of(" \t\r");
  if (begin != std::string_view::npos && rest[begin] != '#')
    static_cast<void>(
        in.natural_from(rest.substr(begin, rest.find_first_of(" \t\r#", begin) - begin)));
  for (Point& point : points) {
    const Words words = in.line_of_words();
    if (words.size() < 3) in.fail("a point has three coordinates");
    if (words.size() > 3 + kMostColours) in.fail("more numbers than a colour has");
    for (std::size_t i = 0; i < 3; ++i) point[i] = in.real_from(words[i]);
    for (std::size_t i = 3; i < words.size(); ++i) static_cast<void>(in.real_from(words[i]));
  }
  return points;
}

Quad off_quad(const Scanner& in, const Words& words, std::size_t points) {
  if (words[0] != "4" || words.size() < 5) in.fail("a face is not a quad");
  Quad quad{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint64_t vertex = in.natural_from(words[i + 1]);
    if (vertex >= points) {
      in.fail("point " + std::to_string(vertex) + " is not among the " + std::to_string(points) +
              " points");
    }
    quad[i] = static_cast<std::uint32_t>(vertex);
  }
  for (std::size_t i = 5; i < words.size(); ++i) static_cast<void>(in.real_from(words[i]));
  return quad;
}

}  // namespace

Surface parse_obj(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes, '#');
  Surface surface{parse_obj_points(name, bytes), {}};  // faces may come before their points
  std::size_t points = 0;                              // so far
  for (Words words = in.line_of_words(); !words.empty(); words = in.line_of_words()) {
    if (words[0] == "v") {
      ++points;
    } else if (words[0] == "f") {
      if (words.size() != 5) in.fail("a face is not a quad");
      Quad quad{};
      for (std::size_t i = 0; i < 4; ++i) {
        quad[i] = obj_vertex(in, words[i + 1], points, surface.points.size());
      }
      surface.quads.push_back(quad);
    } else if (std::find(kPassedOver.begin(), kPassedOver.end(), words[0]) == kPassedOver.end()) {
      in.fail("unknown record " + in_quotes(words[0]));
    }
  }
  return surface;
}

std::vector<Point> parse_obj_points(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes, '#');
  std::vector<Point> points;
  for (Words words = in.line_of_words(); !words.empty(); words = in.line_of_words()) {
    if (words[0] == "v") points.push_back(obj_point(in, words));
  }
  return points;
}

std::vector<Point> parse_off_points(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes, '#');
  std::uint64_t faces = 0;
  return off_points(in, faces);
}

Surface parse_off(const std::string& name, std::string_view bytes) {
  Scanner in(name, bytes, '#');
  std::uint64_t faces = 0;
  Surface surface;
  surface.points = off_points(in, faces);
  surface.quads.reserve(faces);
  for (std::uint64_t face = 0; face < faces; ++face) {
    const Words words = in.line_of_words();
    if (words.empty()) in.fail("the file ends too early");
    surface.quads.push_back(off_quad(in, words, surface.points.size()));
  }
  if (!in.at_end()) in.fail("something follows the last face");
  return surface;
}

}  // namespace hexatlas::check
