// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/node_rows.h"

#include <array>
#include <utility>

namespace croquis {
namespace {

struct ParameterBytes {
  ByteWriter& writer;
  void operator()(bool value) const { writer.flag(value); }
  void operator()(const std::string& value) const { writer.text(value); }
  void operator()(const ParsedText& value) const { writer.text(value.text()); }
  template <typename Number>
  void operator()(Number value) const {
    writer.number(value);
  }
};

}  // namespace

const char* type_word(const ParameterValue& value) {
  static constexpr std::array<const char*, 5> words = {"flag", "integer", "number", "text", "text"};
  return words[value.index()];
}

std::string row_bytes(const NodeRow& row) {
  ByteWriter writer;
  writer.number(row.node.id);
  writer.number(row.position);
  writer.text(row.node.name);
  writer.text(row.node.operation);
  writer.number(static_cast<std::int64_t>(row.node.version));
  writer.flag(row.node.visible);
  writer.count(row.node.parameters.size());
  for (const auto& [name, value] : row.node.parameters) {
    writer.text(name);
    writer.text(type_word(value));
    std::visit(ParameterBytes{writer}, value);
  }
  writer.count(row.node.inputs.size());
  for (const auto& [input, link] : row.node.inputs) {
    writer.text(input);
    writer.number(link.node);
    writer.text(link.output);
  }
  writer.text(row.kind ? to_string(*row.kind) : "");
  writer.text(row.hash);
  // After everything else and only where they are, so that the bytes of all other rows stay as they were.
  if (!row.node.transform.is_identity()) writer.text(number_bytes(row.node.transform));
  if (!row.node.enabled) writer.flag(false);
  if (row.backdrop) {
    writer.text(row.picture_hash);
    writer.text(number_bytes(*row.backdrop));
    writer.flag(row.backdrop->visible);
  }
  if (has_object_row(row.node)) {
    writer.text(number_bytes(row.node.placement));
    writer.text(row.node.group);
  }
  return writer.take();
}

namespace {

ParameterValue parameter_value_from(ByteReader& reader) {
  const std::string type = reader.text();
  if (type == "flag") return reader.flag();
  if (type == "integer") return reader.number<std::int64_t>();
  if (type == "number") return reader.number<double>();
  if (type == "text") return reader.text();
  throw BadBytes("a parameter is of no known type");
}

std::optional<ValueType> value_type_of(std::string_view word) {
  if (word.empty()) return std::nullopt;
  for (const ValueType type : value_types()) {
    if (word == to_string(type)) return type;
  }
  throw BadBytes("a value is of no known type");
}

}  // namespace

std::string past_row_bytes(const NodeRow& row) {
  ByteWriter writer;
  for (const bool has :
       {!row.node.transform.is_identity(), !row.node.enabled, row.backdrop.has_value(), has_object_row(row.node)}) {
    writer.flag(has);
  }
  return writer.take() + row_bytes(row);
}

NodeRow past_row_of(std::string_view bytes) {
  ByteReader reader(bytes);
  const bool has_transform = reader.flag(), is_off = reader.flag(), has_backdrop = reader.flag(),
             has_object = reader.flag();
  NodeRow row;
  row.node.id = reader.number<NodeId>();
  row.position = reader.number<std::int64_t>();
  row.node.name = reader.text();
  row.node.operation = reader.text();
  row.node.version = static_cast<int>(reader.number<std::int64_t>());
  row.node.visible = reader.flag();
  for (std::size_t left = reader.count(1); left > 0; --left) {
    std::string name = reader.text();
    row.node.parameters.insert_or_assign(std::move(name), parameter_value_from(reader));
  }
  for (std::size_t left = reader.count(1); left > 0; --left) {
    std::string input = reader.text();
    const auto source = reader.number<NodeId>();
    row.node.inputs.insert_or_assign(std::move(input), Link{source, reader.text()});
  }
  row.kind = value_type_of(reader.text());
  row.hash = reader.text();
  if (has_transform) row.node.transform = from_number_bytes<Affine3>(reader.text());
  if (is_off) row.node.enabled = reader.flag();
  if (has_backdrop) {
    row.picture_hash = reader.text();
    row.backdrop = from_number_bytes<Backdrop>(reader.text());
    row.backdrop->visible = reader.flag();
  }
  if (has_object) {
    row.node.placement = from_number_bytes<Placement>(reader.text());
    row.node.group = reader.text();
  }
  reader.finish();
  return row;
}

std::vector<double*> numbers_of(Affine3& transform) {
  std::vector<double*> numbers;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) numbers.push_back(&transform.linear(i, k));
  }
  for (double& coordinate : transform.offset) numbers.push_back(&coordinate);
  return numbers;
}

std::vector<double*> numbers_of(Placement& placement) {
  std::vector<double*> numbers;
  for (Vec3* vector : {&placement.position, &placement.rotation, &placement.scale}) {
    for (double& number : *vector) numbers.push_back(&number);
  }
  return numbers;
}

std::vector<double*> numbers_of(Backdrop& backdrop) {
  return {&backdrop.centre.x(), &backdrop.centre.y(), &backdrop.scale, &backdrop.opacity};
}

}  // namespace croquis
