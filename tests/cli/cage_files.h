// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/geometry/poly_mesh.h"

/// What tests of `subdivide` share: cages as files, levels and reports as they come back.
namespace croquis::test {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

std::string obj_of(const PolyMesh& mesh);

PolyMesh mesh_in(const std::string& path);

/// croquis-tags-1
std::string tags_json(const MeshTags& tags);

Json report_of(const ProcessResult& result);

Words codes_of(const Json& findings);

/// Runs `subdivide` on a cage and gives its report; fails the test unless it exits with 0.
Json subdivided(const ScratchFolder& folder, const PolyMesh& cage, const Words& options,
                const std::string& output = "level.obj");

/// The first one, positions up to rounding, tags in any order; empty when there is none.
std::string differences(const PolyMesh& a, const PolyMesh& b);

}  // namespace croquis::test
