// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/tools/mesh/mesh_tool.h"

namespace croquis {

/// What is derived from the tool's mesh, kept as long as it is valid.
struct MeshTool::Cache {
  std::shared_ptr<const PolyMesh> mesh;
  std::shared_ptr<const MeshTopology> topology;
  MeshPicker picker;

  std::optional<MeshTags> sharpness_of;  ///< tags that `sharpness` was made of
  std::vector<double> sharpness;         ///< #E

  std::shared_ptr<const ComponentSelection> vertices_of;  ///< selection that `vertices` was made of
  bool all_vertices = false;                              ///< … or of the whole mesh
  Elements vertices;

  explicit Cache(std::shared_ptr<const PolyMesh> now)
      : mesh(std::move(now)), topology(std::make_shared<const MeshTopology>(*mesh)), picker(mesh, topology) {}
};

}  // namespace croquis
