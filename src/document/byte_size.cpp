// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/byte_size.h"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace croquis {
namespace {

/// A tree node's pointers and colour beside its content, as libstdc++ and libc++ lay it out.
constexpr std::size_t tree_node = 32;

std::size_t size_of(const std::string& text) { return sizeof(std::string) + text.capacity(); }

template <class T>
std::size_t size_of(const std::vector<T>& plain) {
  return plain.capacity() * sizeof(T);
}

std::size_t size_of(const std::map<std::string, std::string>& texts) {
  std::size_t bytes = 0;
  for (const auto& [key, text] : texts) bytes += tree_node + size_of(key) + size_of(text);
  return bytes;
}

std::size_t size_of(const MeshTags& tags) {
  std::size_t bytes = size_of(tags.creases) + size_of(tags.pins) + size_of(tags.sets);
  for (const CreaseSet& set : tags.sets) bytes += set.name.capacity() + size_of(set.edges) + size_of(set.pins);
  return bytes;
}

std::size_t size_of(const PolyMesh& mesh) {
  std::size_t bytes = sizeof(PolyMesh) + size_of(mesh.positions) + size_of(mesh.face_offsets) + size_of(mesh.corners) +
                      size_of(mesh.line_offsets) + size_of(mesh.line_vertices) + size_of(mesh.channels) +
                      size_of(mesh.tags);
  for (const AttributeChannel& channel : mesh.channels) {
    bytes += channel.name.capacity();
    bytes += std::visit([](const auto& values) { return size_of(values); }, channel.data);
    for (const std::string& label : channel.labels) bytes += size_of(label);
  }
  return bytes;
}

std::size_t size_of(const Drawing& drawing) {
  std::size_t bytes = sizeof(Drawing) + drawing.file.capacity() + size_of(drawing.strokes);
  for (const Stroke& stroke : drawing.strokes) {
    bytes += stroke.id.capacity() + stroke.object.capacity() + size_of(stroke.samples) + size_of(stroke.data);
  }
  for (const auto& [object, data] : drawing.object_data) bytes += tree_node + size_of(object) + size_of(data);
  return bytes;
}

std::size_t size_of(const Report& report) {
  std::size_t bytes = sizeof(Report);
  if (const auto* text = std::get_if<std::string>(&report.value())) bytes += text->capacity();
  if (const auto* array = std::get_if<Report::Array>(&report.value())) {
    for (const Report& element : *array) bytes += size_of(element);
  }
  if (const auto* object = std::get_if<Report::Object>(&report.value())) {
    for (const auto& [key, member] : *object) bytes += size_of(key) + size_of(member);
  }
  return bytes;
}

}  // namespace

std::size_t byte_size(const Value& value) {
  return std::visit([](const auto& content) { return content ? size_of(*content) : 0; }, value);
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
  std::size_t bytes = sizeof(Node) + node.name.capacity() + node.operation.capacity();
  for (const auto& [name, value] : node.parameters) {
    bytes += tree_node + size_of(name) + sizeof(ParameterValue);
    if (const auto* text = std::get_if<std::string>(&value)) bytes += text->capacity();
    // What a text stands for is about as large as the text.
    if (const auto* parsed = std::get_if<ParsedText>(&value)) bytes += 2 * parsed->text().capacity();
  }
  for (const auto& [port, link] : node.inputs)
    bytes += tree_node + size_of(port) + sizeof(Link) + link.output.capacity();
  return bytes;
}

}  // namespace croquis
