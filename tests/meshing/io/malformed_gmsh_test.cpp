// Claim. Every defect of a Gmsh file is refused with InvalidInput at its line.
// Oracle. Hand-made defects in the samples, with the line counted by hand.
#include <limits>

#include "tests/meshing/io/malformed.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

TEST(Malformed, Gmsh2) {
  const std::string first = "3 3 2 0 1 10 8 7 20\n";
  expect_surfaces_refused({
      {gmsh, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", 0, "contains no quad"},
      {gmsh, edit(kGmsh2, "$MeshFormat", "$Mesh"), 1, "$MeshFormat is expected, not '$Mesh'"},
      {gmsh, edit(kGmsh2, "2.2 0", "1.0 0"), 2, "unsupported version '1.0'"},
      {gmsh, edit(kGmsh2, "2.2 0", "4.0 0"), 2, "unsupported version '4.0'"},
      {gmsh, edit(kGmsh2, "2.2 0", "2.2 2"), 2, "0 (ASCII) or 1 (binary) is expected"},
      {gmsh, edit(kGmsh2, "2.2 0 8", "2.2 0 4"), 2, "8 bytes"},
      {gmsh, edit(kGmsh2, "$Nodes\n8", "$Nodes\n-8"), 9, "count -8 is negative"},
      {gmsh, edit(kGmsh2, "$Nodes\n8", "$Nodes\n4294967304"), 9, "is too large: only"},
      {gmsh, edit(kGmsh2, "$Nodes\n8", "$Nodes\n9"), 18, "'$EndNodes' is not an integer"},
      {gmsh, edit(kGmsh2, "$Nodes\n8", "$Nodes\n7"), 17, "$EndNodes is expected, not '60'"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "7 1 nan 0\n"), 12, "'nan' is not a finite number"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "7 1 1e400 0\n"), 12, "outside the range"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "20 1 1 0\n"), 12, "second node with tag 20"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "0 1 1 0\n"), 12, "node tag 0 is not positive"},
      {gmsh, edit(kGmsh2, "7 1 1 0\n", "-7 1 1 0\n"), 12, "node tag -7 is not positive"},
      {gmsh, edit(kGmsh2, "$Elements\n8", "$Elements\n7"), 28, "$EndElements is expected"},
      {gmsh, edit(kGmsh2, "$Elements\n8", "$Elements\n9"), 29, "'$EndElements' is not"},
      {gmsh, edit(kGmsh2, "$Elements\n8", "$Elements\n9223372036854775808"), 20, "too large"},
      {gmsh, edit(kGmsh2, first, "3 3 2 0 1 10 8 7 21\n"), 23, "there is no node with tag 21"},
      {gmsh, edit(kGmsh2, first, "3 3 2 0 1 10 8 7 0\n"), 23, "there is no node with tag 0"},
      {gmsh, edit(kGmsh2, first, "3 3 2 0 1 10 8 7 4294967306\n"), 23, "there is no node"},
      {gmsh, edit(kGmsh2, first, "3 3 2 0 1 10 8 7 7\n"), 23, "quad with a repeated vertex"},
      {gmsh, edit(kGmsh2, first, "3 3 -2 0 1 10 8 7 20\n"), 23, "count -2 is negative"},
      {gmsh, edit(kGmsh2, first, "3 2 2 0 1 10 8 7\n"), 23, "triangle; every facet must be a quad"},
      {gmsh, edit(kGmsh2, first, "3 10 0 10 8 7 20 30 40 60 10 8\n"), 23, "second-order quad"},
      {gmsh, edit(kGmsh2, first, "3 4 2 0 1 10 8 7 20\n"), 23, "this is a volume mesh"},
      {gmsh, edit(kGmsh2, first, "3 140 2 0 1 10 8 7 20\n"), 23, "element of unknown type 140"},
      {gmsh, edit(kGmsh2, "$EndNodes", "$EndNode"), 18, "$EndNodes is expected"},
      {gmsh, edit(kGmsh2, "$EndElements\n", ""), 28, "ends where $EndElements is expected"},
      {gmsh, edit(kGmsh2, "$PhysicalNames", "$Wurst"), 4, "unknown section '$Wurst'"},
      {gmsh, edit(kGmsh2, "$EndPhysicalNames", "$"), 4, "no '$EndPhysicalNames' follows"},
      {gmsh, kGmsh2.substr(0, kGmsh2.find("$Physical")) + kGmsh2.substr(kGmsh2.find("$Elements")),
       4, "$Elements before $Nodes"},
      {gmsh, kGmsh2 + "$Nodes\n0\n$EndNodes\n", 30, "second section $Nodes"},
      {gmsh, kGmsh2 + "$Elements\n0\n$EndElements\n", 30, "second section $Elements"},
      {gmsh, kGmsh2 + std::string("\0", 1), 30, "NUL byte"},
  });
}

TEST(Malformed, Gmsh4) {
  expect_surfaces_refused({
      {gmsh, edit(kGmsh4, "2 8 1 50", "3 8 1 50"), 28, "'$EndNodes' is not an integer"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "1 8 1 50"), 12, "fewer nodes in the blocks"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "2 7 1 50"), 13, "more objects in the blocks"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "2 9 1 50"), 27, "fewer nodes in the blocks"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "2 -8 1 50"), 9, "count -8 is negative"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "2 9223372036854775807 1 50"), 9, "is too large"},
      {gmsh, edit(kGmsh4, "2 8 1 50", "1e9 8 1 50"), 9, "'1e9' is not an integer"},
      {gmsh, edit(kGmsh4, "2 1 1 7", "2 1 1 4294967303"), 13, "is too large"},
      {gmsh, edit(kGmsh4, "2 1 1 7", "2 1 1 -7"), 13, "count -7 is negative"},
      {gmsh, edit(kGmsh4, "2 1 1 7", "2 1 2 7"), 13, "0 or 1 is expected"},
      {gmsh, edit(kGmsh4, "2 1 1 7", "9 1 1 7"), 13, "entity of dimension 9"},
      {gmsh, edit(kGmsh4, "\n3\n4\n", "\n3\n3\n"), 16, "second node with tag 3"},
      {gmsh, edit(kGmsh4, "\n3\n4\n", "\n3\n0\n"), 16, "node tag 0 is not positive"},
      {gmsh, edit(kGmsh4, "1 1 0 0.5", "1 inf 0 0.5"), 22, "'inf' is not a finite number"},
      {gmsh, edit(kGmsh4, "2 7 1 7", "2 6 1 7"), 33, "more objects in the blocks"},
      {gmsh, edit(kGmsh4, "2 7 1 7", "2 8 1 7"), 39, "fewer elements in the blocks"},
      {gmsh, edit(kGmsh4, "2 7 1 7", "1 7 1 7"), 32, "fewer elements in the blocks"},
      {gmsh, edit(kGmsh4, "2 1 3 6", "2 1 2 6"), 34, "triangle; every facet must be a quad"},
      {gmsh, edit(kGmsh4, "2 1 3 6", "3 1 5 6"), 33, "is too large"},
      {gmsh, edit(kGmsh4, "2 1 3 6", "2 1 0 6"), 33, "element of unknown type 0"},
      {gmsh, edit(kGmsh4, "2 50 4 3 2", "2 50 4 3 9"), 34, "there is no node with tag 9"},
      {gmsh, edit(kGmsh4, "2 50 4 3 2", "2 50 4 3 -2"), 34, "there is no node with tag -2"},
      {gmsh, edit(kGmsh4, "2 50 4 3 2", "2 50 4 3 4"), 34, "quad with a repeated vertex"},
  });
}

TEST(Malformed, GmshBinary) {
  const std::string binary = gmsh2_binary();
  std::string big_endian = binary;
  std::swap(big_endian[20], big_endian[23]);
  std::string not_finite = gmsh4_binary();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  not_finite.replace(not_finite.find("$EndNodes") - 9, 8, packed(nan));
  expect_surfaces_refused({
      {gmsh, big_endian, 2, "big-endian"},
      {gmsh, not_finite, 5, "not a finite number"},
      {gmsh, edit(binary, "$Nodes\n8", "$Nodes\n9"), 7, "$EndNodes is expected"},
      {gmsh, edit(binary, "$Nodes\n8", "$Nodes\n800"), 6, "is too large"},
      {gmsh, edit(binary, "$Elements\n6", "$Elements\n5"), 10, "block of 6 elements"},
      {gmsh, edit(binary, "$Nodes\n8\n", "$Nodes\n8 x\n"), 6, "binary data are expected"},
  });
}

}  // namespace
