// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/poly_mesh.h"
#include "support/random.h"

namespace croquis::test {

/// A radius that differs from place to place: three waves of random directions, as long as the radius.
class RaggedRadius {
 public:
  /// @param raggedness how much the radius varies, as fraction
  RaggedRadius(Random& random, double radius, double raggedness);

  /// In the direction of an offset from the centre.
  double at(const Vec3& offset) const;

 private:
  double radius_, raggedness_;
  std::array<Vec3, 3> waves_;
  std::array<double, 3> phases_{};
};

/// Grows pieces of a mesh from a face, across edges. Keeps the mesh by reference.
class PieceCutter {
 public:
  explicit PieceCutter(const PolyMesh& mesh);

  const MeshTopology& topology() const { return topology_; }

  /// Faces joined to `first` all of whose vertices lie inside; ascending.
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
  bool is_free(const std::vector<Index>& faces, std::ptrdiff_t rims) const;

  /// Vertices of the faces, and those up to two edges away, are free no more.
  void take(const std::vector<Index>& faces);

 private:
  const PolyMesh& mesh_;
  MeshTopology topology_;
  std::vector<bool> taken_;
};

}  // namespace croquis::test
