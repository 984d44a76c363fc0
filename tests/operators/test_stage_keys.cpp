// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/stage_key.h"
#include "croquis/subdivision/fairing.h"
#include "operators/subdivision_plan.h"
#include "support/member_changes.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::subdivision;

TEST_CASE("scheme, levels and every rule change the hash of a plan of subdivision") {
  const Cage cage = make_cage(cube(), Rules()).cage;
  std::set<ContentHash> hashes = {plan_hash(cage, {})};
  std::size_t expected = 1;
  for (const PlanSettings& changed : changes_of(PlanSettings())) {
    hashes.insert(plan_hash(cage, changed));
    ++expected;
  }
  CHECK(hashes.size() == expected);
  for (const Rules& changed : changes_of(Rules())) {
    PlanSettings settings;
    settings.rules = changed;
    hashes.insert(plan_hash(cage, settings));
    ++expected;
  }
  CHECK(hashes.size() == expected - 1);  // the first rule is changed in both lists
}

TEST_CASE("every option of fairing changes its key") {
  std::set<std::string> keys = {StageKey().add(FairingOptions()).bytes()};
  const auto changes = changes_of(FairingOptions());
  for (const FairingOptions& changed : changes) keys.insert(StageKey().add(changed).bytes());
  CHECK(keys.size() == changes.size() + 1);
}
