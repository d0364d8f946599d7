// Claim. Reading a catalogue and writing it gives the same bytes, with answers of every kind;
// whatever is not a catalogue is refused with its line, and never with another error. Oracle. The
// catalogues that are shipped; catalogues made here by hand; random damage.
#include "tables/format/catalogue.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "tables/format/frame.hpp"
#include "tables/format/sha256.hpp"
#include "tests/shipped.hpp"

namespace {

using namespace hexatlas;
using format::Catalogue;

std::vector<std::filesystem::path> shipped() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(support::kShippedFolder))
    if (entry.path().extension() == ".hxc") files.push_back(entry.path());
  return files;
}

std::string resealed(std::string text) {
  text.erase(text.rfind("end "));
  return text + "end " + format::to_hex(format::sha256(std::array{std::string_view(text)})) + "\n";
}

TEST(CatalogueFile, ShippedOnesReadAndWriteTheSame) {
  ASSERT_GE(shipped().size(), 5U);
  for (const auto& path : shipped()) {
    const std::string bytes = core::read_file(path.string());
    const Catalogue catalogue = format::catalogue_from(bytes, path.string());
    const std::string text = format::catalogue_bytes(catalogue);
    EXPECT_TRUE(text == bytes || format::compressed(text) == bytes) << path;
    EXPECT_EQ(format::catalogue_bytes(format::catalogue_from(format::compressed(text), "x")), text);
  }
}

/// A pyramid with an answer of each kind.
Catalogue pyramid() {
  Catalogue catalogue;
  catalogue.name = "pyramid";
  catalogue.vertices = 5;
  catalogue.cell = *complex::cell_named("pyramid");
  catalogue.symmetries = 8;
  catalogue.labelled = 2;
  catalogue.exhaustive = true;
  auto& entry = catalogue.classes.emplace_back();
  entry.triangulation = {5, {0b10111, 0b11101}};
  entry.automorphisms = 4;
  entry.answers[0] =
      certificate::Realization{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, -1048575}};
  certificate::Refutation refutation;
  refutation.premises = {{1, -2}, {}};
  refutation.polynomials = {{{3}, {{7, {0, 1}, {2, 3, 4, 5}, 1, 3}}, {{2, 6, 0, 1, 2, 1}}},
                            {{-4, 5}, {}, {{1, 0, 2, 7, 1, 2}}}};
  refutation.lemmas = {{{1}, {1, 2}}, {{}, {4294967295U}}};
  entry.answers[1] = refutation;
  return catalogue;
}

TEST(CatalogueFile, EveryKindOfAnswerComesBack) {
  Catalogue catalogue = pyramid();
  const std::string text = format::catalogue_bytes(catalogue);
  const Catalogue again = format::catalogue_from(text, "x");
  EXPECT_EQ(again.classes[0].answers, catalogue.classes[0].answers);
  EXPECT_EQ(format::catalogue_bytes(again), text);
  catalogue.classes[0].answers[1] = certificate::Open{};
  catalogue.classes[0].shelled = false;
  const std::string open = format::catalogue_bytes(catalogue);
  EXPECT_EQ(format::catalogue_bytes(format::catalogue_from(open, "x")), open);
  EXPECT_FALSE(format::catalogue_from(open, "x").classes[0].shelled);
}

TEST(CatalogueFile, OtherBytesAreRefusedWithTheirLine) {
  const std::string good = format::catalogue_bytes(pyramid());
  for (std::size_t cut = 0; cut < good.size(); ++cut)
    EXPECT_THROW((void)format::catalogue_from(good.substr(0, cut), "x"), core::InvalidInput) << cut;
  EXPECT_THROW((void)format::catalogue_from(good + "\n", "x"), core::InvalidInput);
  const std::string frame = format::compressed(good);
  for (std::size_t cut = 0; cut < frame.size(); ++cut)
    EXPECT_THROW((void)format::catalogue_from(frame.substr(0, cut), "x"), core::InvalidInput);
  std::mt19937_64 random(3);
  int refused = 0;
  for (int round = 0; round < 4000; ++round) {
    std::string bad = good;
    bad[random() % (bad.size() - 70)] = " \n-0123456789abcefl"[random() % 18];
    try {
      // Sealed anew, so that the digest does not hide the rest of the reader.
      (void)format::catalogue_from(resealed(bad), "x");
    } catch (const core::InvalidInput& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).rfind("x:", 0), 0U) << error.what();
    }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
