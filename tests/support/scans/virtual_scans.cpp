// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/virtual_scans.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/depth_image.h"
#include "support/scans/piece_cutter.h"

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 normal_of(const PolyMesh& mesh, Index face) {
  const auto t = mesh.face(face);
  const Vec3& a = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}

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

double normal_deviate(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.unit()));
  return radius * std::cos(2 * pi * random.unit());
}

double mean_edge_of(const PolyMesh& mesh) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto t = mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) sum += (mesh.positions[t[i]] - mesh.positions[t[(i + 1) % 3]]).norm();
  }
  return sum / (3 * static_cast<double>(mesh.face_count()));
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
  const double deviation = amount * mean_edge_of(mesh);
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
  const double cell = mean_edge_of(complete) / 2;
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
