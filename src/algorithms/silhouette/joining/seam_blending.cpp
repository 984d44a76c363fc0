// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include "algorithms/silhouette/joining/joining.h"
#include "algorithms/silhouette/joining/union_surface.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::silhouette {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

using Band = UnionSurface;
using BandFace = Band::Face_index;
using BandVertex = Band::Vertex_index;
using Radii = std::map<ObjectPair, double>;

// Of a band's half width.
constexpr double edge_share = 0.2;        // length of its edges
constexpr double remeshed_share = 1.3;    // how far it is triangulated anew: what moves has even triangles around it
constexpr double transition_share = 2.2;  // how far with longer edges first, so that their lengths grow evenly
constexpr double transition_factor = 2.2;
constexpr int transition_rounds = 1;
constexpr int remeshing_rounds = 2;
constexpr int fairing_rounds = 3;  // weights follow the shape; later rounds change little
constexpr double least_weight = 0.02;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Seams, outlines and distances of one surface.
struct SeamBand {
  double least_radius = infinity;                 ///< infinity: there is nothing to round
  std::vector<std::array<Index, 2>> rim_edges{};  ///< where a part turns from front to back
  /// Per vertex the distance from the nearest seam, the shortest way along edges, over its radius; infinity: far off.
  std::vector<double> share{};
};

/// @param radius per vertex that of the seam that it lies on, or 0
void measure_shares(const PolyMesh& mesh, const MeshTopology& topology, const std::vector<double>& radius,
                    SeamBand& band) {
  using Reached = std::tuple<double, Index, double>;  // share, vertex, radius
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  for (Index v = 0; v < radius.size(); ++v) {
    if (radius[v] <= 0) continue;
    queue.emplace(0.0, v, radius[v]);
    band.least_radius = std::min(band.least_radius, radius[v]);
  }
  band.share.assign(radius.size(), infinity);
  while (!queue.empty()) {
    const auto [at, v, own] = queue.top();
    queue.pop();
    if (at >= band.share[v]) continue;
    band.share[v] = at;
    for (const Index corner : topology.vertex_corners(v)) {
      const Index next = topology.vertex(topology.next(corner));
      const double there = at + (mesh.positions[next] - mesh.positions[v]).norm() / own;
      if (there < band.share[next] && there <= transition_share) queue.emplace(there, next, own);
    }
  }
}

SeamBand seam_band(const Shell& joined, const Radii& radii) {
  SeamBand band;
  const MeshTopology topology(joined.mesh);
  std::vector<double> radius(joined.mesh.vertex_count(), 0);
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const std::span<const Index> corners = topology.edge_corners(edge);
    const Index face = topology.face(corners.front()), other = topology.face(corners.back());
    const ObjectPair pair = std::minmax(joined.object_of(face), joined.object_of(other));
    if (pair.first == pair.second) {
      const bool turns = (seen_area(joined.mesh, face) > 0) != (seen_area(joined.mesh, other) > 0);
      if (turns) band.rim_edges.push_back(topology.edge_vertices(edge));
    } else if (const auto found = radii.find(pair); found != radii.end()) {
      for (const Index v : topology.edge_vertices(edge)) radius[v] = std::max(radius[v], found->second);
    }
  }
  measure_shares(joined.mesh, topology, radius, band);
  return band;
}

/// How far and how finely a band is triangulated anew.
struct Remeshing {
  double share = 0;  ///< of the radii
  double edge = 0;   ///< length, sketch units
  int rounds = 0;
};

/// Even triangles beside seams; seams and outlines stay lines of edges.
std::optional<Shell> remeshed(const Shell& joined, const SeamBand& seams, const Remeshing& wanted) {
  Band band = to_surface(joined);
  if (band.number_of_faces() != joined.mesh.face_count()) return std::nullopt;
  auto fixed = band.add_property_map<Band::Edge_index, bool>("e:fixed", false).first;
  for (const auto& [a, b] : seams.rim_edges) {
    fixed[band.edge(band.halfedge(BandVertex(a), BandVertex(b)))] = true;
  }
  std::vector<BandFace> faces;
  for (const BandFace face : band.faces()) {
    bool near = false;
    for (const BandVertex v : band.vertices_around_face(band.halfedge(face))) near |= seams.share[v] <= wanted.share;
    if (near) faces.push_back(face);
  }
  const auto objects = band.property_map<BandFace, Index>("f:object").first;
  try {
    pmp::isotropic_remeshing(
        faces, wanted.edge, band,
        pmp::parameters::number_of_iterations(wanted.rounds).edge_is_constrained_map(fixed).face_patch_map(objects));
  } catch (const std::exception&) {  // a failed precondition of the library
    return std::nullopt;
  }
  return from_surface(band, joined.objects);
}

using Sparse = Eigen::SparseMatrix<double>;

/// Rows of the Laplacian of all vertices that a free one is next to, over the root of their areas.
Sparse laplacian_rows(const PolyMesh& mesh, const std::vector<std::uint8_t>& moves) {
  std::vector<std::uint8_t> beside = moves;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    if (moves[c[0]] || moves[c[1]] || moves[c[2]]) beside[c[0]] = beside[c[1]] = beside[c[2]] = 1;
  }
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> area(mesh.vertex_count(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = c[(k + 1) % 3];
      const Index b = c[(k + 2) % 3];
      const Vec3 u = mesh.positions[a] - mesh.positions[c[k]];
      const Vec3 v = mesh.positions[b] - mesh.positions[c[k]];
      const double twice = u.cross(v).norm();
      area[c[k]] += twice / 6;
      const double weight = std::max(twice > 0 ? u.dot(v) / twice : 0, least_weight) / 2;
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        if (!beside[from]) continue;
        entries.emplace_back(from, to, weight);
        entries.emplace_back(from, from, -weight);
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(mesh.vertex_count());
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(count);
  for (Index v = 0; v < mesh.vertex_count(); ++v) scale[v] = area[v] > 0 ? 1 / std::sqrt(area[v]) : 0;
  Sparse rows(count, count);
  rows.setFromTriplets(entries.begin(), entries.end());
  return scale.asDiagonal() * rows;
}

/// Moves the vertices beside seams to where the squares of the Laplacian's rows are least. @return false if that isn't
/// unique
bool fair(const SeamBand& seams, PolyMesh& mesh) {
  const auto count = static_cast<Eigen::Index>(mesh.vertex_count());
  std::vector<std::uint8_t> moves(mesh.vertex_count(), 0);
  std::vector<Eigen::Index> moving;
  for (Index v = 0; v < moves.size(); ++v) {
    if (!(seams.share[v] < 1)) continue;
    moves[v] = 1;
    moving.push_back(v);
  }
  if (moving.empty()) return true;
  Sparse choose(count, static_cast<Eigen::Index>(moving.size()));
  choose.reserve(Eigen::VectorXi::Ones(choose.cols()));
  for (Eigen::Index i = 0; i < choose.cols(); ++i) choose.insert(moving[static_cast<std::size_t>(i)], i) = 1;
  Eigen::Map<Eigen::Matrix<double, 3, Eigen::Dynamic>> places(mesh.positions.front().data(), 3, count);
  Eigen::SimplicialLDLT<Sparse> factors;
  for (int round = 0; round < fairing_rounds; ++round) {
    const Sparse rows = laplacian_rows(mesh, moves);
    const Sparse own = rows * choose;
    const Sparse normal = own.transpose() * own;
    if (round == 0) factors.analyzePattern(normal);  // it stays the same
    factors.factorize(normal);
    if (factors.info() != Eigen::Success) return false;
    Eigen::MatrixXd held = places.transpose();
    for (const Eigen::Index v : moving) held.row(v).setZero();
    const Eigen::MatrixXd found = factors.solve(-(own.transpose() * (rows * held)));
    if (!found.allFinite()) return false;
    places(Eigen::all, moving) = found.transpose();
  }
  return true;
}

}  // namespace

std::optional<Shell> blend_seams(const Shell& joined, const Radii& radii, double finest) {
  const SeamBand sharp = seam_band(joined, radii);
  if (sharp.least_radius == infinity) return std::nullopt;
  const double edge = std::max(edge_share * sharp.least_radius, finest);
  const std::optional<Shell> coarse =
      remeshed(joined, sharp, {transition_share, transition_factor * edge, transition_rounds});
  if (!coarse) return std::nullopt;
  std::optional<Shell> blended = remeshed(*coarse, seam_band(*coarse, radii), {remeshed_share, edge, remeshing_rounds});
  if (!blended || !fair(seam_band(*blended, radii), blended->mesh)) return std::nullopt;
  return blended;
}

}  // namespace croquis::silhouette
