// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/node_rows.h"

#include <array>

#include "croquis/document/byte_stream.h"

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
  if (!row.node.transform.is_identity()) writer.text(transform_bytes(row.node.transform));
  if (!row.node.enabled) writer.flag(false);
  if (row.backdrop) {
    writer.text(row.picture_hash);
    writer.text(backdrop_bytes(*row.backdrop));
    writer.flag(row.backdrop->visible);
  }
  return writer.take();
}

std::string transform_bytes(const Affine3& transform) {
  ByteWriter writer;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) writer.number(transform.linear(i, k));
  }
  for (const double coordinate : transform.offset) writer.number(coordinate);
  return writer.take();
}

std::string backdrop_bytes(const Backdrop& backdrop) {
  ByteWriter writer;
  for (const double number : {backdrop.centre.x(), backdrop.centre.y(), backdrop.scale, backdrop.opacity})
    writer.number(number);
  return writer.take();
}

}  // namespace croquis
