// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/project_property.h"

#include <algorithm>
#include <set>

#include "croquis/base/error.h"
#include "croquis/document/value_bytes.h"
#include "croquis/io/project_file.h"

namespace croquis::test {
namespace {

bool lists_are_whole(const std::vector<Index>& offsets, const std::vector<Index>& vertices, std::size_t vertex_count) {
  return !offsets.empty() && offsets.front() == 0 && offsets.back() == vertices.size() &&
         std::is_sorted(offsets.begin(), offsets.end()) &&
         std::all_of(vertices.begin(), vertices.end(), [&](Index vertex) { return vertex < vertex_count; });
}

std::string broken_mesh(const PolyMesh& mesh) {
  if (!lists_are_whole(mesh.face_offsets, mesh.corners, mesh.vertex_count())) return "faces are not whole";
  if (!lists_are_whole(mesh.line_offsets, mesh.line_vertices, mesh.vertex_count())) return "lines are not whole";
  for (const AttributeChannel& channel : mesh.channels) {
    const std::size_t elements = mesh.element_count(channel.domain);
    if (channel.width < 1 || channel.size() != elements * static_cast<std::size_t>(channel.width)) {
      return "a channel has a wrong length";
    }
  }
  return "";
}

std::string broken_drawing(const Drawing& drawing) {
  const auto& strokes = drawing.strokes;
  if (!drawing.plane.is_orthonormal()) return "the plane has no right angle";
  const bool bare = std::any_of(strokes.begin(), strokes.end(), [](const auto& s) { return s.samples.empty(); });
  return bare ? "a stroke has no samples" : "";
}

std::string broken_network(const CurveNetwork& network) {
  for (const NetworkCurve& curve : network.curves) {
    if (curve.start >= network.vertices.size() || curve.end >= network.vertices.size()) return "a vertex is missing";
    if (curve.pieces.empty() || curve.pieces.front().points[0] != network.vertices[curve.start] ||
        curve.pieces.back().points[3] != network.vertices[curve.end]) {
      return "a curve doesn't meet its vertices";
    }
  }
  return "";
}

std::string broken_perspective_drawing(const PerspectiveDrawing& drawing) {
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (stroke.pieces.empty() || stroke.group > StrokeGroup::Unknown) return "a stroke has no pieces or no group";
  }
  return "";
}

std::string broken_content(const Value& value) {
  if (const auto mesh = value.as<PolyMesh>()) return broken_mesh(*mesh);
  if (const auto drawing = value.as<Drawing>()) return broken_drawing(*drawing);
  if (const auto network = value.as<CurveNetwork>()) return broken_network(*network);
  if (const auto drawing = value.as<PerspectiveDrawing>()) return broken_perspective_drawing(*drawing);
  if (const auto camera = value.as<Camera>()) return camera->focal_length > 0 ? "" : "a camera without focal length";
  return "";
}

std::string wrong_findings(const Error& error) {
  if (!has_errors(error.findings())) return "an error without errors";
  for (const Finding& finding : error.findings()) {
    if (finding.code.empty() || finding.message.find("fuzzed") == std::string::npos) return "a finding without a name";
  }
  return "";
}

}  // namespace

std::string broken_project(std::string_view bytes) {
  Progress progress;
  ProjectFile project;
  try {
    project = read_project(bytes, "fuzzed", progress);
  } catch (const Error& error) {
    return wrong_findings(error);
  }
  if (project.warnings.size() > 110) return "too many warnings";
  std::set<NodeId> ids;
  for (const auto& node : project.document.nodes()) {
    if (node->id == 0 || node->id >= project.document.next_id()) return "an id is out of range";
    if (!ids.insert(node->id).second) return "two nodes have one id";
    const std::string broken = node->source ? broken_content(*node->source) : "";
    if (!broken.empty()) return broken;
  }
  return "";
}

std::string broken_value(ValueType type, std::string_view bytes) {
  try {
    const Value value = decode(type, bytes);
    const std::string broken = broken_content(value);
    if (!broken.empty()) return broken;
    const std::string written = encode(value);
    return encode(decode(type, written)) == written ? "" : "it reads back differently";
  } catch (const BadBytes&) {
    return "";
  }
}

}  // namespace croquis::test
