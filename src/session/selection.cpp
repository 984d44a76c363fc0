// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/session/selection.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <variant>

namespace croquis {
namespace {

/// The drawing a node is a source of, or null.
const Drawing* drawing_of(const Node& node) {
  if (!node.source) return nullptr;
  const auto* drawing = std::get_if<std::shared_ptr<const Drawing>>(&*node.source);
  return drawing == nullptr ? nullptr : drawing->get();
}

/// Answers for many items with one walk over each drawing.
class Existence {
 public:
  explicit Existence(const Document& document) {
    for (const auto& node : document.nodes()) nodes_.emplace(node->id, node.get());
  }

  bool operator()(const SelectedItem& item) {
    const auto node = nodes_.find(item.node);
    if (node == nodes_.end()) return false;
    const Drawing* drawing = drawing_of(*node->second);
    if (item.part.empty() || drawing == nullptr) return true;
    const auto [ids, added] = strokes_.try_emplace(item.node);
    if (added) {
      for (const Stroke& stroke : drawing->strokes) ids->second.insert(stroke.id);
    }
    return ids->second.contains(item.part);
  }

 private:
  std::map<NodeId, const Node*> nodes_;
  std::map<NodeId, std::set<std::string_view>> strokes_;
};

}  // namespace

Selection existing(Selection selection, const Document& document) {
  if (selection.empty()) return selection;
  std::sort(selection.begin(), selection.end());
  selection.erase(std::unique(selection.begin(), selection.end()), selection.end());
  Existence exists(document);
  std::erase_if(selection, [&](const SelectedItem& item) { return !exists(item); });
  return selection;
}

}  // namespace croquis
