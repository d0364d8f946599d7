#pragma once
/// \file
/// Checks proofs by reverse unit propagation with hints, as in LRAT.
///
/// Source. L. Cruz-Filipe, M. Heule, W. Hunt, M. Kaufmann, P. Schneider-Kamp, "Efficient certified
/// RAT verification" (2017), without the resolution asymmetric tautologies: only consequences.
///
/// Cost. A premise or lemma is sorted once; a hint costs the length of its clause. Memory: two
/// bytes per variable and the literals of the clauses that are not removed.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hexatlas::check {

/// +-variable, variables from 1.
using Literals = std::vector<std::int32_t>;

/// Clauses are sets: a literal given twice counts once. They are numbered from 1 in the order in
/// which they are added.
class LratChecker {
 public:
  /// Requires fewer than 2^31 variables.
  explicit LratChecker(std::size_t variables);

  /// False, and nothing is added, if a literal is 0 or of no variable.
  [[nodiscard]] bool add_premise(const Literals& clause);
  /// Adds the lemma if it follows: with its literals assumed false, each hint in turn is a clause
  /// with all literals but one false, the one then being assumed, and the last hint has all
  /// literals false. Hints after a conflict, unknown or removed clauses, and hints that are not
  /// unit are refused: false, and nothing is added. A lemma with a literal and its negative follows
  /// from nothing, its assumption being a conflict; it must have no hints.
  [[nodiscard]] bool add_lemma(const Literals& clause, std::span<const std::uint32_t> hints);
  /// Frees a clause; later hints to it are refused. False if there is none of that number.
  bool remove(std::uint32_t number);

  [[nodiscard]] std::uint32_t size() const noexcept;     ///< clauses added so far
  [[nodiscard]] bool has_empty_clause() const noexcept;  ///< the premises are unsatisfiable

 private:
  enum class Step : std::uint8_t { unit, conflict, refused };

  [[nodiscard]] bool is_of_variables(const Literals& clause) const noexcept;
  [[nodiscard]] bool is_present(std::uint32_t number) const noexcept;
  [[nodiscard]] int value_of(std::int32_t literal) const noexcept;
  void assume(std::int32_t literal);
  [[nodiscard]] Step propagate(const Literals& clause);
  [[nodiscard]] bool follows(const Literals& clause, std::span<const std::uint32_t> hints);
  void add(const Literals& clause);

  std::vector<Literals> clauses_;  ///< each ascending without repetition
  std::vector<bool> removed_;
  std::vector<std::int16_t> value_;      ///< by variable, all 0 between calls
  std::vector<std::uint32_t> assigned_;  ///< variables whose value is not 0
  bool has_empty_clause_ = false;
};

/// Reads a text in the LRAT format and checks it line by line: `<number> <literals> 0 <hints> 0` is
/// a lemma, `<number> d <numbers> 0` removes clauses. A lemma's number must be the one after the
/// last clause's; the number before `d` says nothing. The last line must be the lemma without
/// literals, and no other line may be one; no line is needed if a premise has no literals.
/// Returns what is wrong, with the line, or the empty string: the premises are unsatisfiable.
/// Throws Malformed, with `file` and the line, if words are not separated by one space, lines do
/// not end in '\n', or a word is no number. The lines are numbered from `first_line`.
[[nodiscard]] std::string fault_of_lrat(LratChecker& checker, std::string_view text,
                                        const std::string& file, std::size_t first_line = 1);

}  // namespace hexatlas::check
