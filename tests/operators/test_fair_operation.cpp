// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"
#include "operators/operations.h"
#include "support/check_operation.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis {
namespace {

Values inputs_of(const PolyMesh& cage) { return {{"cage", std::make_shared<const PolyMesh>(cage)}}; }

/// With a dent to be smoothed out.
PolyMesh dented() {
  PolyMesh cage = test::torus(10, 8);
  cage.positions[13] += Vec3(0.1, 0.2, 0.3);
  return cage;
}

OperationResult fair(const PolyMesh& cage, double weight, Memo* memo = nullptr) {
  Progress progress;
  Context context{progress, Quality::Final, memo};
  return run(*fair_operation(), inputs_of(cage), {{"weight", weight}}, context);
}

double figure(const OperationResult& result, const char* name) {
  return result.outputs.at("details").as<Report>()->at(name).as_number();
}

TEST_CASE("fairing is a function of its arguments") {
  test::check_operation(*fair_operation(), inputs_of(dented()), {});
  test::check_operation(*fair_operation(), inputs_of(test::bolt_loop()),
                        {{"weight", 0.1}, {"chains", std::string("fair")}, {"levels", std::int64_t{1}}});
}

TEST_CASE("fairing moves points, more for lower weights, and bends the surface less") {
  Memo memo;
  double last = figure(fair(dented(), 1, &memo), "energy_before");
  const std::size_t kept = memo.bytes();
  double moved = 0;
  for (const double weight : {100.0, 1.0, 0.01}) {
    const OperationResult result = fair(dented(), weight, &memo);
    CHECK(figure(result, "energy") < last);
    CHECK(figure(result, "greatest_move") > moved);
    last = figure(result, "energy");
    moved = figure(result, "greatest_move");
    CHECK(memo.bytes() == kept);  // what doesn't depend on the weight was there
  }
}

TEST_CASE("fairing keeps pins, tags and connectivity") {
  PolyMesh cage = test::bolt_loop();
  cage.tags.pins = {0};
  const OperationResult result = fair(cage, 0.1);
  const PolyMesh& mesh = result.outputs.at("mesh").get<PolyMesh>();
  CHECK(mesh.tags == cage.tags);
  CHECK(mesh.corners == cage.corners);
  CHECK(mesh.positions[0] == cage.positions[0]);
  for (const Index v : {8U, 9U, 10U, 11U}) CHECK(mesh.positions[v] == cage.positions[v]);
  CHECK(mesh.positions[13] != cage.positions[13]);
}

}  // namespace
}  // namespace croquis
