// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "cli/cage_files.h"
#include "croquis/io/mesh_file.h"

/// What tests of `fill` share: scans as files, fillings and reports as they come back.
namespace croquis::test {

std::string bytes_of(const PolyMesh& mesh, MeshFormat format);
std::string ply_of(const PolyMesh& mesh);

/// The first vertices and faces are those given, bit by bit.
bool begins_with(const PolyMesh& grown, const PolyMesh& given);

/// A sphere with five holes, two of which are an island's ring.
PolyMesh holed_scan();

/// A sphere without its cap.
PolyMesh holed_sphere();

/// Runs `fill` and gives its report; fails the test unless it exits with 0.
Json filled(const std::string& input, const std::string& output, const Words& options = {});

/// Ids of the holes with that action.
std::set<int> holes_with(const Json& report, const std::string& action);

}  // namespace croquis::test
