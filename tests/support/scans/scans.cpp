// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

namespace croquis::test {
namespace {

Vec3 centre_of(const PolyMesh& mesh, Index face) {
  Vec3 sum = Vec3::Zero();
  for (const Index v : mesh.face(face)) sum += mesh.positions[v];
  return sum / static_cast<double>(mesh.face(face).size());
}

bool is_within(const PolyMesh& mesh, Index face, const Vec3& centre, double low, double high) {
  const auto corners = mesh.face(face);
  return std::all_of(corners.begin(), corners.end(), [&](Index v) {
    const double distance = (mesh.positions[v] - centre).norm();
    return distance >= low && distance < high;
  });
}

/// The faces connected across edges to the one nearest to the centre, among those within the radii.
std::vector<Index> piece(const PolyMesh& mesh, const MeshTopology& topology, const Vec3& centre, double low,
                         double high) {
  Index nearest = no_index;
  double least = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const double distance = (centre_of(mesh, f) - centre).norm();
    if (distance < least && is_within(mesh, f, centre, low, high)) least = distance, nearest = f;
  }
  if (nearest == no_index) return {};
  std::set<Index> found = {nearest};
  std::vector<Index> pending = {nearest};
  while (!pending.empty()) {
    const Index face = pending.back();
    pending.pop_back();
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + 1]; ++corner) {
      const Index other = topology.opposite(corner);
      if (other == no_index || !is_within(mesh, topology.face(other), centre, low, high)) continue;
      if (found.insert(topology.face(other)).second) pending.push_back(topology.face(other));
    }
  }
  return {found.begin(), found.end()};
}

PolyMesh of_faces(const PolyMesh& mesh, const std::vector<Index>& faces) {
  PolyMesh part;
  part.positions = mesh.positions;
  for (const Index f : faces) part.add_face(mesh.face(f));
  return part;
}

bool is_disc(const PolyMesh& mesh, const std::vector<Index>& faces) {
  const PolyMesh part = of_faces(mesh, faces);
  const MeshTopology topology(part);
  std::ptrdiff_t vertices = 0;
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (topology.fan_count(v) > 1) return false;
    vertices += topology.fan_count(v);
  }
  const auto faces_less_edges =
      static_cast<std::ptrdiff_t>(faces.size()) - static_cast<std::ptrdiff_t>(topology.edge_count());
  return topology.boundary_loops().size() == 1 && vertices + faces_less_edges == 1;
}

CutScan without(const PolyMesh& complete, std::vector<std::vector<Index>> removed) {
  std::vector<Index> all;
  for (const auto& faces : removed) all.insert(all.end(), faces.begin(), faces.end());
  return {complete, without_faces(complete, all), std::move(removed)};
}

PolyMesh divided(const PolyMesh& mesh) {
  PolyMesh fine;
  fine.positions = mesh.positions;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(fine.positions.size()));
    if (is_new) fine.positions.push_back((mesh.positions[a] + mesh.positions[b]).normalized());
    return found->second;
  };
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const Index a = mesh.face(f)[0], b = mesh.face(f)[1], c = mesh.face(f)[2];
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.add_triangle(a, ab, ca);
    fine.add_triangle(ab, b, bc);
    fine.add_triangle(ca, bc, c);
    fine.add_triangle(ab, bc, ca);
  }
  return fine;
}

}  // namespace

PolyMesh round_sphere(int levels) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  PolyMesh mesh;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& p : mesh.positions) p.normalize();
  constexpr std::array<std::array<Index, 3>, 20> faces = {{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
  for (const auto& f : faces) mesh.add_face(f);
  for (int level = 0; level < levels; ++level) mesh = divided(mesh);
  return mesh;
}

PolyMesh revolved(std::span<const Vec2> profile, Index segments) {
  PolyMesh mesh;
  std::vector<Index> first;  // vertex of each ring's first place
  for (const Vec2& p : profile) {
    first.push_back(static_cast<Index>(mesh.positions.size()));
    const Index count = p.x() > 0 ? segments : 1;
    for (Index i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / segments;
      mesh.positions.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
    }
  }
  const auto at = [&](std::size_t ring, Index i) {
    return profile[ring].x() > 0 ? first[ring] + i % segments : first[ring];
  };
  for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
    for (Index i = 0; i < segments; ++i) {
      const Index a = at(ring, i), b = at(ring, i + 1), c = at(ring + 1, i + 1), d = at(ring + 1, i);
      if (a != b) mesh.add_triangle(a, b, c);
      if (c != d) mesh.add_triangle(a, c, d);
    }
  }
  return mesh;
}

PolyMesh open_tube(double radius, double length, Index segments, Index rings) {
  std::vector<Vec2> profile;
  for (Index i = 0; i <= rings; ++i) profile.emplace_back(radius, length * i / rings);
  return revolved(profile, segments);
}

PolyMesh bowl(Index segments, Index rings) {
  std::vector<Vec2> profile = {{0, -1}};
  for (Index i = 1; i <= rings; ++i) {
    const double angle = std::numbers::pi / 2 * (static_cast<double>(i) / rings - 1);
    profile.emplace_back(std::cos(angle), std::sin(angle));
  }
  return revolved(profile, segments);
}

PolyMesh bust(Index segments, Index rings) {
  std::vector<Vec2> profile;
  for (Index i = 0; i < rings; ++i) {
    const double height = 2.0 * i / rings;
    const double shoulders = 0.75 * std::exp(-std::pow(height / 0.55, 4));
    const double head = height < 2 ? 0.45 * std::sqrt(std::max(0.0, 1 - std::pow((height - 1.45) / 0.55, 2))) : 0;
    profile.emplace_back(std::max({shoulders, head, height < 1.5 ? 0.22 : 0.0}), height);
  }
  profile.emplace_back(0, 2);
  return revolved(profile, segments);
}

PolyMesh sheet(Index columns, Index rows) { return triangulated(grid(columns, rows)); }

PolyMesh divided_box(Index n) {
  PolyMesh mesh;
  std::map<std::array<Index, 3>, Index> known;
  const auto vertex = [&](const std::array<Index, 3>& at) {
    const auto [found, is_new] = known.try_emplace(at, static_cast<Index>(mesh.positions.size()));
    if (is_new)
      mesh.positions.emplace_back(static_cast<double>(at[0]) / n, static_cast<double>(at[1]) / n,
                                  static_cast<double>(at[2]) / n);
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const Index side : {Index{0}, n}) {
      for (Index i = 0; i < n; ++i) {
        for (Index k = 0; k < n; ++k) {
          const auto corner = [&](Index di, Index dk) {
            std::array<Index, 3> at{};
            at[axis] = side, at[(axis + 1) % 3] = i + di, at[(axis + 2) % 3] = k + dk;
            return vertex(at);
          };
          std::array<Index, 4> quad = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
          if (side == 0) std::swap(quad[1], quad[3]);
          mesh.add_triangle(quad[0], quad[1], quad[2]);
          mesh.add_triangle(quad[0], quad[2], quad[3]);
        }
      }
    }
  }
  return mesh;
}

PolyMesh shell(int levels, double wall) {
  const PolyMesh sphere = round_sphere(levels);
  return merged(sphere, flipped(scaled(sphere, 1 - wall)));
}

PolyMesh ring_torus(Index segments, Index sides) { return triangulated(torus(segments, sides)); }

CutScan cut(const PolyMesh& complete, const Vec3& centre, double radius) {
  return without(complete, {piece(complete, MeshTopology(complete), centre, 0, radius)});
}

CutScan cut_ring(const PolyMesh& complete, const Vec3& centre, double inner, double outer) {
  return without(complete, {piece(complete, MeshTopology(complete), centre, inner, outer)});
}

CutScan random_cuts(const PolyMesh& complete, std::uint64_t seed, std::size_t count, double low, double high) {
  Random random(seed);
  const MeshTopology topology(complete);
  std::vector<std::vector<Index>> removed;
  std::set<Index> taken;  // vertices of borders, of pieces, and of the faces around these
  for (const Index v : topology.boundary_loops().values) taken.insert(v);
  for (int attempt = 0; removed.size() < count && attempt < 1000; ++attempt) {
    const Vec3 centre = centre_of(complete, random.below(static_cast<Index>(complete.face_count())));
    const auto faces = piece(complete, topology, centre, 0, random.between(low, high));
    if (faces.empty() || !is_disc(complete, faces)) continue;
    std::set<Index> used;
    for (const Index f : faces) used.insert(complete.face(f).begin(), complete.face(f).end());
    if (std::any_of(used.begin(), used.end(), [&](Index v) { return taken.contains(v); })) continue;
    for (int ring = 0; ring < 2; ++ring) {
      const std::set<Index> inner = used;
      for (const Index v : inner) {
        for (const Index corner : topology.vertex_corners(v)) {
          const auto face = complete.face(topology.face(corner));
          used.insert(face.begin(), face.end());
        }
      }
    }
    taken.insert(used.begin(), used.end());
    removed.push_back(faces);
  }
  return without(complete, std::move(removed));
}

PolyMesh chained_holes(Index count) {
  const Index size = count + 4;
  const PolyMesh squares = grid(size, size);
  std::vector<Index> faces;
  for (Index i = 0; i < count; ++i) faces.push_back((i + 2) * size + i + 2);  // a diagonal
  return triangulated(without_faces(squares, faces));
}

PolyMesh with_noisy_rims(PolyMesh mesh, std::uint64_t seed, double amount) {
  Random random(seed);
  const MeshTopology topology(mesh);
  const auto& loops = topology.boundary_loops();
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    for (const Index v : loops[loop]) {
      double shortest = std::numeric_limits<double>::infinity();
      for (const Index corner : topology.vertex_corners(v))
        shortest =
            std::min(shortest, (mesh.positions[topology.vertex(topology.next(corner))] - mesh.positions[v]).norm());
      const double x = random.between(-1, 1), y = random.between(-1, 1);
      mesh.positions[v] += amount * shortest * Vec3(x, y, random.between(-1, 1));
    }
  }
  return mesh;
}

PolyMesh as_soup(const PolyMesh& mesh) {
  PolyMesh soup;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<Index> corners;
    for (const Index v : mesh.face(f)) {
      corners.push_back(static_cast<Index>(soup.positions.size()));
      soup.positions.push_back(mesh.positions[v]);
    }
    soup.add_face(corners);
  }
  return soup;
}

}  // namespace croquis::test
