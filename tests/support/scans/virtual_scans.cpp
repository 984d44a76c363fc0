// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/virtual_scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/depth_image.h"

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 normal_of(const PolyMesh& mesh, Index face) {
  const auto t = mesh.face(face);
  const Vec3& a = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}

/// A radius that differs from place to place: three waves of random directions, as long as the radius.
class RaggedRadius {
 public:
  RaggedRadius(Random& random, double radius, double raggedness) : radius_(radius), raggedness_(raggedness) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 direction(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      waves_[i] = direction.normalized() * (2 + 2 * static_cast<double>(i)) / radius;
      phases_[i] = random.between(0, 2 * pi);
    }
  }

  double at(const Vec3& offset) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += std::sin(waves_[i].dot(offset) + phases_[i]);
    return radius_ * (1 + raggedness_ * sum / 2);
  }

 private:
  double radius_, raggedness_;
  std::array<Vec3, 3> waves_;
  std::array<double, 3> phases_{};
};

/// Grows pieces of a mesh from a face, across edges.
class PieceCutter {
 public:
  explicit PieceCutter(const PolyMesh& mesh) : mesh_(mesh), topology_(mesh), taken_(mesh.vertex_count(), false) {
    for (const Index v : topology_.boundary_loops().values) taken_[v] = true;
  }

  /// Faces joined to `first` whose vertices all lie within the radius, and out of the island; ascending.
  template <typename Inside>
  std::vector<Index> grow(Index first, const Inside& is_inside) const {
    std::set<Index> found;
    std::vector<Index> pending = {first};
    while (!pending.empty()) {
      const Index face = pending.back();
      pending.pop_back();
      const auto corners = mesh_.face(face);
      if (!std::all_of(corners.begin(), corners.end(), [&](Index v) { return is_inside(mesh_.positions[v]); }))
        continue;
      if (!found.insert(face).second) continue;
      for (Index corner = mesh_.face_offsets[face]; corner < mesh_.face_offsets[face + 1]; ++corner) {
        const Index other = topology_.opposite(corner);
        if (other != no_index && !found.contains(topology_.face(other))) pending.push_back(topology_.face(other));
      }
    }
    return {found.begin(), found.end()};
  }

  /// Whether the faces are a piece with so many rims that share no vertex, without handles, apart from other pieces.
  bool is_free(const std::vector<Index>& faces, std::ptrdiff_t rims) const {
    std::vector<std::array<Index, 2>> edges;
    std::set<Index> vertices;
    for (const Index f : faces) {
      const auto t = mesh_.face(f);
      for (std::size_t i = 0; i < 3; ++i) {
        if (taken_[t[i]]) return false;
        vertices.insert(t[i]);
        edges.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
      }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Index> rim_ends;
    std::ptrdiff_t edge_count = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      ++edge_count;
      if (i + 1 < edges.size() && edges[i] == edges[i + 1]) {
        ++i;
        continue;
      }
      rim_ends.insert(rim_ends.end(), edges[i].begin(), edges[i].end());
    }
    std::sort(rim_ends.begin(), rim_ends.end());
    for (std::size_t i = 2; i < rim_ends.size(); ++i) {
      if (rim_ends[i - 2] == rim_ends[i]) return false;
    }
    const auto count = static_cast<std::ptrdiff_t>(vertices.size()) + static_cast<std::ptrdiff_t>(faces.size());
    return !faces.empty() && count - edge_count == 2 - rims;
  }

  /// Vertices of the faces, and those up to two edges away, are free no more.
  void take(const std::vector<Index>& faces) {
    std::set<Index> used;
    for (const Index f : faces) used.insert(mesh_.face(f).begin(), mesh_.face(f).end());
    for (int ring = 0; ring < 2; ++ring) {
      const std::set<Index> inner = used;
      for (const Index v : inner) {
        for (const Index corner : topology_.vertex_corners(v)) {
          const auto face = mesh_.face(topology_.face(corner));
          used.insert(face.begin(), face.end());
        }
      }
    }
    for (const Index v : used) taken_[v] = true;
  }

 private:
  const PolyMesh& mesh_;
  MeshTopology topology_;
  std::vector<bool> taken_;
};

std::vector<Index> difference(const std::vector<Index>& faces, const std::vector<Index>& less) {
  std::vector<Index> rest;
  std::set_difference(faces.begin(), faces.end(), less.begin(), less.end(), std::back_inserter(rest));
  return rest;
}

/// Around the centre, in whose face it begins, but for an island; empty where the island has no face.
std::vector<Index> ragged_piece(const PieceCutter& cutter, Index first, const Vec3& centre, const RaggedRadius& outer,
                                double island) {
  const auto all = cutter.grow(first, [&](const Vec3& p) { return (p - centre).norm() < outer.at(p - centre); });
  const auto kept = cutter.grow(first, [&](const Vec3& p) { return (p - centre).norm() < island; });
  return island > 0 && kept.empty() ? kept : difference(all, kept);
}

CutScan without(const PolyMesh& complete, std::vector<std::vector<Index>> removed) {
  std::vector<Index> all;
  for (const auto& faces : removed) all.insert(all.end(), faces.begin(), faces.end());
  return {complete, without_faces(complete, all), std::move(removed)};
}

/// Pieces of faces, joined across edges, that are (or are not) in a set; each ascending, by their lowest face.
std::vector<std::vector<Index>> pieces(const PolyMesh& mesh, const MeshTopology& topology,
                                       const std::vector<bool>& in_set, bool wanted) {
  std::vector<bool> seen(mesh.face_count(), false);
  std::vector<std::vector<Index>> all;
  for (Index first = 0; first < mesh.face_count(); ++first) {
    if (seen[first] || in_set[first] != wanted) continue;
    std::vector<Index> piece = {first};
    seen[first] = true;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (Index corner = mesh.face_offsets[piece[i]]; corner < mesh.face_offsets[piece[i] + 1]; ++corner) {
        const Index other = topology.opposite(corner);
        if (other == no_index || seen[topology.face(other)] || in_set[topology.face(other)] != wanted) continue;
        seen[topology.face(other)] = true;
        piece.push_back(topology.face(other));
      }
    }
    std::sort(piece.begin(), piece.end());
    all.push_back(std::move(piece));
  }
  return all;
}

double mean_edge(const PolyMesh& mesh) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto t = mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) sum += (mesh.positions[t[i]] - mesh.positions[t[(i + 1) % 3]]).norm();
  }
  return sum / (3 * static_cast<double>(mesh.face_count()));
}

/// Box and Muller.
double normal_deviate(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.unit())) * std::cos(2 * pi * random.unit());
}

}  // namespace

double diagonal_of(const PolyMesh& mesh) {
  if (mesh.corners.empty()) return 0;
  Vec3 low = mesh.positions[mesh.corners.front()], high = low;
  for (const Index v : mesh.corners) {
    low = low.cwiseMin(mesh.positions[v]);
    high = high.cwiseMax(mesh.positions[v]);
  }
  return (high - low).norm();
}

CutScan ragged_cuts(const PolyMesh& complete, const RaggedCuts& cuts) {
  constexpr int most_attempts = 4000;
  Random random(cuts.seed);
  PieceCutter cutter(complete);
  const double diagonal = diagonal_of(complete);
  std::vector<std::vector<Index>> removed;
  for (int attempt = 0; removed.size() < cuts.count && attempt < most_attempts; ++attempt) {
    const Index first = random.below(static_cast<Index>(complete.face_count()));
    const Vec3 centre = complete.positions[complete.face(first)[0]];
    const double radius = diagonal * cuts.low * std::pow(cuts.high / cuts.low, random.unit());
    const RaggedRadius outer(random, radius, cuts.raggedness);
    std::vector<Index> faces = ragged_piece(cutter, first, centre, outer, cuts.island * radius);
    if (!cutter.is_free(faces, cuts.island > 0 ? 2 : 1)) continue;
    cutter.take(faces);
    removed.push_back(std::move(faces));
  }
  return without(complete, std::move(removed));
}

PolyMesh cut_ragged(const PolyMesh& mesh, const Vec3& centre, double radius, double island, std::uint64_t seed) {
  Random random(seed);
  const RaggedRadius outer(random, radius, RaggedCuts().raggedness);
  Index first = 0;
  const auto distance = [&](Index face) { return (mesh.positions[mesh.face(face)[0]] - centre).norm(); };
  for (Index f = 1; f < mesh.face_count(); ++f) {
    if (distance(f) < distance(first)) first = f;
  }
  const Vec3 middle = mesh.positions[mesh.face(first)[0]];
  return without_faces(mesh, ragged_piece(PieceCutter(mesh), first, middle, outer, island));
}

PolyMesh with_noise(PolyMesh mesh, std::uint64_t seed, double amount) {
  const double deviation = amount * mean_edge(mesh);
  std::vector<Vec3> normals(mesh.vertex_count(), Vec3::Zero());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (const Index v : mesh.face(f)) normals[v] += normal_of(mesh, f);
  }
  Random random(seed);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const double length = normals[v].norm();
    const double along = deviation * normal_deviate(random);
    if (length > 0) mesh.positions[v] += along / length * normals[v];
  }
  return mesh;
}

CutScan seen_from(const PolyMesh& complete, std::span<const Vec3> directions, double greatest_angle) {
  constexpr std::size_t least_missing = 6, least_kept = 50;
  std::vector<bool> is_seen(complete.face_count(), false);
  const double cell = mean_edge(complete) / 2;
  for (const Vec3& direction : directions) {
    const DepthImage image(complete, direction, cell);
    for (Index f = 0; f < complete.face_count(); ++f) {
      const Vec3 normal = normal_of(complete, f);
      if (normal.dot(image.towards()) <= std::cos(greatest_angle) * normal.norm()) continue;
      const auto t = complete.face(f);
      if (std::all_of(t.begin(), t.end(), [&](Index v) { return image.shows(complete.positions[v], 4 * cell); }))
        is_seen[f] = true;
    }
  }
  const MeshTopology topology(complete);
  for (const auto& piece : pieces(complete, topology, is_seen, false)) {
    for (const Index f : piece) is_seen[f] = piece.size() < least_missing;
  }
  for (const auto& piece : pieces(complete, topology, is_seen, true)) {
    for (const Index f : piece) is_seen[f] = piece.size() >= least_kept;
  }
  return without(complete, pieces(complete, topology, is_seen, false));
}

PolyMesh range_images(const PolyMesh& complete, std::span<const Vec3> directions, double spacing) {
  PolyMesh sheets;
  for (const Vec3& direction : directions) sheets = merged(sheets, DepthImage(complete, direction, spacing).surface());
  return sheets;
}

PolyMesh without_loose_vertices(const PolyMesh& mesh) {
  std::vector<bool> is_used(mesh.vertex_count(), false);
  for (const Index v : mesh.corners) is_used[v] = true;
  std::vector<Index> number(mesh.vertex_count(), no_index);
  PolyMesh used;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (!is_used[v]) continue;
    number[v] = static_cast<Index>(used.positions.size());
    used.positions.push_back(mesh.positions[v]);
  }
  used.face_offsets = mesh.face_offsets;
  for (const Index v : mesh.corners) used.corners.push_back(number[v]);
  return used;
}

}  // namespace croquis::test
