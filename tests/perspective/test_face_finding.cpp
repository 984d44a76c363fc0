// SPDX-License-Identifier: GPL-3.0-or-later
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
    WARN(solid.name << ": curves " << solid.network.curves.size() << ", candidates " << result.candidates << ", nodes "
                    << result.nodes << ", internal " << result.internal_rejected);
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
