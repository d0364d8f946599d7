// Claim. A contact sheet is a well-formed page without anything from outside, with a tile per
// class, the badges of its answers, and everything drawn inside its tile; the same bytes each time.
// The drawing of a triangulation keeps orientations, and frames are hidden where a piece is in
// front. Oracle. A strict reader of XML written here; counts from the catalogue; integer
// determinants; hidden parts by rays through faces.
#include "tables/sheet/contact_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <random>
#include <sstream>

#include "tables/sheet/contact_sheet_relax.hpp"
#include "tables/sheet/contact_sheet_scene.hpp"

namespace {

using namespace hexatlas;

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::array<double, 2> box{};  ///< of the drawing it is in
};

/// The elements in the order of their start tags. Fails the test where the text is not well-formed.
class Page {
 public:
  explicit Page(std::string text) : text_(std::move(text)), at_(text_.find("<html")) {
    EXPECT_EQ(text_.substr(0, 16), "<!DOCTYPE html>\n");
    while (at_ < text_.size() && !::testing::Test::HasFailure()) step();
    EXPECT_TRUE(open_.empty());
  }
  [[nodiscard]] std::vector<Element> all(const std::string& name,
                                         const std::string& style = "") const {
    std::vector<Element> found;
    for (const Element& e : elements_) {
      const auto it = e.attributes.find("class");
      if (e.name == name && (style.empty() || (it != e.attributes.end() && it->second == style)))
        found.push_back(e);
    }
    return found;
  }
  [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }

 private:
  void step() {
    if (text_[at_] != '<') {
      EXPECT_NE(text_[at_], '&');
      ++at_;
      return;
    }
    const std::size_t end = text_.find('>', at_);
    ASSERT_NE(end, std::string::npos);
    std::string tag = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    ASSERT_FALSE(tag.empty());
    if (tag[0] == '/') {
      ASSERT_FALSE(open_.empty());
      EXPECT_EQ(tag.substr(1), open_.back());
      open_.pop_back();
      return;
    }
    const bool is_empty = tag.back() == '/';
    if (is_empty) tag.pop_back();
    start(tag);
    if (!is_empty) open_.push_back(elements_.back().name);
  }

  void start(const std::string& tag) {
    Element element;
    std::size_t i = tag.find(' ');
    element.name = tag.substr(0, i);
    while (i < tag.size()) {
      const std::size_t equals = tag.find("=\"", i);
      ASSERT_NE(equals, std::string::npos) << tag;
      const std::size_t quote = tag.find('"', equals + 2);
      ASSERT_NE(quote, std::string::npos) << tag;
      const std::string name = tag.substr(i + 1, equals - i - 1);
      EXPECT_TRUE(
          element.attributes.emplace(name, tag.substr(equals + 2, quote - equals - 2)).second);
      i = quote + 1;
      EXPECT_TRUE(i == tag.size() || tag[i] == ' ') << tag;
    }
    if (element.name == "svg") {
      std::istringstream box(element.attributes["viewBox"]);
      double left = 1, top = 1;
      box >> left >> top >> box_[0] >> box_[1];
      EXPECT_EQ(left + top, 0);
    }
    element.box = box_;
    elements_.push_back(std::move(element));
  }

  std::string text_;
  std::size_t at_;
  std::vector<std::string> open_;
  std::vector<Element> elements_;
  std::array<double, 2> box_{};
};

std::vector<double> numbers_in(std::string text) {
  for (char& c : text)
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) c = ' ';
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double x = 0; stream >> x;) numbers.push_back(x);
  EXPECT_TRUE(stream.eof());
  return numbers;
}

void expect_inside(const Page& page) {
  std::size_t drawn = 0;
  for (const Element& e : page.elements())
    for (const char* name : {"points", "d"}) {
      const auto it = e.attributes.find(name);
      if (it == e.attributes.end()) continue;
      const std::vector<double> numbers = numbers_in(it->second);
      ASSERT_EQ(numbers.size() % 2, 0U);
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        EXPECT_GE(numbers[i], 0) << it->second;
        EXPECT_LE(numbers[i], e.box[i % 2]) << it->second;
      }
      ++drawn;
    }
  EXPECT_GT(drawn, 0U);
}

format::CatalogueClass class_of(int vertices, const std::vector<std::vector<int>>& tetrahedra) {
  format::CatalogueClass entry;
  entry.triangulation.vertices = vertices;
  for (const auto& t : tetrahedra) {
    unsigned set = 0;
    for (const int v : t) set |= complex::bit_of(v);
    entry.triangulation.tetrahedra.push_back(static_cast<complex::VertexSet>(set));
  }
  return entry;
}

certificate::Realization cube_corners() {
  certificate::Realization points;
  for (int v = 0; v < 8; ++v) points.push_back({v & 1, (v >> 1) & 1, (v >> 2) & 1});
  return points;
}

format::CatalogueClass five() {
  return class_of(8, {{0, 1, 2, 4}, {1, 2, 3, 7}, {1, 2, 4, 7}, {1, 4, 5, 7}, {2, 4, 6, 7}});
}
/// Around the diagonal 0 7.
format::CatalogueClass six() {
  return class_of(
      8, {{0, 1, 3, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 6, 7}, {0, 4, 5, 7}, {0, 1, 5, 7}});
}

format::Catalogue hexahedron() {
  format::Catalogue catalogue;
  catalogue.name = "hexahedron";
  catalogue.vertices = 8;
  catalogue.cell = complex::cell_named("hexahedron");
  catalogue.symmetries = 48;
  catalogue.classes = {five(), six(), six(), six()};
  catalogue.classes[0].answers = {cube_corners(), certificate::Open{}, certificate::Open{}};
  catalogue.classes[1].answers = {cube_corners(), std::nullopt, certificate::Refutation{}};
  catalogue.classes[2].answers = {certificate::Refutation{}, certificate::Refutation{},
                                  std::nullopt};
  return catalogue;
}

TEST(ContactSheet, ShowsEveryClassOfTheHexahedron) {
  const std::string text = sheet::contact_sheet(hexahedron());
  EXPECT_EQ(text, sheet::contact_sheet(hexahedron()));
  const Page page(text);
  EXPECT_EQ(page.all("figure", "tile").size(), 4U);
  EXPECT_EQ(page.all("section").size(), 2U);
  EXPECT_EQ(page.all("li", "yes").size(), 2U);
  EXPECT_EQ(page.all("li", "refuted").size(), 3U);
  EXPECT_EQ(page.all("li", "open").size(), 2U);
  EXPECT_EQ(page.all("li", "unasked").size(), 5U);
  EXPECT_EQ(page.all("text", "note").size(), 1U);
  EXPECT_EQ(page.all("text", "note plain").size(), 1U);
  EXPECT_EQ(page.all("circle").size(), 12U);  // of the two graphs
  EXPECT_EQ(page.all("text", "v").size(), 16U);
  const auto graphs = page.all("path", "q");
  ASSERT_EQ(graphs.size(), 2U);  // a ring of six, with each quad halved by two neighbours
  EXPECT_EQ(numbers_in(graphs[0].attributes.at("d")).size(), 6U * 6U);
  expect_inside(page);
}

TEST(ContactSheet, TakesNothingFromOutside) {
  const std::string text = sheet::contact_sheet(hexahedron());
  const Page page(text);
  for (const Element& e : page.elements())
    for (const auto& [name, value] : e.attributes) {
      EXPECT_NE(name, "src");
      EXPECT_TRUE(name != "href" || value[0] == '#') << value;
    }
  EXPECT_EQ(text.find("@import"), std::string::npos);
  EXPECT_EQ(text.find("url(http"), std::string::npos);
}

TEST(ContactSheet, ShowsOtherCellsAndBalls) {
  format::Catalogue prism;
  prism.name = "prism";
  prism.vertices = 7;
  prism.interior = 1;
  prism.cell = complex::cell_named("prism");
  prism.symmetries = 12;
  prism.classes = {class_of(7, {{0, 1, 2, 6},
                                {3, 4, 5, 6},
                                {0, 1, 3, 6},
                                {1, 3, 4, 6},
                                {1, 2, 4, 6},
                                {2, 4, 5, 6},
                                {0, 2, 3, 6},
                                {2, 3, 5, 6}})};
  prism.classes[0].answers[0] = certificate::Realization{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9},
                                                         {9, 0, 9}, {0, 9, 9}, {3, 3, 5}};
  const Page page(sheet::contact_sheet(prism));
  EXPECT_EQ(page.all("figure", "tile").size(), 1U);
  EXPECT_EQ(page.all("text", "v").size(), 7U);
  expect_inside(page);

  format::Catalogue balls;
  balls.name = "balls-5";
  balls.vertices = 5;
  balls.classes = {class_of(5, {{0, 1, 2, 3}, {0, 1, 2, 4}}),
                   class_of(5, {{0, 1, 2, 3}, {0, 1, 2, 4}})};
  balls.classes[1].answers[1] =
      certificate::Realization{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 2}, {1, 1, -2}};
  const Page ball_page(sheet::contact_sheet(balls));
  EXPECT_EQ(ball_page.all("figure", "tile").size(), 2U);
  EXPECT_TRUE(ball_page.all("path", "q").empty());
  expect_inside(ball_page);
}

double volume(const sheet::Corners& t) {
  return sheet::dot(t[1] - t[0], sheet::cross(t[2] - t[0], t[3] - t[0]));
}

/// Skew points: an affine image of the cube with a factor of 40 between its axes.
TEST(ContactSheetDrawing, KeepsOrientationsAndMakesTheCubeACube) {
  for (const int mirror : {1, -1}) {
    std::vector<sheet::Vec> points;
    for (const auto& p : cube_corners()) {
      const auto x = static_cast<double>(p[0]), y = static_cast<double>(p[1]),
                 z = static_cast<double>(p[2]);
      points.push_back({mirror * (x + 9 * y), y + 5 * z, 40 * z + x});
    }
    const complex::Triangulation triangulation = five().triangulation;
    const sheet::Frame frame = sheet::frame_of(complex::cell_named("hexahedron").value());
    for (const auto& [a, b] : frame.edges)
      EXPECT_NEAR(sheet::length(frame.shape[a] - frame.shape[b]), 1, 1e-3);
    const auto drawn = sheet::relaxed(sheet::alike(points, frame.shape), triangulation);
    const auto before = sheet::corners_of(triangulation, points);
    const auto after = sheet::corners_of(triangulation, drawn);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_GT(volume(before[i]) * volume(after[i]), 0);
      for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(sheet::are_apart(after[i], after[j]));
    }
    for (const auto& [a, b] : frame.edges) EXPECT_NEAR(sheet::length(drawn[a] - drawn[b]), 1, 0.2);
  }
}

/// Whether the ray from p towards the eye meets a face.
bool is_behind(const sheet::Corners& t, sheet::Vec p) {
  for (std::size_t k = 0; k < 4; ++k) {
    const sheet::Vec a = t[(k + 1) % 4];
    const sheet::Vec b = t[(k + 2) % 4];
    const sheet::Vec c = t[(k + 3) % 4];
    const auto area = [](sheet::Vec u, sheet::Vec v, sheet::Vec w) {
      return sheet::cross(v - u, w - u).z;
    };
    const double all = area(a, b, c);
    const double at_a = area(p, b, c) / all, at_b = area(a, p, c) / all, at_c = area(a, b, p) / all;
    if (std::min({at_a, at_b, at_c}) > 0 && at_a * a.z + at_b * b.z + at_c * c.z > p.z) return true;
  }
  return false;
}

TEST(ContactSheetDrawing, HidesTheFrameBehindPieces) {
  std::mt19937_64 random(5);
  const auto point = [&random] {
    const auto coordinate = [&random] { return static_cast<double>(random() % 101); };
    const double x = coordinate(), y = coordinate();
    return sheet::Vec{x, y, coordinate()};
  };
  int hidden = 0;
  for (int round = 0; round < 60; ++round) {
    const std::vector<sheet::Corners> pieces{{point(), point(), point(), point()},
                                             {point(), point(), point(), point()}};
    const sheet::Vec a = point(), b = point();
    const auto visible = sheet::visible_parts(a, b, pieces);
    for (int sample = 0; sample < 20; ++sample) {
      const double t = 0.025 + 0.05 * sample;
      const sheet::Vec on = a + t * (b - a);
      const bool is_hidden = is_behind(pieces[0], on) || is_behind(pieces[1], on);
      double nearest = 1;  // to an end of a part: there the samples may disagree
      bool is_in = false;
      for (const auto& [from, to] : visible) {
        is_in = is_in || (from <= t && t <= to);
        nearest = std::min({nearest, std::abs(t - from), std::abs(t - to)});
      }
      EXPECT_TRUE(nearest <= 1e-6 || is_in == !is_hidden) << round << " " << t;
      hidden += is_hidden ? 1 : 0;
    }
  }
  EXPECT_GT(hidden, 50);
}

}  // namespace
