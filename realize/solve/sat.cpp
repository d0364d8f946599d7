#include "realize/solve/sat.hpp"

#include <cadical.hpp>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::solve {
namespace {

constexpr int kSatisfiable = 10;
constexpr int kUnsatisfiable = 20;

void configure(CaDiCaL::Solver& solver) {
  core::ensures(solver.set("quiet", 1), "sat: unknown option");
  // The simplifications whose lemmas need more than unit propagation.
  for (const char* option : {"block", "cover", "condition"})
    core::ensures(solver.set(option, 0), "sat: unknown option");
}

void add_clause(CaDiCaL::Solver& solver, const Clause& clause, std::size_t variables) {
  for (const Literal literal : clause) {
    core::expects(literal != 0 && literal != std::numeric_limits<Literal>::min() &&
                      static_cast<std::size_t>(std::abs(literal)) <= variables,
                  "sat: literals of the stated variables");
    solver.add(literal);
  }
  solver.add(0);
}

void prefer_random_values(CaDiCaL::Solver& solver, std::size_t variables, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (std::size_t i = 1; i <= variables; ++i) {
    const auto variable = static_cast<int>(i);
    solver.phase((random() >> 63U) != 0 ? variable : -variable);
  }
}

Assignment assignment_of(CaDiCaL::Solver& solver, std::size_t variables) {
  Assignment assignment(variables);
  for (std::size_t i = 0; i < variables; ++i)
    assignment[i] = solver.val(static_cast<int>(i) + 1) > 0;
  return assignment;
}

/// A stream into memory: a proof is lost for no lack of disk.
class MemoryStream {
 public:
  MemoryStream() : stream_(open_memstream(&bytes_, &size_)) {
    if (stream_ == nullptr) throw core::ResourceFailure("no memory for a proof");
  }
  ~MemoryStream() {
    if (stream_ != nullptr) std::fclose(stream_);
    std::free(bytes_);  // NOLINT(cppcoreguidelines-no-malloc): allocated by open_memstream
  }
  MemoryStream(const MemoryStream&) = delete;
  MemoryStream& operator=(const MemoryStream&) = delete;

  [[nodiscard]] std::FILE* stream() const noexcept { return stream_; }
  /// All that was written; the stream is closed. Throws ResourceFailure if something was not.
  [[nodiscard]] std::string_view close() {
    const bool failed = std::ferror(stream_) != 0;
    if (std::fclose(std::exchange(stream_, nullptr)) != 0 || failed)
      throw core::ResourceFailure("no memory for a proof");
    return {bytes_, size_};
  }

 private:
  char* bytes_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* stream_;
};

std::vector<std::size_t> order_of_clauses(std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (seed == 0) return order;
  std::mt19937_64 random(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

class DratReader {
 public:
  explicit DratReader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] bool at_end() const noexcept { return at_ == bytes_.size(); }
  [[nodiscard]] ProofStep step() {
    const unsigned kind = byte();
    if (kind != 'a' && kind != 'd') fail();
    ProofStep step{.is_deletion = kind == 'd', .clause = {}};
    while (const Literal literal = this->literal()) step.clause.push_back(literal);
    return step;
  }

 private:
  [[noreturn]] static void fail() { throw core::ResourceFailure("a proof is incomplete"); }
  [[nodiscard]] unsigned byte() {
    if (at_end()) fail();
    return static_cast<unsigned char>(bytes_[at_++]);
  }
  /// Seven bits per byte, least first; 2 variable + (1 if negative), 0 ends a clause.
  [[nodiscard]] Literal literal() {
    std::uint64_t code = 0;
    for (unsigned shift = 0;; shift += 7) {
      const unsigned next = byte();
      code |= std::uint64_t{next & 127U} << shift;
      if (next < 128) break;
      if (shift >= 28) fail();
    }
    const std::uint64_t variable = code / 2;
    if (code == 1 || variable > std::numeric_limits<Literal>::max()) fail();
    const auto literal = static_cast<Literal>(variable);
    return code % 2 == 0 ? literal : -literal;
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace

struct SatSolver::Engine {
  CaDiCaL::Solver solver;
};

SatSolver::SatSolver(std::size_t variables)
    : engine_(std::make_unique<Engine>()), variables_(variables) {
  configure(engine_->solver);
  // Local search and trivial assignments would replace the preferred values by their own.
  for (const char* option : {"walk", "lucky"})
    core::ensures(engine_->solver.set(option, 0), "sat: unknown option");
}
SatSolver::~SatSolver() = default;
SatSolver::SatSolver(SatSolver&&) noexcept = default;
SatSolver& SatSolver::operator=(SatSolver&&) noexcept = default;

void SatSolver::add(const Clause& clause) { add_clause(engine_->solver, clause, variables_); }

std::optional<Assignment> SatSolver::solve(std::uint64_t seed) {
  CaDiCaL::Solver& solver = engine_->solver;
  prefer_random_values(solver, variables_, seed);
  const int status = solver.solve();
  core::ensures(status == kSatisfiable || status == kUnsatisfiable, "sat: no answer");
  if (status == kUnsatisfiable) return std::nullopt;
  return assignment_of(solver, variables_);
}

std::variant<Assignment, RupProof> solve_or_prove(std::span<const Clause> clauses,
                                                  std::size_t variables,
                                                  const ProofSearch& search) {
  MemoryStream proof;
  CaDiCaL::Solver solver;
  if (!search.inprocessing) core::ensures(solver.configure("plain"), "sat: unknown configuration");
  configure(solver);
  solver.trace_proof(proof.stream(), "proof");
  for (const std::size_t i : order_of_clauses(clauses.size(), search.seed))
    add_clause(solver, clauses[i], variables);
  if (search.seed != 0) prefer_random_values(solver, variables, search.seed);
  const int status = solver.solve();
  core::ensures(status == kSatisfiable || status == kUnsatisfiable, "sat: no answer");
  if (status == kSatisfiable) return assignment_of(solver, variables);
  solver.close_proof_trace();
  return read_binary_drat(proof.close());
}

RupProof read_binary_drat(std::string_view bytes) {
  RupProof proof;
  DratReader reader(bytes);
  while (!reader.at_end()) proof.push_back(reader.step());
  return proof;
}

}  // namespace hexatlas::solve
