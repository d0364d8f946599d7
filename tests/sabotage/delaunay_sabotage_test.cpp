// Claim. No damaged Delaunay triangulation is accepted, whether its tetrahedra are damaged, its
// points, or the bytes of its file; and none is refused that is still one.
// Oracle. delaunay_oracle.hpp decides by brute force which random damages are true ones. For bytes:
// what is read must have the content of the undamaged file.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <random>

#include "tables/check/delaunay_check.hpp"
#include "tables/check/malformed.hpp"
#include "tests/tables/check/delaunay_examples.hpp"
#include "tests/tables/check/delaunay_oracle.hpp"

namespace hexatlas::check {
namespace {

using oracle::Points;
using Cells = std::vector<Tetrahedron>;

struct Example {
  Points points;
  Cells cells;
};

class Saboteur {
 public:
  explicit Saboteur(unsigned seed) : random_(seed) {}

  std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(random_() % count); }
  Tetrahedron& cell(Example& e) { return e.cells[below(e.cells.size())]; }
  std::mt19937& random() { return random_; }

  /// Two tetrahedra at a triangle become three at an edge, whatever comes of it.
  void flip(Example& e) {
    const std::uint32_t a = below(e.cells.size());
    for (std::uint32_t b = 0; b < e.cells.size(); ++b) {
      std::vector<std::uint32_t> common;
      std::uint32_t apex = 0;
      for (const std::uint32_t v : e.cells[b]) {
        if (std::find(e.cells[a].begin(), e.cells[a].end(), v) == e.cells[a].end()) {
          apex = v;
        } else {
          common.push_back(v);
        }
      }
      if (common.size() != 3) continue;
      const Tetrahedron first = e.cells[a];
      e.cells.erase(e.cells.begin() + std::max(a, b));
      e.cells.erase(e.cells.begin() + std::min(a, b));
      for (std::size_t i = 0; i < 4; ++i) {
        if (std::find(common.begin(), common.end(), first[i]) == common.end()) continue;
        Tetrahedron part = first;
        part[i] = apex;
        e.cells.push_back(part);
      }
      return;
    }
  }

  void move(Example& e) {
    e.points.moved = below(e.points.at.size());
    e.points.axis = below(3);
    e.points.direction = below(2) == 0 ? 1 : -1;
  }

 private:
  std::mt19937 random_;
};

struct Damage {
  const char* name;
  std::function<void(Saboteur&, Example&)> apply;
};

const std::vector<Damage>& damages() {
  static const std::vector<Damage> kDamages = {
      {"change an index",
       [](Saboteur& s, Example& e) { s.cell(e)[s.below(4)] = s.below(e.points.at.size() + 1); }},
      {"remove a tetrahedron",
       [](Saboteur& s, Example& e) { e.cells.erase(e.cells.begin() + s.below(e.cells.size())); }},
      {"repeat a tetrahedron",
       [](Saboteur& s, Example& e) { e.cells.push_back(Tetrahedron(s.cell(e))); }},
      {"mirror a tetrahedron",
       [](Saboteur& s, Example& e) {
         Tetrahedron& cell = s.cell(e);
         std::swap(cell[s.below(2)], cell[2 + s.below(2)]);
       }},
      {"turn a tetrahedron, no damage",
       [](Saboteur& s, Example& e) {
         Tetrahedron& cell = s.cell(e);
         std::rotate(cell.begin(), cell.begin() + 1, cell.begin() + 1 + 2);
       }},
      {"flip", [](Saboteur& s, Example& e) { s.flip(e); }},
      {"move by one unit in the last place", [](Saboteur& s, Example& e) { s.move(e); }},
      {"add a point that is not used",
       [](Saboteur& s, Example& e) {
         e.points.at.push_back({s.below(9), s.below(9), s.below(9)});
       }},
      {"repeat a point, no damage",
       [](Saboteur& s, Example& e) { e.points.at.push_back(e.points.at[s.below(4)]); }},
      {"exchange two labels everywhere",
       [](Saboteur& s, Example& e) {
         const std::uint32_t a = s.below(e.points.at.size());
         const std::uint32_t b = s.below(e.points.at.size());
         for (Tetrahedron& cell : e.cells)
           for (std::uint32_t& v : cell) v = v == a ? b : v == b ? a : v;
       }},
      {"merge two labels",
       [](Saboteur& s, Example& e) {
         const std::uint32_t a = s.below(e.points.at.size());
         const std::uint32_t b = s.below(e.points.at.size());
         for (Tetrahedron& cell : e.cells) std::replace(cell.begin(), cell.end(), a, b);
       }},
      {"replace a tetrahedron by a random one",
       [](Saboteur& s, Example& e) {
         for (std::uint32_t& v : s.cell(e)) v = s.below(e.points.at.size());
       }},
  };
  return kDamages;
}

/// Coordinates are at least 1, so that a unit in the last place is small but no subnormal number.
Example from_one(Example e) {
  for (auto& p : e.points.at)
    for (auto& value : p) ++value;
  return e;
}

std::vector<Example> examples_of(Saboteur& saboteur) {
  std::vector<Example> result = {from_one({examples::lattice(1), examples::kFive}),
                                 from_one({examples::lattice(1), examples::kuhn(1)}),
                                 from_one({examples::lattice(2), examples::kuhn(2)})};
  while (result.size() < 6) {
    const Points points = examples::random_points(saboteur.random(), 9, 30);
    const Cells cells = oracle::delaunay_of(points);
    if (!cells.empty()) result.push_back(from_one({points, cells}));
  }
  return result;
}

TEST(DelaunaySabotage, TheJudgeSaysWhatBruteForceSays) {
  Saboteur saboteur(1);
  const std::vector<Example> whole = examples_of(saboteur);
  std::size_t refused = 0;
  std::size_t accepted = 0;
  for (int round = 0; round < 400; ++round) {
    for (const Damage& damage : damages()) {
      Example e = whole[saboteur.below(whole.size())];
      const oracle::Whole hull = oracle::volume_of(e.points, e.cells);
      damage.apply(saboteur, e);
      // A point outside would change the hull; it is unused all the same.
      const bool expected = oracle::is_delaunay(e.points, e.cells, hull);
      const DelaunayVerdict verdict = check_delaunay(oracle::mesh_of(e.points, e.cells), nullptr);
      ASSERT_EQ(verdict.accepted, expected) << damage.name << ": " << verdict.reason;
      ++(expected ? accepted : refused);
    }
  }
  EXPECT_GE(refused, 2500U);
  EXPECT_GE(accepted, 500U);
}

TEST(DelaunaySabotage, PointsThatAreMovedFar) {
  Saboteur saboteur(2);
  std::size_t refused = 0;
  std::size_t accepted = 0;
  for (int round = 0; round < 300; ++round) {
    Example e{examples::random_points(saboteur.random(), 7, 30), {}};
    e.cells = oracle::delaunay_of(e.points);
    if (e.cells.empty()) continue;
    e.points.at[saboteur.below(7)][saboteur.below(3)] += 1 + saboteur.below(12);
    const Cells now = oracle::delaunay_of(e.points);
    if (now.empty()) continue;
    const bool expected = oracle::is_delaunay(e.points, e.cells, oracle::volume_of(e.points, now));
    const DelaunayVerdict verdict = check_delaunay(oracle::mesh_of(e.points, e.cells), nullptr);
    ASSERT_EQ(verdict.accepted, expected) << verdict.reason;
    ++(expected ? accepted : refused);
  }
  EXPECT_GE(refused, 50U);
  EXPECT_GE(accepted, 20U);
}

template <class Value>
void append(std::string& bytes, const Value& value) {
  char raw[sizeof(Value)];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

std::string hxtet(const TetrahedralMesh& mesh) {
  std::string bytes("HXTET\0\0\1", 8);
  append(bytes, std::uint64_t{mesh.points.size()});
  append(bytes, std::uint64_t{mesh.tetrahedra.size()});
  for (const Point& p : mesh.points) append(bytes, p);
  for (const Tetrahedron& t : mesh.tetrahedra) append(bytes, t);
  return bytes;
}

std::string rows(const TetrahedralMesh& mesh, const std::string& before, std::uint32_t first,
                 const std::string& after) {
  std::string text;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    text += before;
    for (const std::uint32_t v : t) text += " " + std::to_string(v + first);
    text += after + "\n";
  }
  return text;
}

std::string points(const TetrahedralMesh& mesh, bool numbered, const std::string& after) {
  std::string text;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (numbered) text += std::to_string(i + 1) + " ";
    for (const double value : mesh.points[i]) text += std::to_string(value) + " ";
    text += after + "\n";
  }
  return text;
}

/// With cells of lower dimension, which are to be passed over.
std::vector<std::pair<std::string, std::string>> files(const TetrahedralMesh& mesh) {
  const std::string n = std::to_string(mesh.points.size());
  const std::size_t count = mesh.tetrahedra.size();
  std::string types;
  for (std::size_t i = 0; i < count; ++i) types += "10\n";
  return {
      {"a.hxtet", hxtet(mesh)},
      {"a.vtk", "# vtk DataFile Version 3.0\na\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " + n +
                    " double\n" + points(mesh, false, "") + "CELLS " + std::to_string(count + 3) +
                    " " + std::to_string(5 * count + 11) + "\n" + rows(mesh, "4", 0, "") +
                    "3 0 1 2\n1 0\n4 0 1 4 3\nCELL_TYPES " + std::to_string(count + 3) + "\n" +
                    types + "5\n1\n9\n"},
      {"a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n" + n + "\n" +
                     points(mesh, false, "0") + "Triangles\n1\n1 2 3 0\nTetrahedra\n" +
                     std::to_string(count) + "\n" + rows(mesh, "", 1, " 0") + "End\n"},
      {"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + n + "\n" +
                    points(mesh, true, "") + "$EndNodes\n$Elements\n" + std::to_string(count + 1) +
                    "\n1 2 2 0 1 1 2 3\n" + rows(mesh, "2 4 2 0 1", 1, "") + "$EndElements\n"}};
}

TEST(DelaunaySabotage, FilesThatAreCut) {
  Saboteur saboteur(3);
  const TetrahedralMesh mesh = oracle::mesh_of(examples::lattice(2), examples::kuhn(2));
  for (const auto& [name, bytes] : files(mesh)) {
    const TetrahedralMesh read = parse_tetrahedra(name, bytes);
    EXPECT_EQ(read.points, mesh.points) << name;
    EXPECT_EQ(read.tetrahedra, mesh.tetrahedra) << name;
    EXPECT_EQ(parse_points(name, bytes), mesh.points) << name;
    EXPECT_EQ(parse_tetrahedra("no ending", bytes).tetrahedra, mesh.tetrahedra) << name;
    for (int round = 0; round < 200; ++round) {
      const std::string part = bytes.substr(0, saboteur.below(bytes.size()));
      try {
        const TetrahedralMesh cut = parse_tetrahedra(name, part);
        EXPECT_EQ(cut.points, mesh.points) << name;
        EXPECT_EQ(cut.tetrahedra, mesh.tetrahedra) << name;
      } catch (const Malformed&) {
        continue;
      }
    }
  }
}

void expect_malformed(const std::string& name, const std::string& bytes, const char* words) {
  try {
    static_cast<void>(parse_points(name, bytes));
    static_cast<void>(parse_tetrahedra(name, bytes));
    ADD_FAILURE() << name << " was read; expected: " << words;
  } catch (const Malformed& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(DelaunaySabotage, FilesThatAreWrong) {
  TetrahedralMesh mesh = oracle::mesh_of(examples::lattice(1), examples::kFive);
  const std::string good = hxtet(mesh);
  expect_malformed("a.hxtet", good + "x", "size of the file");
  expect_malformed("a.hxtet", "HXTET\0\0\2" + good.substr(8), "does not begin");
  std::string huge = good;
  huge.replace(8, 8, std::string(8, '\x7f'));
  expect_malformed("a.hxtet", huge, "size of the file");
  mesh.tetrahedra[3][1] = 8;
  expect_malformed("a.hxtet", hxtet(mesh), "tetrahedron 3: point 8 is not among the 8 points");
  mesh.points[2][1] = std::nan("");
  expect_malformed("a.hxtet", hxtet(mesh), "a coordinate of point 2 is not finite");
  expect_malformed("a.bin", "1234567", "multiple of 24");
  expect_malformed("a.xyz", "1 2 3\n4 5\n", "a.xyz:2: a line has not three numbers");
  expect_malformed("a.xyz", "1 2 nan\n", "a.xyz:1");
  expect_malformed("a.stl", "", "a file of points ends in");
  expect_malformed("a.mesh",
                   "MeshVersionFormatted 2\nDimension 3\nVertices\n1\n0 0 0 0\nHexahedra\n1\n"
                   "1 1 1 1 1 1 1 1 0\nEnd\n",
                   "a cell is no tetrahedron");
  EXPECT_THROW(static_cast<void>(parse_mesh("a.hxtet", good)), Malformed);
}

TEST(DelaunaySabotage, FilesOfPoints) {
  const std::vector<Point> expected = {{0, -1.5, 2e-3}, {4, 5, 6}};
  EXPECT_EQ(parse_points("a.xyz", "# points\n0 -1.5 2e-3 # first\n\n4 5 6"), expected);
  std::string bytes;
  for (const Point& p : expected) append(bytes, p);
  EXPECT_EQ(parse_points("a.bin", bytes), expected);
  EXPECT_TRUE(parse_points("a.bin", "").empty());
}

}  // namespace
}  // namespace hexatlas::check
