// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/subdivision/shape_keeping.h"
#include "subdivision/refined.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::subdivision;
using namespace croquis::test;

namespace {

Vec3 area_vector(std::span<const Vec3> polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]) / 2;
  }
  return sum;
}

template <typename Face>
std::vector<Vec3> polygon_of(const Face& face, const std::vector<Vec3>& points) {
  std::vector<Vec3> polygon;
  for (const Index v : face) polygon.push_back(points[v]);
  return polygon;
}

/// Whether a point lies in a convex polygon, both at rounding's distance.
bool lies_in(const Vec3& point, const std::vector<Vec3>& polygon) {
  constexpr double rounding = 4e-15;
  const Vec3 normal = area_vector(polygon).normalized();
  if (std::abs((point - polygon[0]).dot(normal)) > rounding) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 along = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (normal.cross(along).dot(point - polygon[i]) < -rounding) return false;
  }
  return true;
}

/// The share of the region's area that faces of level k cover, each lying within one of the region's faces.
double covered_share(const Refined& result, int k, const PolyMesh& cage, std::span<const Index> region) {
  const HalfEdges& mesh = result.plan.level(k).topology;
  double covered = 0, whole = 0;
  for (const Index face : region) {
    const std::vector<Vec3> outline = polygon_of(cage.face(face), cage.positions);
    whole += area_vector(outline).norm();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const std::vector<Vec3> piece = polygon_of(mesh.face(f), result.at(k));
      const bool inside = std::all_of(piece.begin(), piece.end(), [&](const Vec3& p) { return lies_in(p, outline); });
      if (inside) covered += area_vector(piece).norm();
    }
  }
  return covered / whole;
}

PolyMesh wobbled(PolyMesh mesh, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : mesh.positions) p += 0.1 * Vec3(random.unit(), random.unit(), random.unit());
  return mesh;
}

double total_area(const PolyMesh& mesh, std::span<const Index> faces) {
  double area = 0;
  for (const Index f : faces) area += area_vector(polygon_of(mesh.face(f), mesh.positions)).norm();
  return area;
}

}  // namespace

TEST_CASE("Planar faces of a kept region are part of every level: nothing is beside them, nothing missing") {
  for (const Preset preset : {Preset::Refined, Preset::Paper}) {
    for (const PolyMesh& cage : {bolt(), house(), hex_bolt()}) {
      const std::vector<Index> faces = {0, 2, 5};
      const KeptRegion kept = keep_region(cage, faces);
      CHECK(kept.notices.empty());
      CHECK(kept.region == faces);
      const Refined result = refined(kept.mesh, 4, Rules::of(preset));
      for (int k = 0; k <= 4; ++k) {
        CHECK(covered_share(result, k, kept.mesh, kept.region) == Approx(1).margin(1e-12));
      }
    }
  }
}

TEST_CASE("Bent faces of a kept region are cut into triangles, which are kept exactly") {
  const PolyMesh cage = wobbled(bolt(), 3);
  const std::vector<Index> faces = {1, 2, 6};
  const KeptRegion kept = keep_region(cage, faces);
  REQUIRE(kept.notices.size() == 1);
  CHECK(kept.notices[0].code == "W_TRIANGULATED");
  CHECK(kept.notices[0].message.starts_with("3 faces"));
  CHECK(kept.region.size() == 6);
  CHECK(kept.mesh.face_count() == cage.face_count() + 3);
  for (std::size_t f = 0; f < kept.source_face.size(); ++f) {
    for (const Index v : kept.mesh.face(f)) {
      const auto source = cage.face(kept.source_face[f]);
      CHECK(std::find(source.begin(), source.end(), v) != source.end());
    }
  }
  const Refined result = refined(kept.mesh, 3);
  CHECK(covered_share(result, 3, kept.mesh, kept.region) == Approx(1).margin(1e-12));
}

TEST_CASE("Under Catmull-Clark the points of a kept planar region stay in its faces") {
  const std::vector<Index> top = {0};
  const KeptRegion kept = keep_region(bolt(), top);
  const UniformRefined result = uniformly_refined(kept.mesh, 4);
  const HalfEdges& mesh = result.plan.level(4).topology;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (result.plan.cage_face(4, face) != 0) continue;
    for (const Index v : mesh.face(face)) {
      CHECK(result.at(4)[v].z() == 1);
      CHECK(result.at(4)[v].cwiseAbs().head<2>().maxCoeff() <= 2);
    }
  }
  const std::vector<Vec3> corners(kept.mesh.positions.begin(), kept.mesh.positions.begin() + 4);
  CHECK(greatest_gap(corners, result.at(4)) == 0);
}

TEST_CASE("Polygons with reflex corners are cut along diagonals inside them") {
  PolyMesh star;
  for (int i = 0; i < 10; ++i) {
    const double radius = i % 2 == 0 ? 2 : 0.8, angle = std::numbers::pi * i / 5;
    star.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), i % 2 == 0 ? 0.05 : 0);
  }
  star.add_face(std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  const std::vector<Index> all = {0};
  const KeptRegion kept = keep_region(star, all);
  CHECK(kept.mesh.face_count() == 8);
  const double whole = 10 * 0.5 * 2 * 0.8 * std::sin(std::numbers::pi / 5);
  CHECK(total_area(kept.mesh, kept.region) == Approx(whole).epsilon(0.02));  // overlaps would add up
}

TEST_CASE("Attributes of faces and corners go along when faces are cut") {
  PolyMesh cage = wobbled(cube(), 1);
  std::vector<std::int32_t> ids(cage.face_count());
  for (std::size_t f = 0; f < ids.size(); ++f) ids[f] = static_cast<std::int32_t>(10 + f);
  std::vector<double> uv;
  for (const Index v : cage.corners) uv.insert(uv.end(), {static_cast<double>(v), -static_cast<double>(v)});
  cage.channels.push_back({"group", Domain::Face, 1, ids, {}});
  cage.channels.push_back({"uv", Domain::Corner, 2, uv, {}});
  const std::vector<Index> faces = {0, 3};
  const KeptRegion kept = keep_region(cage, faces);
  CHECK(validate(kept.mesh).empty());
  const auto& groups = std::get<std::vector<std::int32_t>>(kept.mesh.channel("group", Domain::Face)->data);
  for (std::size_t f = 0; f < groups.size(); ++f) CHECK(groups[f] == static_cast<int>(10 + kept.source_face[f]));
  const auto& coordinates = std::get<std::vector<double>>(kept.mesh.channel("uv", Domain::Corner)->data);
  for (std::size_t c = 0; c < kept.mesh.corners.size(); ++c) CHECK(coordinates[2 * c] == kept.mesh.corners[c]);
}

TEST_CASE("Keeping the outline tags and pins the border of a region and leaves its inside") {
  const PolyMesh cage = torus(12, 8);
  const std::vector<Index> faces = {0, 1, 8, 9};
  const PolyMesh kept = keep_outline(cage, faces);
  CHECK(kept.tags.creases.size() == 8);
  CHECK(kept.tags.pins.size() == 8);
  const MeshTopology topology(kept);
  const KeptRegion region = keep_region(cage, faces);
  CHECK(region.mesh.tags.pins.size() == 9);
  CHECK(region.mesh.tags.creases.size() >= 12);
  const Refined result = refined(kept, 3);
  for (const Index pin : kept.tags.pins) CHECK(greatest_gap({&cage.positions[pin], 1}, result.at(3)) == 0);
}

TEST_CASE("At the boundary regions are pinned but not tagged") {
  const PolyMesh cage = grid(3, 3);
  const std::vector<Index> corner_face = {0};
  CHECK(keep_outline(cage, corner_face).tags.creases.size() == 2);
  CHECK(keep_outline(cage, corner_face).tags.pins.size() == 4);
}

TEST_CASE("Tags that are there stay; a finite crease that is kept becomes infinite and leaves its set") {
  PolyMesh cage = bolt();
  cage.tags.creases = {{{1, 0}, 2}, {{12, 13}, 3}};
  cage.tags.pins = {15};
  cage.tags.sets = {{"rim", 2, {{0, 1}}, {}}, {"foot", 3, {{12, 13}}, {15}}};
  const std::vector<Index> top = {0};
  const PolyMesh kept = keep_outline(cage, top);
  CHECK(kept.tags.creases.size() == 5);
  CHECK(kept.tags.creases[0].sharpness == infinite_sharpness);
  CHECK(kept.tags.creases[1].sharpness == 3);
  CHECK(kept.tags.pins == std::vector<Index>{0, 1, 2, 3, 15});
  CHECK(kept.tags.sets[0].edges.empty());
  CHECK(kept.tags.sets[1].edges.size() == 1);
  CHECK(keep_outline(kept, top).tags == kept.tags);
}

TEST_CASE("Kinks above an angle are pinned, others not, and ends and crossings never") {
  const auto radians = [](double angle) { return angle * std::numbers::pi / 180; };
  CHECK(pin_kinks(bolt_loop(), radians(45)).tags.pins == std::vector<Index>{8, 9, 10, 11});
  CHECK(pin_kinks(bolt_loop(), radians(89.9)).tags.pins.size() == 4);
  CHECK(pin_kinks(bolt_loop(), radians(90.1)).tags.pins.empty());
  CHECK(pin_kinks(bolt_open_chain(), radians(45)).tags.pins == std::vector<Index>{9, 10});
  CHECK(pin_kinks(cube_all_sharp(), radians(45)).tags.pins.empty());
  const PolyMesh pinned = pin_kinks(bolt_loop(), radians(45));
  const Refined result = refined(pinned, 3);
  CHECK(greatest_gap(std::vector<Vec3>(pinned.positions.begin() + 8, pinned.positions.begin() + 12), result.at(3)) ==
        0);
}

TEST_CASE("A fully fixed polygon is its own limit") {
  PolyMesh fixed = bolt_loop();
  fixed.tags.pins = {8, 9, 10, 11};
  const Refined result = refined(fixed, 4);
  const Level& level = result.plan.level(4);
  for (const SharpEdge& sharp : level.sharp) {
    const Index corner = level.topology.edge_corner[sharp.edge];
    const Vec3& p = result.at(4)[level.topology.corner_vertex[corner]];
    CHECK(p.z() == 0);
    CHECK(p.cwiseAbs().head<2>().maxCoeff() == Approx(1).margin(1e-15));
  }
}

TEST_CASE("A face that isn't there is refused by name") {
  const std::vector<Index> faces = {0, 99};
  try {
    keep_region(bolt(), faces);
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.findings()[0].code == "E_INDEX");
    CHECK(error.findings()[0].message.find("face 99") != std::string::npos);
  }
}
