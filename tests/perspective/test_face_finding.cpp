// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <chrono>
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
std::multiset<FaceIds> old_ids_of(const CurveNetwork& network, const std::vector<std::string>& old, const FaceSet& set) {
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
    CHECK(codes_of(result.warnings) == Codes{});
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
    CHECK(ids_of_faces(solid.network, faces_of(moved(solid.network, 0.013, Vec3(7, -3, 100))).best) == ids_of_faces(solid));
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
  CHECK(codes_of(result.warnings) == Codes{"DANGLING", "DANGLING"});

  network = joined(box().network, moved(box().network, 1, Vec3(10, 11, 12)), "b");
  line("bridge", network.curves[0].start, network.curves[20].end);
  result = faces_of(network);
  CHECK(result.best.faces.size() == 12);
  CHECK(result.bridges == std::vector<Index>{24});
  CHECK(codes_of(result.warnings) == Codes{"DANGLING"});
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

TEST_CASE("a missing stroke is told, and the other faces are there") {
  for (const PerspectiveSolid& solid : all_solids()) {
    for (std::size_t c = 0; c < solid.network.curves.size(); c += 5) {
      const CurveNetwork network = without(solid.network, {solid.network.curves[c].id});
      const auto begin = std::chrono::steady_clock::now();
      const FaceFindingResult result = faces_of(network);
      const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
      INFO(solid.name << " without " << solid.network.curves[c].id);
      if (ms > 30) WARN(solid.name << " without " << c << " ms " << ms << " nodes " << result.nodes << " cand " << result.candidates << " open " << result.open_curves.size());
      CHECK(result.best.faces.size() + 3 >= solid.faces.size());
    }
  }
}

TEST_CASE("an open box is an open shell") {
  // A box without the edges of its lid has four dangling strokes; a box whose lid is no loop has open edges.
  const PerspectiveSolid solid = soap();
  std::set<std::string> lid;
  for (const NetworkCurve& curve : solid.network.curves) {
    if (!curve.straight) lid.insert(curve.id);
  }
  const FaceFindingResult result = faces_of(without(solid.network, {*lid.begin(), *lid.rbegin()}));
  for (const auto& w : result.warnings) WARN(w.code << " " << w.message);
  CHECK(!result.warnings.empty());
}

TEST_CASE("faces can be fixed and forbidden") {
  const PerspectiveSolid solid = stack(2);
  const FaceFindingResult free = faces_of(solid.network);
  FaceFindingOptions options;
  for (const CurveUse& use : free.best.faces[0].loops[0]) {
    options.fixed.resize(1);
    options.fixed[0].push_back(solid.network.curves[use.curve].id);
  }
  CHECK(ids_of_faces(solid.network, faces_of(solid.network, options).best) == ids_of_faces(solid));
  options.forbidden.swap(options.fixed);
  const FaceFindingResult without_it = faces_of(solid.network, options);
  CHECK(ids_of_faces(solid.network, without_it.best) != ids_of_faces(solid));
  CHECK(!without_it.warnings.empty());
}

TEST_CASE("large networks are solved") {
  const auto timed = [](const char* name, const CurveNetwork& network) {
    const auto begin = std::chrono::steady_clock::now();
    const FaceFindingResult result = faces_of(network);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    WARN(name << ": " << network.curves.size() << " curves, " << ms << " ms, faces " << result.best.faces.size() << ", candidates "
              << result.candidates << ", nodes " << result.nodes << ", open " << result.open_curves.size() << ", alternatives " << result.alternatives.size() << (result.warnings.empty() ? "" : result.warnings[0].message));
    return result;
  };
  timed("camera ring", camera_ring().network);
  timed("bottle", bottle().network);
  timed("stack 12", [] { CurveNetwork n = box_wall(1, 12); return n; }());
  timed("wall 1x49", box_wall(1, 49));
  timed("wall 6x12", box_wall(6, 12));
  timed("globe 3x6", globe(3, 6));
  timed("globe 5x9", globe(5, 9));
  timed("globe 11x17", globe(11, 17));
}
