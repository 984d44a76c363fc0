// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/operators/all_operations.h"

#include "operators/operations.h"

namespace croquis {

Registry all_operations() {
  Registry registry;
  for (const auto make : {inflate_operation, cage_operation, perspective_operation, attribute_network_operation,
                          contour_network_operation, edge_network_operation, patch_cage_operation, surface_operation,
                          surface_cage_operation, subdivide_operation, fair_operation, fill_operation,
                          surface_patch_operation, edit_operation})
    registry.add(make());
  return registry;
}

}  // namespace croquis
