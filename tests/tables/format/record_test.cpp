// Claim. A record gives back the mesh that it was made from, up to labels of interior vertices; a
// payload that describes none gives nullopt and nothing worse.
// Oracle. Isomorphism by nauty, the boundary by sets; payloads written by hand from
// docs/formats/table.md; random bytes.
#include "tables/format/record.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "enum/canon/nauty/hex_symmetry.hpp"
#include "enum/core/errors.hpp"
#include "tests/enum/support.hpp"
#include "tests/tables/format/fixtures.hpp"

namespace {

using namespace hexatlas;
using complex::HexComplex;

std::set<oracle::Cycle> boundary(const HexComplex& mesh) {
  return oracle::boundary({mesh.hexahedra.begin(), mesh.hexahedra.end()});
}

void expect_same(const HexComplex& a, const HexComplex& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(boundary(a), boundary(b));
  EXPECT_EQ(canon::graph_form(a).certificate, canon::graph_form(b).certificate);
}

std::string cells_payload(const HexComplex& mesh) {
  std::string payload(1, '\1');
  for (const auto& cell : mesh.hexahedra)
    for (const std::uint32_t v : cell) {
      payload += static_cast<char>(v & 0xFFU);
      payload += static_cast<char>(v >> 8U);
    }
  return payload;
}

TEST(Record, GivesBackTheMesh) {
  support::Random random(67);
  for (const auto& row : fixtures::rows(18, 14)) {
    const auto q = canon::decode(row.code).value();
    const int hexahedra = static_cast<int>(row.mesh.hexahedra.size());
    const std::string payload = format::encode_record(row.mesh, q);
    EXPECT_EQ(payload.size(), 1U + 2U * static_cast<std::size_t>(hexahedra - 1));
    EXPECT_EQ(payload[0], '\0');
    const auto mesh = format::decode_record(payload, q, hexahedra);
    ASSERT_TRUE(mesh.has_value());
    EXPECT_EQ(support::fault_of_filling(*mesh, row.code), "");
    expect_same(*mesh, row.mesh);
    EXPECT_EQ(format::encode_record(*mesh, q), payload);

    // Hexahedra in another order: a shelling has to be found.
    HexComplex shuffled = row.mesh;
    random.shuffle(shuffled.hexahedra);
    const auto again = format::decode_record(format::encode_record(shuffled, q), q, hexahedra);
    ASSERT_TRUE(again.has_value());
    expect_same(*again, row.mesh);

    // The other encoding, as a writer without a shelling would store it.
    const auto cells = format::decode_record(cells_payload(row.mesh), q, hexahedra);
    ASSERT_TRUE(cells.has_value());
    EXPECT_EQ(cells->hexahedra, row.mesh.hexahedra);
    EXPECT_EQ(cells->vertices, row.mesh.vertices);

    for (const int wrong : {hexahedra - 1, hexahedra + 1, 0, -1}) {
      EXPECT_FALSE(format::decode_record(payload, q, wrong).has_value());
      EXPECT_FALSE(format::decode_record(cells_payload(row.mesh), q, wrong).has_value());
    }
  }
}

TEST(Record, OfMeshesWithManyHexahedra) {
  support::Random random(71);
  for (int i = 0; i < 30; ++i) {
    const auto shelling = support::random_shelling(30, 40, random);
    const auto code = canon::canonical_form(shelling.front().boundary).code;
    const auto form = canon::canonical_form(shelling.front().boundary);
    if (form.is_mirrored) continue;
    // Boundary vertices first, in canonical labels.
    HexComplex mesh = support::mesh_of(support::cells_of(shelling));
    std::vector<std::uint32_t> number(mesh.vertices, 0xFFFFFFFF);
    for (int v = 0; v < shelling.front().boundary.vertices(); ++v)
      number[shelling.vertex_of(static_cast<complex::Vertex>(v))] =
          form.label[static_cast<std::size_t>(v)];
    auto next = static_cast<std::uint32_t>(shelling.front().boundary.vertices());
    for (auto& n : number)
      if (n == 0xFFFFFFFF) n = next++;
    for (auto& cell : mesh.hexahedra)
      for (auto& v : cell) v = number[v];
    random.shuffle(mesh.hexahedra);
    const auto q = canon::decode(code).value();
    const auto back = format::decode_record(format::encode_record(mesh, q), q,
                                            static_cast<int>(mesh.hexahedra.size()));
    ASSERT_TRUE(back.has_value());
    expect_same(*back, mesh);
  }
}

TEST(Record, ByHandForTwoCubes) {
  // docs/formats/table.md: any end quad has four neighbours; taken off with all of them, one new
  // vertex none, a cube is left. The ends are the two quads disjoint from each other's neighbours.
  const auto code = canon::from_text("q1:022972977f").value();
  const auto q = canon::decode(code).value();
  int accepted = 0;
  for (int bottom = 0; bottom < 10; ++bottom) {
    const std::string payload{'\0', static_cast<char>(bottom), '\x0F'};
    const auto mesh = format::decode_record(payload, q, 2);
    if (!mesh) continue;
    ++accepted;
    EXPECT_EQ(mesh->vertices, 12U);
    EXPECT_EQ(support::fault_of_filling(*mesh, code), "");
  }
  EXPECT_EQ(accepted, 2);
}

TEST(Record, FaultyPayloadsDescribeNothing) {
  const auto code = canon::from_text("q1:022972977f").value();
  const auto q = canon::decode(code).value();
  using namespace std::string_literals;
  for (const auto& payload : {""s, "\0"s, "\0\0"s, "\2\0\x0F"s, "\0\0\x10"s, "\0\xFF\x0F"s,
                              "\0\0\x0F\0"s, "\1"s, "\1\0\0"s, "\0\0\0"s})
    EXPECT_FALSE(format::decode_record(payload, q, 2).has_value());
  EXPECT_FALSE(format::decode_record("\0"s, q, 1).has_value()) << "ten quads are no cube";
}

TEST(Record, RandomBytesNeverCrash) {
  support::Random random(73);
  const auto rows = fixtures::rows();
  int decoded = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto& row = rows[random.below(rows.size())];
    const auto q = canon::decode(row.code).value();
    const auto hexahedra = static_cast<int>(1 + random.below(6));
    std::string payload(1, static_cast<char>(random.below(3)));
    const std::size_t size = random.below(8) == 0 ? random.below(40)
                             : payload[0] == 1    ? 16U * static_cast<std::size_t>(hexahedra)
                                                  : 2U * static_cast<std::size_t>(hexahedra - 1);
    for (std::size_t k = 0; k < size; ++k)
      payload += static_cast<char>(random.coin() ? random.below(16) : random.below(256));
    const auto mesh = format::decode_record(payload, q, hexahedra);
    if (!mesh) continue;
    ++decoded;
    ASSERT_EQ(mesh->hexahedra.size(), static_cast<std::size_t>(hexahedra));
    for (const auto& cell : mesh->hexahedra)
      for (const std::uint32_t v : cell) ASSERT_LT(v, mesh->vertices);
  }
  EXPECT_GT(decoded, 100);
}

TEST(Record, NeedsAMesh) {
  const auto q = complex::Quadrangulation::cube();
  EXPECT_THROW((void)format::encode_record({8, {}}, q), core::PreconditionViolated);
  EXPECT_THROW((void)format::encode_record({65'536, {{0, 1, 2, 3, 4, 5, 6, 7}}}, q),
               core::PreconditionViolated);
}

}  // namespace
