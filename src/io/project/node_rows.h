// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "croquis/document/document.h"

/// What the tables hold of one node, between a Document and the rows of a database.
namespace croquis {

/// A node whose source is named by the hash of its bytes instead of being there.
struct NodeRow {
  Node node;  ///< without its source
  std::int64_t position = 0;
  std::optional<ValueType> kind;  ///< of the source
  std::string hash;               ///< of the source's bytes
};

/// The canonical bytes of a row: a project's checksum is taken over those of all its nodes.
std::string row_bytes(const NodeRow& row);

/// A transform's 12 numbers (the rows of the linear part, then the offset) as 96 bytes.
std::string transform_bytes(const Affine3& transform);

/// Identifiers are unsigned in a document and signed in SQLite: the same bits.
inline std::int64_t to_row_id(NodeId id) { return static_cast<std::int64_t>(id); }
inline NodeId from_row_id(std::int64_t id) { return static_cast<NodeId>(id); }

/// "flag", "integer", "number" or "text", in the order of ParameterValue's alternatives.
const char* type_word(const ParameterValue& value);

}  // namespace croquis
