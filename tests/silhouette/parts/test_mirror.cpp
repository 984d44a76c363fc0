// SPDX-License-Identifier: GPL-3.0-or-later
// Solids of symmetric drawings.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/silhouette/stroke_data.h"
#include "silhouette/solids.h"
#include "silhouette/surface_quality.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::check_sound;

namespace {

Stroke loop(const std::string& id, const Vec2& middle, const Vec2& radii, double wave = 0) {
  Stroke stroke;
  stroke.id = id;
  stroke.closed = true;
  for (int k = 0; k < 120; ++k) {
    const double angle = 2 * 3.14159265358979 * (k + 0.5) / 120;
    const double factor = 1 + wave * std::cos(4 * angle);
    stroke.samples.push_back({middle + factor * Vec2(radii.x() * std::cos(angle), radii.y() * std::sin(angle))});
  }
  return stroke;
}

void add_pair(Drawing& drawing, Stroke stroke, double axis) {
  stroke.data[mirror_key] = std::to_string(axis);
  Stroke twin = stroke;
  twin.id += "'";
  twin.data[twin_key] = stroke.id;
  stroke.data[twin_key] = twin.id;
  for (StrokeSample& sample : twin.samples) sample.position.x() = 2 * axis - sample.position.x();
  drawing.strokes.push_back(std::move(stroke));
  drawing.strokes.push_back(std::move(twin));
}

/// A body with ears and eyes, and legs that lie apart. @param size factor of all lengths
Drawing creature(double axis, double size) {
  Drawing drawing;
  Stroke body = loop("body", {axis, 0}, size * Vec2(120, 150), 0.04);
  body.data[mirror_key] = std::to_string(axis);
  drawing.strokes.push_back(body);
  add_pair(drawing, loop("ear", {axis - 75 * size, 150 * size}, size * Vec2(28, 60)), axis);
  add_pair(drawing, loop("leg", {axis - 60 * size, -160 * size}, size * Vec2(30, 70)), axis);
  return drawing;
}

using Place = std::array<double, 3>;

/// The distance of each vertex from the plane, with its other coordinates.
std::pair<std::multiset<Place>, std::multiset<Place>> sides_of(const PolyMesh& mesh, double axis) {
  std::multiset<Place> left, right;
  for (const Vec3& place : mesh.positions) {
    if (place.x() < axis) left.insert({2 * axis - place.x(), place.y(), place.z()});
    if (place.x() > axis) right.insert({place.x(), place.y(), place.z()});
  }
  return {left, right};
}

}  // namespace

TEST_CASE("the halves of a symmetric drawing's solid have the same numbers", "[mirror]") {
  for (const double size : {0.02, 1.0, 50.0}) {
    for (const double axis : {0.0, 300.0 * size}) {
      for (const bool joined : {false, true}) {
        INFO(size << " " << axis << " " << joined);
        Options options;
        options.attach_suggested = joined;
        const Drawing drawing = creature(axis, size);
        const Solid solid = test::solid_of(drawing, options);
        for (const Finding& finding : solid.findings) CHECK(finding.code != "W_MIRROR");
        const auto [left, right] = sides_of(solid.mesh, axis);
        CHECK(left.size() > 500);
        CHECK(left == right);
        check_sound(solid.mesh);
        CHECK(solid.diagnostics.silhouette_iou > 0.97);
      }
    }
  }
}

TEST_CASE("faces of a mirrored half belong to the twin, and one stroke without a line ends the symmetry", "[mirror]") {
  Drawing drawing = creature(10, 1);
  const Solid solid = test::solid_of(drawing);
  const AttributeChannel& owner = *solid.mesh.channel("object", Domain::Face);
  std::vector<double> highest(owner.labels.size(), -1e9), lowest(owner.labels.size(), 1e9);
  for (Index face = 0; face < solid.mesh.face_count(); ++face) {
    const auto object = static_cast<std::size_t>(std::get<std::vector<std::int32_t>>(owner.data)[face]);
    for (const Index vertex : solid.mesh.face(face)) {
      highest[object] = std::max(highest[object], solid.mesh.positions[vertex].x());
      lowest[object] = std::min(lowest[object], solid.mesh.positions[vertex].x());
    }
  }
  for (std::size_t object = 0; object < solid.objects.size(); ++object) {
    const Stroke& stroke = drawing.strokes[solid.objects[object].strokes.front()];
    if (!stroke.data.contains(twin_key)) continue;
    CHECK((stroke.samples.front().position.x() < 10) == (highest[object] < 10));
    CHECK((stroke.samples.front().position.x() > 10) == (lowest[object] > 10));
  }
  drawing.strokes[0].data.erase(mirror_key);
  const auto [left, right] = sides_of(test::solid_of(drawing).mesh, 10);
  CHECK(left != right);
}
