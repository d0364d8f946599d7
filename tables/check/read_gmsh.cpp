#include <algorithm>
#include <array>
#include <unordered_map>

#include "tables/check/readers.hpp"
#include "tables/check/scanner.hpp"

namespace hexatlas::check {

namespace {

constexpr std::array<ShapeNumber, 8> kGmshShapes = {{{1, Shape::kLine},
                                                     {2, Shape::kTriangle},
                                                     {3, Shape::kQuad},
                                                     {4, Shape::kTetrahedron},
                                                     {5, Shape::kHexahedron},
                                                     {6, Shape::kPrism},
                                                     {7, Shape::kPyramid},
                                                     {15, Shape::kVertex}}};

/// The points of a Gmsh file carry tags; their order in the file numbers them here.
struct TaggedDraft {
  Draft draft;
  std::unordered_map<std::uint64_t, std::uint32_t> number_of_tag;
};

void add_tag(Scanner& in, TaggedDraft& tagged, std::uint64_t tag) {
  const auto number = static_cast<std::uint32_t>(tagged.number_of_tag.size());
  if (tag == 0 || !tagged.number_of_tag.emplace(tag, number).second) {
    in.fail("the node tag " + std::to_string(tag) + " is zero or occurs twice");
  }
}

std::uint32_t node(Scanner& in, const TaggedDraft& tagged) {
  const std::uint64_t tag = in.natural();
  const auto found = tagged.number_of_tag.find(tag);
  if (found == tagged.number_of_tag.end()) {
    in.fail("there is no node with tag " + std::to_string(tag));
  }
  return found->second;
}

void read_element(Scanner& in, TaggedDraft& tagged, std::uint64_t type) {
  const auto* const known =
      std::find_if(kGmshShapes.begin(), kGmshShapes.end(),
                   [type](const ShapeNumber& candidate) { return candidate.number == type; });
  if (known == kGmshShapes.end() || tagged.draft.refuses(known->shape)) {
    in.fail("an element of Gmsh type " + std::to_string(type) + " is " + tagged.draft.refusal());
  }
  std::array<std::uint32_t, 8> corners{};
  const auto used = std::span(corners).first(corner_count(known->shape));
  for (std::uint32_t& vertex : used) vertex = node(in, tagged);
  tagged.draft.add(known->shape, used);
}

void read_nodes_2(Scanner& in, TaggedDraft& tagged) {
  const std::uint64_t count = in.count(8);
  tagged.draft.points.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    add_tag(in, tagged, in.natural());
    tagged.draft.points.push_back(in.point());
  }
}

void read_elements_2(Scanner& in, TaggedDraft& tagged) {
  const std::uint64_t count = in.count(6);
  for (std::uint64_t i = 0; i < count; ++i) {
    static_cast<void>(in.natural());
    const std::uint64_t type = in.natural();
    const std::uint64_t tags = in.count(2);
    for (std::uint64_t tag = 0; tag < tags; ++tag) static_cast<void>(in.integer());
    read_element(in, tagged, type);
  }
}

/// The four numbers that open both sections of version 4.1.
struct BlockCounts {
  std::uint64_t blocks;
  std::uint64_t items;
  std::uint64_t least;
  std::uint64_t greatest;
};

BlockCounts read_block_counts(Scanner& in) {
  const std::uint64_t blocks = in.count(2);
  const std::uint64_t items = in.count(2);
  const std::uint64_t least = in.natural();
  const std::uint64_t greatest = in.natural();
  return {blocks, items, least, greatest};
}

std::uint64_t tag_within(Scanner& in, const BlockCounts& counts) {
  const std::uint64_t tag = in.natural();
  if (tag < counts.least || tag > counts.greatest) in.fail("a tag is outside the stated range");
  return tag;
}

void read_nodes_4(Scanner& in, TaggedDraft& tagged) {
  const BlockCounts counts = read_block_counts(in);
  for (std::uint64_t block = 0; block < counts.blocks; ++block) {
    const std::uint64_t dimension = in.natural();
    static_cast<void>(in.integer());
    const std::uint64_t parametric = in.natural();
    if (dimension > 3 || parametric > 1) in.fail("a block of nodes starts wrongly");
    const std::uint64_t size = in.count(8);
    for (std::uint64_t i = 0; i < size; ++i) add_tag(in, tagged, tag_within(in, counts));
    for (std::uint64_t i = 0; i < size; ++i) {
      tagged.draft.points.push_back(in.point());
      for (std::uint64_t j = 0; j < parametric * dimension; ++j) static_cast<void>(in.real());
    }
  }
  if (tagged.draft.points.size() != counts.items) in.fail("the number of nodes is wrong");
}

void read_elements_4(Scanner& in, TaggedDraft& tagged) {
  const BlockCounts counts = read_block_counts(in);
  std::uint64_t total = 0;
  for (std::uint64_t block = 0; block < counts.blocks; ++block) {
    if (in.natural() > 3) in.fail("a block of elements starts wrongly");
    static_cast<void>(in.integer());
    const std::uint64_t type = in.natural();
    const std::uint64_t size = in.count(4);
    for (std::uint64_t i = 0; i < size; ++i) {
      static_cast<void>(tag_within(in, counts));
      read_element(in, tagged, type);
    }
    total += size;
  }
  if (total != counts.items) in.fail("the number of elements is wrong");
}

void pass_over(Scanner& in, std::string_view section) {
  const std::string end = "$End" + std::string(section.substr(1));
  in.skip_line();
  while (in.peek() != end) {
    if (in.at_end()) in.fail("the section " + in_quotes(section) + " does not end");
    in.skip_line();
  }
  in.expect(end);
}

}  // namespace

Draft parse_gmsh(const std::string& name, std::string_view bytes, Wanted wanted) {
  Scanner in(name, bytes);
  in.expect("$MeshFormat");
  const std::string_view version = in.word();
  const bool blocks = version == "4.1";
  if (!blocks && version != "2" && version != "2.1" && version != "2.2")
    in.fail("unknown version " + in_quotes(version));
  if (in.peek() == "1") in.fail("a binary file; save it as ASCII");
  in.expect("0");
  in.expect("8");
  in.expect("$EndMeshFormat");
  TaggedDraft tagged{Draft(wanted), {}};
  bool nodes_seen = false;
  bool elements_seen = false;
  while (!in.at_end()) {
    const std::string_view section = in.word();
    if (section == "$Nodes" && !nodes_seen) {
      blocks ? read_nodes_4(in, tagged) : read_nodes_2(in, tagged);
      in.expect("$EndNodes");
      nodes_seen = true;
    } else if (section == "$Elements" && nodes_seen && !elements_seen) {
      blocks ? read_elements_4(in, tagged) : read_elements_2(in, tagged);
      in.expect("$EndElements");
      elements_seen = true;
    } else if (section[0] == '$' && section != "$Nodes" && section != "$Elements") {
      pass_over(in, section);
    } else {
      in.fail("unknown or misplaced section " + in_quotes(section));
    }
  }
  if (!nodes_seen || !elements_seen) in.fail("the sections Nodes and Elements must be present");
  return std::move(tagged.draft);
}

}  // namespace hexatlas::check
