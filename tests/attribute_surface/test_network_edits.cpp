// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include <catch2/catch.hpp>

#include "attribute_surface/network_samples.h"
#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/attribute_surface/face_edit.h"
#include "croquis/attribute_surface/loop_search.h"
#include "croquis/attribute_surface/network_mirror.h"
#include "croquis/base/error.h"
#include "support/random.h"

namespace croquis {
namespace {

using test::bent_sheet;
using test::Random;
using test::rich_sheet;
using test::text_of;

/// What every network has to be that began as one: valid, with curves that end at their nodes bit for bit and faces
/// whose sides meet in nodes.
void check_sound(const AttributeNetwork& network) {
  for (const Finding& finding : validate(network)) FAIL(finding.message);
  for (const AttributeCurve& curve : network.curves) {
    if (curve.control.empty()) continue;
    if (curve.from != no_index) CHECK((curve.control.front() - network.nodes[curve.from].point).norm() < 1e-12);
    if (curve.to != no_index) CHECK((curve.control.back() - network.nodes[curve.to].point).norm() < 1e-12);
  }
  for (const AttributeFace& face : network.faces) {
    REQUIRE(face.loop.size() >= 2);
    for (std::size_t i = 0; i < face.loop.size(); ++i)
      REQUIRE(end_node(network, face.loop[i]) == start_node(network, face.loop[(i + 1) % face.loop.size()]));
  }
}

/// One of the ids of a kind, as chance has it; empty for none.
std::string any_id(const AttributeNetwork& network, NetworkElement kind, Random& random) {
  const std::vector<std::string> ids = element_ids(network, kind);
  return ids.empty() ? std::string() : ids[random.below(static_cast<std::uint32_t>(ids.size()))];
}

Vec3 any_way(Random& random) {
  return {random.between(-0.2, 0.2), random.between(-0.2, 0.2), random.between(-0.2, 0.2)};
}

using RandomEdit = std::function<AttributeNetwork(const AttributeNetwork&, Random&)>;

const std::vector<RandomEdit>& random_edits() {
  static const SymmetryPlane plane{{1.5, 0, 0}, {1, 0, 0}};
  static const auto node = [](const auto& network, Random& random) {
    return any_id(network, NetworkElement::Node, random);
  };
  static const auto curve = [](const auto& network, Random& random) {
    return any_id(network, NetworkElement::Curve, random);
  };
  static const auto face = [](const auto& network, Random& random) {
    return any_id(network, NetworkElement::Face, random);
  };
  static const auto point = [](const auto& network, Random& random) {
    return any_id(network, NetworkElement::Point, random);
  };
  static const std::vector<RandomEdit> edits = {
      [](auto& n, auto& r) {
        return move_nodes(n, {node(n, r), node(n, r)}, any_way(r));
      },
      [](auto& n, auto& r) {
        return move_handles(n, {{curve(n, r), r.below(4)}, {curve(n, r), r.below(4)}}, any_way(r));
      },
      [](auto& n, auto& r) { return move_curves(n, {curve(n, r)}, any_way(r)); },
      [](auto& n, auto& r) { return split_curve(n, curve(n, r), r.between(0.1, 0.9)).network; },
      [](auto& n, auto& r) {
        return set_join(n, {curve(n, r)}, r.below(2) == 0 ? CurveJoin::Crease : CurveJoin::Smooth);
      },
      [](auto& n, auto& r) {
        return set_slope(n, {curve(n, r), {}}, {r.unit(), any_way(r), 1.2});
      },
      [](auto& n, auto& r) {
        return remove_slope(n, {curve(n, r), {}}, r.below(2) == 0 ? std::optional(0.25) : std::nullopt);
      },
      [](auto& n, auto& r) { return merge_nodes(n, node(n, r), node(n, r)); },
      [](auto& n, auto& r) { return merge_faces(n, curve(n, r)); },
      [](auto& n, auto& r) {
        return delete_elements(n, {{node(n, r)}, {}, {}, {}});
      },
      [](auto& n, auto& r) {
        return delete_elements(n, {{}, {curve(n, r)}, {}, {point(n, r)}});
      },
      [](auto& n, auto& r) {
        return delete_elements(n, {{}, {}, {face(n, r)}, {}});
      },
      [](auto& n, auto& r) { return turn_faces(n, {face(n, r)}); },
      [](auto& n, auto& r) {
        return set_faces(n, {face(n, r)}, {AttributeMode::Position, {}, r.between(-1, 2)});
      },
      [](auto& n, auto& r) {
        return add_point(n, {face(n, r), any_way(r), FanPlace{1, 0.2, 0.3}, 0.1, {}}).network;
      },
      [](auto& n, auto& r) { return move_points(n, {point(n, r)}, any_way(r)); },
      [](auto& n, auto& r) { return tie_ends(n, curve(n, r), 0.1); },
      [](auto& n, auto& r) {
        return add_curve(n, {node(n, r), node(n, r), {any_way(r), any_way(r), any_way(r)}, {}, false}).network;
      },
      [](auto& n, auto& r) {
        const AddedElement added = add_curve(n, {node(n, r), node(n, r), {}, CurveJoin::Crease, false});
        return split_face(added.network, face(n, r), added.id, 0.05).network;
      },
      [](auto& n, auto& r) {
        const AddedElement added = add_curve(n, {{}, {}, {any_way(r), any_way(r)}, {}, true});
        return add_inner_curve(added.network, face(n, r),
                               {find_element(added.network, NetworkElement::Curve, added.id), {}, {}});
      },
      [](auto& n, auto&) { return n.curves.size() > 100 ? n : mirror_network(n, plane, 1e-6).network; },
      [](auto& n, auto& r) {
        const NetworkPartners partners = find_partners(n, plane, 1e-6);
        return with_symmetric_edit(n, move_nodes(n, {node(n, r)}, any_way(r)), plane, partners);
      },
      [](auto& n, auto& r) {
        const NetworkPartners partners = find_partners(n, plane, 1e-6);
        return with_symmetric_edit(n, delete_elements(n, {{}, {curve(n, r)}, {}, {}}), plane, partners);
      },
      [](auto& n, auto& r) {
        const NetworkPartners partners = find_partners(n, plane, 1e-6);
        return with_symmetric_edit(n, split_curve(n, curve(n, r), 0.4).network, plane, partners);
      },
  };
  return edits;
}

TEST_CASE("every edit of a network leaves a valid one and the network before it as it was") {
  int done = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Random random(seed);
    AttributeNetwork network = rich_sheet(3, 2);
    for (int step = 0; step < 25; ++step) {
      const std::string before = text_of(network);
      const auto kind = random.below(static_cast<std::uint32_t>(random_edits().size()));
      INFO("seed " << seed << ", step " << step << ", edit " << kind);
      try {
        AttributeNetwork edited = random_edits()[kind](network, random);
        check_sound(edited);
        CHECK(text_of(network) == before);
        network = std::move(edited);
        ++done;
      } catch (const Error& error) {
        CHECK(error.findings().front().message.size() > 20);
        CHECK(text_of(network) == before);
        ++refused;
      }
    }
  }
  CHECK(done > 3 * refused);
}

TEST_CASE("splitting a curve changes no place of it") {
  for (const double at : {0.1, 0.5, 0.83}) {
    const AttributeNetwork network = rich_sheet(2, 2);
    const SplitCurve split = split_curve(network, "u0_0", at);
    const ArcLengthCurve whole(control_polygon(network, network.curves[0]));
    const Index second = find_element(split.network, NetworkElement::Curve, split.second);
    const ArcLengthCurve first_part(control_polygon(split.network, split.network.curves[0]));
    const ArcLengthCurve second_part(control_polygon(split.network, split.network.curves[second]));
    CHECK(first_part.length() + second_part.length() == Approx(whole.length()).epsilon(1e-12));
    for (int k = 0; k <= 20; ++k) {
      const double s = k / 20.0;
      CHECK((first_part.at(s) - whole.at(s * at)).norm() < 1e-9);
      CHECK((second_part.at(s) - whole.at(at + s * (1 - at))).norm() < 1e-9);
    }
  }
}

TEST_CASE("slopes keep their places and normals when their curve is split") {
  const AttributeNetwork network = rich_sheet(2, 2);
  const SplitCurve split = split_curve(network, "u0_0", 0.5);
  const SlopeAttribute& first = split.network.slopes[find_slope(split.network, {"u0_0", {}})];
  const SlopeAttribute& second = split.network.slopes[find_slope(split.network, {split.second, {}})];
  CHECK(first.at == std::vector<double>{0.5, 1});
  CHECK(second.at == std::vector<double>{0, 0.5});
  CHECK(first.normals[0] == Vec3(0, 0.1, 1));
  CHECK(second.normals[1] == Vec3(0, -0.1, 1));
  CHECK((first.normals[1] - Vec3(0, 0, 1)).norm() < 1e-12);  // halfway between the two
  CHECK(first.normals[1] == second.normals[0]);
}

TEST_CASE("ends of curves follow their node evenly, and nothing else moves") {
  const AttributeNetwork network = bent_sheet(2, 2);
  const AttributeNetwork moved = move_nodes(network, {"n1_1", "n1_1"}, {0.1, 0.2, 0.3});
  const Vec3 by(0.1, 0.2, 0.3);
  for (std::size_t i = 0; i < network.curves.size(); ++i) {
    const AttributeCurve& curve = network.curves[i];
    const bool starts = curve.from == 4, ends = curve.to == 4;
    for (std::size_t j = 0; j < 4; ++j) {
      const double share = starts ? 1 - static_cast<double>(j) / 3 : ends ? static_cast<double>(j) / 3 : 0;
      CHECK((moved.curves[i].control[j] - curve.control[j] - share * by).norm() < 1e-15);
    }
  }
}

TEST_CASE("a line becomes a cubic when its handle is dragged, and its other handle stays") {
  const AttributeNetwork box = test::wire_box();
  const AttributeNetwork bent = move_handles(box, {{"x00", 1}}, {0, 0, 1});
  const auto& control = bent.curves[find_element(bent, NetworkElement::Curve, "x00")].control;
  REQUIRE(control.size() == 4);
  CHECK((control[1] - Vec3(1.0 / 3, 0, 1)).norm() < 1e-15);
  CHECK((control[2] - Vec3(2.0 / 3, 0, 0)).norm() < 1e-15);
  const AttributeNetwork end_moved = move_handles(box, {{"x00", 0}}, {0, 0, 1});
  CHECK(end_moved.nodes[0].point == Vec3(0, 0, 1));
  CHECK(end_moved.curves[0].control.empty());
}

TEST_CASE("a face split by a curve across it and merged again has its old loop, and points go to their half") {
  AttributeNetwork network = bent_sheet(2, 1);
  network = add_point(network, {"f0_0", {0.2, 0.5, 0.3}, {}, {}, {}}).network;
  network = add_point(network, {"f0_0", {0.8, 0.5, 0.3}, {}, {}, {}}).network;
  network = add_point(network, {"f0_0", {0.5, 0.5, 0.3}, FanPlace{0, 0.4, 0.1}, {}, {}}).network;  // towards corner 0
  const AddedElement cut = add_curve(network, {{}, {}, {{0.5, 0, 0.1}, {0.45, 0.5, 0.3}, {0.5, 1, 0.1}}, {}, true});
  CHECK(can_split_face(cut.network, 0, find_element(cut.network, NetworkElement::Curve, cut.id), 0.2));
  const SplitFace split = split_face(cut.network, "f0_0", cut.id, 0.2);
  check_sound(split.network);
  CHECK(split.network.faces.size() == 3);
  CHECK(split.network.nodes.size() == network.nodes.size() + 2);
  const auto face_of = [&](const char* point) {
    return split.network.points[find_element(split.network, NetworkElement::Point, point)].face;
  };
  CHECK(face_of("p1") != face_of("p2"));
  CHECK(face_of("p1") == face_of("p3"));
  const auto has_left_side = [&](Index face) {
    const auto& loop = split.network.faces[face].loop;
    const Index left = find_element(split.network, NetworkElement::Curve, "v0_0");
    return std::ranges::find(loop, left, &AttributeSide::curve) != loop.end();
  };
  CHECK(has_left_side(face_of("p1")));
  CHECK_FALSE(has_left_side(face_of("p2")));
  const AttributeNetwork merged = merge_faces(split.network, cut.id);
  check_sound(merged);
  CHECK(merged.faces.size() == 2);
  CHECK(merged.faces[0].loop.size() == 6);  // both divided sides keep their nodes
  CHECK(std::ranges::all_of(merged.points, [](const PointAttribute& point) { return point.face == 0; }));
}

TEST_CASE("a cut whose end is away from the loop is refused with the gap's size") {
  const AddedElement cut = add_curve(bent_sheet(1, 1), {{}, {}, {{0.5, 0, 0.1}, {0.5, 0.5, 0.2}}, {}, true});
  try {
    split_face(cut.network, "f0_0", cut.id, 0.2);
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(error.findings().front().code == "E_OPEN_LOOP");
    CHECK(error.findings().front().subjects.size() == 2);
  }
}

TEST_CASE("deleting a node in the middle of four faces makes one of them") {
  const AttributeNetwork network = delete_elements(bent_sheet(2, 2), {{"n1_1"}, {}, {}, {}});
  check_sound(network);
  CHECK(network.nodes.size() == 8);
  CHECK(network.curves.size() == 8);
  REQUIRE(network.faces.size() == 1);
  CHECK(network.faces[0].loop.size() == 8);
}

TEST_CASE("deleting a curve at the border takes its face, not the nodes that others have") {
  const AttributeNetwork network = delete_elements(rich_sheet(2, 1), {{}, {"v0_0"}, {}, {}});
  CHECK(network.faces.size() == 1);
  CHECK(network.points.size() == 1);
  CHECK(network.nodes.size() == 6);
  CHECK(find_element(network, NetworkElement::Curve, "inside") == no_index);
}

TEST_CASE("a closed curve becomes a face of four sides") {
  AttributeNetwork network;
  const std::vector<Vec3> control = {{1, 0, 0}, {2, 2, 0}, {-2, 2, 0}, {-2, -2, 0}, {2, -2, 0}, {1, 0, 0}};
  const AddedElement added = add_curve(network, {{}, {}, control, {}, true});
  const SortedLoop loop = sort_loop(added.network, {0}, 1e-9);
  REQUIRE(loop.closed());
  const AddedElement face = close_loop(added.network, loop);
  check_sound(face.network);
  CHECK(face.network.curves.size() == 4);
  CHECK(face.network.faces[0].loop.size() == 4);
}

TEST_CASE("merging the nodes of a straight side leaves a face with a side less") {
  AttributeNetwork box = test::wire_box();
  const auto curve = [&](const char* id) { return find_element(box, NetworkElement::Curve, id); };
  const SortedLoop loop = sort_loop(box, {curve("x00"), curve("x10"), curve("y00"), curve("y01")}, 0);
  REQUIRE(loop.closed());
  box = add_face(box, loop.sides).network;
  const AttributeNetwork merged = merge_nodes(box, "n1", "n0");
  check_sound(merged);
  CHECK(merged.nodes.size() == 7);
  CHECK(merged.curves.size() == 11);
  CHECK(merged.faces[0].loop.size() == 3);
}

TEST_CASE("edits refuse what isn't there and numbers that can't be, and name it") {
  const AttributeNetwork network = bent_sheet(1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(move_nodes(network, {"n7"}, Vec3::Zero()), Catch::Contains("\"n7\""));
  CHECK_THROWS_AS(move_nodes(network, {"n0_0"}, Vec3(nan, 0, 0)), Error);
  CHECK_THROWS_AS(set_faces(network, {"f0_0"}, {{}, {}, 3.0}), Error);
  CHECK_THROWS_AS(split_curve(network, "u0_0", 1), Error);
  CHECK_THROWS_AS(set_slope(network, {"u0_0", {}}, {0.5, {}, 2.0}), Error);
  CHECK_THROWS_AS(set_slope(network, {"u0_0", {}}, {0.5, Vec3(0, 0, 0), {}}), Error);
  CHECK_THROWS_AS(add_inner_curve(network, "f0_0", {0, {}, {}}), Error);
  CHECK_THROWS_AS(merge_faces(network, "u0_0"), Error);
}

}  // namespace
}  // namespace croquis
