// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/node_reader.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "croquis/document/byte_stream.h"

namespace croquis {
namespace {

using RowsById = std::map<NodeId, NodeRow>;

/// The last id can't be used: the next one must be greater.
bool usable_id(NodeId id) { return id != 0 && id != std::numeric_limits<NodeId>::max(); }

bool is_bit(std::int64_t value) { return value == 0 || value == 1; }

bool is_int(std::int64_t value) {
  return value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
}

void read_node(const Statement& row, RowsById& rows, DamageLog& damage) {
  NodeRow read;
  read.node.id = from_row_id(row.integer(0));
  read.position = row.integer(1);
  read.node.name = row.text(2);
  read.node.operation = row.text(3);
  const std::int64_t version = row.integer(4);
  const std::int64_t visible = row.integer(5);
  if (!usable_id(read.node.id) || !is_int(version) || !is_bit(visible)) {
    damage.lose(title_of(read.node) + " has values that can't be and is left out", {node_subject(read.node)});
    return;
  }
  read.node.version = static_cast<int>(version);
  read.node.visible = visible == 1;
  const NodeId id = read.node.id;
  rows.insert_or_assign(id, std::move(read));
}

std::optional<double> read_number(const Statement& row) {
  if (row.is_number(3)) return row.number(3);
  if (!row.is_blob(3)) return std::nullopt;
  std::array<char, sizeof(double)> bytes{};
  const std::string_view blob = row.blob(3);
  if (blob.size() != bytes.size()) return std::nullopt;
  std::copy(blob.begin(), blob.end(), bytes.begin());
  return from_little_endian<double>(bytes);
}

std::optional<ParameterValue> read_parameter_value(const Statement& row) {
  const std::string_view type = row.text(2);
  if (type == "flag" && row.is_integer(3) && is_bit(row.integer(3))) return row.integer(3) == 1;
  if (type == "integer" && row.is_integer(3)) return row.integer(3);
  if (type == "text" && row.is_text(3)) return std::string(row.text(3));
  if (type != "number") return std::nullopt;
  const auto number = read_number(row);
  return number ? std::optional<ParameterValue>(*number) : std::nullopt;
}

void lose(const Node& node, const std::string& loss, DamageLog& damage) {
  damage.lose(title_of(node) + loss, {node_subject(node)});
}

void read_parameter(const Statement& row, NodeRow& owner, DamageLog& damage) {
  const std::string name(row.text(1));
  if (auto value = read_parameter_value(row)) {
    owner.node.parameters.insert_or_assign(name, *std::move(value));
    return;
  }
  damage.lose(title_of(owner.node) + " has lost its parameter '" + printable(name) + "'",
              {node_subject(owner.node), {SubjectKind::Parameter, printable(name), {}, {}, {}}});
}

/// The numbers of a value in a column. @throws BadBytes
template <typename T>
T numbers_in(const Statement& row, int column) {
  return from_number_bytes<T>(row.is_blob(column) ? row.blob(column) : std::string_view());
}

/// Reads what a row holds of a node, or loses it.
template <typename Read>
void read_or_lose(const Node& node, const char* what, DamageLog& damage, const Read& read) {
  try {
    read();
  } catch (const BadBytes&) {
    lose(node, std::string(" has lost ") + what, damage);
  }
}

void read_backdrop(const Statement& row, NodeRow& owner) {
  if (!is_bit(row.integer(3))) throw BadBytes("a flag is neither 0 nor 1");
  Backdrop backdrop = numbers_in<Backdrop>(row, 2);
  backdrop.visible = row.integer(3) == 1;
  owner.backdrop = backdrop;
  owner.picture_hash = row.blob(1);
}

void read_object(const Statement& row, NodeRow& owner) {
  const auto placement = numbers_in<Placement>(row, 1);
  if (!row.is_text(2) || !is_valid(placement)) throw BadBytes("it is no place");
  owner.node.placement = placement;
  owner.node.group = row.text(2);
}

std::optional<ValueType> kind_of(std::string_view word, std::span<const ValueType> types) {
  const auto found = std::find_if(types.begin(), types.end(), [&](ValueType type) { return word == to_string(type); });
  return found == types.end() ? std::nullopt : std::optional(*found);
}

std::vector<NodeRow> in_order(RowsById rows) {
  std::vector<NodeRow> ordered;
  ordered.reserve(rows.size());
  for (auto& [id, row] : rows) ordered.push_back(std::move(row));
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const NodeRow& a, const NodeRow& b) { return a.position < b.position; });
  return ordered;
}

}  // namespace

std::string title_of(const Node& node) {
  return "node " + std::to_string(node.id) + " ('" + printable(node.name) + "')";
}

Subject node_subject(const Node& node) { return {SubjectKind::Node, std::to_string(node.id), {}, {}, {}}; }

std::vector<NodeRow> read_node_rows(const Database& database, std::span<const ValueType> types,
                                    const std::set<TableGroup>& tables, DamageLog& damage) {
  RowsById rows;
  // Rows that begin with the id of a node; those of no node are passed over.
  const auto each_of_node = [&](const char* sql, const char* what, const auto& use) {
    each_row(database, sql, what, damage, [&](const Statement& row) {
      const auto owner = rows.find(from_row_id(row.integer(0)));
      if (owner != rows.end()) use(row, owner->second);
    });
  };
  each_row(database, "SELECT id, position, name, operation, version, visible FROM nodes", "objects and steps", damage,
           [&](const Statement& row) { read_node(row, rows, damage); });
  each_of_node("SELECT node, name, type, value FROM parameters", "parameters",
               [&](const Statement& row, NodeRow& owner) { read_parameter(row, owner, damage); });
  each_of_node("SELECT node, input, source, output FROM links", "links between steps",
               [](const Statement& row, NodeRow& owner) {
                 std::string input(row.text(1));
                 owner.node.inputs.insert_or_assign(std::move(input),
                                                    Link{from_row_id(row.integer(2)), std::string(row.text(3))});
               });
  each_of_node("SELECT node, kind, hash FROM sources", "drawings and meshes",
               [&](const Statement& row, NodeRow& owner) {
                 owner.kind = kind_of(row.text(1), types);
                 if (owner.kind) {
                   owner.hash = row.blob(2);
                 } else {
                   lose(owner.node, " is of a kind that this version doesn't know and is left out", damage);
                   rows.erase(NodeId{owner.node.id});
                 }
               });
  if (tables.contains(TableGroup::Placements)) {
    each_of_node("SELECT node, numbers FROM transforms", "places in space", [&](const Statement& row, NodeRow& owner) {
      read_or_lose(owner.node, "its transform", damage, [&] { owner.node.transform = numbers_in<Affine3>(row, 1); });
    });
    each_of_node("SELECT node FROM nodes_off", "steps that are off",
                 [](const Statement&, NodeRow& owner) { owner.node.enabled = false; });
  }
  if (tables.contains(TableGroup::Backdrops)) {
    each_of_node("SELECT node, hash, numbers, visible FROM backdrops", "pictures behind drawings",
                 [&](const Statement& row, NodeRow& owner) {
                   read_or_lose(owner.node, "the picture behind it", damage, [&] { read_backdrop(row, owner); });
                 });
  }
  if (tables.contains(TableGroup::Objects)) {
    each_of_node("SELECT node, numbers, object_group FROM objects", "objects",
                 [&](const Statement& row, NodeRow& owner) {
                   read_or_lose(owner.node, "its place", damage, [&] { read_object(row, owner); });
                 });
  }
  return in_order(std::move(rows));
}

}  // namespace croquis
