// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/document/document.h"

namespace croquis {

struct OrderedNode {
  const Node* node = nullptr;
  bool in_circle = false;  ///< its links lead in a cycle, or from one cycle to another
};

/// A node and all it depends on, inputs before those who use them; nodes whose links lead in a cycle stand together
/// before the ones that depend on them. Empty when there is no such node. O(#nodes log #nodes), without recursion.
std::vector<OrderedNode> evaluation_order(const Document& document, NodeId target);

}  // namespace croquis
