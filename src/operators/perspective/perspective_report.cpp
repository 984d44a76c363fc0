// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/perspective/perspective_report.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace croquis {
namespace {

template <class Vector>
Report numbers(const Vector& vector) {
  Report list = Report::array();
  for (const double value : vector) list.push(value);
  return list;
}

Report stroke_lists(const std::vector<std::vector<std::string>>& loops) {
  Report list = Report::array();
  for (const auto& loop : loops) list.push(Report::list(loop));
  return list;
}

Report face_list(const std::vector<PerspectiveFace>& faces) {
  Report list = Report::array();
  for (const PerspectiveFace& face : faces) {
    Report entry;
    entry.set("id", face.id).set("strokes", stroke_lists(face.strokes)).set("kind", face.planar ? "planar" : "patch");
    list.push(std::move(entry));
  }
  return list;
}

Report corner_list(const std::vector<PerspectiveCorner>& corners) {
  Report list = Report::array();
  for (const PerspectiveCorner& corner : corners) {
    Report entry;
    entry.set("id", corner.id).set("at", numbers(corner.at));
    list.push(std::move(entry));
  }
  return list;
}

/// Finite ones as [x, y]; those at infinity as null.
Report vanishing_point_list(const PerspectiveResult& result) {
  Report list = Report::array();
  for (const Vec3& point : result.vanishing_points) {
    const bool is_finite = std::abs(point.z()) > 1e-12 * point.head<2>().norm();
    list.push(is_finite ? numbers(Vec2(point.head<2>() / point.z())) : Report());
  }
  return list;
}

Report residual_list(const PerspectiveResult& result) {
  Report list = Report::object();
  for (const PerspectiveStrokeResult& stroke : result.strokes) {
    if (stroke.residual) list.set(stroke.id, *stroke.residual);
  }
  return list;
}

Report use_list(const PerspectiveResult& result) {
  Report::Object members;
  for (const PerspectiveStrokeResult& stroke : result.strokes) {
    members.emplace_back(stroke.id, stroke.used ? "used" : "flagged");
  }
  return Report::of_members(std::move(members));
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

std::string summary_of(const PerspectiveResult& result) {
  const auto counted = [](std::size_t count, const std::string& what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
  };
  return std::to_string(result.mode) + "-point perspective, " + counted(result.edge_strokes, "edge") + ", " +
         counted(result.faces.size(), "face") + ", " + (result.closed ? "closed" : "not closed");
}

/// The strokes along the four sides of a patch; no stroke along those inside a face.
/// The strokes along a patch's sides; null where none was drawn.
Report side_list(const Brep& brep, const BrepFace& face, std::size_t patch,
                 const std::vector<std::string>& stroke_of_curve) {
  const std::vector<Index> halves = brep.around(face.loops.front());
  const auto stroke = [&](Index half) {
    const Index curve = brep.edges[brep.half_edges[half].edge].curve;
    return curve == no_index ? Report() : Report(stroke_of_curve[curve]);
  };
  Report sides = Report::array();
  if (face.patches.size() > 1) {
    const std::size_t before = (patch + halves.size() - 1) % halves.size();
    return sides.push(stroke(halves[patch])), sides.push(Report()), sides.push(Report()),
           sides.push(stroke(halves[before])), sides;
  }
  for (const Index half : halves) sides.push(stroke(half));
  return sides;
}

std::size_t bytes_of_face(const PerspectiveFace& face) {
  std::size_t bytes = sizeof face + face.id.capacity();
  for (const auto& loop : face.strokes) {
    for (const std::string& stroke : loop) bytes += sizeof stroke + stroke.capacity();
  }
  return bytes;
}

Report point_list(const GregoryPatch& patch) {
  Report points = Report::array();
  for (const Vec3& point : patch.boundary) points.push(numbers(point));
  for (const Vec3& point : patch.inner) points.push(numbers(point));
  return points;
}

}  // namespace

Report to_report(const PerspectiveResult& result) {
  Report report;
  report.set("summary", summary_of(result))
      .set("mode", result.mode)
      .set("eye", numbers(result.camera.eye))
      .set("focal_length", result.camera.focal_length)
      .set("focal_length_deviation", result.focal_deviation)
      .set("principal_point", numbers(result.camera.principal_point))
      .set("principal_point_deviation", numbers(result.principal_deviation))
      .set("vanishing_points", vanishing_point_list(result))
      .set("line_residuals", residual_list(result))
      .set("vertices", corner_list(result.corners))
      .set("curves", result.edge_strokes)
      .set("faces", face_list(result.faces))
      .set("internal_faces_rejected", result.internal_faces_rejected)
      .set("alternatives", result.alternatives.size())
      .set("shells", result.shells)
      .set("closed", result.closed)
      .set("strokes", use_list(result))
      .set("max_reprojection_error", result.max_reprojection_error)
      .set("max_g1_angle_degrees", degrees(result.max_g1_angle));
  return report;
}

Report patch_report(const Brep& brep, const std::vector<PerspectiveFace>& faces,
                    const std::vector<std::string>& stroke_of_curve) {
  Report patches = Report::array(), planes = Report::array();
  for (const BrepFace& face : brep.faces) {
    for (std::size_t k = 0; k < face.patches.size(); ++k) {
      Report entry;
      entry.set("face", faces[face.outline].id)
          .set("strokes", side_list(brep, face, k, stroke_of_curve))
          .set("points", point_list(face.patches[k]));
      patches.push(std::move(entry));
    }
    if (!face.planar) continue;
    Report entry;
    entry.set("face", faces[face.outline].id)
        .set("origin", numbers(face.origin))
        .set("normal", numbers(face.normal))
        .set("loops", stroke_lists(faces[face.outline].strokes));
    planes.push(std::move(entry));
  }
  Report report;
  report.set("format", "croquis-patches/1").set("patches", std::move(patches)).set("planes", std::move(planes));
  return report;
}

std::size_t byte_size(const PerspectiveResult& result) {
  std::size_t bytes = sizeof(PerspectiveResult) + result.strokes.capacity() * sizeof(PerspectiveStrokeResult) +
                      result.vertex_places.capacity() * sizeof(Vec2) +
                      result.network.vertices.capacity() * sizeof(Vec3) +
                      result.corners.capacity() * sizeof(PerspectiveCorner);
  for (const NetworkCurve& curve : result.network.curves)
    bytes += sizeof curve + curve.id.capacity() + curve.pieces.capacity() * sizeof(RationalCubic);
  for (const PerspectiveFace& face : result.faces) bytes += bytes_of_face(face);
  for (const FaceAlternative& alternative : result.alternatives) {
    for (const PerspectiveFace& face : alternative.faces) bytes += bytes_of_face(face);
  }
  return bytes;
}

}  // namespace croquis
