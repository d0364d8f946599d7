// Gmsh .msh 2.2 and 4.1, ASCII and little-endian binary. Source: the Gmsh reference manual, "MSH
// file format" and "Legacy formats". Nodes have positive tags, in any order and with gaps; here
// they become positions in the list of nodes.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "enum/core/errors.hpp"
#include "meshing/io/little_endian.hpp"
#include "meshing/io/readers.hpp"
#include "meshing/io/scanner.hpp"

namespace hexatlas::io {
namespace {

/// From tags to positions in the list of nodes.
class NodeTags {
 public:
  struct Node {
    std::int64_t tag;
    mesh::Index position;
    std::uint32_t line;
  };

  void add(std::int64_t tag, std::size_t line) {
    const auto position = static_cast<mesh::Index>(nodes_.size());
    is_sorted_ = is_sorted_ && (nodes_.empty() || nodes_.back().tag < tag);
    nodes_.push_back({tag, position, static_cast<std::uint32_t>(line)});
  }

  /// To be called after the last node. A node whose tag was used before, or null.
  [[nodiscard]] const Node* sort_and_find_duplicate() {
    const auto before = [](const Node& a, const Node& b) {
      return a.tag != b.tag ? a.tag < b.tag : a.position < b.position;
    };
    if (!is_sorted_) std::sort(nodes_.begin(), nodes_.end(), before);
    const auto same = std::adjacent_find(
        nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) { return a.tag == b.tag; });
    return same == nodes_.end() ? nullptr : &*(same + 1);
  }

  /// The position of the node with this tag; null if there is none.
  [[nodiscard]] const mesh::Index* find(std::int64_t tag) const {
    // Most programs count without gaps.
    if (!nodes_.empty() && tag >= nodes_[0].tag) {
      const auto guess = static_cast<std::uint64_t>(tag - nodes_[0].tag);
      if (guess < nodes_.size() && nodes_[guess].tag == tag) return &nodes_[guess].position;
    }
    const auto found =
        std::lower_bound(nodes_.begin(), nodes_.end(), tag,
                         [](const Node& node, std::int64_t wanted) { return node.tag < wanted; });
    return found == nodes_.end() || found->tag != tag ? nullptr : &found->position;
  }

 private:
  std::vector<Node> nodes_;
  bool is_sorted_ = true;
};

class GmshReader {
 public:
  GmshReader(std::string_view bytes, MeshBuilder& builder)
      : scanner_(bytes, builder.file()), builder_(builder) {}

  void read() {
    read_format();
    while (!scanner_.at_end()) {
      const std::string_view section = scanner_.word("a section");
      if (section == "$Nodes") {
        if (has_nodes_) scanner_.fail("second section $Nodes");
        begin_data();
        is_version_4_ ? read_node_blocks() : read_nodes();
        has_nodes_ = true;
        finish_nodes();
      } else if (section == "$Elements") {
        if (!has_nodes_) scanner_.fail("$Elements before $Nodes");
        if (has_elements_) scanner_.fail("second section $Elements");
        has_elements_ = true;
        begin_data();
        is_version_4_ ? read_element_blocks() : read_elements();
      } else if (is_skipped(section)) {
        scanner_.move_to(end_of(section));
      } else {
        scanner_.fail("unknown section " + in_quotes(section));
      }
      expect(end_of(section));
    }
    // Where cells are wanted, their lack tells.
    if (builder_.wanted() == Wanted::points && !has_nodes_) scanner_.fail_cut("$Nodes");
  }

 private:
  static std::string end_of(std::string_view section) {
    return "$End" + std::string(section.substr(1));
  }

  static bool is_skipped(std::string_view section) {
    constexpr std::array<std::string_view, 12> kSkipped{
        "$PhysicalNames", "$Entities",    "$PartitionedEntities", "$Periodic",
        "$GhostElements", "$NodeData",    "$Parametrizations",    "$ElementData",
        "$Comments",      "$MeshVersion", "$ElementNodeData",     "$InterpolationScheme"};
    return std::find(kSkipped.begin(), kSkipped.end(), section) != kSkipped.end();
  }

  void expect(const std::string& keyword) {
    const std::string_view word = scanner_.word(keyword.c_str());
    if (word != keyword) scanner_.fail(keyword + " is expected, not " + in_quotes(word));
  }

  void read_format() {
    expect("$MeshFormat");
    const std::string_view version = scanner_.word("the version");
    is_version_4_ = version == "4.1";
    if (!is_version_4_ && version != "2" && version != "2.1" && version != "2.2")
      scanner_.fail("unsupported version " + in_quotes(version) + "; save as 4.1 or 2.2");
    const std::int64_t encoding = scanner_.integer("0 (ASCII) or 1 (binary)");
    if (encoding != 0 && encoding != 1)
      scanner_.fail("0 (ASCII) or 1 (binary) is expected, not " + std::to_string(encoding));
    is_binary_ = encoding == 1;
    if (scanner_.integer("the size of numbers") != 8) scanner_.fail("numbers must have 8 bytes");
    if (is_binary_) {
      begin_data();
      if (load_little<std::int32_t>(scanner_.raw(4)) != 1)
        scanner_.fail("big-endian binary file; save as ASCII");
    } else {
      scanner_.refuse_nul();
    }
    expect("$EndMeshFormat");
  }

  /// Binary data begin right after the end of the line.
  void begin_data() {
    if (is_binary_ && !scanner_.rest_of_line().empty())
      scanner_.fail("text where binary data are expected");
  }

  // Numbers of the data: words, or 4 or 8 bytes.

  [[nodiscard]] std::int64_t small(const char* expected) {
    return is_binary_ ? load_little<std::int32_t>(scanner_.raw(4)) : scanner_.integer(expected);
  }

  [[nodiscard]] std::int64_t large(const char* expected) {
    return is_binary_ ? load_little<std::int64_t>(scanner_.raw(8)) : scanner_.integer(expected);
  }

  [[nodiscard]] double real(const char* expected) {
    if (!is_binary_) return scanner_.real(expected);
    const double value = load_little<double>(scanner_.raw(8));
    if (!std::isfinite(value)) scanner_.fail("coordinate that is not a finite number");
    return value;
  }

  /// Checks a count of objects with `small_numbers` and `large_numbers` numbers each.
  [[nodiscard]] std::size_t checked(std::int64_t count, std::size_t small_numbers,
                                    std::size_t large_numbers) const {
    constexpr std::size_t kWordBytes = 2;
    return scanner_.to_count(count, is_binary_ ? 4 * small_numbers + 8 * large_numbers
                                               : kWordBytes * (small_numbers + large_numbers));
  }

  [[nodiscard]] std::size_t line() const { return is_binary_ ? 0 : scanner_.line(); }

  void add_tag(std::int64_t tag) {
    if (tag < 1) scanner_.fail("node tag " + std::to_string(tag) + " is not positive");
    tags_.add(tag, line());
  }

  void add_point() {
    mesh::Point point;
    for (double* coordinate : {&point.x, &point.y, &point.z}) *coordinate = real("a coordinate");
    builder_.add_point(point, scanner_.line());
  }

  void finish_nodes() {
    if (const NodeTags::Node* node = tags_.sort_and_find_duplicate())
      throw core::InvalidInput(builder_.file(), node->line,
                               "second node with tag " + std::to_string(node->tag));
  }

  /// `entity`: the tag of the geometrical entity that the cell belongs to.
  void add_cell(const CellType& type, std::int64_t entity) {
    const auto vertices = static_cast<std::size_t>(type.vertices);
    std::array<mesh::Index, 27> corners{};
    for (std::size_t i = 0; i < vertices; ++i) {
      const std::int64_t tag = is_version_4_ ? large("a node") : small("a node");
      const mesh::Index* position = tags_.find(tag);
      if (position == nullptr) scanner_.fail("there is no node with tag " + std::to_string(tag));
      corners[i] = *position;
    }
    builder_.add_cell(type, std::span(corners).first(vertices), line(), entity);
  }

  [[nodiscard]] CellType read_type() {
    const std::int64_t number = small("the type of an element");
    const auto type = gmsh_cell_type(number);
    if (!type) scanner_.fail("element of unknown type " + std::to_string(number));
    return *type;
  }

  // Version 2.2. The counts of nodes and elements are words in binary files, too.

  [[nodiscard]] std::size_t read_count_word(const char* expected, std::size_t small_numbers,
                                            std::size_t large_numbers) {
    const std::int64_t count = scanner_.integer(expected);
    begin_data();
    return checked(count, small_numbers, large_numbers);
  }

  void read_nodes() {
    const std::size_t count = read_count_word("the number of nodes", 1, 3);
    builder_.reserve_points(count);
    for (std::size_t i = 0; i < count; ++i) {
      add_tag(small("the tag of a node"));
      add_point();
    }
  }

  /// Tags of an element, of which the second one is that of the entity; 0 if there is none.
  [[nodiscard]] std::int64_t read_entity(std::int64_t count) {
    const std::size_t tags = checked(count, 1, 0);
    std::int64_t entity = 0;
    for (std::size_t i = 0; i < tags; ++i) {
      const std::int64_t tag = small("a tag");
      if (i == 1) entity = tag;
    }
    return entity;
  }

  void read_elements() {
    const std::size_t count = read_count_word("the number of elements", 2, 0);
    for (std::size_t i = 0; i < count;) {
      if (!is_binary_) {
        static_cast<void>(small("the tag of an element"));
        const CellType type = read_type();
        add_cell(type, read_entity(small("the number of tags")));
        ++i;
        continue;
      }
      const CellType type = read_type();
      const std::int64_t follow = small("the number of elements that follow");
      const std::int64_t tags = small("the number of tags");
      if (follow < 1 || static_cast<std::uint64_t>(follow) > count - i)
        scanner_.fail("block of " + std::to_string(follow) + " elements");
      for (std::int64_t k = 0; k < follow; ++k, ++i) {
        static_cast<void>(small("the tag of an element"));
        add_cell(type, read_entity(tags));
      }
    }
  }

  // Version 4.1.

  /// The numbers of blocks and of objects in them; then the least and the largest tag.
  [[nodiscard]] std::array<std::size_t, 2> read_totals(const char* expected,
                                                       std::size_t numbers_each) {
    const std::size_t blocks = checked(large(expected), 3, 1);
    const std::size_t total = checked(large(expected), 0, numbers_each);
    for (int i = 0; i < 2; ++i) static_cast<void>(large("a tag"));
    return {blocks, total};
  }

  [[nodiscard]] std::size_t read_block_size(std::size_t left, std::size_t large_numbers) {
    const std::size_t size = checked(large("the size of a block"), 0, large_numbers);
    if (size > left) scanner_.fail("more objects in the blocks than announced");
    return size;
  }

  void read_node_blocks() {
    auto [blocks, left] = read_totals("the number of nodes", 4);
    builder_.reserve_points(left);
    for (; blocks > 0; --blocks) {
      const std::int64_t dimension = small("the dimension of an entity");
      if (dimension < 0 || dimension > 3)
        scanner_.fail("entity of dimension " + std::to_string(dimension));
      static_cast<void>(small("the tag of an entity"));
      const std::int64_t parametric = small("0 or 1");
      if (parametric != 0 && parametric != 1) scanner_.fail("0 or 1 is expected");
      const std::size_t size = read_block_size(left, 4);
      left -= size;
      for (std::size_t i = 0; i < size; ++i) add_tag(large("the tag of a node"));
      for (std::size_t i = 0; i < size; ++i) {
        add_point();
        for (std::int64_t k = 0; k < parametric * dimension; ++k)
          static_cast<void>(real("a parametric coordinate"));
      }
    }
    if (left != 0) scanner_.fail("fewer nodes in the blocks than announced");
  }

  void read_element_blocks() {
    auto [blocks, left] = read_totals("the number of elements", 2);
    for (; blocks > 0; --blocks) {
      static_cast<void>(small("the dimension of an entity"));
      const std::int64_t entity = small("the tag of an entity");
      const CellType type = read_type();
      const std::size_t size = read_block_size(left, static_cast<std::size_t>(type.vertices) + 1);
      left -= size;
      builder_.reserve_cells(type, size);
      for (std::size_t i = 0; i < size; ++i) {
        static_cast<void>(large("the tag of an element"));
        add_cell(type, entity);
      }
    }
    if (left != 0) scanner_.fail("fewer elements in the blocks than announced");
  }

  Scanner scanner_;
  MeshBuilder& builder_;
  NodeTags tags_;
  bool is_version_4_ = false;
  bool is_binary_ = false;
  bool has_nodes_ = false;
  bool has_elements_ = false;
};

}  // namespace

void read_gmsh(std::string_view bytes, MeshBuilder& builder) { GmshReader(bytes, builder).read(); }

}  // namespace hexatlas::io
