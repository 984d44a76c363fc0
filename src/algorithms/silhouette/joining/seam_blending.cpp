// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/joining/seam_blending.h"

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

#include "algorithms/silhouette/joining/union_surface.h"

namespace croquis::silhouette {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

using Band = UnionSurface;
using BandFace = Band::Face_index;
using BandVertex = Band::Vertex_index;
using Radii = std::map<std::pair<Index, Index>, double>;

// Of a band's half width.
constexpr double edge_share = 0.2;        // length of its edges
constexpr double remeshed_share = 1.3;    // how far it is triangulated anew: what moves has even triangles around it
constexpr double transition_share = 2.2;  // how far with longer edges first, so that their lengths grow evenly
constexpr double transition_factor = 2.2;
constexpr int transition_rounds = 1;
constexpr int remeshing_rounds = 2;
constexpr int fairing_rounds = 3;  // weights follow the shape; later rounds change little
constexpr double least_weight = 0.02;

Band to_band(const SurfaceUnion& joined) {
  Band band;
  for (const Vec3& p : joined.mesh.positions) band.add_vertex({p.x(), p.y(), p.z()});
  FaceObjects objects = face_objects(band);
  for (std::size_t f = 0; f < joined.mesh.face_count(); ++f) {
    const auto corners = joined.mesh.face(f);
    const BandFace face = band.add_face(BandVertex(corners[0]), BandVertex(corners[1]), BandVertex(corners[2]));
    if (face == Band::null_face()) return {};
    objects[face] = joined.face_objects[f];
  }
  return band;
}

/// An edge with the faces on both sides.
struct FacedEdge {
  Index low, high;
  Index face;
  auto operator<=>(const FacedEdge&) const = default;
};

/// Ascending by their vertices: the two faces of an edge follow one another.
std::vector<FacedEdge> faced_edges(const PolyMesh& mesh) {
  std::vector<FacedEdge> edges;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      edges.push_back({low, high, f});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

double facing(const PolyMesh& mesh, Index face) {
  const auto c = mesh.face(face);
  const Vec2 a = mesh.positions[c[0]].head<2>();
  return cross(mesh.positions[c[1]].head<2>() - a, mesh.positions[c[2]].head<2>() - a);
}

/// Seams, outlines and distances of one surface.
class SeamBand {
 public:
  SeamBand(const SurfaceUnion& joined, const Radii& radii)
      : mesh_(joined.mesh), share_(mesh_.vertex_count(), infinity) {
    const std::vector<FacedEdge> edges = faced_edges(mesh_);
    neighbours_.resize(mesh_.vertex_count());
    std::vector<double> radius(mesh_.vertex_count(), 0);
    for (std::size_t e = 0; e + 1 < edges.size(); e += 2) {
      const auto& [low, high, face] = edges[e];
      const Index other = edges[e + 1].face;
      neighbours_[low].push_back(high);
      neighbours_[high].push_back(low);
      const std::pair<Index, Index> pair = std::minmax(joined.face_objects[face], joined.face_objects[other]);
      if (pair.first == pair.second) {
        if ((facing(mesh_, face) > 0) != (facing(mesh_, other) > 0)) {
          rim_edges_.push_back({low, high});
        }
        continue;
      }
      const auto found = radii.find(pair);
      if (found == radii.end()) continue;
      for (const Index v : {low, high}) radius[v] = std::max(radius[v], found->second);
    }
    spread(radius);
  }

  bool empty() const { return least_radius_ == infinity; }
  double least_radius() const { return least_radius_; }

  /// Where a part turns from front to back.
  const std::vector<std::array<Index, 2>>& rim_edges() const { return rim_edges_; }

  /// Per vertex the distance from the nearest seam over its radius; infinity: far off.
  const std::vector<double>& share() const { return share_; }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

 private:
  /// Shortest ways along edges, in parts of the radius of the seam that they lead to.
  void spread(const std::vector<double>& radius) {
    using Reached = std::tuple<double, Index, double>;  // share, vertex, radius
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    for (Index v = 0; v < radius.size(); ++v) {
      if (radius[v] <= 0) continue;
      queue.emplace(0.0, v, radius[v]);
      least_radius_ = std::min(least_radius_, radius[v]);
    }
    while (!queue.empty()) {
      const auto [at, v, own] = queue.top();
      queue.pop();
      if (at >= share_[v]) continue;
      share_[v] = at;
      for (const Index next : neighbours_[v]) {
        const double there = at + (mesh_.positions[next] - mesh_.positions[v]).norm() / own;
        if (there < share_[next] && there <= transition_share) queue.emplace(there, next, own);
      }
    }
  }

  const PolyMesh& mesh_;
  std::vector<std::vector<Index>> neighbours_;
  double least_radius_ = infinity;
  std::vector<std::array<Index, 2>> rim_edges_;
  std::vector<double> share_;
};

/// How far and how finely a band is triangulated anew.
struct Remeshing {
  double share = 0;  ///< of the radii
  double edge = 0;   ///< length, sketch units
  int rounds = 0;
};

/// Even triangles beside seams; seams and outlines stay lines of edges.
std::optional<SurfaceUnion> remeshed(const SurfaceUnion& joined, const SeamBand& seams, const Remeshing& wanted) {
  Band band = to_band(joined);
  if (band.number_of_faces() != joined.mesh.face_count()) return std::nullopt;
  auto fixed = band.add_property_map<Band::Edge_index, bool>("e:fixed", false).first;
  for (const auto& [a, b] : seams.rim_edges()) {
    fixed[band.edge(band.halfedge(BandVertex(a), BandVertex(b)))] = true;
  }
  std::vector<BandFace> faces;
  for (const BandFace face : band.faces()) {
    bool near = false;
    for (const BandVertex v : band.vertices_around_face(band.halfedge(face))) near |= seams.share()[v] <= wanted.share;
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
  return from_surface(band);
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

/// Moves free vertices to where the squares of rows are least; the pattern of the rows stays the same.
class Fairing {
 public:
  /// @param moves per vertex
  explicit Fairing(const std::vector<std::uint8_t>& moves) : number_(moves.size(), -1) {
    for (Index v = 0; v < moves.size(); ++v) {
      if (!moves[v]) continue;
      number_[v] = static_cast<Eigen::Index>(free_.size());
      free_.push_back(v);
    }
  }

  /// @return false if the least isn't unique
  bool minimise(const Sparse& rows, PolyMesh& mesh) {
    if (free_.empty()) return true;
    const Sparse own = own_columns(rows);
    const Sparse normal = own.transpose() * own;
    if (!analysed_) factors_.analyzePattern(normal);
    analysed_ = true;
    factors_.factorize(normal);
    if (factors_.info() != Eigen::Success) return false;
    for (const int coordinate : {0, 1, 2}) {
      Eigen::VectorXd held = Eigen::VectorXd::Zero(rows.cols());
      for (Index v = 0; v < number_.size(); ++v) {
        if (number_[v] < 0) held[v] = mesh.positions[v][coordinate];
      }
      const Eigen::VectorXd found = factors_.solve(-(own.transpose() * (rows * held)));
      if (!found.allFinite()) return false;
      for (std::size_t i = 0; i < free_.size(); ++i) {
        mesh.positions[free_[i]][coordinate] = found[static_cast<Eigen::Index>(i)];
      }
    }
    return true;
  }

 private:
  /// Those of free vertices.
  Sparse own_columns(const Sparse& rows) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (const Index v : free_) {
      for (Sparse::InnerIterator entry(rows, v); entry; ++entry) {
        entries.emplace_back(entry.row(), number_[v], entry.value());
      }
    }
    Sparse own(rows.rows(), static_cast<Eigen::Index>(free_.size()));
    own.setFromTriplets(entries.begin(), entries.end());
    return own;
  }

  std::vector<Index> free_;
  std::vector<Eigen::Index> number_;  ///< per vertex, of the free ones
  Eigen::SimplicialLDLT<Sparse> factors_;
  bool analysed_ = false;
};

bool fair(const SeamBand& seams, PolyMesh& mesh) {
  std::vector<std::uint8_t> moves(mesh.vertex_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) moves[v] = seams.share()[v] < 1 ? 1 : 0;
  Fairing fairing(moves);
  for (int round = 0; round < fairing_rounds; ++round) {
    if (!fairing.minimise(laplacian_rows(mesh, moves), mesh)) return false;
  }
  return true;
}

}  // namespace

std::optional<SurfaceUnion> blend_seams(const SurfaceUnion& joined,
                                        const std::map<std::pair<Index, Index>, double>& radii, double finest) {
  const SeamBand sharp(joined, radii);
  if (sharp.empty()) return std::nullopt;
  const double edge = std::max(edge_share * sharp.least_radius(), finest);
  const std::optional<SurfaceUnion> coarse =
      remeshed(joined, sharp, {transition_share, transition_factor * edge, transition_rounds});
  if (!coarse) return std::nullopt;
  std::optional<SurfaceUnion> blended =
      remeshed(*coarse, SeamBand(*coarse, radii), {remeshed_share, edge, remeshing_rounds});
  if (!blended) return std::nullopt;
  const SeamBand seams(*blended, radii);
  if (!fair(seams, blended->mesh)) return std::nullopt;
  return blended;
}

}  // namespace croquis::silhouette
