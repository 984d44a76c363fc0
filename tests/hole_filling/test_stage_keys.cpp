// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/stage_key.h"
#include "croquis/hole_filling/fill_holes.h"
#include "support/key_recorder.h"
#include "support/member_changes.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

std::string key_of_run(const std::string& stage, FillOptions options) {
  const PolyMesh scan = without_faces(round_sphere(2), std::vector<Index>{0});
  return stage_key(stage, [&](StageCache* cache) {
    options.cache = cache;
    Progress progress;
    fill_holes(scan, options, progress);
  });
}

}  // namespace

TEST_CASE("every option of the fitted function changes the key of a patch, and the same options give the same key") {
  const FillOptions options;
  std::set<std::string> keys = {key_of_run("fill/patch/2", options)};
  CHECK_FALSE(keys.contains(""));
  CHECK(keys.contains(key_of_run("fill/patch/2", options)));
  const auto changes = changes_of(options.implicit);
  for (const ImplicitOptions& changed : changes) {
    FillOptions other;
    other.implicit = changed;
    keys.insert(key_of_run("fill/patch/2", other));
  }
  CHECK(keys.size() == changes.size() + 1);
  CHECK_FALSE(keys.contains(""));
}

TEST_CASE("every option of the analysis changes its key") {
  const FillOptions options;
  std::set<std::string> keys = {key_of_run("fill/analysis/1", options)};
  const auto changes = changes_of(options.analysis);
  for (const HoleAnalysisOptions& changed : changes) {
    FillOptions other;
    other.analysis = changed;
    keys.insert(key_of_run("fill/analysis/1", other));
  }
  CHECK(keys.size() == changes.size() + 1);
  CHECK_FALSE(keys.contains(""));
}

TEST_CASE("every setting of a patch changes its key") {
  std::set<std::string> keys = {StageKey().add(PatchSettings()).bytes()};
  const auto changes = changes_of(PatchSettings());
  for (const PatchSettings& changed : changes) keys.insert(StageKey().add(changed).bytes());
  CHECK(keys.size() == changes.size() + 1);
}
