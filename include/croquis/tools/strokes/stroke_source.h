// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "croquis/session/session.h"

/// What tools that draw strokes do with the source of these, whatever kind of drawing it holds.
namespace croquis {

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
