#include "realize/solve/coordinates_jacobian.hpp"

namespace hexatlas::solve {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
void add(Vector& to, double factor, const Vector& v) {
  for (std::size_t c = 0; c < 3; ++c) to[c] += factor * v[c];
}

/// Start of the edge in direction k with offset o: the two other coordinates, low bit first.
std::size_t edge_start(std::size_t k, std::size_t o) {
  constexpr std::array<std::array<std::size_t, 2>, 3> kOthers{{{2, 4}, {1, 4}, {1, 2}}};
  return (o & 1U) * kOthers[k][0] + (o >> 1U) * kOthers[k][1];
}

/// The bits of `choice` are j, k, i, k', i', j' of realize/exact/jacobian.hpp.
struct Term {
  std::array<std::size_t, 3> edge;  // offset in each direction
  std::size_t coefficient;
  double share;  // 1 / number of determinants of the coefficient
};

constexpr std::array<Term, 64> kTerms = [] {
  std::array<Term, 64> terms{};
  for (std::size_t choice = 0; choice < 64; ++choice) {
    const auto bit = [choice](unsigned place) { return choice >> place & 1U; };
    const std::array<std::size_t, 3> index{bit(2) + bit(4), bit(0) + bit(5), bit(1) + bit(3)};
    double share = 1;
    for (const std::size_t i : index)
      if (i == 1) share /= 2;
    terms[choice] = {{choice & 3U, choice >> 2U & 3U, choice >> 4U},
                     index[0] + 3 * index[1] + 9 * index[2],
                     share};
  }
  return terms;
}();

using Products = std::array<std::array<Vector, 4>, 4>;

Products cross_products(const std::array<Vector, 4>& a, const std::array<Vector, 4>& b) {
  Products result{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) result[i][j] = cross(a[i], b[j]);
  return result;
}

}  // namespace

const std::array<double, exact::kJacobianCoefficients>& JacobianCoefficients::at(
    std::span<const double> points) {
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t o = 0; o < 4; ++o) {
      const std::size_t start = edge_start(k, o);
      const std::size_t end = start + (std::size_t{1} << k);
      for (std::size_t c = 0; c < 3; ++c)
        edges_[k][o][c] = points[3 * end + c] - points[3 * start + c];
    }
  const Products products = cross_products(edges_[1], edges_[2]);
  values_.fill(0);
  for (const Term& term : kTerms)
    values_[term.coefficient] +=
        term.share * dot(edges_[0][term.edge[0]], products[term.edge[1]][term.edge[2]]);
  return values_;
}

void JacobianCoefficients::add_derivative(std::span<const double> weights,
                                          std::span<double> gradient) const {
  const std::array<Products, 3> products{cross_products(edges_[1], edges_[2]),
                                         cross_products(edges_[2], edges_[0]),
                                         cross_products(edges_[0], edges_[1])};
  std::array<std::array<Vector, 4>, 3> by_edge{};
  for (const Term& term : kTerms) {
    const double factor = term.share * weights[term.coefficient];
    const auto [a, b, c] = term.edge;
    add(by_edge[0][a], factor, products[0][b][c]);
    add(by_edge[1][b], factor, products[1][c][a]);
    add(by_edge[2][c], factor, products[2][a][b]);
  }
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t o = 0; o < 4; ++o) {
      const std::size_t start = edge_start(k, o);
      const std::size_t end = start + (std::size_t{1} << k);
      for (std::size_t c = 0; c < 3; ++c) {
        gradient[3 * end + c] += by_edge[k][o][c];
        gradient[3 * start + c] -= by_edge[k][o][c];
      }
    }
}

}  // namespace hexatlas::solve
