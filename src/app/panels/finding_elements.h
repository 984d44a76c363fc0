// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/mesh_editing/mesh_selection.h"

/// From findings to elements that can be selected.
namespace croquis::app {

/// Names of the strokes that a finding is about.
std::vector<std::string> strokes_of(const Finding& finding);

/// Numbers of the holes that a finding is about.
std::vector<Index> holes_of(const Finding& finding);

/// Elements of a mesh, to be selected in the mode for them.
struct PickedElements {
  ComponentKind kind = ComponentKind::Vertex;
  Elements elements;
};

/// The mesh's elements that a finding is about, of the kind that it names first.
PickedElements elements_of(const Finding& finding, const MeshTopology& topology);

}  // namespace croquis::app
