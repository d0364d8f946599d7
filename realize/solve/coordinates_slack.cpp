#include "realize/solve/coordinates_slack.hpp"

#include <cstdlib>
#include <map>

namespace hexatlas::solve {
namespace {

using Vector = std::array<double, 3>;

Vector difference(const double* to, const double* from) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

CoordinateSlacks::CoordinateSlacks(const SignConditions& conditions,
                                   certificate::Condition condition) {
  if (condition == certificate::Condition::jacobian) jacobian_.emplace();
  std::map<certificate::Literal, std::size_t> place;
  const auto renumbered = [&](certificate::Literal literal) -> Signed {
    const auto [entry, is_new] = place.try_emplace(std::abs(literal), brackets_.size());
    if (is_new) brackets_.push_back(chirotope::points_of(std::abs(literal)));
    return {entry->second, literal > 0 ? 1.0 : -1.0};
  };
  for (const certificate::Literal unit : conditions.units) units_.push_back(renumbered(unit));
  for (const certificate::Clause& clause : conditions.clauses) {
    for (const certificate::Literal literal : clause) literals_.push_back(renumbered(literal));
    clause_ends_.push_back(literals_.size());
  }
  values_.resize(brackets_.size());
  greatest_.resize(clause_ends_.size());
  slacks_.resize(units_.size() + clause_ends_.size());
}

std::span<const double> CoordinateSlacks::at(std::span<const double> points) {
  points_.assign(points.begin(), points.end());
  for (std::size_t i = 0; i < brackets_.size(); ++i) {
    const auto [a, b, c, d] = brackets_[i];
    const double* base = &points_[3U * a];
    values_[i] = dot(difference(&points_[3U * b], base),
                     cross(difference(&points_[3U * c], base), difference(&points_[3U * d], base)));
  }
  const auto value_of = [this](const Signed& l) { return l.sign * values_[l.bracket]; };
  std::size_t slack = 0;
  for (const Signed& unit : units_) slacks_[slack++] = value_of(unit);
  std::size_t literal = 0;
  for (std::size_t clause = 0; clause < clause_ends_.size(); ++clause) {
    Signed best = literals_[literal];
    for (++literal; literal < clause_ends_[clause]; ++literal)
      if (value_of(literals_[literal]) > value_of(best)) best = literals_[literal];
    greatest_[clause] = best;
    slacks_[slack++] = value_of(best);
  }
  slacks_.resize(slack);
  if (jacobian_) {
    const auto& coefficients = jacobian_->at(points);
    slacks_.insert(slacks_.end(), coefficients.begin(), coefficients.end());
  }
  return slacks_;
}

void CoordinateSlacks::add_derivative(std::span<const double> weights, std::span<double> gradient) {
  bracket_weights_.assign(brackets_.size(), 0);
  for (std::size_t i = 0; i < units_.size(); ++i)
    bracket_weights_[units_[i].bracket] += units_[i].sign * weights[i];
  for (std::size_t i = 0; i < greatest_.size(); ++i)
    bracket_weights_[greatest_[i].bracket] += greatest_[i].sign * weights[units_.size() + i];
  for (std::size_t i = 0; i < brackets_.size(); ++i) {
    if (bracket_weights_[i] == 0) continue;
    const auto [a, b, c, d] = brackets_[i];
    const double* base = &points_[3U * a];
    const Vector u = difference(&points_[3U * b], base);
    const Vector v = difference(&points_[3U * c], base);
    const Vector w = difference(&points_[3U * d], base);
    const Vector by_u = cross(v, w);
    const Vector by_v = cross(w, u);
    const Vector by_w = cross(u, v);
    for (std::size_t k = 0; k < 3; ++k) {
      gradient[3U * b + k] += bracket_weights_[i] * by_u[k];
      gradient[3U * c + k] += bracket_weights_[i] * by_v[k];
      gradient[3U * d + k] += bracket_weights_[i] * by_w[k];
      gradient[3U * a + k] -= bracket_weights_[i] * (by_u[k] + by_v[k] + by_w[k]);
    }
  }
  if (jacobian_)
    jacobian_->add_derivative(weights.subspan(units_.size() + greatest_.size()), gradient);
}

}  // namespace hexatlas::solve
