// Claim. The vertices of a PLY file are read whatever the types of x, y and z and whatever stands
// around them; every defect is refused with InvalidInput at its line.
// Oracle. Hand-made files in both encodings, lines counted by hand.
#include <gtest/gtest.h>

#include <limits>

#include "tests/meshing/io/malformed.hpp"
#include "tests/meshing/io/sample_points.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;
using enum FileFormat;

std::string header(const std::string& encoding, const std::string& type, int count) {
  return "ply\nformat " + encoding + " 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty " + type + " z\nproperty " + type + " x\nproperty " + type +
         " y\nend_header\n";
}

/// z, x and y in binary, then the words of each; the last vertex has the extremes of the type.
template <class Number>
void check_type(const std::string& name) {
  using Limits = std::numeric_limits<Number>;
  const std::string bytes =
      header("binary_little_endian", name, 2) +
      packed(Number{7}, Number{2}, Number{9}, Limits::lowest(), Limits::max(), Number{0});
  const std::vector<mesh::Point> expected{
      {2, 9, 7}, {static_cast<double>(Limits::max()), 0, static_cast<double>(Limits::lowest())}};
  EXPECT_EQ(io::parse_points(bytes, ply, "f"), expected) << name;
  EXPECT_EQ(io::parse_points(header("ascii", name, 1) + "7 2 9\n", ply, "f"),
            (std::vector<mesh::Point>{{2, 9, 7}}))
      << name;
}

TEST(Ply, EveryType) {
  for (const char* name : {"char", "int8"}) check_type<std::int8_t>(name);
  for (const char* name : {"uchar", "uint8"}) check_type<std::uint8_t>(name);
  for (const char* name : {"short", "int16"}) check_type<std::int16_t>(name);
  for (const char* name : {"ushort", "uint16"}) check_type<std::uint16_t>(name);
  for (const char* name : {"int", "int32"}) check_type<std::int32_t>(name);
  for (const char* name : {"uint", "uint32"}) check_type<std::uint32_t>(name);
  for (const char* name : {"float", "float32"}) check_type<float>(name);
  for (const char* name : {"double", "float64"}) check_type<double>(name);
}

TEST(Ply, EndsOfLines) {
  std::string dos = kPlyAscii;
  for (std::size_t at = 0; (at = dos.find('\n', at)) != std::string::npos; at += 2)
    dos.replace(at, 1, "\r\n");
  EXPECT_EQ(io::parse_points(dos, ply, "f"), kPoints);
  std::string binary = ply_binary();
  const std::size_t end = binary.find("end_header\n");
  for (std::size_t at = 0; (at = binary.find('\n', at)) <= end + 20; at += 2)
    binary.replace(at, 1, "\r\n");
  EXPECT_EQ(io::parse_points(binary, ply, "f"), kPoints);
}

TEST(Ply, WhatFollowsTheVerticesIsNotRead) {
  EXPECT_EQ(io::parse_points(until(kPlyAscii, "0 255 1 0 1\n"), ply, "f"), kPoints);
  EXPECT_EQ(io::parse_points(kPlyAscii + "more\n", ply, "f"), kPoints);
}

TEST(Ply, ElementsWithoutProperties) {
  const std::string text = edit(kPlyAscii, "element camera", "element nothing 9\nelement camera");
  EXPECT_EQ(io::parse_points(text, ply, "f"), kPoints);
  EXPECT_EQ(io::parse_points(edit(ply_binary(), "element camera",
                                  "element nothing 9223372036854775807\nelement camera"),
                             ply, "f"),
            kPoints);
}

TEST(Malformed, PlyHeader) {
  const auto bad = [](const std::string& from, const std::string& to, std::size_t line,
                      const std::string& reason) {
    return Malformed{ply, edit(kPlyAscii, from, to), line, reason};
  };
  expect_all_refused(
      {
          bad("ply\n", "plx\n", 1, "'ply' is expected, not 'plx'"),
          bad("ply\n", "\n", 1, "empty line in the header"),
          bad("format ascii 1.0", "element vertex 8", 2, "'format' with an encoding"),
          bad("format ascii", "format binary_big_endian", 2, "big-endian binary file"),
          bad("format ascii", "format utf8", 2, "unknown encoding 'utf8'"),
          bad("ascii 1.0", "ascii 2.0", 2, "unsupported version '2.0'"),
          bad("comment", "remark", 3, "unknown keyword 'remark'"),
          bad("element camera 1\n", "", 4, "property before any element"),
          bad("element camera 1", "element camera", 4, "an element has a name and a count"),
          bad("element camera 1", "element camera -1", 4, "count -1 is negative"),
          bad("element camera 1", "element camera x", 4, "'x' is not an integer"),
          bad("element face 1", "element vertex 1", 13, "second element vertex"),
          bad("property float view", "property half view", 5, "unknown type 'half'"),
          bad("property float view", "property float", 5, "a property has a type and a name"),
          bad("property list uchar int ids", "property list uchar ids", 6,
              "a list has two types and a name"),
          bad("property list uchar int ids", "property list float int ids", 6,
              "list counted by 'float'"),
          bad("property double x", "property list uchar double x", 8, "coordinate 'x' is a list"),
          bad("property uchar red", "property uchar x", 9, "second property 'x'"),
          bad("property int z", "property int w", 7, "vertices need the properties x, y and z"),
          bad("element vertex", "element vertices", 15, "there is no element vertex"),
          {ply, until(kPlyAscii, "ids\n"), 6, "the file ends where end_header is expected"},
      },
      io::parse_points);
}

TEST(Malformed, PlyAscii) {
  const auto bad = [](const std::string& from, const std::string& to, std::size_t line,
                      const std::string& reason) {
    return Malformed{ply, edit(kPlyAscii, from, to), line, reason};
  };
  expect_all_refused(
      {
          bad("element vertex 8", "element vertex 9", 25, "the file ends where"),
          bad("element vertex 8", "element vertex 80", 16, "count 80 is too large: only"),
          bad("element vertex 8", "element vertex 9223372036854775807", 16, "is too large"),
          bad("element camera 1", "element camera 1000", 15, "count 1000 is too large"),
          bad("0.5 3 7", "0.5 300 7", 16, "count 300 is too large"),
          bad("0.5 3 7", "0.5 -3 7", 16, "count -3 is negative"),
          bad("0.5 3 7", "0.5 3.5 7", 16, "'3.5' is not an integer"),
          bad("1 255 1 0 0", "nan 255 1 0 0", 19, "'nan' is not a finite number"),
          bad("1 255 1 0 0", "1 255 inf 0 0", 19, "'inf' is not a finite number"),
          bad("1 255 1 0 0", "1 255 1 0 0.5", 19, "'0.5' is not an integer"),
          bad("1 255 1 0 0", "1 255 one 0 0", 19, "'one' is not a number"),
          bad("1 255 1 0 0", "1 255 1 -1 0", 19, "count -1 is negative"),
          bad("1 255 1 0 0", std::string("1 255 1 \0 0", 11), 19, "NUL byte"),
      },
      io::parse_points);
}

TEST(Malformed, PlyBinary) {
  const std::string whole = ply_binary();
  const std::size_t data = whole.find("end_header\n") + 11;
  const std::size_t first = data + 13;  // of the vertices, after the camera
  std::string not_finite = whole, list = whole;
  not_finite.replace(first, 8, packed(std::numeric_limits<double>::quiet_NaN()));
  list.replace(data + 4, 1, "\xFF");
  expect_all_refused(
      {
          {ply, whole.substr(0, first + 40), 15, "count 8 is too large: only 40 bytes follow"},
          {ply, whole.substr(0, whole.size() - 20), 16, "the file ends where binary data is"},
          {ply, edit(whole, "vertex 8", "vertex 9"), 16, "the file ends where binary data"},
          {ply, edit(whole, "vertex 8", "vertex 800"), 15, "count 800 is too large"},
          {ply, edit(whole, "camera 1", "camera 2000"), 15, "count 2000 is too large"},
          {ply, not_finite, 15, "vertex 0, counted from 0, has a coordinate that is not a finite"},
          {ply, list, 15, "count 255 is too large"},
      },
      io::parse_points);
}

}  // namespace
