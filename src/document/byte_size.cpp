// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/byte_size.h"

#include <string>
#include <variant>

#include "croquis/document/backdrop.h"
#include "document/content_size.h"

namespace croquis {
std::size_t byte_size(const Value& value) {
  return value.has_content() ? value.type().traits().byte_size(value.content().get()) : 0;
}

std::size_t byte_size(const Values& values) {
  std::size_t bytes = 0;
  for (const auto& [name, value] : values) bytes += tree_node + size_of(name) + sizeof(Value) + byte_size(value);
  return bytes;
}

std::size_t byte_size(const Findings& findings) {
  std::size_t bytes = size_of(findings);
  for (const Finding& finding : findings) {
    bytes += finding.code.capacity() + finding.message.capacity() + size_of(finding.subjects);
    for (const Subject& subject : finding.subjects) bytes += subject.id.capacity() + size_of(subject.at);
  }
  return bytes;
}

std::size_t byte_size(const Node& node) {
  std::size_t bytes = sizeof(Node) + node.name.capacity() + node.operation.capacity() + node.group.capacity();
  for (const auto& [name, value] : node.parameters) {
    bytes += tree_node + size_of(name) + sizeof(ParameterValue);
    if (const auto* text = std::get_if<std::string>(&value)) bytes += text->capacity();
    // What a text stands for is about as large as the text.
    if (const auto* parsed = std::get_if<ParsedText>(&value)) bytes += 2 * parsed->text().capacity();
  }
  for (const auto& [port, link] : node.inputs)
    bytes += tree_node + size_of(port) + sizeof(Link) + link.output.capacity();
  if (node.backdrop) bytes += sizeof(Backdrop);
  return bytes;
}

}  // namespace croquis
