#include "tables/check/lrat.hpp"

#include <algorithm>
#include <limits>

#include "tables/check/text_lines.hpp"

namespace hexatlas::check {

namespace {

/// Absolute value, also of the least number.
std::uint32_t variable_of(std::int32_t literal) noexcept {
  const auto bits = static_cast<std::uint32_t>(literal);
  return literal < 0 ? 0U - bits : bits;
}

constexpr std::int64_t kMostVariable = std::numeric_limits<std::int32_t>::max();

/// The numbers up to a 0.
void read_literals(LineWords& line, Literals& literals) {
  literals.clear();
  while (const std::int64_t literal = line.integer()) {
    if (literal > kMostVariable || literal < -kMostVariable) line.fail("no such variable");
    literals.push_back(static_cast<std::int32_t>(literal));
  }
}

void read_numbers(LineWords& line, std::vector<std::uint32_t>& numbers) {
  numbers.clear();
  while (const std::uint64_t number = line.natural()) {
    if (number > std::numeric_limits<std::uint32_t>::max()) line.fail("no such clause");
    numbers.push_back(static_cast<std::uint32_t>(number));
  }
}

}  // namespace

LratChecker::LratChecker(std::size_t variables) : value_(variables + 1, 0) {}

bool LratChecker::add_premise(const Literals& clause) {
  if (!is_of_variables(clause)) return false;
  add(clause);
  return true;
}

bool LratChecker::add_lemma(const Literals& clause, std::span<const std::uint32_t> hints) {
  if (!is_of_variables(clause)) return false;
  const bool accepted = follows(clause, hints);
  for (const std::uint32_t variable : assigned_) value_[variable] = 0;
  assigned_.clear();
  if (accepted) add(clause);
  return accepted;
}

bool LratChecker::remove(std::uint32_t number) {
  if (!is_present(number)) return false;
  removed_[number - 1] = true;
  clauses_[number - 1] = Literals();
  return true;
}

std::uint32_t LratChecker::size() const noexcept {
  return static_cast<std::uint32_t>(clauses_.size());
}

bool LratChecker::has_empty_clause() const noexcept { return has_empty_clause_; }

bool LratChecker::is_of_variables(const Literals& clause) const noexcept {
  return std::all_of(clause.begin(), clause.end(), [this](std::int32_t literal) {
    return literal != 0 && variable_of(literal) < value_.size();
  });
}

bool LratChecker::is_present(std::uint32_t number) const noexcept {
  return number != 0 && number <= clauses_.size() && !removed_[number - 1];
}

int LratChecker::value_of(std::int32_t literal) const noexcept {
  const int value = value_[variable_of(literal)];
  return literal < 0 ? -value : value;
}

void LratChecker::assume(std::int32_t literal) {
  const std::uint32_t variable = variable_of(literal);
  value_[variable] = literal < 0 ? -1 : 1;
  assigned_.push_back(variable);
}

LratChecker::Step LratChecker::propagate(const Literals& clause) {
  std::int32_t unit = 0;
  for (const std::int32_t literal : clause) {
    const int value = value_of(literal);
    if (value < 0) continue;
    if (value > 0 || unit != 0) return Step::refused;
    unit = literal;
  }
  if (unit == 0) return Step::conflict;
  assume(unit);
  return Step::unit;
}

bool LratChecker::follows(const Literals& clause, std::span<const std::uint32_t> hints) {
  for (const std::int32_t literal : clause) {
    const int value = value_of(literal);
    if (value > 0) return hints.empty();
    if (value == 0) assume(-literal);
  }
  for (std::size_t i = 0; i < hints.size(); ++i) {
    if (!is_present(hints[i])) return false;
    const Step step = propagate(clauses_[hints[i] - 1]);
    if (step != Step::unit) return step == Step::conflict && i + 1 == hints.size();
  }
  return false;
}

void LratChecker::add(const Literals& clause) {
  // As a set, so that a clause with a literal twice is unit when that literal is left.
  Literals& literals = clauses_.emplace_back(clause);
  std::sort(literals.begin(), literals.end());
  literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
  removed_.push_back(false);
  has_empty_clause_ = has_empty_clause_ || literals.empty();
}

std::string fault_of_lrat(LratChecker& checker, std::string_view text, const std::string& file,
                          std::size_t first_line) {
  TextLines lines(file, text, first_line);
  Literals literals;
  std::vector<std::uint32_t> numbers;
  while (!lines.at_end()) {
    LineWords line = lines.next();
    const auto fault = [&line](const std::string& reason) {
      return "line " + std::to_string(line.number()) + ": " + reason;
    };
    if (checker.has_empty_clause()) return fault("a line after the empty clause");
    const std::uint64_t number = line.natural();
    LineWords after = line;
    if (after.word() == "d") {
      line = after;
      read_numbers(line, numbers);
      line.expect_end();
      for (const std::uint32_t clause : numbers) {
        if (!checker.remove(clause)) return fault("there is no clause " + std::to_string(clause));
      }
      continue;
    }
    read_literals(line, literals);
    read_numbers(line, numbers);
    line.expect_end();
    if (number != std::uint64_t{checker.size()} + 1) return fault("the number is not the next one");
    if (!checker.add_lemma(literals, numbers)) return fault("the lemma does not follow");
  }
  return checker.has_empty_clause() ? std::string() : "there is no empty clause";
}

}  // namespace hexatlas::check
