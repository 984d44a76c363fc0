// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "attribute_surface/network_samples.h"
#include "croquis/attribute_surface/attribute_surface.h"
#include "croquis/attribute_surface/face_edit.h"
#include "croquis/attribute_surface/network_mirror.h"
#include "support/random.h"

namespace croquis {
namespace {

using test::rich_sheet;
using test::text_of;

/// The sheet lies at x >= 0 with a row of curves in the plane x = 0 once that row is flattened.
const SymmetryPlane plane{{0, 0, 0}, {2, 0, 0}};

AttributeNetwork half_sheet() {
  AttributeNetwork network = rich_sheet(2, 2);
  for (AttributeNode& node : network.nodes) node.point.x() = std::abs(node.point.x()) < 0.1 ? 0 : node.point.x();
  for (AttributeCurve& curve : network.curves) {
    const bool in_plane = std::ranges::all_of(curve.control, [](const Vec3& p) { return std::abs(p.x()) < 0.1; });
    for (Vec3& place : curve.control) place.x() = in_plane ? 0 : place.x();
  }
  return network;
}

AttributeNetwork whole_sheet() { return mirror_network(half_sheet(), plane, 1e-6).network; }

bool is_symmetric(const AttributeNetwork& network) {
  const NetworkPartners partners = find_partners(network, plane, 1e-9);
  const auto all = [](const std::vector<Index>& found) { return std::ranges::find(found, no_index) == found.end(); };
  return all(partners.nodes) && all(partners.curves) && all(partners.faces) && all(partners.points);
}

TEST_CASE("a mirrored network shares what lies in the plane, and mirroring it again adds nothing") {
  const AttributeNetwork half = half_sheet();
  const MirroredNetwork whole = mirror_network(half, plane, 1e-6);
  CHECK(validate(whole.network).empty());
  CHECK(whole.network.nodes.size() == 2 * half.nodes.size() - 3);
  CHECK(whole.network.curves.size() == 2 * half.curves.size() - 2);
  CHECK(whole.network.faces.size() == 2 * half.faces.size());
  CHECK(whole.network.points.size() == 2 * half.points.size());
  CHECK(whole.network.slopes.size() == 2 * half.slopes.size());
  CHECK(whole.added.nodes.front() == "n1_0_m");
  CHECK(whole.findings.empty());
  CHECK(is_symmetric(whole.network));
  CHECK(text_of(mirror_network(whole.network, plane, 1e-6).network) == text_of(whole.network));
}

TEST_CASE("curves at one place are mirrored to different curves, so that no loop has one twice") {
  AttributeNetwork network;
  network.nodes = {{"a", {1, 0, 0}}, {"b", {1, 1, 0}}, {"c", {-1, 0, 0}}, {"d", {-1, 1, 0}}};
  network.curves = {{"first", 0, 1, {}}, {"second", 0, 1, {}}, {"other", 2, 3, {}}};
  AttributeFace face;
  face.id = "face";
  face.loop = {{0, false}, {1, true}};
  network.faces = {face};
  REQUIRE(validate(network).empty());
  const MirroredNetwork whole = mirror_network(network, plane, 1e-6);
  CHECK(validate(whole.network).empty());
  CHECK(whole.network.curves.size() == 4);
  CHECK(whole.network.faces.size() == 2);
  CHECK(is_symmetric(whole.network));
}

TEST_CASE("surfaces of mirrored networks are symmetric, and their normals point to the mirrored side") {
  const AttributeNetwork whole = whole_sheet();
  Progress progress;
  const AttributeSurface surface = make_attribute_surface(whole, progress);
  const std::size_t count = whole.faces.size() / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const FaceSurface& original = *surface.faces[i].surface;
    const FaceSurface& image = *surface.faces[i + count].surface;
    CHECK(surface.faces[i].flipped == surface.faces[i + count].flipped);
    for (const double a : {0.1, 0.3, 0.5}) {
      // Corner k of the loop turned round is corner n - k.
      const Vec3 place = original.at(place_in(original.domain(), {1, a, 0.2}));
      const Vec3 mirror = image.at(place_in(image.domain(), {2, 0.2, a}));
      CHECK((mirrored(place, plane) - mirror).norm() < 1e-9);
      Vec3 normal = original.normal(place_in(original.domain(), {1, a, 0.2}));
      normal.x() = -normal.x();
      CHECK((normal - image.normal(place_in(image.domain(), {2, 0.2, a}))).norm() < 1e-6);
    }
  }
}

TEST_CASE("curves that cross the plane are named") {
  AttributeNetwork box = test::wire_box();
  const SymmetryPlane oblique{{0.4, 0, 0}, {1, 0.2, 0}};
  const MirroredNetwork mirrored = mirror_network(box, oblique, 1e-6);
  CHECK(validate(mirrored.network).empty());
  REQUIRE(mirrored.findings.size() >= 4);
  CHECK(mirrored.findings.front().code == "W_MIRROR_CROSSING");
  CHECK(mirror_network(box, {{0.5, 0, 0}, {1, 0, 0}}, 1e-6).added.empty());  // symmetric as it is
}

TEST_CASE("edits done on both sides leave symmetric networks symmetric") {
  const AttributeNetwork whole = whole_sheet();
  const NetworkPartners partners = find_partners(whole, plane, 1e-6);
  const auto on_both = [&](const AttributeNetwork& edited) {
    AttributeNetwork result = with_symmetric_edit(whole, edited, plane, partners);
    CHECK(validate(result).empty());
    return result;
  };
  const auto check = [&](const char* what, const AttributeNetwork& edited) {
    INFO(what);
    const AttributeNetwork result = on_both(edited);
    CHECK(is_symmetric(result));
    CHECK(text_of(result) != text_of(whole));
  };
  const Vec3 by(0.05, 0.1, -0.2);
  check("node", move_nodes(whole, {"n2_1"}, by));
  check("node of the image", move_nodes(whole, {"n2_1_m"}, by));
  check("node in the plane", move_nodes(whole, {"n0_1"}, by));
  check("both", move_nodes(whole, {"n2_1", "n2_1_m"}, by));
  check("handle", move_handles(whole, {{"u0_0", 1}}, by));
  check("split", split_curve(whole, "u1_1", 0.3).network);
  check("split in the plane", split_curve(whole, "v0_0", 0.3).network);
  check("join", set_join(whole, {"u1_1"}, CurveJoin::Crease));
  check("slope", set_slope(whole, {"v1_0", "f0_0"}, {0.3, Vec3(0.2, 0, 1), {}}));
  check("settings", set_faces(whole, {"f1_1"}, {AttributeMode::Position, {}, 0.2}));
  check("point", move_points(whole, {"p1"}, by));
  check("new point", add_point(whole, {"f1_0", {1.4, 0.3, 0.5}, FanPlace{0, 0.1, 0.3}, {}, {}}).network);
  check("delete curve", delete_elements(whole, {{}, {"u1_1"}, {}, {}}));
  check("delete face", delete_elements(whole, {{}, {}, {"f1_1"}, {}}));
  check("delete node", delete_elements(whole, {{"n1_1"}, {}, {}, {}}));
  check("delete point", delete_elements(whole, {{}, {}, {}, {"p2"}}));
  check("merge nodes", merge_nodes(whole, "n2_1", "n2_2"));
  check("merge with the image", merge_nodes(whole, "n1_1", "n1_1_m"));
  check("new curve", add_curve(whole, {"n0_0", "n1_1", {}, CurveJoin::Smooth, false}).network);
  check("split face",
        split_face(add_curve(whole, {"n1_0", "n2_1", {}, {}, false}).network, "f1_0", "c1", 1e-6).network);
}

TEST_CASE("an edit on both sides is the edit itself where there is no other side") {
  const AttributeNetwork box = test::wire_box();
  const SymmetryPlane far{{100, 0, 0}, {1, 0, 0}};
  const AttributeNetwork edited = move_nodes(box, {"n3"}, {0, 0, 1});
  CHECK(text_of(with_symmetric_edit(box, edited, far, find_partners(box, far, 1e-6))) == text_of(edited));
}

}  // namespace
}  // namespace croquis
