// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "croquis/document/backdrop.h"
#include "croquis/document/document.h"

/// What the tables hold of one node, between a Document and the rows of a database.
namespace croquis {

/// A node whose source and picture are named by the hashes of their bytes instead of being there.
struct NodeRow {
  Node node;  ///< without its source and its backdrop
  std::int64_t position = 0;
  std::optional<ValueType> kind;          ///< of the source
  std::string hash;                       ///< of the source's bytes
  std::optional<Backdrop> backdrop = {};  ///< without its picture
  std::string picture_hash = {};          ///< of the picture's bytes
};

/// The canonical bytes of a row: a project's checksum is taken over those of all its nodes.
std::string row_bytes(const NodeRow& row);

/// The same for a reader: which of its parts that few nodes have follow is said first.
std::string past_row_bytes(const NodeRow& row);

/// The row of such bytes. @throws BadBytes
NodeRow past_row_of(std::string_view bytes);

/// A transform's 12 numbers (the rows of the linear part, then the offset) as 96 bytes.
std::string transform_bytes(const Affine3& transform);
Affine3 transform_of(std::string_view bytes);  ///< @throws BadBytes

/// A placement's 9 numbers (position, rotation, scale) as 72 bytes.
std::string placement_bytes(const Placement& placement);
Placement placement_of(std::string_view bytes);  ///< @throws BadBytes

/// Whether the node has a row in the table of objects.
inline bool has_object_row(const Node& node) { return !(node.placement == Placement()) || !node.group.empty(); }

/// Where a backdrop lies and how strong it is (its centre's x and y, scale, opacity) as 32 bytes.
std::string backdrop_bytes(const Backdrop& backdrop);
Backdrop backdrop_of(std::string_view bytes);  ///< @throws BadBytes

/// Identifiers are unsigned in a document and signed in SQLite: the same bits.
inline std::int64_t to_row_id(NodeId id) { return static_cast<std::int64_t>(id); }
inline NodeId from_row_id(std::int64_t id) { return static_cast<NodeId>(id); }

/// "flag", "integer", "number" or "text", in the order of ParameterValue's alternatives.
const char* type_word(const ParameterValue& value);

}  // namespace croquis
