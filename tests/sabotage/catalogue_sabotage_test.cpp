// Claim. No damaged catalogue is accepted: neither one whose bytes are damaged, nor one that is
// damaged in a line, a word or a digit and given a correct digest afterwards, unless it is as true
// as before. Oracle. catalogue_oracle.hpp says whether a text is a true catalogue; it knows nothing
// of hints. Without a new digest any change is a true damage. The refutations of the catalogues of
// this project are damaged in single literals, hints and lines; what is still accepted must follow
// by propagation without hints from premises listed by their definitions.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <random>

#include "tables/check/catalogue.hpp"
#include "tables/check/file_bytes.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/zstd_frame.hpp"
#include "tests/sabotage/sample_catalogues.hpp"
#include "tests/shipped.hpp"

namespace hexatlas::check {
namespace {

using namespace sabotage;

bool is_accepted(const std::string& text) {
  try {
    return check_catalogue_bytes(text, "damaged").accepted;
  } catch (const Malformed&) {
    return false;
  }
}

TextCatalogue answered(TextCatalogue c, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  answer_conditions(c, random);
  return c;
}

/// Small ones with points, refutations and open questions; without the last line.
const std::vector<std::string>& samples() {
  static const std::vector<std::string> texts = [] {
    std::vector<std::string> bodies;
    std::uint64_t seed = 1;
    for (const SampleCell& cell : {prism(), tetrahedron(1), tetrahedron(2), octahedron()}) {
      bodies.push_back(body_of(answered(catalogue_of(cell), ++seed)));
    }
    bodies.push_back(body_of(answered(catalogue_of_balls(5), ++seed)));
    TextCatalogue unshelled = catalogue_of(pyramid(1));
    unshelled.list[0].unshelled = true;
    std::sort(unshelled.list[0].tetrahedra.begin(), unshelled.list[0].tetrahedra.end(),
              [](const Simplex& a, const Simplex& b) {
                return numbers_of({a}, first_numbers(6)) < numbers_of({b}, first_numbers(6));
              });
    bodies.push_back(body_of(unshelled));
    bodies.push_back(body_of(catalogue_of_cubes()));
    return bodies;
  }();
  return texts;
}

/// The ordered numbers of the format.
std::vector<int> sorted_list(const TextClass& item) {
  return numbers_of(item.tetrahedra, first_numbers(16));
}

class Sabotage {
 public:
  /// What the judge says of the text, sealed, must be what the oracle says; where a refutation is
  /// damaged, the judge may say less.
  void expect_same(const std::string& body, const std::string& what, bool in_refutation) {
    const std::string text = sealed(body);
    const bool accepted = is_accepted(text);
    const bool is_true = oracle_.is_true(text);
    if (in_refutation ? accepted && !is_true : accepted != is_true) {
      ADD_FAILURE() << what << (accepted ? " is accepted\n" : " is refused\n") << text;
    }
    ++(accepted ? accepted_ : refused_);
  }
  [[nodiscard]] int accepted() const { return accepted_; }
  [[nodiscard]] int refused() const { return refused_; }

 private:
  CatalogueOracle oracle_{std::string(judged_definition_digest())};
  int accepted_ = 0;
  int refused_ = 0;
};

bool is_of_refutation(const std::string& line) {
  return line.starts_with("c ") || line.starts_with("l ") || line.starts_with("f ");
}

std::string joined(const std::vector<std::string>& parts, char separator) {
  std::string text;
  for (const std::string& part : parts) text += part + separator;
  return text;
}

std::string line_from(const std::vector<std::string>& words) {
  std::string line = joined(words, ' ');
  if (!line.empty()) line.pop_back();
  return line;
}

TEST(CatalogueSabotage, SamplesAreTrue) {
  CatalogueOracle oracle{std::string(judged_definition_digest())};
  for (const std::string& body : samples()) {
    EXPECT_TRUE(is_accepted(sealed(body))) << body;
    EXPECT_TRUE(oracle.is_true(sealed(body))) << body;
  }
}

TEST(CatalogueSabotage, NoChangeOfBytesIsAccepted) {
  std::mt19937_64 random(3);
  for (const std::string& body : samples()) {
    const std::string good = sealed(body);
    for (int round = 0; round < 300; ++round) {
      std::string bad = good;
      const std::size_t at = random() % bad.size();
      bad[at] = static_cast<char>(static_cast<unsigned char>(bad[at]) ^ 1U << random() % 8);
      EXPECT_FALSE(is_accepted(bad)) << bad;
    }
    for (std::size_t size = 0; size < good.size(); size += 1 + size / 20) {
      EXPECT_FALSE(is_accepted(good.substr(0, size)));
    }
    EXPECT_FALSE(is_accepted(good + "\n"));
    EXPECT_FALSE(is_accepted(good + good));
    EXPECT_FALSE(is_accepted(" " + good));
  }
}

TEST(CatalogueSabotage, LinesDroppedDoubledAndSwapped) {
  Sabotage sabotage;
  for (const std::string& body : samples()) {
    const std::vector<std::string> lines = lines_of(body);
    const std::size_t step = 1 + lines.size() / 150;
    for (std::size_t i = 0; i < lines.size(); i += step) {
      const bool inside = is_of_refutation(lines[i]);
      std::vector<std::string> dropped = lines;
      dropped.erase(dropped.begin() + static_cast<std::ptrdiff_t>(i));
      sabotage.expect_same(joined(dropped, '\n'), "dropped: " + lines[i], inside);
      std::vector<std::string> doubled = lines;
      doubled.insert(doubled.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
      sabotage.expect_same(joined(doubled, '\n'), "doubled: " + lines[i], inside);
      if (i + 1 == lines.size()) continue;
      std::vector<std::string> swapped = lines;
      std::swap(swapped[i], swapped[i + 1]);
      sabotage.expect_same(joined(swapped, '\n'), "swapped: " + lines[i], inside);
    }
  }
  EXPECT_GT(sabotage.refused(), 500);
}

/// All words of all lines outside refutations, and some inside.
TEST(CatalogueSabotage, WordsAndDigitsChanged) {
  Sabotage sabotage;
  std::mt19937_64 random(5);
  for (const std::string& body : samples()) {
    const std::vector<std::string> lines = lines_of(body);
    std::vector<std::string> vocabulary = {"0", "1", "-1", "yes", "no", "unshelled", "open", "ff"};
    for (const std::string& line : lines) {
      for (const std::string& word : words_of(line)) vocabulary.push_back(word);
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool inside = is_of_refutation(lines[i]);
      if (inside && random() % 20 != 0) continue;
      const std::vector<std::string> words = words_of(lines[i]);
      const auto try_words = [&](const std::vector<std::string>& changed) {
        std::vector<std::string> bad = lines;
        bad[i] = line_from(changed);
        if (bad[i] != lines[i]) {
          sabotage.expect_same(joined(bad, '\n'), lines[i] + " -> " + bad[i], inside);
        }
      };
      for (std::size_t w = 0; w < words.size(); ++w) {
        std::vector<std::string> changed = words;
        changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(w));
        try_words(changed);
        changed = words;
        changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(w), words[w]);
        try_words(changed);
        if (w + 1 < words.size()) {
          changed = words;
          std::swap(changed[w], changed[w + 1]);
          try_words(changed);
        }
        changed = words;
        changed[w] = vocabulary[random() % vocabulary.size()];
        try_words(changed);
        changed[w] = words[w];
        char& digit = changed[w][random() % changed[w].size()];
        digit = "0123456789abcdefgz-_+. "[random() % 23];
        try_words(changed);
        changed[w] = "0" + words[w];
        try_words(changed);
      }
    }
  }
  EXPECT_GT(sabotage.refused(), 1500);
  EXPECT_GT(sabotage.accepted(), 20);
}

void renumber(TextCatalogue& c) {
  for (std::size_t i = 0; i < c.list.size(); ++i) {
    c.list[i].number = static_cast<std::int64_t>(i) + 1;
  }
  c.classes = static_cast<std::int64_t>(c.list.size());
}

CatalogueLaw broken_by(const TextCatalogue& c) {
  return check_catalogue_bytes(sealed(body_of(c)), "damaged").broken;
}

/// A class twice, the second time as another member, and all numbers as they should be.
TEST(CatalogueSabotage, EquivalentClassesAreFound) {
  std::mt19937_64 random(9);
  for (const bool balls : {false, true}) {
    const TextCatalogue c = balls ? catalogue_of_balls(6) : catalogue_of_cubes();
    const Maps maps = balls ? all_maps(6) : maps_of_cell(c.cell(), 8);
    for (std::size_t i = 0; i < c.list.size(); ++i) {
      TextCatalogue bad = c;
      TextClass again = c.list[i];
      for (int tries = 0; tries < 100 && sorted_list(again) == sorted_list(c.list[i]); ++tries) {
        const auto& map = maps[random() % maps.size()];
        for (Simplex& t : again.tetrahedra) {
          for (int& v : t) v = map[static_cast<std::size_t>(v)];
          t = sorted(t);
        }
      }
      bad.list.insert(bad.list.begin() + static_cast<std::ptrdiff_t>(i) + 1, again);
      bad.labelled += balls ? 0 : c.symmetries / again.automorphisms;
      if (balls) {
        std::sort(bad.list.begin(), bad.list.end(), [](const TextClass& a, const TextClass& b) {
          return std::pair(a.tetrahedra.size(), sorted_list(a)) <
                 std::pair(b.tetrahedra.size(), sorted_list(b));
        });
      }
      renumber(bad);
      EXPECT_EQ(broken_by(bad), CatalogueLaw::kEquivalent);
    }
  }
}

TEST(CatalogueSabotage, ExchangedClassesAreFound) {
  for (const TextCatalogue& c : {catalogue_of_cubes(), catalogue_of_balls(6)}) {
    for (std::size_t i = 0; i + 1 < c.list.size(); ++i) {
      TextCatalogue bad = c;
      std::swap(bad.list[i], bad.list[i + 1]);
      renumber(bad);
      EXPECT_EQ(broken_by(bad), CatalogueLaw::kOrder);
    }
  }
}

TEST(CatalogueSabotage, HostileTextsEnd) {
  const std::string good = body_of(catalogue_of_balls(5));
  const std::string head = good.substr(0, good.find("classes "));
  EXPECT_FALSE(is_accepted(sealed(head + "classes 18446744073709551615\nexhaustive no\n")));
  EXPECT_FALSE(is_accepted(sealed(head + "classes 18446744073709551616\nexhaustive no\n")));
  std::string all_fours = "class 1 1";
  for (const Simplex& t : subsets(first_numbers(16), 4)) all_fours.append(" ").append(digits(t));
  const std::string sixteen = "hexatlas catalogue 1\ndefinition " +
                              std::string(judged_definition_digest()) +
                              "\nkind balls\nname x\nvertices 16\ninterior 0\nclasses 1\n"
                              "exhaustive no\n";
  EXPECT_FALSE(is_accepted(sealed(sixteen + all_fours + "\n")));
  EXPECT_FALSE(is_accepted(sealed(sixteen + "class 1 1 unshelled 0123\n")));
  // 16 tetrahedra about an edge, in a circle: a ball with 18 vertices would be too much, 14 are
  // not.
  std::string fan = "class 1 48";
  for (int i = 2; i < 15; ++i) fan.append(" ").append(digits({0, 1, i, i + 1}));
  EXPECT_FALSE(is_accepted(sealed(sixteen + fan + "\n")));
  EXPECT_TRUE(is_accepted(sealed(sixteen + "class 1 4" + fan.substr(10) + "\n")));
  const std::string refuted = sixteen + "class 1 4" + fan.substr(10) + "\nembedded refuted\n";
  for (const std::string line :
       {"c 2147483648 0", "c -2147483649 0", "c 99999999999999999999 0", "c 0", "l 1 0 0",
        "l 0 4294967295 0", "l 0 4294967296 0", "c 1821 0", "c 1 1 0", "f 1 0", "f 0 1",
        "f 1 0 1 0 1 2 3 4 5 1 2", "f 1 0 1 0 0 2 3 4 5 1 2", "f 1 0 1099511627776 0 1 2 3 4 5 1 2",
        "qed", "x", ""}) {
    std::string text = refuted;
    text.append(line).append("\nqed\n");
    EXPECT_FALSE(is_accepted(sealed(text))) << line;
  }
}

/// One class with its refutation as a catalogue of its own, with the indices of the lines of that.
struct SingleRefutation {
  std::vector<std::string> lines;
  std::vector<std::size_t> places;
};

std::vector<SingleRefutation> refutations_in(const std::string& path) {
  const std::string bytes = bytes_of_file(path);
  std::string unpacked;
  if (begins_zstd_frame(bytes)) {
    EXPECT_TRUE(unpack_frame(bytes, kMostText, unpacked)) << path;
  }
  const std::string& text = unpacked.empty() ? bytes : unpacked;
  const TextCatalogue whole = lenient(text.substr(0, text.rfind("end ")));
  std::vector<SingleRefutation> found;
  for (const TextClass& item : whole.list) {
    for (const TextProperty& property : item.properties) {
      if (property.answer != "refuted") continue;
      TextCatalogue one = whole;
      one.list = {item};
      one.list[0].number = 1;
      one.list[0].properties = {property};
      one.classes = 1;
      one.labelled = one.symmetries / std::max<std::int64_t>(1, item.automorphisms);
      SingleRefutation& single = found.emplace_back();
      single.lines = lines_of(body_of(one));
      for (std::size_t i = 0; i < single.lines.size(); ++i) {
        if (is_of_refutation(single.lines[i])) single.places.push_back(i);
      }
    }
  }
  return found;
}

/// Changes a literal, hint or line of the refutation, in one of eight ways.
std::vector<std::string> damaged(const SingleRefutation& good, std::mt19937_64& random) {
  std::vector<std::string> lines = good.lines;
  const std::size_t i = good.places[random() % good.places.size()];
  const auto at = lines.begin() + static_cast<std::ptrdiff_t>(i);
  std::vector<std::string> words = words_of(lines[i]);
  const std::size_t w = 1 + random() % (words.size() - 1);
  switch (random() % 8) {
    case 0:
      lines.erase(at);
      return lines;
    case 1:
      lines.insert(at, *at);
      return lines;
    case 2:
      std::swap(lines[i], lines[good.places[random() % good.places.size()]]);
      return lines;
    case 3:
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(w));
      break;
    case 4:
      words[w] = words[w][0] == '-' ? words[w].substr(1) : "-" + words[w];
      break;
    case 5:
      words[w] = std::to_string(std::stoll(words[w]) + 1);
      break;
    case 6:
      words[w] = std::to_string(std::stoll(words[w]) - 1);
      break;
    default:
      std::swap(words[w], words[1 + random() % (words.size() - 1)]);
      break;
  }
  lines[i] = line_from(words);
  return lines;
}

TEST(CatalogueSabotage, NoDamagedRefutationIsAccepted) {
  std::vector<SingleRefutation> refutations;
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = support::kShippedFolder;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".hxc") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    EXPECT_TRUE(check_catalogue(file.string()).accepted) << file;
    for (SingleRefutation& one : refutations_in(file.string())) refutations.push_back(one);
  }
  ASSERT_FALSE(refutations.empty()) << "no refutation in " << folder;
  Sabotage sabotage;
  for (const SingleRefutation& good : refutations) {
    sabotage.expect_same(joined(good.lines, '\n'), "a refutation", false);
  }
  EXPECT_EQ(sabotage.refused(), 0);
  std::mt19937_64 random(17);
  for (int round = 0; round < 1000; ++round) {
    const SingleRefutation& good = refutations[random() % refutations.size()];
    const std::vector<std::string> bad = damaged(good, random);
    if (bad == good.lines) continue;
    // The oracle, which is slow, is asked only if the judge accepts.
    const std::string body = joined(bad, '\n');
    if (is_accepted(sealed(body))) sabotage.expect_same(body, "a damaged refutation", true);
  }
}

}  // namespace
}  // namespace hexatlas::check
