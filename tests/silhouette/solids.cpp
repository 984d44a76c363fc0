// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette/solids.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "silhouette/surface_quality.h"
#include "support/sketches/characters/character.h"

namespace croquis::test {

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

}  // namespace croquis::test
