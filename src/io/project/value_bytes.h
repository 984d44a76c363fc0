// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/document/value.h"
#include "io/project/byte_stream.h"

namespace croquis {

/// The whole value in the canonical form, in the oldest layout that holds it: equal values give equal bytes, and
/// nothing is rounded (docs/project-file.md has the layout).
/// @throws Error (E_LIMIT) for a report nested too deeply
std::string encode(const Value& value);

/// The value of those bytes. What comes out is safe to compute with: indices and offsets are in range, channels have
/// their lengths.
/// @throws BadBytes
Value decode(ValueType type, std::string_view bytes);

void write_mesh_bytes(const PolyMesh& mesh, ByteWriter& writer);  ///< without its tags
void write_tag_bytes(const MeshTags& tags, ByteWriter& writer);
void write_drawing_bytes(const Drawing& drawing, ByteWriter& writer);
void write_report_bytes(const Report& report, ByteWriter& writer);

PolyMesh read_mesh_bytes(ByteReader& reader);  ///< without its tags
MeshTags read_tag_bytes(ByteReader& reader);
Drawing read_drawing_bytes(ByteReader& reader);
Report read_report_bytes(ByteReader& reader);

}  // namespace croquis
