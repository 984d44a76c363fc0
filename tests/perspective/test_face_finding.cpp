// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <map>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/perspective/face_finding.h"
#include "perspective/network_shapes.h"
#include "support/perspective/solids.h"

using namespace croquis;
using namespace croquis::test;

namespace {

using Codes = std::vector<std::string>;

/// Every curve is walked along once in each direction.
void check_directions(const CurveNetwork& network, const FaceSet& set) {
  std::map<std::pair<Index, bool>, int> uses;
  for (const NetworkFace& face : set.faces) {
    for (const CurveLoop& loop : face.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        ++uses[{loop[i].curve, loop[i].reversed}];
        const CurveUse& next = loop[(i + 1) % loop.size()];
        const NetworkCurve &a = network.curves[loop[i].curve], &b = network.curves[next.curve];
        CHECK((loop[i].reversed ? a.start : a.end) == (next.reversed ? b.end : b.start));
      }
    }
  }
  CHECK(uses.size() == 2 * network.curves.size());
  for (const auto& [use, count] : uses) CHECK(count == 1);
}

/// Faces as sets of the ids that curves had before they were shuffled.
std::multiset<FaceIds> old_ids_of(const CurveNetwork& network, const std::vector<std::string>& old,
                                  const FaceSet& set) {
  CurveNetwork named = network;
  for (std::size_t c = 0; c < old.size(); ++c) named.curves[c].id = old[c];
  return ids_of_faces(named, set);
}

}  // namespace

TEST_CASE("the faces of every test solid are found") {
  for (const PerspectiveSolid& solid : all_solids()) {
    INFO(solid.name);
    const FaceFindingResult result = faces_of(solid.network);
    CHECK(ids_of_faces(solid.network, result.best) == ids_of_faces(solid));
    CHECK(sorted_codes(result.warnings) == Codes{});
    CHECK(result.best.shells.size() == static_cast<std::size_t>(solid.shells));
    check_directions(solid.network, result.best);
  }
}

TEST_CASE("faces don't depend on order, direction and ids of strokes") {
  for (const PerspectiveSolid& solid : all_solids()) {
    INFO(solid.name);
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const auto [network, old] = shuffled(solid.network, seed);
      const FaceFindingResult result = faces_of(network);
      CHECK(old_ids_of(network, old, result.best) == ids_of_faces(solid));
      CHECK(result.warnings.empty());
    }
  }
}

TEST_CASE("walls between stacked boxes are no faces") {
  for (int n = 2; n <= 6; ++n) {
    const FaceFindingResult result = faces_of(stack(n).network);
    CHECK(result.best.faces.size() == static_cast<std::size_t>(4 * n + 2));
    CHECK(result.internal_rejected == static_cast<std::size_t>(n - 1));
  }
}

TEST_CASE("faces of nets of arcs are found") {
  for (const PolyhedronNet& net : sphere_nets()) {
    INFO(net.name);
    CHECK(faces_of(net.network).best.faces.size() == net.faces);
    CHECK(faces_of(net.network).warnings.empty());
    const FaceFindingResult result = faces_of(perturbed(net.network, 0.1, 3));
    CHECK(result.best.faces.size() == net.faces);
  }
}

TEST_CASE("faces are found in any position and size") {
  for (const PerspectiveSolid& solid : all_solids()) {
    INFO(solid.name);
    CHECK(ids_of_faces(solid.network, faces_of(moved(solid.network, 0.013, Vec3(7, -3, 100))).best) ==
          ids_of_faces(solid));
    const FaceFindingResult turned = faces_of(rotated(solid.network));
    CHECK(ids_of_faces(solid.network, turned.best) == ids_of_faces(solid));
  }
}

TEST_CASE("curves that bound nothing are named and left out") {
  CurveNetwork network = box().network;
  const Index corner = network.curves[0].start;
  network.vertices.emplace_back(-1, -1, -1);
  network.vertices.emplace_back(-2, -1, -1);
  const Index tip = static_cast<Index>(network.vertices.size() - 2);
  const auto line = [&](const char* id, Index a, Index b) {
    network.curves.push_back({id, a, b, {straight_cubic(network.vertices[a], network.vertices[b])}, true});
  };
  line("antenna", corner, tip);
  line("top", tip, tip + 1);
  FaceFindingResult result = faces_of(network);
  CHECK(result.best.faces.size() == 6);
  CHECK(result.dangling == std::vector<Index>{12, 13});
  CHECK(sorted_codes(result.warnings) == Codes{"DANGLING", "DANGLING"});

  network = joined(box().network, moved(box().network, 1, Vec3(10, 11, 12)), "b");
  line("bridge", network.curves[0].start, network.curves[20].end);
  result = faces_of(network);
  CHECK(result.best.faces.size() == 12);
  CHECK(result.bridges == std::vector<Index>{24});
  CHECK(sorted_codes(result.warnings) == Codes{"DANGLING"});
}

TEST_CASE("a shell inside another one bounds a void") {
  const CurveNetwork network = joined(box().network, moved(box().network, 0.4, Vec3(1, 1, 0.5)), "inner");
  const FaceFindingResult result = faces_of(network);
  CHECK(result.best.faces.size() == 12);
  REQUIRE(result.best.shells.size() == 2);
  CHECK(result.best.shells[0].is_void != result.best.shells[1].is_void);
  for (const NetworkShell& shell : result.best.shells) {
    const NetworkFace& face = result.best.faces[shell.faces[0]];
    const bool inner = network.curves[face.loops[0][0].curve].id.starts_with("inner");
    CHECK(shell.is_void == inner);
    const Vec3 centre(2, 1.5, inner ? 0.9 : 1);
    CHECK((face.normal.dot(face.origin - centre) < 0) == inner);
  }
  CHECK(result.warnings.empty());
}

TEST_CASE("a shell inside a void is solid again") {
  const CurveNetwork room = joined(box().network, moved(box().network, 0.6, Vec3(0.8, 0.6, 0.4)), "void");
  const FaceFindingResult result = faces_of(joined(room, moved(box().network, 0.2, Vec3(1.6, 1.2, 0.8)), "core"));
  REQUIRE(result.best.shells.size() == 3);
  for (const NetworkShell& shell : result.best.shells) {
    REQUIRE(shell.faces.size() == 6);
    const NetworkFace& face = result.best.faces[shell.faces[0]];
    // The middle of all three boxes is (2, 1.5, 1); the faces of the middle one look at it.
    const double outwards = face.normal.dot(face.origin - Vec3(2, 1.5, 1));
    const double height = std::abs(outwards);
    const bool middle = height > 0.5 && height < 1.3;
    INFO("a face " << height << " from the middle");
    CHECK(shell.is_void == middle);
    CHECK((outwards < 0) == middle);
  }
}

TEST_CASE("solids that touch in one vertex are solved apart") {
  CurveNetwork network = joined(box().network, moved(box().network, 1, Vec3(4, 3, 2)), "b");
  // One vertex for the corner that both have.
  for (NetworkCurve& curve : network.curves) {
    for (Index* end : {&curve.start, &curve.end}) {
      for (Index v = 0; v < *end; ++v) {
        if (network.vertices[v] == network.vertices[*end]) *end = v;
      }
    }
  }
  const FaceFindingResult result = faces_of(network);
  CHECK(result.best.faces.size() == 12);
  CHECK(result.best.shells.size() == 2);
  CHECK(result.open_curves.empty());
}

TEST_CASE("without one of its strokes a solid keeps the faces that don't have it") {
  for (const PerspectiveSolid& solid : all_solids()) {
    for (std::size_t c = 0; c < solid.network.curves.size(); c += 3) {
      const std::string& id = solid.network.curves[c].id;
      INFO(solid.name << " without " << id);
      const FaceFindingResult result = faces_of(without(solid.network, {id}));
      CHECK(result.best.faces.size() + 2 >= solid.faces.size());
      CHECK(result.nodes < 50000);
    }
  }
}

TEST_CASE("a stroke missing from a box is found by the face that isn't flat") {
  const PerspectiveSolid solid = box();
  for (const NetworkCurve& curve : solid.network.curves) {
    const FaceFindingResult result = faces_of(without(solid.network, {curve.id}));
    CHECK(result.best.faces.size() == 5);
    REQUIRE(sorted_codes(result.warnings) == Codes{"NONPLANAR_STRAIGHT_FACE"});
    CHECK(result.warnings[0].subjects.size() == 6);
  }
}

TEST_CASE("a stroke missing at a smooth face is told by its corners") {
  const PerspectiveSolid solid = soap();
  for (const NetworkCurve& curve : solid.network.curves) {
    if (curve.straight) continue;
    const FaceFindingResult result = faces_of(without(solid.network, {curve.id}));
    CHECK(sorted_codes(result.warnings) == Codes{"MISSING_STROKE", "MISSING_STROKE"});
  }
}

TEST_CASE("a sheet that sticks out of a solid stays open") {
  CurveNetwork network = box().network;
  // Vertices of the box along the first stroke, and two more beside it.
  const Index a = network.curves[0].start, b = network.curves[0].end;
  const Vec3 out = (network.vertices[a] - Vec3(2, 1.5, 1)).cwiseProduct(Vec3(0, 0.5, 0.5));
  const auto first = static_cast<Index>(network.vertices.size());
  network.vertices.push_back(network.vertices[a] + out);
  network.vertices.push_back(network.vertices[b] + out);
  const auto line = [&](const char* id, Index from, Index to) {
    network.curves.push_back({id, from, to, {straight_cubic(network.vertices[from], network.vertices[to])}, true});
  };
  line("f0", a, first);
  line("f1", first, first + 1);
  line("f2", first + 1, b);
  const FaceFindingResult result = faces_of(network);
  CHECK(result.best.faces.size() == 6);
  CHECK(result.open_curves == std::vector<Index>{12, 13, 14});
  const Codes codes = sorted_codes(result.warnings);
  CHECK(std::ranges::count(codes, "NOT_CLOSED") == 1);
  REQUIRE(result.best.shells.size() == 1);
  CHECK(result.best.shells[0].closed);
}

TEST_CASE("a single loop is an open shell") {
  const CurveNetwork network =
      line_network({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const FaceFindingResult result = faces_of(network);
  CHECK(result.best.faces.size() == 1);
  CHECK(result.open_curves.size() == 4);
  CHECK(sorted_codes(result.warnings) == Codes{"NOT_CLOSED"});
  REQUIRE(result.best.shells.size() == 1);
  CHECK(!result.best.shells[0].closed);
  CHECK(faces_of({}).best.faces.empty());
}

TEST_CASE("sets of faces that fit as well are told, and can be chosen") {
  const CurveNetwork network = box_in_box();
  const FaceFindingResult result = faces_of(network);
  CHECK(result.best.faces.size() == 16);
  CHECK(sorted_codes(result.warnings) == Codes{"AMBIGUOUS"});
  REQUIRE(result.alternatives.size() == 2);
  for (const FaceSet& set : result.alternatives) {
    CHECK(set.faces.size() == 16);
    CHECK(set.cost == Approx(result.best.cost));
    check_directions(network, set);
    // Its faces, fixed, lead to it.
    FaceFindingOptions options;
    for (const FaceIds& face : ids_of_faces(network, set))
      options.fixed.emplace_back(face.begin()->begin(), face.begin()->end());
    const FaceFindingResult chosen = faces_of(network, options);
    CHECK(chosen.alternatives.empty());
    CHECK(ids_of_faces(network, chosen.best) == ids_of_faces(network, set));
  }
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto [other, old] = shuffled(network, seed);
    CHECK(old_ids_of(other, old, faces_of(other).best) == ids_of_faces(network, result.best));
  }
}

TEST_CASE("a face that is forbidden isn't chosen") {
  const PerspectiveSolid solid = stack(2);
  FaceFindingOptions options;
  options.forbidden.resize(1);
  for (const SolidSide& side : solid.faces[0].loops[0])
    options.forbidden[0].push_back(solid.network.curves[side.curve].id);
  const FaceFindingResult result = faces_of(solid.network, options);
  const FaceIds forbidden = {{options.forbidden[0].begin(), options.forbidden[0].end()}};
  CHECK(!ids_of_faces(solid.network, result.best).contains(forbidden));
  CHECK(!result.warnings.empty());
}

TEST_CASE("the search for faces ends at its limit with what it has") {
  FaceFindingOptions options;
  options.node_limit = 300;
  const FaceFindingResult result = faces_of(globe(5, 9), options);
  CHECK(result.nodes < 1000);
  options.node_limit = 40;
  const Codes codes = sorted_codes(faces_of(camera_ring().network, options).warnings);
  CHECK(std::ranges::count(codes, "SEARCH_LIMIT") == 1);
}

TEST_CASE("finding faces can be cancelled and reports how far it is") {
  std::atomic<bool> cancel{true};
  Progress cancelled({}, &cancel);
  CHECK_THROWS_AS(find_faces(globe(3, 6), cancelled), Cancelled);
  double last = 0;
  Progress progress([&](double fraction, const std::string&) {
    CHECK(fraction >= last);
    last = fraction;
  });
  find_faces(globe(3, 6), progress);
  CHECK(last == 1);
}

TEST_CASE("networks of some hundred curves are solved in few steps") {
  for (const auto& [network, faces] : {std::pair(box_wall(1, 49), 198), std::pair(box_wall(6, 12), 180),
                                       std::pair(globe(5, 9), 54), std::pair(globe(11, 17), 204)}) {
    const FaceFindingResult result = faces_of(network);
    CHECK(result.best.faces.size() == static_cast<std::size_t>(faces));
    CHECK(result.warnings.empty());
    CHECK(result.nodes < 2000);
  }
}
