// Claim. Damaged files of every kind obey the law of tests/fuzz/round_trip.hpp.
// Oracle. The law itself, on samples with seeded random changes.
#include <gtest/gtest.h>

#include <random>

#include "tests/fuzz/round_trip.hpp"
#include "tests/meshing/io/sample_hybrid.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::io_tests;

/// One change: a bit, a byte, a byte more or less, eight bytes of a large number, a cut, or a part
/// of the file a second time.
void mutate(std::string& bytes, std::mt19937_64& random) {
  const std::size_t at = random() % (bytes.size() + 1);
  const std::size_t size = random() % 16;
  switch (random() % 7) {
    case 0:
      if (at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
      break;
    case 1:
      if (at < bytes.size()) bytes[at] = "0123456789-+.en \n\0\xFF"[random() % 19];
      break;
    case 2:
      bytes.insert(at, 1, "0123456789-+.en \n\0\xFF"[random() % 19]);
      break;
    case 3:
      bytes.erase(at, 1 + random() % 3);
      break;
    case 4:
      bytes.replace(at, std::min<std::size_t>(8, bytes.size() - at),
                    packed(random() % 2 == 0 ? ~(random() % 8) : random() % 64));
      break;
    case 5:
      if (random() % 8 == 0) bytes.resize(at);
      break;
    default:
      bytes.insert(random() % (bytes.size() + 1), bytes.substr(at, size));
  }
}

TEST(Mutations, ObeyTheLaw) {
  std::mt19937_64 random(20261122);
  std::size_t with_points = 0, refused = 0;
  for (const auto& samples : {surface_samples(), hexahedra_samples(), tetrahedra_samples(),
                              hybrid_samples(), points_samples()})
    for (const Sample& sample : samples) {
      SCOPED_TRACE(sample.name);
      for (int i = 0; i < 400; ++i) {
        std::string bytes = sample.bytes;
        for (std::size_t k = 1 + random() % 4; k > 0; --k) mutate(bytes, random);
        const fuzz::Outcome outcome = fuzz::check_bytes(bytes, sample.format);
        ++(outcome.has_points ? with_points : refused);
      }
    }
  // The changes are neither harmless nor fatal always.
  EXPECT_GT(with_points, 1000U);
  EXPECT_GT(refused, 1000U);
}

}  // namespace
