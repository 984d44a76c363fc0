// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_report.h"
#include "croquis/perspective/solid.h"
#include "perspective/network_shapes.h"
#include "support/perspective/solids.h"

using namespace croquis;
using namespace croquis::test;

namespace {

constexpr double degrees = 180 / std::numbers::pi;

MeshReport report_of(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, true, progress);
}

/// Where a face's patches are at t along the i-th half-edge of their loop.
PatchPoint patch_on_side(const BrepFace& face, std::size_t i, double t) {
  const auto on_side = [](const GregoryPatch& patch, std::size_t side, double s) {
    switch (side) {
      case 0: return patch.at(s, 0);
      case 1: return patch.at(1, s);
      case 2: return patch.at(1 - s, 1);
      default: return patch.at(0, 1 - s);
    }
  };
  if (face.patches.size() == 1) return on_side(face.patches[0], i, t);
  if (t <= 0.5) return on_side(face.patches[i], 0, 2 * t);
  return on_side(face.patches[(i + 1) % face.patches.size()], 3, 2 * t - 1);
}

/// Position and normal of a half-edge's face at t along the half-edge.
std::pair<Vec3, Vec3> face_along(const Brep& brep, Index half, double t) {
  const BrepFace& face = brep.faces[brep.face_of(half)];
  if (face.planar) return {Vec3::Zero(), face.normal};
  const std::vector<Index> around = brep.around(face.loops[0]);
  const PatchPoint p =
      patch_on_side(face, static_cast<std::size_t>(std::ranges::find(around, half) - around.begin()), t);
  return {p.at, p.normal()};
}

struct SmoothFigures {
  std::size_t edges = 0;
  double angle = 0;        ///< degrees, largest between the faces of a smooth edge
  double gap = 0;          ///< largest between a patch's side and the fitted cubic
  double spoke_angle = 0;  ///< degrees, between neighbouring patches of a face
};

SmoothFigures smooth_figures(const Brep& brep) {
  SmoothFigures figures;
  constexpr int samples = 40;
  for (const BrepEdge& edge : brep.edges) {
    figures.edges += edge.smooth ? 1U : 0U;
    for (int k = 0; k <= samples; ++k) {
      const double t = static_cast<double>(k) / samples;
      const Vec3 drawn = edge.fitted.size() == 1 ? edge.fitted[0].at(t)
                         : t <= 0.5              ? edge.fitted[0].at(2 * t)
                                                 : edge.fitted[1].at(2 * t - 1);
      std::array<Vec3, 2> normals;
      for (const int side : {0, 1}) {
        const Index half = edge.half_edges[static_cast<std::size_t>(side)];
        if (half == no_index) continue;
        const auto [at, normal] = face_along(brep, half, side == 0 ? t : 1 - t);
        normals[static_cast<std::size_t>(side)] = normal;
        if (!brep.faces[brep.face_of(half)].planar) figures.gap = std::max(figures.gap, (at - drawn).norm());
      }
      if (edge.smooth) figures.angle = std::max(figures.angle, degrees * angle_between(normals[0], normals[1]));
    }
  }
  for (const BrepFace& face : brep.faces) {
    for (std::size_t i = 0; face.patches.size() > 1 && i < face.patches.size(); ++i) {
      for (int k = 0; k <= samples; ++k) {
        const double t = static_cast<double>(k) / samples;
        const PatchPoint a = face.patches[i].at(1, t), b = face.patches[(i + 1) % face.patches.size()].at(t, 1);
        figures.gap = std::max(figures.gap, (a.at - b.at).norm());
        figures.spoke_angle = std::max(figures.spoke_angle, degrees * angle_between(a.normal(), b.normal()));
      }
    }
  }
  return figures;
}

/// The largest error of the radius, of patches over the unit sphere.
double radius_error(const Brep& brep) {
  double worst = 0;
  for (const BrepFace& face : brep.faces) {
    for (const GregoryPatch& patch : face.patches) {
      for (int i = 0; i <= 20; ++i) {
        for (int j = 0; j <= 20; ++j) {
          const double error = patch.at(i / 20.0, j / 20.0).at.norm() - 1;
          if (std::abs(error) > std::abs(worst)) worst = error;
        }
      }
    }
  }
  return std::abs(worst);
}

/// The least cosine between a triangle and the normals of its corners.
double least_triangle_cosine(const PolyMesh& mesh) {
  const auto& normals = std::get<std::vector<double>>(mesh.channel("normal", Domain::Corner)->data);
  double least = 1;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    const Vec3 normal = (mesh.positions[corners[1]] - mesh.positions[corners[0]])
                            .cross(mesh.positions[corners[2]] - mesh.positions[corners[0]])
                            .normalized();
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t k = 3 * (3 * f + c);
      least = std::min(least, normal.dot(Vec3(normals[k], normals[k + 1], normals[k + 2])));
    }
  }
  return least;
}

}  // namespace

TEST_CASE("solids of all test networks are closed, with the true genus") {
  for (const PerspectiveSolid& test : all_solids()) {
    INFO(test.name);
    const Solid solid = solid_of(test.network);
    CHECK(validate(solid.brep).empty());
    const BrepFigures figures = inspect(solid.brep);
    CHECK(figures.open_edges == 0);
    CHECK(figures.vertices == test.network.vertices.size());
    CHECK(figures.rings == static_cast<std::size_t>(test.rings()));
    CHECK(figures.genus == test.genus);
    CHECK(solid.warnings.empty());

    const MeshReport mesh = report_of(solid.tessellation.mesh);
    CHECK(mesh.closed);
    CHECK(mesh.oriented);
    CHECK(mesh.nonmanifold_edges + mesh.nonmanifold_vertices + mesh.degenerate_faces == 0);
    CHECK(mesh.euler_characteristic == 2 * (test.shells - test.genus));
    CHECK(mesh.self_intersections == 0);
    CHECK(*mesh.volume > 0);
    CHECK(least_triangle_cosine(solid.tessellation.mesh) > 0);

    const SmoothFigures smooth = smooth_figures(solid.brep);
    CHECK(smooth.angle < 1e-6);
    CHECK(smooth.spoke_angle < 1e-6);
    CHECK(smooth.gap < 1e-12);
  }
}

TEST_CASE("nets of arcs become smooth balls") {
  const std::map<std::string, double> greatest_error = {
      {"cube", 0.012}, {"octahedron", 0.003}, {"dodecahedron", 0.004}, {"prism", 0.025}};
  for (const PolyhedronNet& net : sphere_nets()) {
    INFO(net.name);
    const Solid solid = solid_of(net.network);
    CHECK(solid.warnings.empty());
    const SmoothFigures smooth = smooth_figures(solid.brep);
    CHECK(smooth.edges == net.network.curves.size());
    CHECK(smooth.angle < 1e-6);
    CHECK(smooth.spoke_angle < 1e-6);
    CHECK(smooth.gap < 1e-12);
    CHECK(radius_error(solid.brep) < greatest_error.at(net.name));
  }
}

TEST_CASE("bent nets are smooth where their strokes allow it") {
  for (const PolyhedronNet& net : sphere_nets()) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      INFO(net.name << " " << seed);
      const Solid solid = solid_of(perturbed(net.network, 0.05, seed));
      const SmoothFigures smooth = smooth_figures(solid.brep);
      CHECK(smooth.angle < 1e-6);
      CHECK(smooth.spoke_angle < 1e-6);
      CHECK(smooth.gap < 1e-12);
      CHECK(2 * smooth.edges > net.network.curves.size());
      const MeshReport mesh = report_of(solid.tessellation.mesh);
      CHECK(mesh.closed);
      CHECK(mesh.self_intersections == 0);
      CHECK(least_triangle_cosine(solid.tessellation.mesh) > 0);
    }
  }
}

TEST_CASE("volumes are those of the solids") {
  const auto volume = [](const PerspectiveSolid& test) {
    return *report_of(solid_of(test.network).tessellation.mesh).volume;
  };
  CHECK(volume(box()) == Approx(24).epsilon(1e-12));
  CHECK(volume(cylinder()) == Approx(std::numbers::pi * 1.3 * 1.3 * 2).epsilon(1e-3));
  CHECK(volume(ball()) == Approx(4 * std::numbers::pi / 3 * std::pow(1.5, 3)).epsilon(6e-3));
}

TEST_CASE("a cavity counts as negative volume") {
  const CurveNetwork network = joined(box().network, moved(box().network, 0.4, Vec3(1, 1, 0.5)), "inner");
  const Solid solid = solid_of(network);
  const double inner = 24 * 0.4 * 0.4 * 0.4;
  std::vector<double> volumes = solid.tessellation.volume;
  std::ranges::sort(volumes);
  REQUIRE(volumes.size() == 2);
  CHECK(volumes[0] == Approx(-inner));
  CHECK(volumes[1] == Approx(24));
  CHECK(inspect(solid.brep).genus == 0);
  CHECK(*report_of(solid.tessellation.mesh).volume == Approx(24 - inner));
}

TEST_CASE("edges of two cubics lead to stars and stay smooth") {
  for (const PolyhedronNet& net : sphere_nets()) {
    INFO(net.name);
    std::vector<FittedCurve> fitted = polynomial_pieces(net.network);
    for (std::size_t c = 0; c < fitted.size(); c += 3) {
      const auto [first, second] = fitted[c].pieces[0].split(0.5);
      fitted[c].pieces = {first, second};
    }
    Progress progress;
    const Solid solid = make_solid(net.network, fitted, faces_of(net.network).best, progress);
    const SmoothFigures smooth = smooth_figures(solid.brep);
    CHECK(smooth.edges == net.network.curves.size());
    CHECK(smooth.angle < 1e-6);
    CHECK(smooth.spoke_angle < 1e-6);
    CHECK(smooth.gap < 1e-12);
    CHECK(radius_error(solid.brep) < 0.06);
    const MeshReport mesh = report_of(solid.tessellation.mesh);
    CHECK(mesh.closed);
    CHECK(mesh.self_intersections == 0);
  }
}

TEST_CASE("the mesh doesn't depend on order, direction and ids of strokes") {
  for (const PerspectiveSolid& test : all_solids()) {
    INFO(test.name);
    const PolyMesh mesh = solid_of(test.network).tessellation.mesh;
    const PolyMesh other = solid_of(shuffled(test.network, 7).first).tessellation.mesh;
    REQUIRE(other.corners == mesh.corners);
    double greatest = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      greatest = std::max(greatest, (mesh.positions[v] - other.positions[v]).norm());
    }
    CHECK(greatest < 1e-12);
  }
}

TEST_CASE("an open shell is built") {
  const CurveNetwork network =
      line_network({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const Solid solid = solid_of(network);
  CHECK(validate(solid.brep).empty());
  CHECK(inspect(solid.brep).open_edges == 4);
  CHECK(!inspect(solid.brep).genus);
  CHECK(solid.tessellation.mesh.face_count() == 2);
}

TEST_CASE("solids that touch in a vertex get one each") {
  CurveNetwork network = joined(box().network, moved(box().network, 1, Vec3(4, 3, 2)), "b");
  for (NetworkCurve& curve : network.curves) {
    for (Index* end : {&curve.start, &curve.end}) {
      for (Index v = 0; v < *end; ++v) {
        if (network.vertices[v] == network.vertices[*end]) *end = v;
      }
    }
  }
  const Solid solid = solid_of(network);
  CHECK(solid.brep.vertices.size() == 16);
  CHECK(inspect(solid.brep).genus == 0);
  CHECK(report_of(solid.tessellation.mesh).nonmanifold_vertices == 0);
}

TEST_CASE("edges that strokes' planes keep from being smooth are named") {
  // The vertex where three arcs of an octahedron's face meet is pulled out: its legs span no plane, and the arcs can't
  // leave their own planes.
  CurveNetwork network = ball().network;
  const Index top = network.curves[0].start;
  for (NetworkCurve& curve : network.curves) {
    std::array<Vec3, 4>& p = curve.pieces[0].points;
    if (curve.start == top) p[1] += 0.08 * (p[1] - p[0]).norm() * network.vertices[top].normalized();
    if (curve.end == top) p[2] += 0.08 * (p[2] - p[3]).norm() * network.vertices[top].normalized();
  }
  const Solid solid = solid_of(network);
  CHECK(smooth_figures(solid.brep).angle < 1e-6);
  CHECK(report_of(solid.tessellation.mesh).closed);
}

TEST_CASE("a fine mesh is nearer to the surface than a coarse one") {
  SolidOptions fine;
  fine.tessellation.chord_tolerance = 0.00005;
  const double sphere = 4 * std::numbers::pi / 3 * std::pow(1.5, 3);
  const auto error = [&](const SolidOptions& options) {
    return sphere - solid_of(ball().network, options).tessellation.volume[0];
  };
  CHECK(error(fine) < error({}));
  CHECK(std::abs(error(fine)) < 0.003 * sphere);
}
