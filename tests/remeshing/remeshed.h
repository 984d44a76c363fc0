// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/remeshing/remesh.h"

namespace croquis::test {

inline remeshing::RemeshResult remesh(const PolyMesh& mesh, const remeshing::RemeshOptions& options = {}) {
  Progress progress;
  return remeshing::remesh_surface(mesh, options, progress);
}

}  // namespace croquis::test
