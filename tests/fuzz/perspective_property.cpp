// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/perspective_property.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>

#include "croquis/base/error.h"
#include "croquis/io/camera_file.h"
#include "croquis/io/perspective_drawing_file.h"

namespace croquis::test {
namespace {

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (!std::isfinite(a) && !std::isfinite(b));
}

bool same(const Vec2& a, const Vec2& b) { return same(a.x(), b.x()) && same(a.y(), b.y()); }

bool same(const PerspectiveStroke& a, const PerspectiveStroke& b) {
  if (a.pieces.size() != b.pieces.size()) return false;
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (!same(a.pieces[i][k], b.pieces[i][k])) return false;
    }
  }
  return a.id == b.id && a.role == b.role && a.group == b.group && a.colour == b.colour && a.straight == b.straight &&
         a.from == b.from && a.to == b.to && a.link == b.link && a.start_lock == b.start_lock &&
         a.end_lock == b.end_lock && a.hidden == b.hidden && same(a.weight, b.weight);
}

std::string broken_stroke(const PerspectiveStroke& stroke) {
  if (stroke.id.empty()) return "a stroke without a name";
  if (stroke.pieces.empty()) return "a stroke without pieces";
  if (stroke.straight && stroke.pieces.size() != 1) return "a straight stroke of several pieces";
  if (!(stroke.weight > 0)) return "a weight that isn't positive";
  for (std::size_t i = 1; i < stroke.pieces.size(); ++i) {
    if (!same(stroke.pieces[i][0], stroke.pieces[i - 1][3])) return "pieces that don't follow each other";
  }
  return "";
}

std::string wrong_findings(const Error& error) {
  if (!has_errors(error.findings())) return "an error without errors";
  for (const Finding& finding : error.findings()) {
    if (finding.code.empty() || finding.message.empty()) return "a finding without a name";
  }
  return error.findings().size() > 1000 ? "too many findings" : "";
}

std::string broken_drawing(const PerspectiveDrawing& drawing, bool from_svg) {
  if (!(drawing.image_size.minCoeff() > 0) || drawing.strokes.empty()) return "no sheet or no strokes";
  std::set<std::string> ids;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (!ids.insert(stroke.id).second) return "two strokes of one name";
    const std::string broken = broken_stroke(stroke);
    if (!broken.empty()) return broken;
  }
  Progress progress;
  const std::string written = write_perspective_json(drawing);
  if (written.find("\xef\xbf\xbd") != std::string::npos) return "";  // bytes that are no UTF-8 don't come back
  const PerspectiveDrawing json = read_perspective_json(written, "fuzzed").drawing;
  if (!same_drawing(drawing, json)) return "the written JSON reads back differently";
  // XML has no control characters.
  const bool has_controls = std::ranges::any_of(
      std::array{"\\u00", "\\b", "\\f"}, [&](const char* escape) { return written.find(escape) != std::string::npos; });
  if (!from_svg || has_controls) return "";
  const PerspectiveDrawing svg = read_perspective_svg(write_perspective_svg(json), "fuzzed", progress).drawing;
  return same_drawing(drawing, svg) ? "" : "the written SVG reads back differently";
}

}  // namespace

bool same_drawing(const PerspectiveDrawing& a, const PerspectiveDrawing& b) {
  if (a.strokes.size() != b.strokes.size()) return false;
  for (std::size_t i = 0; i < a.strokes.size(); ++i) {
    if (!same(a.strokes[i], b.strokes[i])) return false;
  }
  return same(a.origin, b.origin) && same(a.image_size, b.image_size) && a.known_point == b.known_point &&
         a.known_lengths == b.known_lengths && a.field_of_view == b.field_of_view &&
         a.principal_point == b.principal_point && a.unit == b.unit && a.shells == b.shells;
}

std::string broken_perspective(std::string_view bytes) {
  try {
    Progress progress;
    const bool json = bytes.starts_with('{');
    const PerspectiveReadResult read =
        json ? read_perspective_json(bytes, "fuzzed") : read_perspective_svg(bytes, "fuzzed", progress);
    if (read.warnings.size() > 1000) return "too many warnings";
    return broken_drawing(read.drawing, !json);
  } catch (const Error& error) {
    return wrong_findings(error);
  }
}

std::string broken_camera(std::string_view bytes) {
  try {
    const CameraFile read = read_camera_file(bytes, "fuzzed");
    const Camera& camera = read.camera;
    const Eigen::Matrix3d off = camera.rotation * camera.rotation.transpose() - Eigen::Matrix3d::Identity();
    if (!(off.cwiseAbs().maxCoeff() < 1e-9) || !(camera.focal_length > 0)) return "a camera that isn't one";
    return "";
  } catch (const Error& error) {
    return wrong_findings(error);
  }
}

}  // namespace croquis::test
