// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/scan_damage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"
#include "support/scans/triangle_measures.h"
#include "support/scans/virtual_scans.h"
#include "support/scans/waves.h"

namespace croquis::test {
namespace {

Vec3 random_offset(Random& random) {
  const double x = random.between(-1, 1), y = random.between(-1, 1);
  return {x, y, random.between(-1, 1)};
}

/// Unit normals, zero for vertices without faces.
std::vector<Vec3> vertex_normals(const PolyMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertex_count(), Vec3::Zero());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const Index v : mesh.face(f)) normals[v] += area_vector_of_triangle(mesh, f);
  }
  for (Vec3& n : normals) n = n.norm() > 0 ? n.normalized() : Vec3::Zero();
  return normals;
}

/// The mean edge of the triangles around each vertex.
std::vector<double> mean_edges_at_vertices(const PolyMesh& mesh) {
  std::vector<double> sums(mesh.vertex_count(), 0), counts(mesh.vertex_count(), 0);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto t = mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      const double length = (mesh.positions[a] - mesh.positions[b]).norm();
      sums[a] += length, sums[b] += length, ++counts[a], ++counts[b];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = counts[v] > 0 ? sums[v] / counts[v] : 0;
  return sums;
}

PolyMesh floating_piece(Random& random, double edge) {
  const double size = edge * random.between(0.7, 3);
  PolyMesh piece;
  if (random.unit() < 0.3) {
    piece = round_sphere(static_cast<int>(random.below(2)));
  } else {
    const auto columns = 1 + random.below(4), rows = 1 + random.below(4);
    piece = translated(sheet(columns, rows), Vec3(-0.5 * columns, -0.5 * rows, 0));
  }
  const Waves crumpled(random, 4, 3);
  for (Vec3& p : piece.positions) p += 0.3 * crumpled.at(p) * Vec3(0.3, 0.2, 1);
  const Vec3 axis = random_offset(random).normalized();
  return rotated(scaled(piece, size), random.between(0, 6), axis);
}

/// A corner of the mesh, its edge's ends, and the third vertex of its triangle.
struct RimEdge {
  Index from, to, across;
};

RimEdge rim_edge(const PolyMesh& mesh, Index corner) {
  const Index first = corner - corner % 3, i = corner % 3;
  return {mesh.corners[corner], mesh.corners[first + (i + 1) % 3], mesh.corners[first + (i + 2) % 3]};
}

}  // namespace

std::vector<Index> split_between(PolyMesh& mesh, std::span<const Index> labels) {
  std::map<std::pair<Index, Index>, Index> copies;  // vertex, label
  std::vector<Index> label_of(mesh.vertex_count(), no_index);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (Index corner = mesh.face_offsets[f]; corner < mesh.face_offsets[f + 1]; ++corner) {
      const Index v = mesh.corners[corner];
      if (label_of[v] == no_index) label_of[v] = labels[f];
      if (label_of[v] == labels[f]) continue;
      const auto [found, is_new] = copies.try_emplace({v, labels[f]}, static_cast<Index>(mesh.vertex_count()));
      if (is_new) {
        const Vec3 place = mesh.positions[v];
        mesh.positions.push_back(place);
        label_of.push_back(labels[f]);
      }
      mesh.corners[corner] = found->second;
    }
  }
  return label_of;
}

void misplace_last_bits(PolyMesh& mesh, Random& random, const std::vector<bool>& is_moved) {
  constexpr double far = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    if (!is_moved[v]) continue;
    for (double& x : mesh.positions[v]) x = std::nextafter(x, random.unit() < 0.5 ? far : -far);
  }
}

void add_lumps(PolyMesh& mesh, Random& random, double amount) {
  const double edge = mean_edge_of(mesh);
  std::vector<Waves> lumps;
  for (int i = 0; i < 6; ++i) lumps.emplace_back(random, edge * random.between(4, 12), 1);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  const std::vector<double> edges = mean_edges_at_vertices(mesh);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    double lump = 0;  // the sum of six sines has a deviation of sqrt(3)
    for (const Waves& waves : lumps) lump += waves.at(mesh.positions[v]) / std::numbers::sqrt3;
    const double own = edges[v] * normal_deviate(random);
    mesh.positions[v] += amount * std::numbers::sqrt2 / 2 * (edge * lump + own) * normals[v];
  }
}

void add_depth_noise(PolyMesh& mesh, Random& random, const Vec3& direction, double amount) {
  const Vec3 ahead = direction.normalized();
  for (Vec3& p : mesh.positions) {
    const double depth = p.dot(ahead);
    const double read = amount > 0 ? std::round(depth / amount + 0.7 * normal_deviate(random)) * amount : depth;
    p += (read - depth) * ahead;
  }
}

void add_floating_pieces(PolyMesh& mesh, Random& random, std::size_t count,
                         const std::function<bool(const Vec3&)>& is_far) {
  const double edge = mean_edge_of(mesh);
  Vec3 low = mesh.positions[mesh.corners[0]], high = low;
  for (const Index v : mesh.corners) {
    low = low.cwiseMin(mesh.positions[v]);
    high = high.cwiseMax(mesh.positions[v]);
  }
  const Vec3 size = high - low;
  const auto corners = static_cast<Index>(mesh.corners.size());
  for (std::size_t placed = 0, tries = 0; placed < count && tries < 200 * count; ++tries) {
    Vec3 at = mesh.positions[mesh.corners[random.below(corners)]] + 12 * edge * random_offset(random);
    if (random.unit() < 0.25) at = low + size.cwiseProduct(0.55 * random_offset(random) + Vec3::Constant(0.5));
    const PolyMesh piece = translated(floating_piece(random, edge), at);
    if (!std::all_of(piece.positions.begin(), piece.positions.end(), is_far)) continue;
    mesh = merged(mesh, piece);
    ++placed;
  }
}

std::size_t add_stray_triangles(PolyMesh& mesh, Random& random, std::vector<Index>& rim, double share) {
  std::set<Index> used;
  std::vector<Index> open;
  std::size_t count = 0;
  for (const Index corner : rim) {
    const auto [a, b, across] = rim_edge(mesh, corner);
    const bool hangs = random.unit() < share && !used.contains(a) && !used.contains(b);
    if (!hangs) {
      open.push_back(corner);
      continue;
    }
    used.insert({a, b});
    ++count;
    const Vec3 pa = mesh.positions[a], pb = mesh.positions[b], middle = (pa + pb) / 2;
    const double length = (pb - pa).norm();
    const Vec3 out = (middle - mesh.positions[across]).normalized();
    const Vec3 up = out.cross(pb - pa).normalized();
    const Vec3 tip = (random.unit() < 0.33 ? pa : middle) + length * random.between(0.4, 1) * out +
                     length * random.between(-0.4, 0.4) * up;
    const auto first = static_cast<Index>(mesh.corners.size()), n = static_cast<Index>(mesh.vertex_count());
    mesh.positions.push_back(tip);
    if (count % 3 != 0) {
      mesh.add_triangle(b, a, n);
      open.insert(open.end(), {first + 1, first + 2});
    } else {
      mesh.positions.push_back(tip + 0.5 * length * (pa - pb).normalized() + 0.2 * length * out);
      mesh.add_triangle(a, n + 1, n);
      open.push_back(corner);
    }
  }
  rim = std::move(open);
  return count;
}

void add_fins(PolyMesh& mesh, Random& random, std::size_t count) {
  const MeshTopology topology(mesh);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  const auto corners = static_cast<Index>(mesh.corners.size());
  std::set<Index> used;
  while (used.size() < count) {
    const Index corner = random.below(corners);
    if (topology.opposite(corner) == no_index || !used.insert(topology.edge(corner)).second) continue;
    const auto [a, b, across] = rim_edge(mesh, corner);
    const Vec3 pa = mesh.positions[a], pb = mesh.positions[b];
    const auto n = static_cast<Index>(mesh.vertex_count());
    mesh.positions.push_back((pa + pb) / 2 + (pb - pa).norm() * (normals[a] + normals[b]).normalized());
    mesh.add_triangle(a, b, n);
  }
}

}  // namespace croquis::test
