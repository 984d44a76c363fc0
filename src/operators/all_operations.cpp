// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/operators/all_operations.h"

#include "operators/edit_operation.h"
#include "operators/fair_operation.h"
#include "operators/fill_operation.h"
#include "operators/inflate_operation.h"
#include "operators/perspective/attribute_network_operation.h"
#include "operators/perspective/patch_cage_operation.h"
#include "operators/perspective/perspective_operation.h"
#include "operators/subdivide_operation.h"
#include "operators/surface/contour_network_operation.h"
#include "operators/surface/edge_network_operation.h"
#include "operators/surface/surface_cage_operation.h"
#include "operators/surface/surface_operation.h"
#include "operators/surface/surface_patch_operation.h"

namespace croquis {

Registry all_operations() {
  Registry registry;
  registry.add(std::make_unique<InflateOperation>());
  registry.add(std::make_unique<PerspectiveOperation>());
  registry.add(std::make_unique<AttributeNetworkOperation>());
  registry.add(std::make_unique<ContourNetworkOperation>());
  registry.add(std::make_unique<EdgeNetworkOperation>());
  registry.add(std::make_unique<PatchCageOperation>());
  registry.add(std::make_unique<SurfaceOperation>());
  registry.add(std::make_unique<SurfaceCageOperation>());
  registry.add(std::make_unique<SubdivideOperation>());
  registry.add(std::make_unique<FairOperation>());
  registry.add(std::make_unique<FillOperation>());
  registry.add(std::make_unique<SurfacePatchOperation>());
  registry.add(std::make_unique<EditOperation>());
  return registry;
}

}  // namespace croquis
