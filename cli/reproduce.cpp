// One command from the definition to the judged result of "There are 174 subdivisions of the
// hexahedron into tetrahedra": two enumerations, completeness, realizability, pictures. The numbers
// expected are those of the literature, or were fixed before this program first ran (see
// experiments/2026-11-hexahedron-174).

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/long_work.hpp"
#include "cli/output.hpp"
#include "enum/balls/spheres.hpp"
#include "enum/balls/spheres_cells.hpp"
#include "enum/balls/triangulations.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/build/catalogues.hpp"
#include "tables/build/realize.hpp"
#include "tables/check/catalogue.hpp"
#include "tables/check/completeness.hpp"
#include "tables/sheet/contact_sheet.hpp"

namespace hexatlas::cli {
namespace {

using certificate::Condition;

/// By number of tetrahedra from 5 to 15: Pellerin, Verhetsel, Remacle (2018).
constexpr std::array<std::uint64_t, 11> kClassesBySize{1, 5, 5, 7, 13, 20, 35, 30, 28, 19, 11};
/// Triangulated 3-spheres with 5 .. 9 vertices: Altshuler, Bokowski, Steinberg (1980).
constexpr std::array<std::size_t, 5> kSpheres{1, 2, 5, 39, 1296};
constexpr std::size_t kClasses = 174;
constexpr std::size_t kRealizable = 171;
constexpr std::size_t kConvex = 158;        // tables/data/hexahedron.hxc, each with a certificate
constexpr std::size_t kWithJacobian = 143;  // likewise
constexpr std::size_t kGreatestSize = 15;

constexpr const char* kCatalogueFile = "hexahedron.hxc";
constexpr const char* kPicturesFile = "hexahedron.html";
constexpr const char* kProofFile = "hexahedron.hxl";

/// Prints a line per claim and remembers whether all of them held.
class Ledger {
 public:
  template <class Value>
  void compare(const std::string& claim, const Value& found, const Value& expected) {
    const bool agrees = found == expected;
    all_agree_ = all_agree_ && agrees;
    print(agrees ? fmt::format("ok    {}: {}\n", claim, found)
                 : fmt::format("FAIL  {}: {}, expected {}\n", claim, found, expected));
  }
  void hold(const std::string& claim, bool holds) {
    all_agree_ = all_agree_ && holds;
    print(fmt::format("{}  {}\n", holds ? "ok  " : "FAIL", claim));
  }
  void note(const std::string& text) { print(fmt::format("      {}\n", text)); }
  [[nodiscard]] bool all_agree() const { return all_agree_; }

 private:
  bool all_agree_ = true;
};

class Reproduction {
 public:
  explicit Reproduction(const ReproduceOptions& options)
      : folder_(options.folder),
        threads_(parallel::threads_or_all(options.threads)),
        cell_(*complex::cell_named("hexahedron")) {}

  /// Whether all claims hold; nothing if it was stopped, which would look like a refutation.
  std::optional<bool> run() {
    if (!folder_.empty())
      for (const std::string name : {kCatalogueFile, kPicturesFile, kProofFile})
        core::expect_writable(path_of(name));
    enumerate();
    enumerate_through_spheres();
    answer(Condition::embedded);
    if (stop_requested()) return std::nullopt;
    compare_realizable();
    for (const auto& [condition, realizable] :
         {std::pair{Condition::convex, kConvex}, {Condition::jacobian, kWithJacobian}}) {
      answer(condition);
      if (stop_requested()) return std::nullopt;
      compare_in_part(condition, realizable);
    }
    judge();
    prove_complete();
    if (stop_requested()) return std::nullopt;
    write_all();
    return ledger_.all_agree();
  }

 private:
  [[nodiscard]] std::string path_of(const std::string& name) const {
    return (std::filesystem::path(folder_) / name).string();
  }

  void write_all() {
    if (folder_.empty()) return;
    if (!proof_.empty()) write(kProofFile, proof_);
    write(kCatalogueFile, format::catalogue_bytes(catalogue_));
    write(kPicturesFile, sheet::contact_sheet(catalogue_));
  }

  void write(const std::string& name, const std::string& bytes) {
    const std::string path = path_of(name);
    core::write_file(path, bytes);
    ledger_.note("written: " + path);
  }

  void enumerate() {
    balls::CensusOptions options;
    options.threads = threads_;
    census_ = balls::triangulations(cell_, options);
    catalogue_ = build::catalogue_of(cell_, "hexahedron", options, census_);
    ledger_.hold("the direct search is exhaustive", census_.exhaustive);
    ledger_.compare("classes, direct search", census_.classes.size(), kClasses);
    for (std::size_t i = 0; i < kClassesBySize.size(); ++i)
      ledger_.compare(fmt::format("classes with {} tetrahedra", i + 5),
                      census_.by_tetrahedra[i + 5].classes, kClassesBySize[i]);
    ledger_.note(fmt::format("labelled triangulations: {}", census_.total().labelled));
  }

  void enumerate_through_spheres() {
    balls::Spheres list = balls::spheres(balls::kMinSphereVertices, {threads_, {}});
    for (std::size_t i = 0; i < kSpheres.size(); ++i) {
      if (i > 0) list = balls::next_spheres(list, {threads_, {}});
      ledger_.compare(fmt::format("3-spheres with {} vertices", list.vertices), list.found.size(),
                      kSpheres[i]);
    }
    const balls::CellClasses other = balls::triangulations_from(list, cell_, {}, threads_);
    bool same = other.classes.size() == census_.classes.size();
    for (std::size_t i = 0; same && i < other.classes.size(); ++i)
      same = other.classes[i].triangulation == census_.classes[i].canonical &&
             other.classes[i].automorphisms == census_.classes[i].automorphisms;
    ledger_.hold("the spheres give the same classes, one by one", same);
    ledger_.compare("labelled, through spheres", other.labelled, census_.total().labelled);
  }

  void answer(Condition condition) {
    build::RealizeOptions options;
    options.condition = condition;
    options.threads = threads_;
    realize_classes(catalogue_, options, std::string(certificate::name_of(condition)));
    const build::AnswerCounts counts = build::count_answers(catalogue_, condition);
    ledger_.note(fmt::format("{}: {} by coordinates, {} refuted, {} open",
                             certificate::name_of(condition), counts.realizable, counts.refuted,
                             counts.open));
  }

  /// Answers in full take longer searches; those that come at once must not contradict them.
  void compare_in_part(Condition condition, std::size_t realizable) {
    const build::AnswerCounts counts = build::count_answers(catalogue_, condition);
    ledger_.hold(fmt::format("as far as answered, not beyond {} by coordinates and {} refuted",
                             realizable, kClasses - realizable),
                 counts.realizable <= realizable && counts.refuted <= kClasses - realizable);
  }

  void compare_realizable() {
    const build::AnswerCounts counts = build::count_answers(catalogue_, Condition::embedded);
    ledger_.compare("realizable classes", counts.realizable, kRealizable);
    ledger_.compare("refuted classes", counts.refuted, kClasses - kRealizable);
    bool all_large = true;
    for (const auto& entry : catalogue_.classes)
      if (std::holds_alternative<certificate::Refutation>(*entry.answers[0]))
        all_large = all_large && entry.triangulation.tetrahedra.size() == kGreatestSize;
    ledger_.hold("the refuted classes have 15 tetrahedra", all_large);
  }

  void judge() {
    const check::CatalogueVerdict verdict =
        check::check_catalogue_bytes(format::catalogue_bytes(catalogue_), kCatalogueFile);
    ledger_.hold("the judge accepts classes, coordinates and refutations" +
                     (verdict.accepted ? "" : ": " + verdict.reason),
                 verdict.accepted);
  }

  void prove_complete() {
    const auto certificate = prove_completeness(catalogue_);
    ledger_.hold("no other triangulation: a solver found a proof", certificate.has_value());
    if (!certificate) return;
    const check::CompletenessVerdict verdict = check::check_completeness_bytes(
        format::catalogue_bytes(catalogue_), kCatalogueFile, *certificate, kProofFile);
    ledger_.hold("the judge accepts the proof" +
                     (verdict.complete ? fmt::format(", {} bytes", certificate->size())
                                       : ": " + verdict.fault),
                 verdict.complete);
    ledger_.compare("labelled, by the judge", verdict.labelled,
                    static_cast<std::size_t>(census_.total().labelled));
    proof_ = *certificate;
  }

  std::string folder_;
  int threads_;
  complex::Cell cell_;
  balls::Census census_;
  format::Catalogue catalogue_;
  std::string proof_;  ///< of completeness; empty if none was found
  Ledger ledger_;
};

}  // namespace

ExitCode reproduce(const ReproduceOptions& options) {
  if (!options.folder.empty()) {
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    if (error)
      throw core::InvalidInput(options.folder, "cannot be made a folder: " + error.message());
  }
  const std::optional<bool> agrees = Reproduction(options).run();
  if (!agrees) {
    say("stopped; whether hexahedron-174 is reproduced is open, and nothing is written");
    return ExitCode::undecided;
  }
  print(*agrees ? "hexahedron-174: reproduced\n" : "hexahedron-174: NOT reproduced\n");
  return *agrees ? ExitCode::yes : ExitCode::no;
}

}  // namespace hexatlas::cli
