// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "io/gltf/gltf_document.h"

namespace croquis {

/// A node with a mesh, and where it lies.
struct GlbInstance {
  std::size_t node = 0;
  std::size_t mesh = 0;
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
};

/// All of a model's, parents before children, else in the order of their numbers. Linear in the number of nodes.
/// @throws Error E_SYNTAX when a node is reached twice or is its own descendant, E_INDEX
std::vector<GlbInstance> glb_instances(const GltfDocument& document);

}  // namespace croquis
