// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/value_bytes.h"

#include <memory>

namespace croquis {
namespace {

constexpr std::uint32_t layout_version = 1;

struct Encoder {
  ByteWriter& writer;
  void operator()(const std::shared_ptr<const PolyMesh>& mesh) const { write_mesh_bytes(*mesh, writer); }
  void operator()(const std::shared_ptr<const Drawing>& drawing) const { write_drawing_bytes(*drawing, writer); }
  void operator()(const std::shared_ptr<const Report>& report) const { write_report_bytes(*report, writer); }
};

Value read_value(ValueType type, ByteReader& reader) {
  switch (type) {
    case ValueType::Mesh: return std::make_shared<const PolyMesh>(read_mesh_bytes(reader));
    case ValueType::Drawing: return std::make_shared<const Drawing>(read_drawing_bytes(reader));
    case ValueType::Report: return std::make_shared<const Report>(read_report_bytes(reader));
  }
  throw BadBytes("its kind is not known");
}

}  // namespace

std::string encode(const Value& value) {
  ByteWriter writer;
  writer.number(layout_version);
  std::visit(Encoder{writer}, value);
  return writer.take();
}

Value decode(ValueType type, std::string_view bytes) {
  ByteReader reader(bytes);
  if (reader.number<std::uint32_t>() != layout_version) throw BadBytes("its layout is not known");
  Value value = read_value(type, reader);
  reader.finish();
  return value;
}

}  // namespace croquis
