// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "croquis/session/session.h"

/// What tools that draw strokes do with the source of these, whatever kind of drawing it holds.
namespace croquis {

inline bool contains(const std::vector<std::string>& ids, const std::string& id) {
  return std::ranges::find(ids, id) != ids.end();
}

/// The document with a new source and the operation that it goes to.
/// @param options   the tool's: name of the drawing; operation, version and port of what is made of it
/// @param operation with the parameters and the transform that it starts with
template <class Options>
Document with_stroke_source(const Document& document, Value drawing, const Options& options, Node operation) {
  Node source;
  source.id = document.next_id();
  source.name = options.name;
  source.source = std::move(drawing);
  operation.name = options.operation;
  operation.operation = options.operation;
  operation.version = options.version;
  operation.inputs[options.port] = {source.id, "value"};
  return document.with(std::move(source)).with(std::move(operation));
}

/// The node that holds a drawing of that type: the one set, else the document's first; 0 for none.
template <class Drawing>
NodeId source_node(const Document& document, NodeId set) {
  if (source_of<Drawing>(document.find(set)) != nullptr) return set;
  const auto found = std::ranges::find_if(document.nodes(),
                                          [](const auto& node) { return source_of<Drawing>(node.get()) != nullptr; });
  return found == document.nodes().end() ? 0 : (*found)->id;
}

/// The first operation that takes a source by this port; 0 for none.
inline NodeId operation_on(const Document& document, NodeId source, const std::string& port) {
  for (const auto& node : document.nodes()) {
    const auto input = node->inputs.find(port);
    if (source != 0 && input != node->inputs.end() && input->second.node == source) return node->id;
  }
  return 0;
}

/// Ids of those strokes of a node that are selected, in the drawing's order.
template <class Stroke>
std::vector<std::string> selected_ids(const Session& session, NodeId node, const std::vector<Stroke>& strokes) {
  std::vector<std::string> ids;
  for (const Stroke& stroke : strokes) {
    if (std::ranges::binary_search(session.selection(), SelectedItem{node, stroke.id})) ids.push_back(stroke.id);
  }
  return ids;
}

/// Selects these strokes of a node, and nothing else.
inline void select_ids(Session& session, NodeId node, const std::vector<std::string>& ids) {
  Selection selection;
  for (const std::string& id : ids) selection.push_back({node, id});
  session.select(std::move(selection));
}

}  // namespace croquis
