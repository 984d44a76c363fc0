// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string_view>

#include "croquis/remeshing/remesh.h"

namespace croquis::test {

inline remeshing::RemeshResult remesh(const PolyMesh& mesh, const remeshing::RemeshOptions& options = {}) {
  Progress progress;
  return remeshing::remesh_surface(mesh, options, progress);
}

inline bool warns(const remeshing::RemeshResult& result, std::string_view code) {
  return std::ranges::find(result.warnings, code, &Finding::code) != result.warnings.end();
}

}  // namespace croquis::test
