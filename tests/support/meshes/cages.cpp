// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/meshes/cages.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <numeric>
#include <utility>

#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

void add_face(PolyMesh& mesh, std::initializer_list<Index> vertices) {
  mesh.add_face(std::span<const Index>(vertices.begin(), vertices.size()));
}

PolyMesh mesh_of(std::initializer_list<Vec3> points, std::initializer_list<std::initializer_list<Index>> faces) {
  PolyMesh mesh;
  mesh.positions = points;
  for (const auto& face : faces) add_face(mesh, face);
  return mesh;
}

Vec3 ring_point(const Ring& ring, Index sides, Index i) {
  if (sides == 4) return {i == 1 || i == 2 ? ring.size : -ring.size, i >= 2 ? ring.size : -ring.size, ring.z};
  const double angle = 2 * std::numbers::pi * i / sides;
  return {ring.size * std::cos(angle), ring.size * std::sin(angle), ring.z};
}

}  // namespace

PolyMesh ring_stack(Index sides, std::span<const Ring> rings) {
  PolyMesh mesh;
  for (const Ring& ring : rings) {
    for (Index i = 0; i < sides; ++i) mesh.positions.push_back(ring_point(ring, sides, i));
  }
  std::vector<Index> end(sides);
  std::iota(end.begin(), end.end(), Index{0});
  mesh.add_face(end);
  for (Index upper = 0; upper + sides < mesh.vertex_count(); upper += sides) {
    for (Index i = 0; i < sides; ++i) {
      const Index next = (i + 1) % sides, lower = upper + sides;
      add_face(mesh, {lower + i, lower + next, upper + next, upper + i});
    }
  }
  std::iota(end.rbegin(), end.rend(), static_cast<Index>(mesh.vertex_count() - sides));
  mesh.add_face(end);
  return mesh;
}

PolyMesh bolt() { return ring_stack(4, std::array<Ring, 4>{{{2, 1}, {2, 0}, {1, 0}, {1, -3}}}); }

PolyMesh bolt_loop() { return tagged(bolt(), std::array<VertexPair, 4>{{{8, 9}, {8, 11}, {9, 10}, {10, 11}}}); }

PolyMesh bolt_open_chain() { return tagged(bolt(), std::array<VertexPair, 3>{{{8, 9}, {9, 10}, {10, 11}}}); }

PolyMesh hex_bolt() { return ring_stack(6, std::array<Ring, 5>{{{2, 1}, {2, 0}, {1.5, 0}, {1, -0.5}, {1, -3}}}); }

PolyMesh centred_cube() {
  return mesh_of({{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
                 {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

PolyMesh cube_top_loop() { return tagged(centred_cube(), std::array<VertexPair, 4>{{{4, 5}, {4, 6}, {5, 7}, {6, 7}}}); }

PolyMesh cube_all_sharp() { return tagged(centred_cube(), all_edges(centred_cube())); }

PolyMesh l_bracket() {
  // The outline of the L at y = 0 and y = 1, and quads between; the L's two sides are cut into three squares each.
  return mesh_of({{0, 0, 0},
                  {1, 0, 0},
                  {2, 0, 0},
                  {2, 0, 1},
                  {1, 0, 1},
                  {1, 0, 2},
                  {0, 0, 2},
                  {0, 0, 1},
                  {0, 1, 0},
                  {1, 1, 0},
                  {2, 1, 0},
                  {2, 1, 1},
                  {1, 1, 1},
                  {1, 1, 2},
                  {0, 1, 2},
                  {0, 1, 1}},
                 {{0, 1, 4, 7},
                  {1, 2, 3, 4},
                  {7, 4, 5, 6},
                  {8, 15, 12, 9},
                  {9, 12, 11, 10},
                  {15, 14, 13, 12},
                  {1, 0, 8, 9},
                  {2, 1, 9, 10},
                  {3, 2, 10, 11},
                  {4, 3, 11, 12},
                  {5, 4, 12, 13},
                  {6, 5, 13, 14},
                  {7, 6, 14, 15},
                  {0, 7, 15, 8}});
}

PolyMesh icosahedron() {
  const double g = std::numbers::phi;
  return mesh_of({{-1, g, 0},
                  {1, g, 0},
                  {-1, -g, 0},
                  {1, -g, 0},
                  {0, -1, g},
                  {0, 1, g},
                  {0, -1, -g},
                  {0, 1, -g},
                  {g, 0, -1},
                  {g, 0, 1},
                  {-g, 0, -1},
                  {-g, 0, 1}},
                 {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
}

PolyMesh pyramid(Index sides) {
  PolyMesh mesh;
  for (Index i = 0; i < sides; ++i) mesh.positions.push_back(ring_point({1, 0}, sides, i));
  mesh.positions.emplace_back(0, 0, 1.5);
  std::vector<Index> base(sides);
  std::iota(base.rbegin(), base.rend(), Index{0});
  mesh.add_face(base);
  for (Index i = 0; i < sides; ++i) mesh.add_triangle(i, (i + 1) % sides, sides);
  return mesh;
}

PolyMesh house() {
  return mesh_of(
      {{0, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 2}, {0, 0, 1}, {0, 3, 0}, {2, 3, 0}, {2, 3, 1}, {1, 3, 2}, {0, 3, 1}},
      {{0, 1, 2, 3, 4}, {9, 8, 7, 6, 5}, {1, 0, 5, 6}, {2, 1, 6, 7}, {3, 2, 7, 8}, {4, 3, 8, 9}, {0, 4, 9, 5}});
}

PolyMesh valence_two_disc() {
  // A 2 x 2 ring of quads around a hole that two quads fill, with vertex 8 between them.
  return mesh_of(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1.5, 1.5, 0.5}},
      {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 8}, {6, 7, 4, 8}});
}

PolyMesh mixed_disc() {
  return mesh_of({{0, 0, 0},
                  {1, 0, 0},
                  {2, 0, 0},
                  {3, 0, 0},
                  {0, 1, 0},
                  {1, 1, 0.4},
                  {2, 1, 0.5},
                  {3, 1, 0},
                  {0, 2, 0},
                  {1, 2, 0.3},
                  {2, 2, 0.2},
                  {3, 2, 0},
                  {1.5, 3, 0}},
                 {{0, 1, 5},
                  {0, 5, 4},
                  {1, 2, 6, 5},
                  {2, 3, 7},
                  {2, 7, 6},
                  {4, 5, 9, 8},
                  {5, 6, 7, 11, 10, 9},
                  {8, 9, 10, 11, 12}});
}

PolyMesh single_face(Index sides) {
  PolyMesh mesh = pyramid(sides);
  mesh.positions.pop_back();
  mesh.corners.resize(sides);
  mesh.face_offsets = {0, sides};
  return mesh;
}

PolyMesh back_to_back(Index sides) {
  PolyMesh mesh = single_face(sides);
  std::vector<Index> back(mesh.corners.rbegin(), mesh.corners.rend());
  mesh.add_face(back);
  return mesh;
}

std::vector<NamedCage> all_cages() {
  return {{"bolt", bolt()},
          {"hex bolt", hex_bolt()},
          {"cube", centred_cube()},
          {"L-bracket", l_bracket()},
          {"icosahedron", icosahedron()},
          {"pyramid of 7", pyramid(7)},
          {"house", house()},
          {"disc with valence 2", valence_two_disc()},
          {"mixed disc", mixed_disc()},
          {"triangle", single_face(3)},
          {"two pentagons", back_to_back(5)},
          {"torus", torus(5, 4)},
          {"double torus", double_torus()},
          {"sphere", uv_sphere(6, 4)},
          {"grid", grid(4, 3)}};
}

std::vector<VertexPair> all_edges(const PolyMesh& mesh) {
  std::vector<VertexPair> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [low, high] = std::minmax(face[i], face[(i + 1) % face.size()]);
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

PolyMesh tagged(PolyMesh mesh, std::span<const VertexPair> edges, double sharpness) {
  for (const VertexPair& edge : edges) mesh.tags.creases.push_back({edge, sharpness});
  return mesh;
}

}  // namespace croquis::test
