// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/document/document.h"
#include "croquis/document/kept_work.h"
#include "io/project/database.h"
#include "io/project/node_rows.h"

namespace croquis {

/// Keeps a database equal to a document. It writes what has changed since its last document: nodes are compared by
/// address, and values that stay are neither encoded nor written again. The caller opens and ends transactions.
/// Members throw DatabaseError, Cancelled, Error.
class ProjectWriter {
 public:
  /// @param database has the schema and no nodes; must outlive the writer
  explicit ProjectWriter(Database& database) : database_(database) {}

  /// To be called inside a transaction.
  void write(const Document& document, const KeptWork& kept, Progress& progress);

  /// The transaction of the last `write` is on disk: later ones start from here.
  void confirm();

  void write_meta(const std::string& key, const std::string& value);
  void write_thumbnail(const std::vector<std::uint8_t>& png);

 private:
  struct Entry {
    NodeRow row;
    const Node* node = nullptr;  ///< in the state's document
  };
  struct State {
    Document document;  ///< it and what is kept hold alive what the addresses below name
    KeptWork kept;
    std::map<NodeId, Entry> entries;
    std::map<const void*, std::string> hashes;  ///< of the sources' bytes, by the address of the value
    std::map<const Node*, std::string> past;    ///< of the rows of nodes of past documents and versions
  };

  NodeRow row_of(const Node& node, std::size_t position, State& next, const Progress& progress);
  std::string hash_of(const Value& value, State& next, const Progress& progress);
  void insert(const NodeRow& row);
  void remove(NodeId id);
  NodeRow unplaced_row(const Node& node, State& next, const Progress& progress);
  void write_results(State& next, const Progress& progress);
  void write_past(State& next, const Progress& progress);
  std::string stored_nodes(const Document& document, State& next, const Progress& progress);
  void write_checksum(const State& state);

  Database& database_;
  State confirmed_;
  State written_;
};

/// Over the rows of all nodes in their order: shows whether a file is as it was saved.
std::string nodes_checksum(const std::vector<const NodeRow*>& rows, NodeId next_id);

}  // namespace croquis
