// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mesh_property.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/error.h"

namespace croquis::test {
namespace {

std::string wrong_findings(const Error& error) {
  if (error.findings().empty() || !has_errors(error.findings())) return "an error without errors";
  for (const Finding& finding : error.findings()) {
    if (finding.code.empty() || finding.message.find("fuzzed") == std::string::npos) return "a finding without a name";
  }
  return error.findings().size() > 2000 ? "too many findings" : "";
}

std::string broken_round_trip(const PolyMesh& mesh, MeshFormat format, bool ascii) {
  Progress progress;
  const std::string bytes = write_mesh(mesh, format, {0, ascii}, progress).bytes;
  try {
    const PolyMesh back = read_mesh({bytes, format, "fuzzed", false}, progress).mesh;
    if (!same_connectivity(mesh, back)) return "the written mesh reads back differently";
    if (mesh.positions != back.positions) return "the written positions read back differently";
    if (format == MeshFormat::Obj && !same_tags(mesh.tags, back.tags)) return "the written tags read back differently";
  } catch (const Error& error) {
    return std::string("the written mesh is refused: ") + error.what();
  }
  return "";
}

/// What GLB holds comes back: faces, and positions that fit its 32-bit numbers. Polylines come back in pieces.
std::string broken_glb(const PolyMesh& mesh) {
  const auto exact = [](const Vec3& p) { return p == p.cast<float>().cast<double>(); };
  if (mesh.face_count() == 0 || !std::all_of(mesh.positions.begin(), mesh.positions.end(), exact)) return "";
  Progress progress;
  const std::string bytes = write_mesh(mesh, MeshFormat::Glb, {}, progress).bytes;
  try {
    const PolyMesh back = read_mesh({bytes, MeshFormat::Glb, "fuzzed", false}, progress).mesh;
    if (mesh.corners != back.corners) return "the written faces read back differently";
    if (mesh.positions != back.positions) return "the written positions read back differently";
  } catch (const Error& error) {
    return std::string("the written mesh is refused: ") + error.what();
  }
  return "";
}

}  // namespace

bool same_connectivity(const PolyMesh& a, const PolyMesh& b) {
  return a.vertex_count() == b.vertex_count() && a.face_offsets == b.face_offsets && a.corners == b.corners &&
         a.line_offsets == b.line_offsets && a.line_vertices == b.line_vertices;
}

bool same_tags(const MeshTags& a, const MeshTags& b) {
  const auto same_sharpness = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  const auto same_crease = [&](const Crease& x, const Crease& y) {
    return x.vertices == y.vertices && same_sharpness(x.sharpness, y.sharpness);
  };
  return std::equal(a.creases.begin(), a.creases.end(), b.creases.begin(), b.creases.end(), same_crease) &&
         a.pins == b.pins && a.sets == b.sets;
}

bool usable(const PolyMesh& mesh) {
  const auto in_range = [&](Index v) { return v < mesh.vertex_count(); };
  const auto finite = [](const Vec3& p) { return p.allFinite(); };
  const auto fits = [&](const AttributeChannel& channel) {
    return channel.size() == mesh.element_count(channel.domain) * static_cast<std::size_t>(channel.width);
  };
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face_offsets[f + 1] < mesh.face_offsets[f] + 3) return false;
  }
  return mesh.face_offsets.back() == mesh.corners.size() && mesh.line_offsets.back() == mesh.line_vertices.size() &&
         std::all_of(mesh.corners.begin(), mesh.corners.end(), in_range) &&
         std::all_of(mesh.line_vertices.begin(), mesh.line_vertices.end(), in_range) &&
         std::all_of(mesh.positions.begin(), mesh.positions.end(), finite) &&
         std::all_of(mesh.channels.begin(), mesh.channels.end(), fits);
}

std::string broken_property(std::string_view bytes, MeshFormat format) {
  Progress progress;
  PolyMesh mesh;
  try {
    mesh = read_mesh({bytes, format, "fuzzed", false}, progress).mesh;
  } catch (const Error& error) {
    return wrong_findings(error);
  }
  if (!usable(mesh)) return "the mesh is not usable";
  if (format == MeshFormat::Glb) return broken_glb(mesh);
  // As text where there is a choice: binary STL can't hold what a text one may say.
  const std::string broken = broken_round_trip(mesh, format, true);
  return broken.empty() && format == MeshFormat::Ply ? broken_round_trip(mesh, format, false) : broken;
}

}  // namespace croquis::test
