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

void read_parameter(const Statement& row, RowsById& rows, DamageLog& damage) {
  const auto owner = rows.find(from_row_id(row.integer(0)));
  if (owner == rows.end()) return;
  const std::string name(row.text(1));
  if (auto value = read_parameter_value(row)) {
    owner->second.node.parameters.insert_or_assign(name, *std::move(value));
    return;
  }
  damage.lose(title_of(owner->second.node) + " has lost its parameter '" + printable(name) + "'",
              {node_subject(owner->second.node), {SubjectKind::Parameter, printable(name), {}, {}, {}}});
}

void read_link(const Statement& row, RowsById& rows) {
  const auto owner = rows.find(from_row_id(row.integer(0)));
  if (owner == rows.end()) return;
  std::string input(row.text(1));
  owner->second.node.inputs.insert_or_assign(std::move(input),
                                             Link{from_row_id(row.integer(2)), std::string(row.text(3))});
}

void read_transform(const Statement& row, RowsById& rows, DamageLog& damage) {
  const auto owner = rows.find(from_row_id(row.integer(0)));
  if (owner == rows.end()) return;
  Node& node = owner->second.node;
  try {
    node.transform = transform_of(row.is_blob(1) ? row.blob(1) : std::string_view());
  } catch (const BadBytes&) {
    damage.lose(title_of(node) + " has lost its transform", {node_subject(node)});
  }
}

void read_off(const Statement& row, RowsById& rows) {
  const auto owner = rows.find(from_row_id(row.integer(0)));
  if (owner != rows.end()) owner->second.node.enabled = false;
}

void read_backdrop(const Statement& row, RowsById& rows, DamageLog& damage) {
  const auto owner = rows.find(from_row_id(row.integer(0)));
  if (owner == rows.end()) return;
  const Node& node = owner->second.node;
  try {
    if (!is_bit(row.integer(3))) throw BadBytes("a flag is neither 0 nor 1");
    Backdrop backdrop = backdrop_of(row.is_blob(2) ? row.blob(2) : std::string_view());
    backdrop.visible = row.integer(3) == 1;
    owner->second.backdrop = backdrop;
    owner->second.picture_hash = row.blob(1);
  } catch (const BadBytes&) {
    damage.lose(title_of(node) + " has lost the picture behind it", {node_subject(node)});
  }
}

void read_object(const Statement& row, RowsById& rows, DamageLog& damage) {
  const auto owner = rows.find(from_row_id(row.integer(0)));
  if (owner == rows.end()) return;
  Node& node = owner->second.node;
  Placement placement;
  const std::string_view bytes = row.blob(1);
  const bool whole = row.is_blob(1) && bytes.size() == placement_bytes(placement).size() && row.is_text(2);
  if (whole) {
    ByteReader reader(bytes);
    for (Vec3* numbers : {&placement.position, &placement.rotation, &placement.scale}) {
      for (double& number : *numbers) number = reader.number<double>();
    }
  }
  if (!whole || !is_valid(placement)) {
    damage.lose(title_of(node) + " has lost its place", {node_subject(node)});
    return;
  }
  node.placement = placement;
  node.group = row.text(2);
}

std::optional<ValueType> kind_of(std::string_view word, std::span<const ValueType> types) {
  const auto found = std::find_if(types.begin(), types.end(), [&](ValueType type) { return word == to_string(type); });
  return found == types.end() ? std::nullopt : std::optional(*found);
}

void read_source(const Statement& row, std::span<const ValueType> types, RowsById& rows, DamageLog& damage) {
  const auto owner = rows.find(from_row_id(row.integer(0)));
  if (owner == rows.end()) return;
  const auto kind = kind_of(row.text(1), types);
  if (!kind) {
    damage.lose(title_of(owner->second.node) + " is of a kind that this version doesn't know and is left out",
                {node_subject(owner->second.node)});
    rows.erase(owner);
    return;
  }
  owner->second.kind = kind;
  owner->second.hash = row.blob(2);
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
                                    const LaterTables& later, DamageLog& damage) {
  RowsById rows;
  each_row(database, "SELECT id, position, name, operation, version, visible FROM nodes", "objects and steps", damage,
           [&](const Statement& row) { read_node(row, rows, damage); });
  each_row(database, "SELECT node, name, type, value FROM parameters", "parameters", damage,
           [&](const Statement& row) { read_parameter(row, rows, damage); });
  each_row(database, "SELECT node, input, source, output FROM links", "links between steps", damage,
           [&](const Statement& row) { read_link(row, rows); });
  each_row(database, "SELECT node, kind, hash FROM sources", "drawings and meshes", damage,
           [&](const Statement& row) { read_source(row, types, rows, damage); });
  if (later.placements) {
    each_row(database, "SELECT node, numbers FROM transforms", "places in space", damage,
             [&](const Statement& row) { read_transform(row, rows, damage); });
    each_row(database, "SELECT node FROM nodes_off", "steps that are off", damage,
             [&](const Statement& row) { read_off(row, rows); });
  }
  if (later.backdrops) {
    each_row(database, "SELECT node, hash, numbers, visible FROM backdrops", "pictures behind drawings", damage,
             [&](const Statement& row) { read_backdrop(row, rows, damage); });
  }
  if (later.objects) {
    each_row(database, "SELECT node, numbers, object_group FROM objects", "objects", damage,
             [&](const Statement& row) { read_object(row, rows, damage); });
  }
  return in_order(std::move(rows));
}

}  // namespace croquis
