// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/curve_lifting.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/perspective/camera/sheet_frame.h"
#include "algorithms/perspective/curves/rational_lift.h"
#include "algorithms/perspective/stroke_words.h"

namespace croquis {
namespace {

/// Into the piece from its start, or from its end.
Vec2 leaving_direction(const PictureCubic& piece, bool from_end) {
  const Vec2& origin = from_end ? piece[3] : piece[0];
  for (std::size_t i = 1; i < 4; ++i) {
    const Vec2 step = piece[from_end ? 3 - i : i] - origin;
    if (step.norm() > 0) return step;
  }
  return Vec2::Zero();
}

double turn_between(const PictureCubic& before, const PictureCubic& after) {
  const Vec2 arriving = -leaving_direction(before, true);
  const Vec2 leaving = leaving_direction(after, false);
  return std::atan2(std::abs(cross(arriving, leaving)), arriving.dot(leaving));
}

class Lifting {
 public:
  Lifting(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const VertexCoordinates& coordinates,
          const CurveOptions& options)
      : drawing_(drawing), vertices_(vertices), coordinates_(coordinates), options_(options) {}

  LiftedCurves run() {
    std::vector<Index> behind;
    std::vector<Index> strokes;
    for (Index s = 0; s < drawing_.strokes.size(); ++s) {
      if (has_ends(s)) strokes.push_back(s);
    }
    std::vector<std::vector<std::vector<RationalCubic>>> lifted;
    std::vector<Index> kept;
    for (const Index s : strokes) {
      auto pieces = lift(s);
      if (pieces) {
        kept.push_back(s);
        lifted.push_back(std::move(*pieces));
      } else {
        behind.push_back(s);
      }
    }
    add_vertices(kept);
    for (std::size_t i = 0; i < kept.size(); ++i) add_curves(kept[i], lifted[i]);
    warn(behind);
    return std::move(result_);
  }

 private:
  bool has_ends(Index s) {
    const std::array<Index, 2>& ends = vertices_.of_stroke[s];
    if (drawing_.strokes[s].role != StrokeRole::Edge) return false;
    const bool lifted =
        ends[0] != no_index && ends[1] != no_index && coordinates_.in_front[ends[0]] && coordinates_.in_front[ends[1]];
    if (!lifted) result_.flat.push_back(s);
    return lifted;
  }

  std::optional<std::vector<std::vector<RationalCubic>>> lift(Index s) const {
    const std::array<Index, 2>& ends = vertices_.of_stroke[s];
    return lifted_stroke(drawing_.strokes[s], drawing_.strokes[s].group, coordinates_.positions[ends[0]],
                         coordinates_.positions[ends[1]], coordinates_.camera);
  }

  void add_vertices(const std::vector<Index>& strokes) {
    std::vector<bool> used(vertices_.vertices.size(), false);
    for (const Index s : strokes) {
      for (const Index v : vertices_.of_stroke[s]) used[v] = true;
    }
    result_.vertex.assign(used.size(), no_index);
    for (Index v = 0; v < used.size(); ++v) {
      if (used[v]) result_.vertex[v] = add_vertex(coordinates_.positions[v]);
    }
  }

  Index add_vertex(const Vec3& position) {
    result_.network.vertices.push_back(position);
    return static_cast<Index>(result_.network.vertices.size() - 1);
  }

  /// One curve, or one for each part between corners.
  void add_curves(Index s, const std::vector<std::vector<RationalCubic>>& pieces) {
    const PerspectiveStroke& stroke = drawing_.strokes[s];
    std::vector<std::size_t> begins{0};
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      if (turn_between(stroke.pieces[i - 1], stroke.pieces[i]) > options_.joint_angle) begins.push_back(i);
    }
    Index at = result_.vertex[vertices_.of_stroke[s][0]];
    for (std::size_t part = 0; part < begins.size(); ++part) {
      const bool last = part + 1 == begins.size();
      const std::size_t end = last ? pieces.size() : begins[part + 1];
      NetworkCurve curve;
      curve.id = begins.size() == 1 ? stroke.id : stroke.id + "/" + std::to_string(part + 1);
      for (std::size_t i = begins[part]; i < end; ++i) {
        curve.pieces.insert(curve.pieces.end(), pieces[i].begin(), pieces[i].end());
      }
      curve.start = at;
      curve.end = last ? result_.vertex[vertices_.of_stroke[s][1]] : add_vertex(curve.pieces.back().points[3]);
      at = curve.end;
      curve.straight = end == begins[part] + 1 && is_straight(stroke.pieces[begins[part]]);
      if (curve.straight) {
        curve.pieces = {straight_cubic(curve.pieces.front().points[0], curve.pieces.back().points[3])};
      }
      result_.network.curves.push_back(std::move(curve));
      result_.stroke.push_back(s);
    }
  }

  void warn(const std::vector<Index>& behind) {
    for (const Subject& subject : stroke_subjects(drawing_, behind)) {
      result_.warnings.push_back(make_warning(Category::Geometry, "CURVE_BEHIND_HORIZON",
                                              "Stroke " + subject.id +
                                                  " crosses the horizon of the plane that its group says, and stays in "
                                                  "the picture: check its group.",
                                              {subject}));
    }
    result_.flat.insert(result_.flat.end(), behind.begin(), behind.end());
    std::sort(result_.flat.begin(), result_.flat.end());
  }

  const PerspectiveDrawing& drawing_;
  const DrawingVertices& vertices_;
  const VertexCoordinates& coordinates_;
  const CurveOptions& options_;
  LiftedCurves result_;
};

}  // namespace

LiftedCurves lift_curves(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                         const VertexCoordinates& coordinates, const CurveOptions& options) {
  return Lifting(drawing, vertices, coordinates, options).run();
}

std::vector<FittedCurve> fit_curves(const CurveNetwork& network, const Camera& camera, double unit,
                                    const CurveOptions& options) {
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : network.vertices) box.extend(vertex);
  const double most_error = options.fit_error * (box.isEmpty() ? 0 : box.diagonal().norm());
  std::vector<FittedCurve> all;
  for (const NetworkCurve& curve : network.curves) {
    FittedCurve fitted;
    for (const RationalCubic& piece : curve.pieces) {
      FittedCurve part = fit_polynomial(piece, camera, options.fit_distance * unit, most_error);
      fitted.pieces.insert(fitted.pieces.end(), part.pieces.begin(), part.pieces.end());
      fitted.distance = std::max(fitted.distance, part.distance);
      fitted.error = std::max(fitted.error, part.error);
    }
    all.push_back(std::move(fitted));
  }
  return all;
}

}  // namespace croquis
