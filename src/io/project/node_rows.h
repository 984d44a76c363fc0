// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/document/backdrop.h"
#include "croquis/document/byte_stream.h"
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

/// The numbers that files hold of a transform (12: the rows of the linear part, then the offset), of a placement (9:
/// position, rotation, scale) and of a backdrop (4: its centre's x and y, scale, opacity), in their order.
std::vector<double*> numbers_of(Affine3& transform);
std::vector<double*> numbers_of(Placement& placement);
std::vector<double*> numbers_of(Backdrop& backdrop);

/// These numbers as 8 bytes each.
template <typename T>
std::string number_bytes(T value) {
  ByteWriter writer;
  for (const double* number : numbers_of(value)) writer.number(*number);
  return writer.take();
}

/// @throws BadBytes
template <typename T>
T from_number_bytes(std::string_view bytes) {
  T value;
  ByteReader reader(bytes);
  for (double* number : numbers_of(value)) *number = reader.number<double>();
  reader.finish();
  return value;
}

/// Whether the node has a row in the table of objects.
inline bool has_object_row(const Node& node) { return !(node.placement == Placement()) || !node.group.empty(); }

/// Identifiers are unsigned in a document and signed in SQLite: the same bits.
inline std::int64_t to_row_id(NodeId id) { return static_cast<std::int64_t>(id); }
inline NodeId from_row_id(std::int64_t id) { return static_cast<NodeId>(id); }

/// "flag", "integer", "number" or "text", in the order of ParameterValue's alternatives.
const char* type_word(const ParameterValue& value);

}  // namespace croquis
