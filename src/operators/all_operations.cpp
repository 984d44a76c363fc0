// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/operators/all_operations.h"

#include "operators/inflate_operation.h"

namespace croquis {

Registry all_operations() {
  Registry registry;
  registry.add(std::make_unique<InflateOperation>());
  return registry;
}

}  // namespace croquis
