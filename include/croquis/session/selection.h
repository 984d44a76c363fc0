// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "croquis/document/document.h"

namespace croquis {

/// One thing that is selected: a node, or a part of it.
struct SelectedItem {
  NodeId node = 0;
  std::string part;  ///< of a drawing: a stroke's id; empty for the whole node

  friend auto operator<=>(const SelectedItem&, const SelectedItem&) = default;
};

/// Sorted by node and part, each once.
using Selection = std::vector<SelectedItem>;

/// Sorted, each item once, and without what isn't in the document: nodes that aren't there, and parts of drawings that
/// aren't strokes of theirs. Parts of other nodes are kept: only their evaluation knows them.
/// O(#selection log #selection + #nodes + #strokes of the drawings with selected parts)
Selection existing(Selection selection, const Document& document);

}  // namespace croquis
