// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
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

Solid solid_of(const CurveNetwork& network, const SolidOptions& options = {}) {
  Progress progress;
  return make_solid(network, polynomial_pieces(network), faces_of(network).best, progress, options);
}

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
  const PatchPoint p = patch_on_side(face, static_cast<std::size_t>(std::ranges::find(around, half) - around.begin()), t);
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
  return worst;
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
    WARN(test.name << ": volume " << *mesh.volume << ", triangles " << mesh.faces << ", smooth edges " << smooth.edges
                   << " angle " << smooth.angle << " spokes " << smooth.spoke_angle << " gap " << smooth.gap
                   << " least cosine " << least_triangle_cosine(solid.tessellation.mesh));
  }
}

TEST_CASE("nets of arcs become smooth balls") {
  for (const PolyhedronNet& net : sphere_nets()) {
    for (const double noise : {0.0, 0.1}) {
      for (const SlopeRule slope : {SlopeRule::Mean, SlopeRule::Proportion, SlopeRule::Fair}) {
        SolidOptions options;
        options.patches.slope = slope;
        const Solid solid = solid_of(noise > 0 ? perturbed(net.network, noise, 5) : net.network, options);
        const SmoothFigures smooth = smooth_figures(solid.brep);
        WARN(net.name << " noise " << noise << " rule " << int(slope) << ": radius error % "
                      << 100 * radius_error(solid.brep) << " smooth " << smooth.edges << "/" << solid.brep.edges.size()
                      << " angle " << smooth.angle << " spokes " << smooth.spoke_angle << " gap " << smooth.gap
                      << " warnings " << solid.warnings.size());
        CHECK(smooth.angle < 1e-6);
        CHECK(smooth.spoke_angle < 1e-6);
        CHECK(smooth.gap < 1e-12);
      }
    }
  }
}
