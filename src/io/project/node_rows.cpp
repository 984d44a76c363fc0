// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/node_rows.h"

#include <array>

#include "io/project/byte_stream.h"

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
  return writer.take();
}

}  // namespace croquis
