// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_report.h"
#include "croquis/perspective/patch_cage.h"
#include "croquis/perspective/solid.h"
#include "perspective/network_shapes.h"
#include "support/perspective/solids.h"

using namespace croquis;
using namespace croquis::test;

namespace {

PatchCage cage_of(const Brep& brep, std::size_t segments) {
  Progress progress;
  return make_patch_cage(brep, {segments}, progress);
}

/// Of a point and the curve, found by brute force.
double distance_to_curve(const BrepEdge& edge, const Vec3& point) {
  double least = 1e300;
  for (const RationalCubic& piece : edge.pieces) {
    double at = 0, step = 1.0 / 64;
    for (int i = 0; i <= 64; ++i) {
      if ((piece.at(i * step) - point).norm() < (piece.at(at) - point).norm()) at = i * step;
    }
    for (; step > 1e-9; step /= 2) {
      for (const double t : {std::max(at - step, 0.0), std::min(at + step, 1.0)}) {
        if ((piece.at(t) - point).norm() < (piece.at(at) - point).norm()) at = t;
      }
    }
    least = std::min(least, (piece.at(at) - point).norm());
  }
  return least;
}

using Edge = std::pair<Index, Index>;

Edge edge_of(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// The edges of a mesh that lie along an edge of the solid: both ends and the faces' plane tell it.
std::set<Edge> mesh_edges(const PolyMesh& mesh) {
  std::set<Edge> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) edges.insert(edge_of(face[i], face[(i + 1) % face.size()]));
  }
  return edges;
}

double reflex_corner(const PolyMesh& mesh) {
  double worst = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < face.size(); ++i)
      normal += mesh.positions[face[i]].cross(mesh.positions[face[(i + 1) % face.size()]]);
    normal.normalize();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 a = mesh.positions[face[(i + 1) % face.size()]] - mesh.positions[face[i]];
      const Vec3 b = mesh.positions[face[(i + 2) % face.size()]] - mesh.positions[face[(i + 1) % face.size()]];
      worst = std::max(worst, -a.cross(b).dot(normal) / (a.norm() * b.norm()));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("cages of solids are closed and have the solid's Euler number") {
  for (const PerspectiveSolid& test : all_solids()) {
    const Brep brep = solid_of(test.network).brep;
    for (const std::size_t segments : {2U, 4U, 8U}) {
      INFO(test.name << ", " << segments);
      const PatchCage cage = cage_of(brep, segments);
      CHECK(cage.warnings.empty());
      CHECK(validate(cage.mesh).empty());
      Progress progress;
      const MeshReport report = inspect(cage.mesh, true, progress);
      CHECK(report.closed);
      CHECK(report.oriented);
      CHECK(report.nonmanifold_vertices == 0);
      CHECK(report.euler_characteristic == 2 * (test.shells - test.genus));
      CHECK(*report.volume > 0);
      CHECK(report.self_intersections == 0);
      CHECK(reflex_corner(cage.mesh) < (segments == 2 ? 0.6 : 0.09));  // plane ones convex, those of patches nearly so
    }
  }
}

TEST_CASE("sharp edges of the solid are sharp in the cage, smooth ones aren't, and vertices lie on the exact curves") {
  for (const PerspectiveSolid& test : all_solids()) {
    INFO(test.name);
    const Brep brep = solid_of(test.network).brep;
    const PatchCage cage = cage_of(brep, 4);
    std::set<Edge> tagged;
    for (const Crease& crease : cage.mesh.tags.creases) {
      CHECK(crease.sharpness == infinite_sharpness);
      CHECK(tagged.insert(edge_of(crease.vertices[0], crease.vertices[1])).second);
    }
    const std::set<Edge> edges = mesh_edges(cage.mesh);
    CHECK(std::ranges::includes(edges, tagged));
    // Each tagged edge lies on one sharp edge of the solid; the ends of these are reached by chains of tagged ones.
    std::size_t expected = 0;
    for (const BrepEdge& edge : brep.edges) {
      const bool curved = std::ranges::any_of(
          edge.half_edges, [&](Index h) { return h != no_index && !brep.faces[brep.face_of(h)].planar; });
      const std::size_t parts = edge.straight && !curved ? 1 : 4;
      if (!edge.smooth) expected += parts;
    }
    std::size_t along_edges = 0;
    for (const auto& [a, b] : tagged) {
      const bool on_sharp = std::ranges::any_of(brep.edges, [&](const BrepEdge& edge) {
        return !edge.smooth && distance_to_curve(edge, cage.mesh.positions[a]) < 1e-7 &&
               distance_to_curve(edge, cage.mesh.positions[b]) < 1e-7;
      });
      along_edges += on_sharp ? 1U : 0U;
      if (on_sharp) continue;
      // A cut through a plane face, between two corners of the solid.
      for (const Index end : {a, b}) {
        REQUIRE(end < brep.vertices.size());
        CHECK(std::ranges::count_if(brep.edges, [&](const BrepEdge& edge) {
                return !edge.smooth && (edge.start == end || edge.end == end);
              }) > 2);
      }
      const auto is_in = [&](Index vertex, const BrepFace& face) {
        return std::abs(face.normal.dot(cage.mesh.positions[vertex] - face.origin)) < 1e-9;
      };
      CHECK(std::ranges::any_of(brep.faces,
                                [&](const BrepFace& face) { return face.planar && is_in(a, face) && is_in(b, face); }));
    }
    CHECK(along_edges == expected);
  }
}

TEST_CASE("plane faces of cages stay plane, and straight edges whole where no curve asks for more") {
  const PatchCage plain = cage_of(solid_of(box().network).brep, 8);
  CHECK(plain.mesh.vertex_count() == 8);
  CHECK(plain.mesh.face_count() == 6);
  CHECK(plain.mesh.tags.creases.size() == 12);
  const PatchCage step = cage_of(solid_of(l_block().network).brep, 8);
  CHECK(step.mesh.vertex_count() == 12);
  CHECK(step.mesh.face_count() == 6 + 2 * 2);  // each L is two convex parts
  const PatchCage frame = cage_of(solid_of(ring_frame().network).brep, 8);
  CHECK(frame.mesh.vertex_count() == 16);
  for (std::size_t f = 0; f < frame.mesh.face_count(); ++f) CHECK(frame.mesh.face(f).size() <= 6);
}
