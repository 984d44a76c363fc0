// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/project_writer.h"

#include <bit>
#include <cmath>
#include <set>
#include <utility>

#include "croquis/document/byte_stream.h"
#include "croquis/document/value_bytes.h"
#include "io/project/blob_store.h"
#include "io/project/schema.h"

namespace croquis {
namespace {

/// Binds a parameter's value to place 3.
struct ParameterBinder {
  Statement& statement;
  std::string& scratch;
  void operator()(bool value) const { statement.bind(3, std::int64_t{value}); }
  void operator()(std::int64_t value) const { statement.bind(3, value); }
  void operator()(const std::string& value) const { statement.bind_text(3, value); }
  void operator()(double value) const {
    // SQLite has no NaN and no negative zero; these go as their bytes.
    if (!std::isnan(value) && (value != 0 || !std::signbit(value))) {
      statement.bind(3, value);
      return;
    }
    const auto bytes = little_endian(value);
    scratch.assign(bytes.begin(), bytes.end());
    statement.bind_blob(3, scratch);
  }
};

void insert_parameters(const Database& database, const Node& node) {
  Statement statement(database, "INSERT INTO parameters(node, name, type, value) VALUES(?, ?, ?, ?)");
  for (const auto& [name, value] : node.parameters) {
    std::string scratch;
    statement.bind(0, to_row_id(node.id)).bind_text(1, name).bind_text(2, type_word(value));
    std::visit(ParameterBinder{statement, scratch}, value);
    statement.run();
  }
}

/// What few nodes have lies in tables of its own, which other projects don't have: these stay what they were.
void insert_rare_parts(Database& database, const NodeRow& row) {
  const Node& node = row.node;
  const std::int64_t id = to_row_id(node.id);
  if (!node.transform.is_identity()) {
    require_tables(database, TableGroup::Placements);
    run_statement(database, "INSERT INTO transforms(node, numbers) VALUES(?, ?)", id,
                  Bytes{number_bytes(node.transform)});
  }
  if (!node.enabled) {
    require_tables(database, TableGroup::Placements);
    run_statement(database, "INSERT INTO nodes_off(node) VALUES(?)", id);
  }
  if (has_object_row(node)) {
    require_tables(database, TableGroup::Objects);
    run_statement(database, "INSERT INTO objects(node, numbers, object_group) VALUES(?, ?, ?)", id,
                  Bytes{number_bytes(node.placement)}, node.group);
  }
  if (row.backdrop) {
    require_tables(database, TableGroup::Backdrops);
    run_statement(database, "INSERT INTO backdrops(node, hash, numbers, visible) VALUES(?, ?, ?, ?)", id,
                  Bytes{row.picture_hash}, Bytes{number_bytes(*row.backdrop)}, std::int64_t{row.backdrop->visible});
  }
}

}  // namespace

void ProjectWriter::write(const Document& document, const KeptWork& kept, Progress& progress) {
  State next;
  next.document = document;
  next.kept = kept;
  const auto& nodes = document.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = *nodes[i];
    next.entries[node.id] = {row_of(node, i, next, progress), &node};
    progress.report(static_cast<double>(i + 1) / static_cast<double>(nodes.size()));
  }
  for (const auto& [id, entry] : confirmed_.entries) {
    if (!next.entries.contains(id)) remove(id);
  }
  write_results(next, progress);
  write_past(next, progress);
  remove_unused_blobs(database_);
  write_checksum(next);
  written_ = std::move(next);
}

void ProjectWriter::confirm() { confirmed_ = std::move(written_); }

NodeRow ProjectWriter::row_of(const Node& node, std::size_t position, State& next, const Progress& progress) {
  const auto old = confirmed_.entries.find(node.id);
  const bool known = old != confirmed_.entries.end();
  const bool unmoved =
      known && old->second.node == &node && old->second.row.position == static_cast<std::int64_t>(position);
  NodeRow row = unplaced_row(node, next, progress);
  row.position = static_cast<std::int64_t>(position);
  if (unmoved) return row;
  if (known) remove(node.id);
  insert(row);
  return row;
}

NodeRow ProjectWriter::unplaced_row(const Node& node, State& next, const Progress& progress) {
  NodeRow row{node, 0, std::nullopt, {}};
  row.node.source.reset();
  row.node.backdrop.reset();
  if (node.source) {
    row.kind = node.source->type();
    row.hash = hash_of(*node.source, next, progress);
  }
  if (node.backdrop) {
    row.backdrop = *node.backdrop;
    row.backdrop->picture.reset();
    row.picture_hash = hash_of(node.backdrop->picture, next, progress);
  }
  return row;
}

std::string ProjectWriter::hash_of(const Value& value, State& next, const Progress& progress) {
  const void* address = value.content().get();
  for (const State* state : {&std::as_const(confirmed_), &std::as_const(next)}) {
    const auto known = state->hashes.find(address);
    if (known != state->hashes.end()) return next.hashes[address] = std::string(known->second);
  }
  const std::string bytes = encode(value);
  const std::string hash = blob_hash(bytes);
  store_blob(database_, hash, bytes, progress);
  return next.hashes[address] = hash;
}

void ProjectWriter::insert(const NodeRow& row) {
  const Node& node = row.node;
  const std::int64_t id = to_row_id(node.id);
  run_statement(database_,
                "INSERT INTO nodes(id, position, name, operation, version, visible) VALUES(?, ?, ?, ?, ?, ?)", id,
                row.position, node.name, node.operation, std::int64_t{node.version}, std::int64_t{node.visible});
  insert_parameters(database_, node);
  for (const auto& [input, link] : node.inputs) {
    run_statement(database_, "INSERT INTO links(node, input, source, output) VALUES(?, ?, ?, ?)", id, input,
                  to_row_id(link.node), link.output);
  }
  insert_rare_parts(database_, row);
  if (!row.kind) return;
  run_statement(database_, "INSERT INTO sources(node, kind, hash) VALUES(?, ?, ?)", id, to_string(*row.kind),
                Bytes{row.hash});
}

void ProjectWriter::remove(NodeId id) {
  const auto delete_from = [&](const std::string& table) {
    run_statement(database_, "DELETE FROM " + table + " WHERE " + (table == "nodes" ? "id" : "node") + "=?",
                  to_row_id(id));
  };
  for (const char* table : {"nodes", "parameters", "links", "sources"}) delete_from(table);
  for (const auto& [group, table] :
       {std::pair(TableGroup::Backdrops, "backdrops"), std::pair(TableGroup::Objects, "objects"),
        std::pair(TableGroup::Placements, "transforms"), std::pair(TableGroup::Placements, "nodes_off")}) {
    if (has_tables(database_, group)) delete_from(table);
  }
}

void ProjectWriter::write_results(State& next, const Progress& progress) {
  if (has_tables(database_, TableGroup::Results)) database_.execute("DELETE FROM kept_results");
  for (const auto& [id, kept] : next.kept.results) {
    for (const auto& [role, value] : {std::pair("result", &kept.result), std::pair("edited", &kept.edited)}) {
      if (!value->has_content()) continue;
      require_tables(database_, TableGroup::Results);
      const std::string hash = hash_of(*value, next, progress);
      run_statement(database_, "INSERT INTO kept_results(node, role, kind, hash) VALUES(?, ?, ?, ?)", to_row_id(id),
                    role, to_string(value->type()), Bytes{hash});
    }
  }
}

void ProjectWriter::write_past(State& next, const Progress& progress) {
  const KeptWork& kept = next.kept;
  if (kept.past.empty() && kept.versions.empty() && !has_tables(database_, TableGroup::Past)) return;
  require_tables(database_, TableGroup::Past);
  database_.execute("DELETE FROM past");
  if (has_tables(database_, TableGroup::Versions)) database_.execute("DELETE FROM versions");
  std::int64_t number = 0;
  for (const PastDocument& past : kept.past) {
    run_statement(database_, "INSERT INTO past(number, label, next_id, nodes) VALUES(?, ?, ?, ?)", number++, past.label,
                  to_row_id(past.document.next_id()), Bytes{stored_nodes(past.document, next, progress)});
  }
  for (const Version& version : kept.versions) {
    require_tables(database_, TableGroup::Versions);
    const auto& png = version.picture_png;
    run_statement(database_, "INSERT INTO versions(number, name, next_id, nodes, png) VALUES(?, ?, ?, ?, ?)", number++,
                  version.name, to_row_id(version.document.next_id()),
                  Bytes{stored_nodes(version.document, next, progress)}, Bytes{std::string(png.begin(), png.end())});
  }
  std::set<std::string> used;
  for (const auto& [node, hash] : next.past) used.insert(hash);
  for (const auto& [node, hash] : confirmed_.past) {
    if (used.contains(hash)) continue;
    run_statement(database_, "DELETE FROM past_nodes WHERE hash=?", Bytes{hash});
  }
}

/// Each state of a node is stored once, however many documents have it. @return the hashes of all nodes in their order
std::string ProjectWriter::stored_nodes(const Document& document, State& next, const Progress& progress) {
  std::string hashes;
  for (const auto& node : document.nodes()) {
    const NodeRow row = unplaced_row(*node, next, progress);
    std::string& hash = next.past[node.get()];
    const auto known = confirmed_.past.find(node.get());
    if (known != confirmed_.past.end()) {
      hash = known->second;
    } else if (hash.empty()) {
      const std::string bytes = past_row_bytes(row);
      hash = blob_hash(bytes);
      run_statement(database_, "INSERT OR IGNORE INTO past_nodes(hash, bytes, source, picture) VALUES(?, ?, ?, ?)",
                    Bytes{hash}, Bytes{bytes}, Bytes{row.hash}, Bytes{row.picture_hash});
    }
    hashes += hash;
  }
  return hashes;
}

void ProjectWriter::write_meta(const std::string& key, const std::string& value) {
  run_statement(database_, "INSERT OR REPLACE INTO meta(key, value) VALUES(?, ?)", key, value);
}

void ProjectWriter::write_thumbnail(const std::vector<std::uint8_t>& png) {
  if (png.empty()) return;
  const Bytes bytes{{reinterpret_cast<const char*>(png.data()), png.size()}};
  run_statement(database_, "INSERT OR REPLACE INTO thumbnail(id, png) VALUES(1, ?)", bytes);
}

void ProjectWriter::write_checksum(const State& state) {
  std::vector<const NodeRow*> rows;
  for (const auto& node : state.document.nodes()) rows.push_back(&state.entries.at(node->id).row);
  const NodeId next_id = state.document.next_id();
  write_meta("next_id", std::to_string(next_id));
  const std::string checksum = nodes_checksum(rows, next_id);
  run_statement(database_, "INSERT OR REPLACE INTO meta(key, value) VALUES('checksum', ?)", Bytes{checksum});
}

std::string nodes_checksum(const std::vector<const NodeRow*>& rows, NodeId next_id) {
  ByteWriter writer;
  writer.number(next_id);
  for (const NodeRow* row : rows) writer.text(row_bytes(*row));
  return blob_hash(writer.take());
}

}  // namespace croquis
