// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/uneven_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "croquis/geometry/mesh_topology.h"
#include "support/scans/sculptures.h"
#include "support/scans/triangle_measures.h"
#include "support/scans/virtual_scans.h"
#include "support/scans/waves.h"

namespace croquis::test {
namespace {

constexpr int most_rounds = 12;

/// How many times as many triangles as at its least a place has: ratio^s, s in 0..1 of a wave as long as the model.
class Density {
 public:
  /// The level of the waves is chosen so that the mesh gets as many triangles as wanted.
  Density(const PolyMesh& mesh, std::uint64_t seed, std::size_t triangles, double ratio)
      : random_(seed), waves_(random_, 0.9 * diagonal_of(mesh), 3), ratio_(ratio) {
    double low = -4, high = 4;
    for (int i = 0; i < 30; ++i) {
      level_ = (low + high) / 2;
      double count = 0;
      for (std::size_t f = 0; f < mesh.face_count(); ++f) count += at(centre_of_triangle(mesh, f));
      (count > static_cast<double>(triangles) ? high : low) = level_;
    }
  }

  double at(const Vec3& place) const { return std::pow(ratio_, std::clamp(0.7 * waves_.at(place) + level_, 0.0, 1.0)); }

 private:
  Random random_;
  Waves waves_;
  double ratio_, level_ = 0;
};

/// Marks the edges to cut: the longest of every triangle that is too large, and of every one with a marked edge.
std::vector<bool> marked_edges(const PolyMesh& mesh, const MeshTopology& topology, const std::vector<bool>& too_large) {
  std::vector<Index> longest(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double most = -1;
    for (Index corner = 3 * f; corner < 3 * f + 3; ++corner) {
      const Index edge = topology.edge(corner);
      const auto [a, b] = topology.edge_vertices(edge);  // the same bits from both sides
      const double length = (mesh.positions[a] - mesh.positions[b]).squaredNorm();
      if (length > most || (length == most && edge < longest[f])) most = length, longest[f] = edge;
    }
  }
  std::vector<bool> is_marked(topology.edge_count(), false);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!too_large[f]) continue;
    for (Index face = f; face != no_index && !is_marked[longest[face]];) {
      const Index edge = longest[face];
      is_marked[edge] = true;
      const auto corners = topology.edge_corners(edge);
      const Index first = topology.face(corners[0]);
      face = first == face && corners.size() > 1 ? topology.face(corners[1]) : first;
    }
  }
  return is_marked;
}

/// Cuts every triangle along its marked edges, the longest of which is marked if any is.
PolyMesh cut_at(const PolyMesh& mesh, const MeshTopology& topology, const std::vector<bool>& is_marked,
                std::vector<Vec3>& middles) {
  std::vector<Index> middle(topology.edge_count(), no_index);
  const auto first_new = static_cast<Index>(mesh.vertex_count());
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    if (!is_marked[edge]) continue;
    const auto [a, b] = topology.edge_vertices(edge);
    middle[edge] = first_new + static_cast<Index>(middles.size());
    middles.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
  }
  PolyMesh fine;
  fine.positions = mesh.positions;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::array<Index, 3> m{};
    double most = -1;
    Index first = 0;
    for (Index i = 0; i < 3; ++i) {
      const Index edge = topology.edge(3 * f + i);
      m[i] = middle[edge];
      const auto [a, b] = topology.edge_vertices(edge);
      const double length = (mesh.positions[a] - mesh.positions[b]).squaredNorm();
      if (m[i] != no_index && length > most) most = length, first = i;
    }
    const auto t = mesh.face(f);
    const Index a = t[first], b = t[(first + 1) % 3], c = t[(first + 2) % 3];
    if (most < 0) {
      fine.add_triangle(a, b, c);
      continue;
    }
    const Index ab = m[first], bc = m[(first + 1) % 3], ca = m[(first + 2) % 3];
    if (bc == no_index) {
      fine.add_triangle(ab, b, c);
    } else {
      fine.add_triangle(ab, b, bc);
      fine.add_triangle(ab, bc, c);
    }
    if (ca == no_index) {
      fine.add_triangle(a, ab, c);
    } else {
      fine.add_triangle(a, ab, ca);
      fine.add_triangle(ab, c, ca);
    }
  }
  return fine;
}

}  // namespace

PolyMesh with_uneven_density(PolyMesh mesh, const std::function<double(const Vec3&)>& solid, std::uint64_t seed,
                             std::size_t triangles, double ratio) {
  const Density density(mesh, seed, triangles, ratio);
  double area = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) area += area_of_triangle(mesh, f);
  const double mean = area / static_cast<double>(mesh.face_count());
  constexpr double spare = 1.4;  // a triangle that is cut has half of its area: from there down to 0.7 is 1 in the mean
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<bool> too_large(mesh.face_count());
    for (std::size_t f = 0; f < too_large.size(); ++f)
      too_large[f] = area_of_triangle(mesh, f) * density.at(centre_of_triangle(mesh, f)) > spare * mean;
    if (std::none_of(too_large.begin(), too_large.end(), [](bool is) { return is; })) break;
    const MeshTopology topology(mesh);
    std::vector<Vec3> middles;
    mesh = cut_at(mesh, topology, marked_edges(mesh, topology, too_large), middles);
    bring_onto(solid, middles, std::sqrt(mean));
    mesh.positions.insert(mesh.positions.end(), middles.begin(), middles.end());
  }
  return mesh;
}

}  // namespace croquis::test
