// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/meshes/mesh_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "support/random.h"

namespace croquis::test {
namespace {

void add_quad(PolyMesh& mesh, Index a, Index b, Index c, Index d) { mesh.add_face(std::array{a, b, c, d}); }

double turn(Index step, Index steps) { return 2 * std::numbers::pi * step / steps; }

/// The boundary quads of unit cubes, each cube named by its lowest corner.
PolyMesh cube_union(const std::set<std::array<int, 3>>& cubes) {
  PolyMesh mesh;
  std::map<std::array<int, 3>, Index> vertices;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = vertices.try_emplace(at, static_cast<Index>(mesh.positions.size()));
    if (is_new) mesh.positions.emplace_back(at[0], at[1], at[2]);
    return found->second;
  };
  for (const auto& cube : cubes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        auto neighbour = cube;
        neighbour[axis] += 2 * side - 1;
        if (cubes.contains(neighbour)) continue;
        std::array<Index, 4> quad{};
        for (std::size_t i = 0; i < 4; ++i) {
          auto corner = cube;
          corner[axis] += side;
          corner[(axis + 1) % 3] += (i == 1 || i == 2) ? 1 : 0;
          corner[(axis + 2) % 3] += i >= 2 ? 1 : 0;
          quad[i] = vertex(corner);
        }
        if (side == 0) std::reverse(quad.begin(), quad.end());
        mesh.add_face(quad);
      }
    }
  }
  return mesh;
}

/// A random order of 0 … count-1 (Fisher and Yates).
std::vector<Index> permutation(Random& random, std::size_t count) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  for (std::size_t i = count; i > 1; --i) {
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  }
  return order;
}

}  // namespace

PolyMesh tetrahedron() {
  PolyMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.add_triangle(0, 2, 1);
  mesh.add_triangle(0, 1, 3);
  mesh.add_triangle(1, 2, 3);
  mesh.add_triangle(2, 0, 3);
  return mesh;
}

PolyMesh cube() { return cube_union({{0, 0, 0}}); }

PolyMesh bent_box() {
  PolyMesh mesh = cube();
  for (Vec3& position : mesh.positions) {
    if (position == Vec3(1, 1, 1)) position.z() = 2;
  }
  return mesh;
}

PolyMesh uv_sphere(Index segments, Index rings) {
  PolyMesh mesh;
  mesh.positions.emplace_back(0, 0, -1);
  for (Index ring = 1; ring < rings; ++ring) {
    const double latitude = std::numbers::pi * (static_cast<double>(ring) / rings - 0.5);
    for (Index i = 0; i < segments; ++i) {
      const double longitude = turn(i, segments);
      mesh.positions.emplace_back(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                                  std::sin(latitude));
    }
  }
  mesh.positions.emplace_back(0, 0, 1);
  const Index north = static_cast<Index>(mesh.positions.size()) - 1;
  const auto at = [&](Index ring, Index i) { return 1 + (ring - 1) * segments + i % segments; };
  for (Index i = 0; i < segments; ++i) mesh.add_triangle(0, at(1, i + 1), at(1, i));
  for (Index ring = 1; ring + 1 < rings; ++ring) {
    for (Index i = 0; i < segments; ++i)
      add_quad(mesh, at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i));
  }
  for (Index i = 0; i < segments; ++i) mesh.add_triangle(at(rings - 1, i), at(rings - 1, i + 1), north);
  return mesh;
}

PolyMesh torus(Index segments, Index sides) {
  PolyMesh mesh;
  for (Index i = 0; i < segments; ++i) {
    const double around = turn(i, segments);
    for (Index j = 0; j < sides; ++j) {
      const double radius = 1 + 0.4 * std::cos(turn(j, sides));
      mesh.positions.emplace_back(radius * std::cos(around), radius * std::sin(around), 0.4 * std::sin(turn(j, sides)));
    }
  }
  const auto at = [&](Index i, Index j) { return (i % segments) * sides + j % sides; };
  for (Index i = 0; i < segments; ++i) {
    for (Index j = 0; j < sides; ++j) add_quad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return mesh;
}

PolyMesh double_torus() {
  std::set<std::array<int, 3>> cubes;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (y != 1 || x % 2 == 0) cubes.insert({x, y, 0});
    }
  }
  return cube_union(cubes);
}

PolyMesh grid(Index columns, Index rows) {
  PolyMesh mesh;
  for (Index y = 0; y <= rows; ++y) {
    for (Index x = 0; x <= columns; ++x) mesh.positions.emplace_back(x, y, 0);
  }
  const auto at = [&](Index x, Index y) { return y * (columns + 1) + x; };
  for (Index y = 0; y < rows; ++y) {
    for (Index x = 0; x < columns; ++x) add_quad(mesh, at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
  }
  return mesh;
}

PolyMesh moebius(Index quads) {
  PolyMesh mesh;
  for (Index i = 0; i < quads; ++i) {
    const double around = turn(i, quads);
    for (const double side : {-0.3, 0.3}) {
      const double radius = 1 + side * std::cos(around / 2);
      mesh.positions.emplace_back(radius * std::cos(around), radius * std::sin(around), side * std::sin(around / 2));
    }
  }
  for (Index i = 0; i + 1 < quads; ++i) add_quad(mesh, 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
  add_quad(mesh, 2 * quads - 2, 1, 0, 2 * quads - 1);
  return mesh;
}

PolyMesh tetrahedra_sharing_edge() {
  PolyMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (const auto& [a, b, c, d] : {std::array<Index, 4>{0, 2, 3, 1}, std::array<Index, 4>{0, 4, 5, 1}}) {
    mesh.add_triangle(a, c, b);
    mesh.add_triangle(a, b, d);
    mesh.add_triangle(b, c, d);
    mesh.add_triangle(c, a, d);
  }
  return mesh;
}

PolyMesh tetrahedra_sharing_vertex() {
  PolyMesh mesh = tetrahedron();
  const PolyMesh mirrored = flipped(scaled(tetrahedron(), -1));
  for (std::size_t v = 1; v < 4; ++v) mesh.positions.push_back(mirrored.positions[v]);
  for (std::size_t f = 0; f < 4; ++f) {
    std::array<Index, 3> triangle{};
    std::transform(mirrored.face(f).begin(), mirrored.face(f).end(), triangle.begin(),
                   [](Index v) { return v == 0 ? 0 : v + 3; });
    mesh.add_face(triangle);
  }
  return mesh;
}

PolyMesh random_soup(std::uint64_t seed, Index count) {
  Random random(seed);
  PolyMesh mesh;
  for (Index t = 0; t < count; ++t) {
    for (int i = 0; i < 3; ++i) {
      const double x = random.unit();
      const double y = random.unit();
      mesh.positions.emplace_back(x, y, random.unit());
    }
    mesh.add_triangle(3 * t, 3 * t + 1, 3 * t + 2);
  }
  return mesh;
}

PolyMesh transformed(PolyMesh mesh, const Eigen::Affine3d& transform) {
  for (Vec3& position : mesh.positions) position = transform * position;
  return mesh;
}

PolyMesh translated(PolyMesh mesh, const Vec3& offset) {
  return transformed(std::move(mesh), Eigen::Affine3d(Eigen::Translation3d(offset)));
}

PolyMesh scaled(PolyMesh mesh, double factor) {
  return transformed(std::move(mesh), Eigen::Affine3d(Eigen::UniformScaling<double>(factor)));
}

PolyMesh rotated(PolyMesh mesh, double radians, const Vec3& axis) {
  return transformed(std::move(mesh), Eigen::Affine3d(Eigen::AngleAxisd(radians, axis.normalized())));
}

PolyMesh flipped(const PolyMesh& mesh) {
  PolyMesh result = mesh;
  for (Index f = 0; f < mesh.face_count(); ++f) result = flipped_face(std::move(result), f);
  return result;
}

PolyMesh flipped_face(PolyMesh mesh, Index face) {
  std::reverse(mesh.corners.begin() + mesh.face_offsets[face], mesh.corners.begin() + mesh.face_offsets[face + 1]);
  return mesh;
}

PolyMesh triangulated(const PolyMesh& mesh) {
  PolyMesh result;
  result.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 2; i < face.size(); ++i) result.add_triangle(face[0], face[i - 1], face[i]);
  }
  return result;
}

PolyMesh merged(const PolyMesh& a, const PolyMesh& b) {
  PolyMesh result = a;
  const Index offset = static_cast<Index>(a.positions.size());
  result.positions.insert(result.positions.end(), b.positions.begin(), b.positions.end());
  for (std::size_t f = 0; f < b.face_count(); ++f) {
    std::vector<Index> face(b.face(f).begin(), b.face(f).end());
    for (Index& vertex : face) vertex += offset;
    result.add_face(face);
  }
  return result;
}

PolyMesh without_faces(const PolyMesh& mesh, std::span<const Index> faces) {
  PolyMesh result;
  result.positions = mesh.positions;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (std::find(faces.begin(), faces.end(), f) == faces.end()) result.add_face(mesh.face(f));
  }
  return result;
}

PolyMesh shuffled(const PolyMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  const std::vector<Index> new_id = permutation(random, mesh.vertex_count());
  PolyMesh result;
  result.positions.resize(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) result.positions[new_id[v]] = mesh.positions[v];
  for (const Index f : permutation(random, mesh.face_count())) {
    std::vector<Index> face;
    for (const Index vertex : mesh.face(f)) face.push_back(new_id[vertex]);
    std::rotate(face.begin(), face.begin() + random.below(static_cast<std::uint32_t>(face.size())), face.end());
    result.add_face(face);
  }
  return result;
}

}  // namespace croquis::test
