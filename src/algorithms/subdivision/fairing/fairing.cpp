// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/fairing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>

#include "algorithms/subdivision/fairing/fair_system.h"
#include "croquis/base/error.h"
#include "croquis/subdivision/cage.h"
#include "croquis/subdivision/doo_sabin.h"

namespace croquis::subdivision {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Matrix>;

Eigen::MatrixX3d as_matrix(std::span<const Vec3> points) {
  Eigen::MatrixX3d matrix(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return matrix;
}

}  // namespace

struct Fairing::State {
  PolyMesh mesh;
  FairingOptions options;
  Findings warnings;
  double edge_length = 1;
  std::vector<EdgeChain> chains;  ///< by the mesh's vertices
  std::vector<ChainShape> shapes;
  Freedom freedom;        ///< #V of the mesh
  Freedom chain_freedom;  ///< the same, for the chains' own fairing
  WeightMatrix energy;    ///< the surface energy of one coordinate is |energy X|^2; rows by #V of the mesh
  Matrix moves;           ///< 3 #V by unknowns
  Matrix quadratic;       ///< unknowns by unknowns, without the weight
  Factor factor;
  std::optional<double> factored_weight;

  void move_chains(double weight, std::vector<Vec3>& points) const;
  void factorize(double weight);
  void move_surface(std::vector<Vec3>& points) const;
};

void Fairing::State::move_chains(double weight, std::vector<Vec3>& points) const {
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const std::vector<Index>& vertices = chains[i].vertices;
    std::vector<Vec3> curve;
    for (const Index vertex : vertices) curve.push_back(mesh.positions[vertex]);
    curve = fair_chain(chains[i], shapes[i], std::move(curve), edge_length, weight);
    for (std::size_t j = 0; j < curve.size(); ++j) {
      const Vec3& start = mesh.positions[vertices[j]];
      points[vertices[j]] = start + allowed(chain_freedom[vertices[j]], curve[j] - start);
    }
  }
}

void Fairing::State::factorize(double weight) {
  if (factored_weight == weight) return;
  Matrix shifted = quadratic;
  shifted.diagonal().array() += weight;
  factor.factorize(shifted);
  if (factor.info() != Eigen::Success) {
    throw Error(make_error(Category::Geometry, "E_FAIRING",
                           "The fairing equations can't be solved with this weight; take a greater one."));
  }
  factored_weight = weight;
}

void Fairing::State::move_surface(std::vector<Vec3>& points) const {
  const Eigen::MatrixX3d pull = energy.transpose() * (energy * as_matrix(points));
  const Eigen::VectorXd interleaved = pull.transpose().reshaped();
  const Eigen::VectorXd steps = moves * factor.solve(-(moves.transpose() * interleaved)).eval();
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!freedom[v].empty()) points[v] += steps.segment<3>(static_cast<Eigen::Index>(3 * v));
  }
}

namespace {

double median_edge_length(const PolyMesh& mesh, const MeshTopology& topology) {
  std::vector<double> lengths;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto [a, b] = topology.edge_vertices(edge);
    lengths.push_back((mesh.positions[a] - mesh.positions[b]).norm());
  }
  if (lengths.empty()) return 1;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle > 0 ? *middle : 1;
}

/// Points of the cage as weights of the mesh's: fans of one vertex move together.
WeightMatrix joined_fans(const Cage& cage, std::size_t mesh_vertices) {
  WeightRows rows;
  for (const Index vertex : cage.source_vertex) {
    rows.add(vertex, 1);
    rows.end_row();
  }
  return to_matrix(rows, mesh_vertices);
}

/// L S: the Laplacian of the last level, as weights of the mesh's points.
WeightMatrix energy_rows(const Cage& cage, const DooSabinPlan& plan, std::size_t mesh_vertices, Progress& progress) {
  PositionBuffers buffers;
  plan.positions(cage.positions, buffers);
  WeightMatrix rows = fair_laplacian(plan.level(plan.levels()), buffers.levels.back());
  for (int k = plan.levels(); k >= 1; --k) {
    rows = WeightMatrix(rows * plan.weights(k));
    progress.report(1 - k / (plan.levels() + 1.0));
  }
  rows = WeightMatrix(rows * joined_fans(cage, mesh_vertices));
  progress.report(1);
  return rows;
}

/// Each coordinate alike: the quadratic form over interleaved x, y, z.
Matrix for_three_axes(const Matrix& form) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * static_cast<std::size_t>(form.nonZeros()));
  for (Eigen::Index column = 0; column < form.outerSize(); ++column) {
    for (Matrix::InnerIterator entry(form, column); entry; ++entry) {
      for (int axis = 0; axis < 3; ++axis) {
        entries.emplace_back(3 * static_cast<int>(entry.row()) + axis, 3 * static_cast<int>(entry.col()) + axis,
                             entry.value());
      }
    }
  }
  Matrix result(3 * form.rows(), 3 * form.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

double energy_of(const WeightMatrix& energy, std::span<const Vec3> points) {
  const Eigen::MatrixX3d curvature = energy * as_matrix(points);
  return curvature.squaredNorm();
}

void find_chains(const Cage& cage, const Level& level, std::vector<EdgeChain>& chains,
                 std::vector<ChainShape>& shapes) {
  constexpr double any = 1e-300;
  chains = edge_chains(level, any);
  shapes = chain_shapes(level, chains, cage.positions);
  for (EdgeChain& chain : chains) {
    for (Index& vertex : chain.vertices) vertex = cage.source_vertex[vertex];
  }
}

void require_weight(double weight) {
  if (weight > 0 && std::isfinite(weight)) return;
  throw Error(make_error(Category::Usage, "E_PARAMETER", "The weight of fairing has to be a number above 0.",
                         {{SubjectKind::Parameter, "weight", {}, {}, {}}}));
}

FairCage measured(const PolyMesh& before, PolyMesh after, const WeightMatrix& energy, const Freedom& freedom) {
  FairCage result;
  result.energy_before = energy_of(energy, before.positions);
  result.energy = energy_of(energy, after.positions);
  std::size_t movable = 0;
  for (std::size_t v = 0; v < freedom.size(); ++v) {
    const double move = (after.positions[v] - before.positions[v]).norm();
    result.greatest_move = std::max(result.greatest_move, move);
    result.mean_move += move;
    if (!freedom[v].empty() || move > 0) ++movable;
  }
  if (movable > 0) result.mean_move /= static_cast<double>(movable);
  result.mesh = std::move(after);
  return result;
}

}  // namespace

Fairing::Fairing(const PolyMesh& mesh, const FairingOptions& options, Progress& progress)
    : state_(std::make_shared<State>()) {
  State& state = *state_;
  state.mesh = mesh;
  state.options = options;
  CageResult made = make_cage(mesh, options.rules);
  state.warnings = std::move(made.warnings);
  Progress planning = progress.step("refine", 0.2);
  const DooSabinPlan plan(made.cage, options.rules, options.levels, planning);
  const MeshTopology topology(mesh);
  state.edge_length = median_edge_length(mesh, topology);
  find_chains(made.cage, plan.level(0), state.chains, state.shapes);

  state.chain_freedom = full_freedom(mesh.vertex_count());
  if (options.keep_planes) keep_planes_beside_tags(mesh, topology, state.chain_freedom);
  state.freedom = state.chain_freedom;
  hold(mesh, topology, false, state.chain_freedom);
  hold(mesh, topology, true, state.freedom);

  Progress weighing = progress.step("curvature", 0.4);
  state.energy = energy_rows(made.cage, plan, mesh.vertex_count(), weighing);
  const Matrix columns = state.energy;
  state.moves = freedom_matrix(state.freedom);
  const Matrix form = for_three_axes(columns.transpose() * columns);
  progress.check();
  state.quadratic = state.moves.transpose() * Matrix(form * state.moves);
  state.quadratic.prune(0.0);
  progress.report(0.8);
  Matrix identity(state.quadratic.rows(), state.quadratic.cols());
  identity.setIdentity();
  state.quadratic += 0 * identity;  // the diagonal is there for every weight
  state.factor.analyzePattern(state.quadratic);
  progress.report(1);
}

double Fairing::default_weight() const {
  // On noisy tori ten takes out most noise before the shape as a whole starts to shrink.
  constexpr double per_squared_edge = 10;
  return per_squared_edge / (state_->edge_length * state_->edge_length);
}

const Findings& Fairing::warnings() const { return state_->warnings; }

std::size_t Fairing::free_point_count() const {
  return static_cast<std::size_t>(std::count_if(state_->freedom.begin(), state_->freedom.end(),
                                                [](const Directions& free) { return !free.empty(); }));
}

FairCage Fairing::solve(double weight, Progress& progress) {
  require_weight(weight);
  PolyMesh moved = state_->mesh;
  if (state_->options.fair_chains) state_->move_chains(weight, moved.positions);
  progress.report(0.1);
  if (state_->moves.cols() > 0) {
    state_->factorize(weight);
    progress.report(0.8);
    state_->move_surface(moved.positions);
  }
  progress.report(1);
  return measured(state_->mesh, std::move(moved), state_->energy, state_->freedom);
}

}  // namespace croquis::subdivision
