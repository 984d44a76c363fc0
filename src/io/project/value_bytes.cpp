// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/value_bytes.h"

#include <memory>

namespace croquis {
namespace {

constexpr std::uint32_t first_layout = 1;
constexpr std::uint32_t tagged_layout = 2;  // of meshes with tags, which the first one has no place for

struct Encoder {
  ByteWriter& writer;
  void operator()(const std::shared_ptr<const PolyMesh>& mesh) const {
    writer.number(mesh->tags.empty() ? first_layout : tagged_layout);
    write_mesh_bytes(*mesh, writer);
    if (!mesh->tags.empty()) write_tag_bytes(mesh->tags, writer);
  }
  void operator()(const std::shared_ptr<const Drawing>& drawing) const {
    writer.number(first_layout);
    write_drawing_bytes(*drawing, writer);
  }
  void operator()(const std::shared_ptr<const Report>& report) const {
    writer.number(first_layout);
    write_report_bytes(*report, writer);
  }
};

std::shared_ptr<const PolyMesh> read_mesh(std::uint32_t layout, ByteReader& reader) {
  PolyMesh mesh = read_mesh_bytes(reader);
  if (layout == tagged_layout) mesh.tags = read_tag_bytes(reader);
  return std::make_shared<const PolyMesh>(std::move(mesh));
}

Value read_value(ValueType type, std::uint32_t layout, ByteReader& reader) {
  switch (type) {
    case ValueType::Mesh: return read_mesh(layout, reader);
    case ValueType::Drawing: return std::make_shared<const Drawing>(read_drawing_bytes(reader));
    case ValueType::Report: return std::make_shared<const Report>(read_report_bytes(reader));
  }
  throw BadBytes("its kind is not known");
}

}  // namespace

std::string encode(const Value& value) {
  ByteWriter writer;
  std::visit(Encoder{writer}, value);
  return writer.take();
}

Value decode(ValueType type, std::string_view bytes) {
  ByteReader reader(bytes);
  const auto layout = reader.number<std::uint32_t>();
  const std::uint32_t newest = type == ValueType::Mesh ? tagged_layout : first_layout;
  if (layout < first_layout || layout > newest) throw BadBytes("its layout is not known");
  Value value = read_value(type, layout, reader);
  reader.finish();
  return value;
}

}  // namespace croquis
