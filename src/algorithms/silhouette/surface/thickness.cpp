// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace croquis::silhouette {
namespace {

// Triangles flatter than that (height over length) count as that high: what has no area has no stiffness that could be
// worked out.
constexpr double least_height = 1e-3;

/// Twice the area of a triangle that is no flatter than that.
double area_with_height(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return std::max(cross(b - a, c - a), least_height * longest);
}

/// A symmetric matrix of the edges' weights, negative, with the diagonal that makes every row's sum 0.
Eigen::SparseMatrix<double> stiffness_of(const LiftedTriangulation& lifted,
                                         const std::vector<std::array<double, 3>>& weights) {
  const auto count = static_cast<Eigen::Index>(lifted.planar_vertex.size());
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * lifted.triangles.size() + 3 * lifted.planar_vertex.size());
  for (Index t = 0; t < lifted.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index other = lifted.neighbours[t][k];
      if (other < t) continue;  // each edge once; no_index is the largest number
      const Index a = lifted.triangles[t][(k + 1) % 3];
      const Index b = lifted.triangles[t][(k + 2) % 3];
      double weight = weights[t][k];
      if (other != no_index) {
        const std::array<Index, 3>& beyond = lifted.neighbours[other];
        weight += weights[other][beyond[0] == t ? 0 : beyond[1] == t ? 1 : 2];
      }
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
      diagonal[a] += weight;
      diagonal[b] += weight;
    }
  }
  for (Eigen::Index v = 0; v < count; ++v) entries.emplace_back(v, v, diagonal[v]);
  Eigen::SparseMatrix<double> stiffness(count, count);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

}  // namespace

SheetOperator make_sheet_operator(const SheetSampling& sheets, const Eigen::VectorXd& weight) {
  const LiftedTriangulation& lifted = sheets.lifted;
  SheetOperator op;
  op.on_boundary = lifted.on_boundary;
  op.position.reserve(lifted.planar_vertex.size());
  for (const Index point : lifted.planar_vertex) op.position.push_back(sheets.points[point]);
  op.area = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(lifted.planar_vertex.size()));
  std::vector<std::array<double, 3>> weights;
  weights.reserve(lifted.triangles.size());
  for (const auto& corners : lifted.triangles) {
    const auto& [a, b, c] = corners;
    const double mean = weight.size() > 0 ? (weight[a] + weight[b] + weight[c]) / 3 : 1;
    const double twice_area = area_with_height(op.position[a], op.position[b], op.position[c]);
    std::array<double, 3>& own = weights.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2& apex = op.position[corners[k]];
      const Vec2 first = op.position[corners[(k + 1) % 3]] - apex, second = op.position[corners[(k + 2) % 3]] - apex;
      own[k] = first.dot(second) / (2 * twice_area) * mean;  // half the cotangent of the angle
    }
    for (const Index v : corners) op.area[v] += mean * twice_area / 6;
  }
  op.stiffness = stiffness_of(lifted, weights);
  return op;
}

namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Against the stiffness matrix, which has no unit: on a tube values settle within a quarter of the radius.
constexpr double node_stiffness = 10;

constexpr int node_pulls = 2;

/// How far a node's pull is spread, in radii: a pull at a point of a wide body would be seen as a bump.
constexpr double node_reach = 0.6;

/// Keeps a part without any node regular; too weak to be noticed elsewhere.
constexpr double background_stiffness = 1e-6;

/// The least u inside, as a part of that of a disk inscribed at the vertex' own triangles. Only reached when a very
/// obtuse triangle breaks the maximum principle.
constexpr double least_load = 0.25;

/// Of a rim's curvature times radius. At 1, where a tube ends in a half disk, the weight would vanish.
constexpr double greatest_turn = 0.8;

/// A chord whose half and distance make no more than that of the square of a larger ball's radius is a section of that
/// ball. Drawn balls aren't exact.
constexpr double covered_chord = 1.1;
constexpr double smaller = 0.95;  // of the radius: along a tube each node speaks for itself

// Between these, beta is sqrt(1/2) on a tube, less where a limb flares, and 1 on a disk.
constexpr double least_beta = 0.6;
constexpr double greatest_beta = 1.2;

// Of the radius: how far a mean of the rim's turning reaches to either side; weights fall off linearly.
constexpr double turn_reach = 0.8;

/// A vertex in the loops of the boundary; those inside have no neighbours there.
struct RimVertex {
  Index next = no_index;
  Index previous = no_index;
  double radius = 0;
  double turn = 0;    ///< angle, positive to the left: around the surface
  double length = 0;  ///< half of the two edges there
};

/// @return per lifted vertex
std::vector<RimVertex> rim_loops(const SheetSampling& sheets) {
  const LiftedTriangulation& lifted = sheets.lifted;
  std::vector<RimVertex> loops(lifted.planar_vertex.size());
  for (Index t = 0; t < lifted.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (lifted.neighbours[t][corner] != no_index) continue;
      const Index begin = lifted.triangles[t][(corner + 1) % 3];
      const Index end = lifted.triangles[t][(corner + 2) % 3];
      loops[begin].next = end;
      loops[end].previous = begin;
      loops[begin].radius = sheets.pieces[sheets.planar.constraints[lifted.planar_triangle[t]][corner]].radius;
    }
  }
  const auto place = [&](Index v) { return sheets.points[lifted.planar_vertex[v]]; };
  for (Index v = 0; v < loops.size(); ++v) {
    if (loops[v].next == no_index) continue;
    const Vec2 before = place(v) - place(loops[v].previous);
    const Vec2 after = place(loops[v].next) - place(v);
    loops[v].turn = std::atan2(cross(before, after), before.dot(after));
    loops[v].length = (before.norm() + after.norm()) / 2;
  }
  return loops;
}

/// Turning per length around a vertex.
double mean_curvature(const SheetSampling& sheets, const std::vector<RimVertex>& loops, Index vertex) {
  const auto place = [&](Index v) { return sheets.points[sheets.lifted.planar_vertex[v]]; };
  const double far = turn_reach * loops[vertex].radius;
  double turn = loops[vertex].turn;
  double length = loops[vertex].length;
  for (const auto onward : {&RimVertex::next, &RimVertex::previous}) {
    double distance = 0;
    for (Index v = vertex;;) {
      const Index other = loops[v].*onward;
      distance += (place(other) - place(v)).norm();
      if (distance >= far || other == vertex) break;
      turn += (1 - distance / far) * loops[other].turn;
      length += (1 - distance / far) * loops[other].length;
      v = other;
    }
  }
  return turn / length;
}

/// The values of ln w on the rim: the length of the axis per length of the rim.
Eigen::VectorXd rim_log_weights(const SheetSampling& sheets) {
  return (1 - rim_turn(sheets).array().cwiseMax(-greatest_turn).cwiseMin(greatest_turn)).log();
}

/// One column for every vertex inside, ascending: systems of what vanishes on the boundary are solved for these alone.
Matrix inner_vertices(const SheetOperator& op) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index v = 0; v < op.on_boundary.size(); ++v) {
    if (!op.on_boundary[v]) entries.emplace_back(v, static_cast<Eigen::Index>(entries.size()), 1.0);
  }
  Matrix inner(op.stiffness.rows(), static_cast<Eigen::Index>(entries.size()));
  inner.setFromTriplets(entries.begin(), entries.end());
  return inner;
}

/// Per node of the skeleton whether it gives the thickness: not where its chord is one of a larger ball along the
/// skeleton.
std::vector<std::uint8_t> speaking_nodes(const Skeleton& skeleton) {
  const auto count = static_cast<Index>(skeleton.nodes.size());
  const std::vector<std::vector<Index>> around = skeleton.neighbours();
  std::vector<Index> by_radius(count);
  std::iota(by_radius.begin(), by_radius.end(), 0);
  const auto radius = [&](Index n) { return skeleton.nodes[n].radius; };
  std::stable_sort(by_radius.begin(), by_radius.end(), [&](Index a, Index b) { return radius(a) > radius(b); });
  const auto covers = [&](Index outer, Index inner) {
    const double across = (skeleton.nodes[inner].position - skeleton.nodes[outer].position).squaredNorm();
    const double reach = radius(outer) * radius(outer);
    return across < reach && across + radius(inner) * radius(inner) < covered_chord * reach &&
           radius(inner) < smaller * radius(outer);
  };
  std::vector<std::uint8_t> met(count, 0);
  std::vector<std::uint8_t> speaks(count, 0);
  std::vector<Index> queue;
  for (const Index outer : by_radius) {
    if (met[outer] != 0) continue;
    met[outer] = speaks[outer] = 1;
    queue.assign(1, outer);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      for (const Index inner : around[queue[head]]) {
        if (met[inner] != 0 || !covers(outer, inner)) continue;
        met[inner] = 1;
        queue.push_back(inner);
      }
    }
  }
  return speaks;
}

/// Spreads the nodes that give the thickness over the vertices around them, in their own sheet. The weights of a node
/// sum to 1; they fall off smoothly towards its reach.
std::vector<NodeShare> node_shares(const SheetOperator& op, const std::vector<LiftedPlace>& nodes,
                                   const Skeleton& skeleton) {
  const std::vector<std::uint8_t> speaks = speaking_nodes(skeleton);
  std::vector<NodeShare> shares;
  std::vector<Index> queue;
  std::vector<Index> last_seen(op.position.size(), no_index);  // per vertex, the node that met it last
  for (Index n = 0; n < nodes.size(); ++n) {
    if (speaks[n] == 0) continue;
    const double distance = node_reach * skeleton.nodes[n].radius;
    const LiftedPlace& place = nodes[n];
    Vec2 centre = Vec2::Zero();
    for (std::size_t i = 0; i < 3; ++i) centre += place.weights[i] * op.position[place.vertices[i]];
    const std::size_t first = shares.size();
    queue.assign(place.vertices.begin(), place.vertices.end());
    for (const Index v : queue) last_seen[v] = n;
    double sum = 0;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const Index v = queue[head];
      const double nearness = 1 - (op.position[v] - centre).squaredNorm() / (distance * distance);
      if (nearness <= 0) continue;
      shares.push_back({v, n, op.area[v] * nearness * nearness});
      sum += shares.back().weight;
      for (Matrix::InnerIterator near(op.stiffness, v); near; ++near) {
        const auto other = static_cast<Index>(near.row());
        if (std::exchange(last_seen[other], n) != n) queue.push_back(other);
      }
    }
    for (std::size_t s = first; s < shares.size(); ++s) shares[s].weight /= sum;
    if (sum > 0) continue;
    for (std::size_t i = 0; i < 3; ++i) shares.push_back({place.vertices[i], n, place.weights[i]});
  }
  return shares;
}

}  // namespace

NodeExtension::NodeExtension(const SheetOperator& op, const std::vector<LiftedPlace>& nodes, const Skeleton& skeleton)
    : factors_(std::make_unique<SymmetricFactors>()),
      shares_(node_shares(op, nodes, skeleton)),
      background_(background_stiffness / op.area.sum() * op.area) {
  Matrix matrix = op.stiffness;
  for (Eigen::Index v = 0; v < matrix.cols(); ++v) matrix.coeffRef(v, v) += background_[v];
  for (const NodeShare& share : shares_) matrix.coeffRef(share.vertex, share.vertex) += node_stiffness * share.weight;
  factors_->compute(matrix);
}

Eigen::VectorXd NodeExtension::extend(const Eigen::VectorXd& node_values) const {
  const double middle = node_values.size() > 0 ? node_values.mean() : 1;
  Eigen::VectorXd values = Eigen::VectorXd::Constant(background_.size(), middle);
  for (int pull = 0; pull < node_pulls; ++pull) {
    // What the springs leave of each node's value is pulled once more: they flatten peaks.
    Eigen::VectorXd missing = node_values;
    for (const NodeShare& share : shares_) missing[share.node] -= share.weight * values[share.vertex];
    Eigen::VectorXd right = Eigen::VectorXd::Zero(values.size());
    for (const NodeShare& share : shares_) {
      right[share.vertex] += node_stiffness * share.weight * missing[share.node];
    }
    values += factors_->solve(right);
  }
  return values;
}

Eigen::VectorXd rim_turn(const SheetSampling& sheets) {
  const std::vector<RimVertex> loops = rim_loops(sheets);
  Eigen::VectorXd turns = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(loops.size()));
  for (Index v = 0; v < loops.size(); ++v) {
    if (loops[v].next != no_index) turns[v] = mean_curvature(sheets, loops, v) * loops[v].radius;
  }
  return turns;
}

double value_at(const LiftedPlace& place, const Eigen::VectorXd& values) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += place.weights[i] * values[place.vertices[i]];
  return sum;
}

Eigen::VectorXd sheet_thickness(const SheetSampling& sheets, const SheetOperator& op, const Skeleton& skeleton,
                                const std::vector<LiftedPlace>& nodes, const NodeExtension& extension,
                                Progress& progress) {
  const Matrix inner = inner_vertices(op);
  SymmetricFactors factors(inner.transpose() * Matrix(op.stiffness * inner));
  const auto solve = [&](const Eigen::VectorXd& load) -> Eigen::VectorXd {
    return inner * factors.solve(inner.transpose() * load).eval();
  };
  const Eigen::VectorXd rim = rim_log_weights(sheets);
  const Eigen::VectorXd log_weight = rim + solve(-(op.stiffness * rim));  // harmonic
  progress.check();
  const SheetOperator unbent = make_sheet_operator(sheets, log_weight.array().exp());
  factors.factorize(inner.transpose() * Matrix(unbent.stiffness * inner));  // of the same pattern
  Eigen::VectorXd u = solve(4 * unbent.area);
  for (Eigen::Index v = 0; v < u.size(); ++v) {
    if (!op.on_boundary[static_cast<std::size_t>(v)]) u[v] = std::max(u[v], least_load * op.area[v]);
  }
  progress.check();

  Eigen::VectorXd beta(static_cast<Eigen::Index>(nodes.size()));
  for (Index n = 0; n < nodes.size(); ++n) {
    // Interpolated u rather than its root: the root of the mean has the smaller error.
    beta[n] = std::clamp(skeleton.nodes[n].radius / std::sqrt(std::max(value_at(nodes[n], u), 1e-300)), least_beta,
                         greatest_beta);
  }
  return extension.extend(beta).cwiseProduct(u.cwiseSqrt());
}

}  // namespace croquis::silhouette
