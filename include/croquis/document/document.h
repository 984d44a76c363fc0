// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/document/value.h"
#include "croquis/geometry/placement.h"

namespace croquis {

struct Backdrop;

/// The name of a node in links, files and selections: never used again in the same document. 0 names none.
using NodeId = std::uint64_t;

/// Where an input comes from.
struct Link {
  NodeId node = 0;
  std::string output;  ///< name of the output port; a source has one, named "value"

  friend bool operator==(const Link&, const Link&) = default;
};

/// One thing in a document: a source (a drawing, an imported mesh) or an operation with its parameters and inputs.
/// Nothing computed is kept here.
struct Node {
  NodeId id = 0;
  std::string name;                    ///< as people see it
  std::string operation;               ///< id of the operation; empty for a source
  int version = 1;                     ///< of the operation it was made with
  ParameterValues parameters;          ///< those that differ from the operation's defaults
  std::map<std::string, Link> inputs;  ///< by port name
  std::optional<Value> source;         ///< of a source, and of nothing else
  bool visible = true;

  /// What is applied to all that the node gives, a source's value too. One that isn't invertible is a finding.
  Affine3 transform = {};

  /// Of an operation: off, it computes nothing and passes on its input (see Evaluator).
  bool enabled = true;

  /// Of a drawing: the picture behind it; null for none. No computation sees it.
  std::shared_ptr<const Backdrop> backdrop = {};

  /// Of the first node of a chain: where the object stands that the chain makes. No computation sees it, so steps that
  /// come, go or change work on what they did before.
  Placement placement = {};

  /// Of the first node of a chain: the name that its object shares with others to be handled as one; empty for none.
  std::string group = {};
};

/// What a node is a source of: null where it isn't there, is no source, or holds a value of another type.
template <ValueContent T>
std::shared_ptr<const T> source_of(const Node* node) {
  return node == nullptr || !node->source ? nullptr : node->source->as<T>();
}

/// What people edit and save: an immutable value.
///
/// Editing makes a new document that shares all nodes but those edited. So undo is keeping the old value, a background
/// job works on a snapshot without locks, and saving never sees half an edit. Copies cost a vector of pointers.
class Document {
 public:
  /// Of these nodes in their order, for readers of files. O(#nodes).
  /// @param nodes   their ids differ and none is 0
  /// @param next_id raised above all of them when it is not
  static Document of(std::vector<std::shared_ptr<const Node>> nodes, NodeId next_id);

  /// In the order they were added.
  const std::vector<std::shared_ptr<const Node>>& nodes() const { return nodes_; }

  /// The node of that id, or null. O(#nodes).
  const Node* find(NodeId id) const;

  /// The node and all that it is made from, in their order. O(#nodes) for each of these.
  std::vector<std::shared_ptr<const Node>> upstream(NodeId id) const;

  /// The id that the next new node gets: greater than every id that was ever used.
  NodeId next_id() const { return next_id_; }

  /// With this node in place of the one of its id, else after the last one. Id 0 stands for next_id().
  [[nodiscard]] Document with(Node node) const;

  /// Without the node, and without the links to it. The same document when there is none of that id.
  [[nodiscard]] Document without(NodeId id) const;

  /// Whether both share every node: a cheap "nothing was edited".
  friend bool same_nodes(const Document& a, const Document& b) {
    return a.nodes_ == b.nodes_ && a.next_id_ == b.next_id_;
  }

 private:
  std::vector<std::shared_ptr<const Node>> nodes_;
  NodeId next_id_ = 1;
};

}  // namespace croquis
