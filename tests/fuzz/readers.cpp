// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <set>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/value_bytes.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/camera_file.h"
#include "croquis/io/json.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/mesh_tags_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/io/project_file.h"
#include "croquis/io/surface_places_file.h"
#include "croquis/io/svg_drawing.h"

namespace croquis::test {
namespace {

/// Texts with bytes that are no UTF-8 don't come back: writers put a replacement character there.
bool has_replaced_bytes(const std::string& written) { return written.find("\xef\xbf\xbd") != std::string::npos; }

/// Offsets ascend from 0 to the number of vertices' indices, which are in range.
bool lists_are_whole(const std::vector<Index>& offsets, const std::vector<Index>& vertices, std::size_t vertex_count) {
  return !offsets.empty() && offsets.front() == 0 && offsets.back() == vertices.size() &&
         std::ranges::is_sorted(offsets) &&
         std::ranges::all_of(vertices, [&](Index vertex) { return vertex < vertex_count; });
}

std::string broken_mesh(const PolyMesh& mesh) {
  if (!lists_are_whole(mesh.face_offsets, mesh.corners, mesh.vertex_count())) return "faces are not whole";
  if (!lists_are_whole(mesh.line_offsets, mesh.line_vertices, mesh.vertex_count())) return "lines are not whole";
  const bool fit = std::ranges::all_of(mesh.channels, [&](const AttributeChannel& channel) {
    return channel.width >= 1 &&
           channel.size() == mesh.element_count(channel.domain) * static_cast<std::size_t>(channel.width);
  });
  return fit ? "" : "a channel has a wrong length";
}

/// What readers of meshes promise beyond that: positions are finite, faces have 3 corners or more.
std::string broken_read_mesh(const PolyMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face_offsets[f + 1] < mesh.face_offsets[f] + 3) return "a face has less than three corners";
  }
  const bool finite = std::ranges::all_of(mesh.positions, [](const Vec3& p) { return p.allFinite(); });
  return finite ? broken_mesh(mesh) : "a position is not finite";
}

std::string broken_round_trip(const PolyMesh& mesh, MeshFormat format, bool ascii) {
  Progress progress;
  const std::string bytes = write_mesh(mesh, format, {0, ascii}, progress).bytes;
  try {
    const PolyMesh back = read_mesh({bytes, format, "fuzzed", false}, progress).mesh;
    // Polylines come back from GLB in pieces.
    const bool same = format == MeshFormat::Glb ? mesh.corners == back.corners : same_connectivity(mesh, back);
    if (!same) return "the written mesh reads back differently";
    if (mesh.positions != back.positions) return "the written positions read back differently";
    if (format == MeshFormat::Obj && !same_tags(mesh.tags, back.tags)) return "the written tags read back differently";
  } catch (const Error& error) {
    return std::string("the written mesh is refused: ") + error.what();
  }
  return "";
}

template <MeshFormat format>
std::string broken_mesh_file(std::string_view bytes) {
  Progress progress;
  const PolyMesh mesh = read_mesh({bytes, format, "fuzzed", false}, progress).mesh;
  std::string broken = broken_read_mesh(mesh);
  if (!broken.empty()) return broken;
  if (format == MeshFormat::Glb) {  // holds faces, and positions of 32 bits
    const auto exact = [](const Vec3& p) { return p == p.cast<float>().cast<double>(); };
    const bool fits = mesh.face_count() > 0 && std::ranges::all_of(mesh.positions, exact);
    return fits ? broken_round_trip(mesh, format, false) : "";
  }
  // As text where there is a choice: binary STL can't hold what a text one may say.
  broken = broken_round_trip(mesh, format, true);
  return broken.empty() && format == MeshFormat::Ply ? broken_round_trip(mesh, format, false) : broken;
}

std::string broken_svg(std::string_view bytes) {
  Progress progress;
  const Drawing drawing = read_svg_drawing(bytes, "fuzzed", progress).drawing;
  if (drawing.strokes.empty()) return "a drawing without strokes";
  for (const Stroke& stroke : drawing.strokes) {
    if (stroke.samples.empty() || stroke.id.empty()) return "a stroke without samples or name";
    const auto finite = [](const StrokeSample& sample) { return sample.position.allFinite(); };
    if (!std::ranges::all_of(stroke.samples, finite)) return "a sample that is not finite";
  }
  return "";
}

std::string broken_tags(std::string_view bytes) {
  const Report report = read_json(bytes, "fuzzed");
  const std::string written = write_json(report);
  if (write_json(read_json(written, "fuzzed")) != written) return "the written JSON reads back differently";
  const MeshTagsReadResult read = read_mesh_tags(report);
  if (read.warnings.size() > 200) return "too many warnings";
  const Report again = read_json(write_json(report_of(read.tags)), "fuzzed");
  return read_mesh_tags(again).tags == read.tags ? "" : "the written tags read back differently";
}

std::string broken_places(std::string_view bytes) {
  const SurfacePlacesReadResult read = read_surface_places(read_json(bytes, "fuzzed"));
  if (read.warnings.size() > 200) return "too many warnings";
  const std::string written = write_json(report_of(read.places));
  if (has_replaced_bytes(written)) return "";
  const SurfacePlacesReadResult again = read_surface_places(read_json(written, "fuzzed"));
  if (!again.warnings.empty()) return "the written places have unknown members";
  return again.places == read.places ? "" : "the written places read back differently";
}

std::string broken_attribute_network(std::string_view bytes) {
  const AttributeNetworkReadResult read = read_attribute_network(bytes, "fuzzed");
  if (!validate(read.network).empty()) return "a network that isn't valid";
  if (read.warnings.size() > 200) return "too many warnings";
  const std::string written = write_attribute_network(read.network);
  if (has_replaced_bytes(written)) return "";
  const AttributeNetworkReadResult again = read_attribute_network(written, "fuzzed");
  if (!again.warnings.empty()) return "the written network has unknown members";
  const auto bytes_of = [](const AttributeNetwork& n) { return encode(std::make_shared<const AttributeNetwork>(n)); };
  return bytes_of(again.network) == bytes_of(read.network) ? "" : "the written network reads back differently";
}

std::string broken_stroke(const PerspectiveStroke& stroke) {
  if (stroke.id.empty()) return "a stroke without a name";
  if (stroke.pieces.empty()) return "a stroke without pieces";
  if (stroke.straight && stroke.pieces.size() != 1) return "a straight stroke of several pieces";
  if (!(stroke.weight > 0)) return "a weight that isn't positive";
  for (std::size_t i = 1; i < stroke.pieces.size(); ++i) {
    const Vec2 &end = stroke.pieces[i - 1][3], &start = stroke.pieces[i][0];
    if (start != end && (start.allFinite() || end.allFinite())) return "pieces that don't follow each other";
  }
  return "";
}

std::string broken_perspective(std::string_view bytes) {
  Progress progress;
  const bool is_json = bytes.starts_with('{');
  const PerspectiveReadResult read =
      is_json ? read_perspective_json(bytes, "fuzzed") : read_perspective_svg(bytes, "fuzzed", progress);
  if (read.warnings.size() > 1000) return "too many warnings";
  const PerspectiveDrawing& drawing = read.drawing;
  if (!(drawing.image_size.minCoeff() > 0) || drawing.strokes.empty()) return "no sheet or no strokes";
  std::set<std::string> ids;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (!ids.insert(stroke.id).second) return "two strokes of one name";
    const std::string broken = broken_stroke(stroke);
    if (!broken.empty()) return broken;
  }
  const std::string written = write_perspective_json(drawing);
  if (has_replaced_bytes(written)) return "";
  const PerspectiveDrawing json = read_perspective_json(written, "fuzzed").drawing;
  if (!same_drawing(drawing, json)) return "the written JSON reads back differently";
  // XML has no control characters.
  const bool has_controls = std::ranges::any_of(
      std::array{"\\u00", "\\b", "\\f"}, [&](const char* escape) { return written.find(escape) != std::string::npos; });
  if (is_json || has_controls) return "";
  const PerspectiveDrawing svg = read_perspective_svg(write_perspective_svg(json), "fuzzed", progress).drawing;
  return same_drawing(drawing, svg) ? "" : "the written SVG reads back differently";
}

std::string broken_camera(std::string_view bytes) {
  const Camera camera = read_camera_file(bytes, "fuzzed").camera;
  const Eigen::Matrix3d off = camera.rotation * camera.rotation.transpose() - Eigen::Matrix3d::Identity();
  return off.cwiseAbs().maxCoeff() < 1e-9 && camera.focal_length > 0 ? "" : "a camera that isn't one";
}

std::string broken_content(const Value& value) {
  if (const auto mesh = value.as<PolyMesh>()) return broken_mesh(*mesh);
  if (const auto drawing = value.as<Drawing>()) {
    if (!drawing->plane.is_orthonormal()) return "the plane has no right angle";
    const bool bare = std::ranges::any_of(drawing->strokes, [](const auto& s) { return s.samples.empty(); });
    return bare ? "a stroke has no samples" : "";
  }
  if (const auto network = value.as<CurveNetwork>()) {
    for (const NetworkCurve& curve : network->curves) {
      const std::vector<Vec3>& vertices = network->vertices;
      if (curve.start >= vertices.size() || curve.end >= vertices.size()) return "a vertex is missing";
      if (curve.pieces.empty() || curve.pieces.front().points[0] != vertices[curve.start] ||
          curve.pieces.back().points[3] != vertices[curve.end]) {
        return "a curve doesn't meet its vertices";
      }
    }
  }
  if (const auto drawing = value.as<PerspectiveDrawing>()) {
    for (const PerspectiveStroke& stroke : drawing->strokes) {
      if (stroke.pieces.empty() || stroke.group > StrokeGroup::Unknown) return "a stroke has no pieces or no group";
    }
  }
  if (const auto camera = value.as<Camera>()) return camera->focal_length > 0 ? "" : "a camera without focal length";
  return "";
}

std::string broken_project(std::string_view bytes) {
  Progress progress;
  const ProjectFile project = read_project(bytes, "fuzzed", progress);
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

/// The values in a project file, whose hashes keep the fuzzer of whole files from them.
std::string broken_value(std::string_view bytes) {
  if (bytes.empty()) return "";
  const ValueType type = value_types()[static_cast<unsigned char>(bytes[0]) % value_types().size()];
  try {
    const Value value = decode(type, bytes.substr(1));
    const std::string broken = broken_content(value);
    if (!broken.empty()) return broken;
    const std::string written = encode(value);
    return encode(decode(type, written)) == written ? "" : "it reads back differently";
  } catch (const BadBytes&) {
    return "";
  }
}

}  // namespace

ReaderVerdict FuzzedReader::verdict_on(std::string_view bytes) const {
  try {
    return {broken(bytes), false};
  } catch (const Error& error) {
    const Findings& findings = error.findings();
    if (!has_errors(findings)) return {"an error without errors", true};
    if (findings.size() > most_findings) return {"too many findings", true};
    for (const Finding& finding : findings) {
      if (finding.code.empty() || finding.message.find(names_file ? "fuzzed" : "") == std::string::npos)
        return {"a finding without a name", true};
      if (finding.message.empty()) return {"a finding without a sentence", true};
      if (only_malformed && finding.category != Category::Malformed) return {"a finding of another kind", true};
    }
    return {"", true};
  }
}

const std::vector<FuzzedReader>& fuzzed_readers() {
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  static const std::vector<FuzzedReader> all = {{"obj", broken_mesh_file<MeshFormat::Obj>, 2000, true, false},
                                                {"ply", broken_mesh_file<MeshFormat::Ply>, 2000, true, false},
                                                {"stl", broken_mesh_file<MeshFormat::Stl>, 2000, true, false},
                                                {"off", broken_mesh_file<MeshFormat::Off>, 2000, true, false},
                                                {"glb", broken_mesh_file<MeshFormat::Glb>, 2000, true, false},
                                                {"svg", broken_svg, any, false, false},
                                                {"tags", broken_tags, 200, false, true},
                                                {"places", broken_places, 200, false, true},
                                                {"network", broken_attribute_network, 200, true, true},
                                                {"perspective", broken_perspective, 1000, false, false},
                                                {"camera", broken_camera, 1000, false, false},
                                                {"croq", broken_project, any, true, false},
                                                {"value", broken_value, 0, false, false}};
  return all;
}

const FuzzedReader& fuzzed_reader(std::string_view name) {
  return *std::ranges::find(fuzzed_readers(), name, &FuzzedReader::name);
}

bool same_connectivity(const PolyMesh& a, const PolyMesh& b) {
  return a.vertex_count() == b.vertex_count() && a.face_offsets == b.face_offsets && a.corners == b.corners &&
         a.line_offsets == b.line_offsets && a.line_vertices == b.line_vertices;
}

bool same_tags(const MeshTags& a, const MeshTags& b) {
  const auto same_sharpness = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  const auto same_crease = [&](const Crease& x, const Crease& y) {
    return x.vertices == y.vertices && same_sharpness(x.sharpness, y.sharpness);
  };
  return std::ranges::equal(a.creases, b.creases, same_crease) && a.pins == b.pins && a.sets == b.sets;
}

bool same_drawing(const PerspectiveDrawing& a, const PerspectiveDrawing& b) {
  const auto hash_of_content = [](PerspectiveDrawing drawing) {
    drawing.file.clear();
    const auto make_finite_or_nan = [](double& number) {
      if (!std::isfinite(number)) number = std::numeric_limits<double>::quiet_NaN();
    };
    for (PerspectiveStroke& stroke : drawing.strokes) {
      stroke.line.reset();
      make_finite_or_nan(stroke.weight);
      for (PictureCubic& piece : stroke.pieces) {
        for (Vec2& point : piece) std::ranges::for_each(point, make_finite_or_nan);
      }
    }
    return content_hash(Value(std::make_shared<const PerspectiveDrawing>(std::move(drawing))));
  };
  return hash_of_content(a) == hash_of_content(b);
}

}  // namespace croquis::test
