// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette/solids.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "silhouette/surface_quality.h"
#include "support/sketches/characters/character.h"

namespace croquis::test {
namespace {

double plane_slope(const PolyMesh& mesh) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  const Vec3 origin = mesh.positions.front();
  for (const Vec3& position : mesh.positions) {
    const Vec3 place = position - origin;
    const Vec3 row(place.x(), place.y(), 1);
    normal += row * row.transpose();
    right += place.z() * row;
  }
  const Vec3 plane = normal.fullPivHouseholderQr().solve(right);
  return plane.head<2>().norm();
}

}  // namespace

silhouette::Solid solid_of(const Drawing& drawing, const silhouette::Options& options) {
  Progress progress;
  return inflate(silhouette::label(drawing, options, progress), drawing, options, progress);
}

silhouette::Solid solid_of(const FigureFixture& fixture, const silhouette::Options& options) {
  Progress progress;
  silhouette::LabelledDrawing labelled;
  labelled.figures.push_back(fixture.figure);
  return inflate(labelled, fixture.drawing, options, progress);
}

MeshReport report_of(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, true, progress);
}

void check_sound(const PolyMesh& mesh) {
  const MeshReport figures = report_of(mesh);
  CHECK(figures.closed);
  CHECK(figures.oriented);
  CHECK(figures.nonmanifold_edges == 0);
  CHECK(figures.nonmanifold_vertices == 0);
  CHECK(figures.degenerate_faces == 0);
  CHECK(figures.self_intersections == std::size_t{0});
  CHECK(figures.volume.value_or(0) > 0);
}

PolyMesh part_named(const silhouette::Solid& solid, const std::string& name) {
  const auto& labels = solid.mesh.channel("object", Domain::Face)->labels;
  const auto place = std::ranges::find(labels, name);
  REQUIRE(place != labels.end());
  return part_of(solid.mesh, static_cast<int>(place - labels.begin()));
}

double depth_of(const PolyMesh& mesh) {
  const auto bounds = *report_of(mesh).bounds;
  return bounds[1].z() - bounds[0].z();
}

TriangleTree tree_of(const PolyMesh& mesh) {
  std::vector<std::array<Vec3, 3>> triangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    triangles.push_back({mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]});
  }
  return TriangleTree(std::move(triangles));
}

double slender_share(const PolyMesh& mesh) {
  const std::vector<double> angles = smallest_angles(mesh);
  const auto slender = std::ranges::lower_bound(angles, 15.0) - angles.begin();
  return static_cast<double>(slender) / static_cast<double>(angles.size());
}

Sketch character_named(const std::string& name) {
  const std::vector<Character> all = all_characters();
  const auto found = std::ranges::find(all, name, &Character::name);
  REQUIRE(found != all.end());
  return character_sketch(*found);
}

std::vector<PartDepth> part_depths(const silhouette::Solid& solid) {
  const AttributeChannel& channel = *solid.mesh.channel("object", Domain::Face);
  std::vector<PartDepth> parts;
  for (std::size_t object = 0; object < channel.labels.size(); ++object) {
    const PolyMesh mesh = part_of(solid.mesh, static_cast<int>(object));
    if (mesh.positions.empty()) continue;
    const auto by_height = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
    const auto [low, high] = std::minmax_element(mesh.positions.begin(), mesh.positions.end(), by_height);
    parts.push_back({channel.labels[object], low->z(), high->z(), plane_slope(mesh)});
  }
  return parts;
}

std::map<std::string, PartDepth> depths_by_name(const silhouette::Solid& solid) {
  std::map<std::string, PartDepth> parts;
  for (const PartDepth& part : part_depths(solid)) parts[part.name] = part;
  return parts;
}

double middle_spread(const std::vector<PartDepth>& parts) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double sum = 0;
  for (const PartDepth& part : parts) {
    low = std::min(low, part.middle());
    high = std::max(high, part.middle());
    sum += part.depth();
  }
  return parts.empty() ? 0 : (high - low) / sum;
}

double steepest(const std::vector<PartDepth>& parts) {
  double most = 0;
  for (const PartDepth& part : parts) most = std::max(most, part.slope);
  return most;
}

}  // namespace croquis::test
