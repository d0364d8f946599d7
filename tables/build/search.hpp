#pragma once
/// \file
/// Search for small hexahedral meshes of many boundaries at once: what fills a table.
///
/// Method, in rounds. A *sweep* grows balls from the single hexahedron, level by level
/// (enum/flips/beam.hpp); each boundary reached has a mesh. *Exchange*: of each mesh, balls of its
/// hexahedra are exchanged for smaller ones that the sweep knows (enum/flips/replacement.hpp).
/// Then the boundaries with the largest meshes, and those without one, get more. *Cuts*: two known
/// balls are joined along a disc (enum/flips/cut.hpp), and what they make, as well as the mesh
/// known before, goes through a longer exchange. *Symmetric collars*, for boundaries that have an
/// involution, and *collars*: hexahedra are taken off inwards until a known ball fits, or one that
/// has the involution, too (enum/flips/meeting.hpp, enum/flips/symmetric_balls.hpp). *Annealing*:
/// exchange that may break the strict rule for a while (enum/flips/annealing.hpp), begun with the
/// known mesh and with others of the same boundary from collars of all kinds, those that do not
/// quite fit among them (enum/flips/faulty_meeting.hpp), and with parts of meshes of other
/// boundaries (enum/flips/transplant.hpp), in each dual class (enum/complex/dual_class.hpp) that
/// these have or leaps come to. What is found goes back into the
/// beam, with all balls on the way, and the next sweep goes on from there: so a mesh one flip away
/// from a smaller one becomes smaller, too. A mesh without a shelling that the beam could hold is
/// kept beside it.
///
/// The search proceeds in steps of seconds to a few minutes. Between two steps it can be saved.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/meeting.hpp"
#include "enum/flips/replacement.hpp"
#include "enum/flips/symmetric_balls.hpp"
#include "enum/flips/walk.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::build {

/// All 3-connected quadrangulations with an even number of quads from 6 to `max_quads`, ascending.
/// From the generator of enum/quads.
[[nodiscard]] std::vector<canon::Code> three_connected_codes(int max_quads);

struct SearchOptions {
  /// Of the balls grown. The seed and the threads are those of the whole search.
  flips::BeamOptions balls{.max_quads = 24, .fronts_per_class = 200, .fronts_per_level = 1'000'000};
  int max_hexahedra = 72;  ///< of a ball
  int rounds = 3;          ///< each: sweep, exchange, cuts, symmetric collars, collars, annealing
  int growths = 20;        ///< of exchange, per boundary and round
  std::size_t cut = 1000;  ///< boundaries per round
  std::size_t cuts_each = 10;  ///< cuts of one boundary, each of which gets its exchange
  int cut_growths = 300;       ///< of exchange, per cut
  int cut_interior = 4;        ///< vertices inside the disc of a cut, at most 8
  unsigned cut_uphill = 4;     ///< of exchange, per cut (replacement.hpp)
  /// A mesh with a symmetry is found at widths at which others are not.
  flips::BeamOptions symmetric{
      .max_quads = 34, .fronts_per_class = 20, .fronts_per_level = 1'000, .scars_per_quad = 3};
  int max_symmetric = 40;        ///< hexahedra
  std::size_t symmetrized = 50;  ///< boundaries per round
  /// Symmetric balls that fill the cavities of such collars, beside the balls known. What they
  /// prefer of irregularity and of simple zones is what `balls` do.
  flips::BeamOptions symmetric_balls{
      .max_quads = 36, .fronts_per_class = 200, .fronts_per_level = 500};
  int max_symmetric_ball = 24;  ///< hexahedra; 0: there are none
  /// Some boundaries have no flip that adds less than four quads; those around two vertices of high
  /// degree have no short way back to fewer.
  flips::BeamOptions collars{
      .max_quads = flips::kMaxSearchQuads, .fronts_per_class = 20, .fronts_per_level = 3'000};
  int max_collar = 12;             ///< hexahedra
  int guided = 0;                  ///< of wide and symmetric collars, as in MeetingOptions
  std::size_t collared = 100;      ///< boundaries per round
  std::size_t annealed = 0;        ///< boundaries per round
  std::size_t anneal_starts = 16;  ///< meshes that annealing of one boundary begins with
  /// Others with faults (enum/flips/faulty_meeting.hpp), as many with symmetric collars, and as
  /// many with symmetric balls in these.
  std::size_t anneal_faulty = 100;
  std::size_t anneal_cut = 100;         ///< others with faults (enum/flips/faulty_cut.hpp)
  std::size_t anneal_transplant = 100;  ///< others, with faults or not (enum/flips/transplant.hpp)
  int anneal_rounds = 8;                ///< of annealing, per beginning and leap
  /// Of annealing that keeps an involution, per beginning and involution (symmetric_walk.hpp).
  int anneal_symmetric = 8;
  int anneal_leaps = 120;  ///< to other meshes (enum/flips/annealing.hpp)
};

/// How the mesh of a boundary was found, as a word of the census; and the other way round, for
/// words that are none FrontOrigin::known.
[[nodiscard]] std::string_view name_of(flips::FrontOrigin origin) noexcept;
[[nodiscard]] flips::FrontOrigin origin_named(std::string_view name) noexcept;

class TableSearch {
 public:
  /// `targets`: codes of 3-connected quadrangulations with at most kMaxSearchQuads quads.
  TableSearch(std::vector<canon::Code> targets, const SearchOptions& options);

  enum class Phase : std::uint8_t {
    sweep,
    exchange,
    cuts,
    symmetric,
    collars,
    annealing,
    finished
  };

  [[nodiscard]] bool is_finished() const noexcept { return phase_ == Phase::finished; }
  /// Does the next piece of work. Requires that the search is not finished.
  void step();

  struct Progress {
    std::string phase;
    std::size_t done = 0, total = 0;
  };
  [[nodiscard]] Progress progress() const;

  struct Row {
    canon::Code code;
    int hexahedra = 0;
    flips::FrontOrigin origin = flips::FrontOrigin::grown;
  };
  /// The targets with a mesh so far, ascending.
  [[nodiscard]] std::vector<Row> rows() const;
  [[nodiscard]] std::vector<canon::Code> without_mesh() const;
  /// The mesh of a target, validated under the strict rule and against its boundary (InternalError
  /// otherwise). Requires that it has one.
  [[nodiscard]] complex::HexComplex mesh(const canon::Code& target) const;
  [[nodiscard]] const flips::Beam& balls() const noexcept { return balls_; }

  /// All that is needed to go on as if the search had never stopped, with a digest.
  [[nodiscard]] std::string to_bytes() const;
  /// Throws InvalidInput, with `name` for the file, if the bytes are damaged or of a search with
  /// other targets or options; threads, the limit of memory and the number of rounds may differ. A
  /// finished search goes on if there are more rounds now.
  [[nodiscard]] static TableSearch from_bytes(std::string_view bytes,
                                              std::vector<canon::Code> targets,
                                              const SearchOptions& options,
                                              const std::string& name);
  /// Whether these are the bytes of a saved search, intact or not.
  [[nodiscard]] static bool is_saved(std::string_view bytes) noexcept;
  /// A new search that begins with the balls and meshes of a saved one, which may have been for
  /// other targets. Throws InvalidInput as above; the options of the balls must be the same.
  [[nodiscard]] static TableSearch started_from(std::string_view bytes,
                                                std::vector<canon::Code> targets,
                                                const SearchOptions& options,
                                                const std::string& name);
  using Origins = std::map<canon::Code, flips::FrontOrigin>;
  /// Takes over the meshes of a table, those for targets that have none or a larger one; `origins`:
  /// how they were found, as far as known. Throws InvalidInput, with `name` for the table, if one
  /// of them does not fill its boundary. Returns how many were taken. Cost: milliseconds for each.
  std::size_t take_over(const format::Table& table, const std::string& name,
                        const Origins& origins = {});

 private:
  static constexpr int kNone = 1 << 14;  ///< hexahedra: more than any mesh has

  /// A mesh beside the beam: one that has no shelling with boundaries as short as the beam's.
  struct Loose {
    int hexahedra = 0;
    flips::FrontOrigin origin = flips::FrontOrigin::joined;
    std::string record;  ///< tables/format/record.hpp
  };
  struct Found {
    complex::HexComplex mesh;
    flips::FrontOrigin origin = flips::FrontOrigin::exchanged;
    bool is_shelled = false;  ///< its hexahedra can be taken off as add_ball() requires
  };

  using Finder = std::function<std::optional<Found>(const canon::Code&, int threads)>;

  void sweep_step();
  void exchange_step();
  void cut_step();
  const flips::SymmetricBalls* symmetric_balls();
  void symmetric_step();
  void collar_step();
  void anneal_step();
  [[nodiscard]] flips::MeetingOptions collars_for(int below, int threads) const;
  [[nodiscard]] flips::MeetingOptions symmetric_collars_for(const canon::Code& code, int below,
                                                            int threads) const;
  [[nodiscard]] std::vector<complex::HexComplex> beginnings(const canon::Code& code,
                                                            int threads) const;
  [[nodiscard]] std::vector<flips::FaultyMesh> faulty_beginnings(
      const canon::Code& code, int size, int threads, const flips::SymmetricBalls* symmetric) const;
  [[nodiscard]] std::vector<flips::FaultyMesh> transplants(const canon::Code& code, int below,
                                                           int threads) const;
  [[nodiscard]] std::vector<const canon::Code*> next_largest(std::size_t count);
  void begin(Phase phase, std::size_t largest);
  void next_round();
  [[nodiscard]] Found smaller(const canon::Code& code, const complex::HexComplex& mesh,
                              flips::FrontOrigin origin, int growths) const;
  [[nodiscard]] std::optional<Found> cut(const canon::Code& code) const;
  [[nodiscard]] Found in_order(const canon::Code& code, Found found) const;
  [[nodiscard]] Found met(const canon::Code& code, complex::HexComplex mesh) const;
  void adopt(const canon::Code& code, const Found& found);
  void adopt_all(const std::vector<const canon::Code*>& batch, const Finder& find);
  [[nodiscard]] std::uint64_t seed_for(const canon::Code& code) const;
  [[nodiscard]] const Loose* loose(const canon::Code& code) const;
  [[nodiscard]] complex::HexComplex unchecked_mesh(const canon::Code& code) const;
  [[nodiscard]] int hexahedra(const canon::Code& code) const;  ///< kNone without a mesh
  [[nodiscard]] flips::FrontOrigin origin(const canon::Code& code) const;
  [[nodiscard]] std::string settings() const;
  void restore_found(std::string_view bytes, const std::string& name);

  std::vector<canon::Code> targets_;
  SearchOptions options_;
  flips::Beam balls_;
  Phase phase_ = Phase::sweep;
  int round_ = 0;
  std::size_t position_ = 0;  ///< next target of the phase
  int taken_from_ = 0;        ///< the phase is for targets with so many hexahedra, or more
  std::map<canon::Code, Loose> loose_;
  /// From the phase of symmetric collars to the end of a round; grown anew after a restart.
  std::optional<flips::SymmetricBalls> symmetric_balls_;
};

/// The rows of a table. Cost: each mesh is made and validated.
[[nodiscard]] std::vector<format::TableRow> table_rows(const TableSearch& search);

}  // namespace hexatlas::build
