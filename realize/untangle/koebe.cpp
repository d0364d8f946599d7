#include "realize/untangle/koebe.hpp"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "enum/core/checks.hpp"

namespace hexatlas::untangle {
namespace {

using hexatlas::complex::Dart;
using hexatlas::complex::Quadrangulation;
using Plane = std::complex<double>;

constexpr int kMaxNewtonSteps = 200;
constexpr int kMaxHalvings = 20;
constexpr int kMaxBoosts = 1000;
constexpr double kTolerance = 1e-13;

/// The circles in the plane: those of the vertices, then those of the quads. Each has a ring of
/// darts: of vertex v those that begin there, of quad q its own, counter-clockwise; a dart stands
/// for the circles of its origin and of its quad, which cross. Dart 0 has its point of contact at
/// infinity.
class Pattern {
 public:
  explicit Pattern(const Quadrangulation& sphere)
      : sphere_(sphere),
        circles_(static_cast<std::size_t>(sphere.vertices() + sphere.quads())),
        is_line_(circles_),
        radius_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(circles_))) {
    for (const Dart d : {Dart{0}, sphere.twin(0)}) {
      is_line_[vertex_of(d)] = true;
      is_line_[quad_of(d)] = true;
    }
    find_radii();
    lay_out();
  }

  /// The point of contact of the edge of d. Requires that it is not at infinity.
  [[nodiscard]] Plane contact(Dart d) const {
    if (is_line_[vertex_of(d)]) d = sphere_.twin(d);
    // The quad of d is on its left: d has half the quad's angle less than the quad's centre.
    const double angle = direction_[d] - 0.5 * angle_at(vertex_of(d), quad_of(d));
    return centre_[vertex_of(d)] + std::polar(radius_of(vertex_of(d)), angle);
  }

 private:
  [[nodiscard]] std::size_t vertex_of(Dart d) const { return sphere_.origin(d); }
  [[nodiscard]] std::size_t quad_of(Dart d) const {
    return static_cast<std::size_t>(sphere_.vertices()) + Quadrangulation::quad_of(d);
  }
  [[nodiscard]] double radius_of(std::size_t circle) const {
    return std::exp(radius_(static_cast<Eigen::Index>(circle)));
  }
  /// In which circle `at` sees the points it has in common with the circle `other`.
  [[nodiscard]] double angle_at(std::size_t at, std::size_t other) const {
    if (is_line_[other]) return std::numbers::pi;
    return 2 * std::atan(std::exp(radius_(static_cast<Eigen::Index>(other)) -
                                  radius_(static_cast<Eigen::Index>(at))));
  }

  /// 2 pi minus the sum of the angles, at each circle; 0 for lines.
  [[nodiscard]] Eigen::VectorXd defects() const {
    Eigen::VectorXd result(radius_.size());
    for (std::size_t i = 0; i < circles_; ++i)
      result(static_cast<Eigen::Index>(i)) = is_line_[i] ? 0 : 2 * std::numbers::pi;
    for (int d = 0; d < sphere_.darts(); ++d) {
      const std::size_t v = vertex_of(static_cast<Dart>(d));
      const std::size_t q = quad_of(static_cast<Dart>(d));
      if (!is_line_[v]) result(static_cast<Eigen::Index>(v)) -= angle_at(v, q);
      if (!is_line_[q]) result(static_cast<Eigen::Index>(q)) -= angle_at(q, v);
    }
    return result;
  }

  [[nodiscard]] Eigen::VectorXd newton_step(const Eigen::VectorXd& defect) const {
    std::vector<Eigen::Triplet<double>> entries;
    bool is_scale_fixed = false;
    for (std::size_t i = 0; i < circles_; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (is_line_[i] || !is_scale_fixed) entries.emplace_back(row, row, 1);
      is_scale_fixed = is_scale_fixed || !is_line_[i];
    }
    for (int d = 0; d < sphere_.darts(); ++d) {
      const std::size_t v = vertex_of(static_cast<Dart>(d));
      const std::size_t q = quad_of(static_cast<Dart>(d));
      if (is_line_[v] || is_line_[q]) continue;
      const auto i = static_cast<Eigen::Index>(v);
      const auto j = static_cast<Eigen::Index>(q);
      const double weight = 1 / std::cosh(radius_(i) - radius_(j));
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
      entries.emplace_back(i, j, -weight);
      entries.emplace_back(j, i, -weight);
    }
    Eigen::SparseMatrix<double> matrix(radius_.size(), radius_.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    return factors.solve(-defect);
  }

  void find_radii() {
    Eigen::VectorXd defect = defects();
    for (int i = 0; i < kMaxNewtonSteps && defect.lpNorm<Eigen::Infinity>() > kTolerance; ++i) {
      const Eigen::VectorXd before = radius_;
      const Eigen::VectorXd step = newton_step(defect);
      const double norm = defect.norm();
      for (int halvings = 0; halvings < kMaxHalvings; ++halvings) {
        radius_ = before + std::ldexp(1.0, -halvings) * step;
        defect = defects();
        if (defect.norm() < norm) break;
      }
      if (!(defect.norm() < norm)) break;
    }
  }

  /// The darts of a circle, counter-clockwise from d on.
  [[nodiscard]] Dart next_around(std::size_t circle, Dart d) const {
    return circle < static_cast<std::size_t>(sphere_.vertices()) ? sphere_.turn_left(d)
                                                                 : Quadrangulation::next(d);
  }

  /// The directions from the centre of a circle to those it crosses, one of them known; and the
  /// centres there.
  void turn_around(std::size_t circle, Dart first, double direction,
                   std::vector<std::size_t>& waiting) {
    const bool is_vertex = circle < static_cast<std::size_t>(sphere_.vertices());
    Dart d = first;
    do {
      const std::size_t other = is_vertex ? quad_of(d) : vertex_of(d);
      if (is_vertex) direction_[d] = direction;
      if (!is_line_[other] && !is_placed_[other]) {
        is_placed_[other] = true;
        centre_[other] = centre_[circle] +
                         std::polar(std::hypot(radius_of(circle), radius_of(other)), direction);
        reached_by_[other] = d;
        back_[other] = direction + std::numbers::pi;
        waiting.push_back(other);
      }
      const Dart next = next_around(circle, d);
      direction += 0.5 * (angle_at(circle, other) +
                          angle_at(circle, is_vertex ? quad_of(next) : vertex_of(next)));
      d = next;
    } while (d != first);
  }

  void lay_out() {
    centre_.resize(circles_);
    reached_by_.resize(circles_);
    back_.resize(circles_);
    is_placed_.resize(circles_);
    direction_.resize(static_cast<std::size_t>(sphere_.darts()));
    Dart d = 0;
    while (is_line_[vertex_of(d)]) ++d;
    std::vector<std::size_t> waiting{vertex_of(d)};
    is_placed_[vertex_of(d)] = true;
    reached_by_[vertex_of(d)] = d;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      const std::size_t circle = waiting[i];
      turn_around(circle, reached_by_[circle], back_[circle], waiting);
    }
  }

  const Quadrangulation& sphere_;
  std::size_t circles_;
  std::vector<bool> is_line_;
  Eigen::VectorXd radius_;  ///< its logarithm; of lines without meaning
  std::vector<Plane> centre_;
  std::vector<Dart> reached_by_;  ///< of a circle: a dart whose direction from its centre is known
  std::vector<double> back_;      ///< that direction
  std::vector<bool> is_placed_;
  std::vector<double> direction_;  ///< of a dart: from the centre of its origin to that of its quad
};

/// From the south pole's side, so that what is counter-clockwise in the plane is so from outside.
Eigen::Vector3d on_sphere(Plane p) {
  const double square = std::norm(p);
  return Eigen::Vector3d{-2 * p.real(), 2 * p.imag(), square - 1} / (square + 1);
}

/// Moves the points on the sphere by Lorentz boosts until their centre is the origin.
void centre(std::vector<Eigen::Vector3d>& points) {
  for (int i = 0; i < kMaxBoosts; ++i) {
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points) b += p / static_cast<double>(points.size());
    const double square = b.squaredNorm();
    if (square < kTolerance * kTolerance) return;
    const double gamma = 1 / std::sqrt(1 - square);
    for (Eigen::Vector3d& p : points) {
      const double along = b.dot(p);
      p = (p + ((gamma - 1) * along / square - gamma) * b) / (gamma * (1 - along));
      p.normalize();
    }
  }
}

/// The apex of the cone that touches the unit sphere in the circle through three points.
Eigen::Vector3d apex(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  return normal / normal.dot(a);
}

}  // namespace

std::vector<exact::Point3> koebe_polyhedron(const Quadrangulation& sphere) {
  core::expects(sphere.is_three_connected(), "koebe_polyhedron: a 3-connected quadrangulation");
  const Pattern pattern(sphere);
  std::vector<Plane> flat;
  std::vector<std::size_t> edge_of(static_cast<std::size_t>(sphere.darts()));
  std::vector<Eigen::Vector3d> contacts{{0, 0, 1}};
  for (int i = 1; i < sphere.darts(); ++i) {
    const auto d = static_cast<Dart>(i);
    if (sphere.twin(d) == 0) continue;  // the contact at infinity
    if (sphere.twin(d) < d) {
      edge_of[d] = edge_of[sphere.twin(d)];
      continue;
    }
    edge_of[d] = contacts.size();
    contacts.emplace_back(0, 0, 0);
    flat.push_back(pattern.contact(d));
  }
  Plane middle = 0;
  for (const Plane p : flat) middle += p / static_cast<double>(flat.size());
  double size = 0;
  for (const Plane p : flat) size = std::max(size, std::abs(p - middle));
  for (std::size_t i = 0; i < flat.size(); ++i)
    contacts[i + 1] = on_sphere(2.0 * (flat[i] - middle) / size);
  centre(contacts);
  std::vector<exact::Point3> result(static_cast<std::size_t>(sphere.vertices()));
  for (int i = 0; i < sphere.darts(); ++i) {
    const auto a = static_cast<Dart>(i);
    const Dart b = sphere.turn_left(a);
    const Eigen::Vector3d p =
        apex(contacts[edge_of[a]], contacts[edge_of[b]], contacts[edge_of[sphere.turn_left(b)]]);
    result[sphere.origin(a)] = {p(0), p(1), p(2)};
  }
  return result;
}

}  // namespace hexatlas::untangle
