#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "tables/check/canonical_form.hpp"
#include "tables/check/catalogue.hpp"
#include "tables/check/catalogue_points.hpp"
#include "tables/check/catalogue_read.hpp"
#include "tables/check/cell_laws.hpp"
#include "tables/check/file_bytes.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/refutation.hpp"
#include "tables/check/shelling.hpp"
#include "tables/check/triangulation_laws.hpp"
#include "tables/check/zstd_frame.hpp"

namespace hexatlas::check {

namespace {

constexpr int kMostInterior = 6;
/// What one judgement may spend on searches, whatever the file: steps of searches for shellings,
/// and images of tetrahedra under permutations.
constexpr std::uint64_t kAllShellingSteps = 100 * kShellingSteps;
constexpr std::uint64_t kAllImages = std::uint64_t{1} << 34;

class CatalogueJudge {
 public:
  CatalogueJudge(const CatalogueText& text, const std::string& file) : text_(text), file_(file) {}

  CatalogueVerdict judge() {
    verdict_.name = text_.name;
    verdict_.is_cell = text_.is_cell;
    verdict_.vertices = text_.vertices;
    verdict_.interior = text_.interior;
    verdict_.claims_exhaustive = text_.exhaustive;
    if (judge_file() && (!text_.is_cell || judge_cell()) && judge_classes()) {
      verdict_.accepted = !verdict_.undecided;
    }
    return std::move(verdict_);
  }

 private:
  bool reject(CatalogueLaw law, std::string reason) {
    verdict_.undecided = false;
    verdict_.broken = law;
    verdict_.reason = std::move(reason);
    return false;
  }

  /// Judging goes on: a later law may be broken.
  void leave_undecided(CatalogueLaw law, std::string reason) {
    if (verdict_.undecided) return;
    verdict_.undecided = true;
    verdict_.broken = law;
    verdict_.reason = std::move(reason);
  }

  bool judge_file() {
    if (!text_.digest_holds) {
      return reject(CatalogueLaw::kDigest, "the digest at the end is not that of the file");
    }
    if (text_.definition != judged_definition_digest()) {
      return reject(CatalogueLaw::kDefinition, "the definition is not the one that is judged here");
    }
    return true;
  }

  bool judge_cell() {
    boundary_vertices_ = text_.vertices - text_.interior;
    const std::string broken = broken_cell_law(text_.facets, boundary_vertices_);
    if (!broken.empty()) return reject(CatalogueLaw::kCell, broken);
    if (!is_cell_of_name(text_.name, text_.facets, boundary_vertices_)) {
      return reject(CatalogueLaw::kName, "the cell is no " + text_.name);
    }
    const auto symmetries = symmetries_of(text_.facets);
    if (symmetries.size() != text_.symmetries) {
      return reject(CatalogueLaw::kSymmetries,
                    "the group of the cell has the order " + std::to_string(symmetries.size()));
    }
    verdict_.symmetries = text_.symmetries;
    if (text_.interior <= kMostInterior) {
      permutations_ = with_interior_permutations(symmetries, boundary_vertices_, text_.interior);
    }
    return true;
  }

  bool judge_classes() {
    for (const CatalogueClass& item : text_.list) {
      prefix_ = "class " + std::to_string(verdict_.classes + 1) + ": ";
      if (item.number != verdict_.classes + 1) {
        return reject(CatalogueLaw::kNumbering,
                      prefix_ + "has the number " + std::to_string(item.number));
      }
      const CatalogueFinding found = judge_class(item);
      if (found) return reject(found->law, prefix_ + found->reason);
      ++verdict_.classes;
    }
    if (verdict_.classes != text_.classes) {
      return reject(CatalogueLaw::kNumbering,
                    "there are " + std::to_string(verdict_.classes) + " classes");
    }
    if (text_.is_cell && !verdict_.undecided && verdict_.labelled != text_.labelled) {
      return reject(CatalogueLaw::kLabelled,
                    "the sum of the class sizes is " + std::to_string(verdict_.labelled));
    }
    return true;
  }

  CatalogueFinding judge_class(const CatalogueClass& item) {
    const Tetrahedra& tetrahedra = item.tetrahedra;
    CatalogueFinding found = check_triangles(tetrahedra);
    if (!found) found = check_vertices(tetrahedra, text_.vertices);
    if (found) return found;
    if (item.shelled && !is_shelling(tetrahedra)) {
      return BrokenLaw{CatalogueLaw::kBall, "the order of the tetrahedra is no shelling"};
    }
    if (!item.shelled && !find_ball_proof(tetrahedra, shelling_steps_)) {
      leave_undecided(CatalogueLaw::kBall, prefix_ + "no shelling was found");
      return std::nullopt;
    }
    OutwardTriangle outward{};
    if (text_.is_cell) {
      found = check_boundary(tetrahedra, text_.facets, outward);
      if (!found && !text_.boundary_tetrahedra) {
        found = check_boundary_tetrahedra(tetrahedra, text_.facets);
      }
    }
    if (!found) found = judge_order(item);
    if (found) return found;
    const std::vector<int> signs =
        text_.is_cell ? coherent_signs(tetrahedra, outward) : coherent_signs(tetrahedra);
    for (const Property& property : item.properties) {
      found = judge_property(property, tetrahedra, signs);
      if (found) return found;
    }
    return std::nullopt;
  }

  /// The canonical form, if the means suffice.
  std::optional<CanonicalForm> form_of(const Tetrahedra& tetrahedra) {
    const std::uint64_t maps = text_.is_cell ? permutations_.size() : 24 * tetrahedra.size();
    const std::uint64_t images = maps * tetrahedra.size();
    if (maps == 0 || images > images_left_) return std::nullopt;
    images_left_ -= images;
    return text_.is_cell ? form_in_cell(tetrahedra, permutations_) : form_of_ball(tetrahedra);
  }

  CatalogueFinding judge_order(const CatalogueClass& item) {
    std::optional<CanonicalForm> form = form_of(item.tetrahedra);
    if (!form) {
      leave_undecided(CatalogueLaw::kEquivalent, prefix_ + "there are too many permutations");
      return std::nullopt;
    }
    if (form->automorphisms != item.automorphisms) {
      return BrokenLaw{CatalogueLaw::kAutomorphisms,
                       "has " + std::to_string(form->automorphisms) + " automorphisms"};
    }
    verdict_.labelled += text_.symmetries / form->automorphisms;
    const auto [other, is_new] = number_of_.try_emplace(form->least, item.number);
    if (!is_new) {
      return BrokenLaw{CatalogueLaw::kEquivalent,
                       "is equivalent to class " + std::to_string(other->second)};
    }
    // Cells are in the order of the canonical forms, balls in that of the lists given.
    Tetrahedra place = std::move(form->least);
    if (!text_.is_cell) {
      place = item.tetrahedra;
      std::sort(place.begin(), place.end());
    }
    if (std::pair(place.size(), place) <= std::pair(last_place_.size(), last_place_)) {
      return BrokenLaw{CatalogueLaw::kOrder, "should come before the class before it"};
    }
    last_place_ = std::move(place);
    return std::nullopt;
  }

  CatalogueFinding judge_property(const Property& property, const Tetrahedra& tetrahedra,
                                  const std::vector<int>& signs) {
    ConditionCounts& counts = verdict_.conditions[static_cast<std::size_t>(property.condition)];
    CatalogueFinding found;
    switch (property.answer) {
      case Property::Answer::kOpen:
        ++counts.open;
        break;
      case Property::Answer::kPoints: {
        bool undecided = false;
        found = check_points(tetrahedra, signs, property.points, property.condition, undecided);
        if (undecided) {
          leave_undecided(found->law, prefix_ + found->reason);
          return std::nullopt;
        }
        ++counts.realizable;
        break;
      }
      case Property::Answer::kRefuted: {
        RefutationCounts parts;
        found = check_refutation(property.refutation, file_, {text_.vertices, tetrahedra, signs},
                                 property.condition, parts);
        verdict_.premises += parts.premises;
        verdict_.polynomials += parts.polynomials;
        verdict_.lemmas += parts.lemmas;
        ++counts.refuted;
        break;
      }
    }
    return found;
  }

  const CatalogueText& text_;
  const std::string& file_;
  CatalogueVerdict verdict_;
  int boundary_vertices_ = 0;
  std::vector<VertexPermutation> permutations_;  ///< none if they are too many
  std::uint64_t shelling_steps_ = kAllShellingSteps;
  std::uint64_t images_left_ = kAllImages;
  std::map<Tetrahedra, std::uint64_t> number_of_;  ///< class, by canonical form
  Tetrahedra last_place_;
  std::string prefix_;
};

}  // namespace

std::string_view judged_definition_digest() noexcept {
  return "17153c2e79d354ff76005078f00c01b64715358ecdf9379c22a2df925e13e4ab";
}

bool is_catalogue(std::string_view first_bytes) noexcept {
  return begins_zstd_frame(first_bytes) || first_bytes.starts_with("hexatlas catalogue ");
}

CatalogueVerdict check_catalogue_bytes(std::string_view bytes, const std::string& file) {
  std::string unpacked;
  if (begins_zstd_frame(bytes)) {
    if (!unpack_frame(bytes, kMostText, unpacked)) {
      throw Malformed(
          file, 0, "is not one Zstandard frame of at most " + std::to_string(kMostText) + " bytes");
    }
    bytes = unpacked;
  }
  return CatalogueJudge(read_catalogue(bytes, file), file).judge();
}

CatalogueVerdict check_catalogue(const std::string& path) {
  const std::string bytes = bytes_of_file(path, kMostText);
  return check_catalogue_bytes(bytes, name_of_file(path));
}

}  // namespace hexatlas::check
