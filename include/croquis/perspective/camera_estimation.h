// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/members.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/camera.h"
#include "croquis/geometry/perspective_drawing.h"

/// From the strokes of a drawing that run along the axes to the camera that it was seen with.
///
/// After Cho and Kim, "Reconstructing 3D solid shape from a single perspective drawing", section 3.1, which intersects
/// two lines per axis and takes the orthocentre of the three vanishing points. Here all lines are fitted at once
/// (maximum likelihood of their end points), so that vanishing points may lie at infinity.
namespace croquis {

/// One of something for each of the axes x, y and z, which are numbered 0..2 everywhere.
template <typename T>
class PerAxis {
 public:
  PerAxis() = default;
  PerAxis(const T& x, const T& y, const T& z) : values_{x, y, z} {}

  T& operator[](int axis) { return values_[static_cast<std::size_t>(axis)]; }
  const T& operator[](int axis) const { return values_[static_cast<std::size_t>(axis)]; }

  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  std::array<T, 3> values_{};
};

/// The lengths of the perspective library that are said in u are parts of the sheet: 1 u is its diagonal / 1250, which
/// is 1 px for a sheet of 1000 x 750 px. A drawing and its enlargement give the same result.
inline constexpr double sheet_units_per_diagonal = 1250;

/// How many of the three vanishing points are not at infinity.
enum class PerspectiveMode { Automatic = 0, OnePoint = 1, TwoPoint = 2, ThreePoint = 3 };

struct CameraOptions {
  PerspectiveMode mode = PerspectiveMode::Automatic;
  double minimum_line = 0.03;  ///< parts of the diagonal, 0.005..0.2: shorter strokes aren't used, unless an axis has
                               ///< fewer than three longer ones
  double principal_spread = 0.25;  ///< diagonals, 0.001..1: how far off the centre the principal point may be
  double flat_principal_spread =
      0.02;                     ///< the same along the horizon where fewer than three vanishing points are finite
  double focal_length = 1.2;    ///< diagonals, 0.1..10: what it is likely to be
  double focal_spread = 0.5;    ///< of its logarithm, 0.01..2
  double outlier_sigmas = 5;    ///< 3..10: lines farther off are left out …
  double outlier_distance = 2;  ///< u, and at least so far off
  double mode_rise = 9;         ///< 4..25: chi-squared that dropping a vanishing point may cost
  double noise_floor = 0.15;    ///< u: drawings are never judged as more exact than this
  bool turn_round = false;      ///< x and y point the other way; a drawing can't show it
};

constexpr auto members(const CameraOptions& options) {
  return std::tie(options.mode, options.minimum_line, options.principal_spread, options.flat_principal_spread,
                  options.focal_length, options.focal_spread, options.outlier_sigmas, options.outlier_distance,
                  options.mode_rise, options.noise_floor, options.turn_round);
}

static_assert(lists_every_member<CameraOptions>);

/// A stroke along an axis, and how well it points at its vanishing point.
struct VanishingLine {
  Index stroke = no_index;  ///< in the drawing
  int axis = 0;             ///< 0..2
  double residual = 0;      ///< px: how far its ends are off the line from its middle to the vanishing point
  bool used = false;        ///< not too short, not left out
  bool outlier = false;     ///< left out because it points elsewhere
};

/// A camera with its eye at the origin, and how certain it is. Standard deviations follow from the noise of the lines.
struct CameraEstimate {
  Camera camera;
  PerspectiveMode mode = PerspectiveMode::ThreePoint;
  PerAxis<bool> finite{true, true, true};  ///< vanishing points that aren't at infinity
  PerAxis<Vec3> vanishing_points{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< homogeneous, px
  std::vector<VanishingLine> lines;         ///< all strokes along axes, in the order of the drawing
  double sigma = 0;                         ///< px: noise of line ends; 0 where there are no more lines than unknowns
  double focal_deviation = 0;               ///< px
  Vec2 principal_deviation = Vec2::Zero();  ///< px
  bool focal_assumed = false;               ///< one-point perspective without a stated field of view
  Findings warnings;
};

/// The camera of a drawing.
///
/// @param drawing its metadata count: field of view, principal point, known point (for the signs of the axes)
/// @param groups  what each stroke of the drawing is taken for, #strokes; strokes of parallel groups are the lines
/// @throws Error VP_INSUFFICIENT, ALL_PARALLEL, EYE_NONE (category Geometry); Cancelled
/// About 0.1 ms per line. Results don't depend on the order and direction of strokes.
CameraEstimate estimate_camera(const PerspectiveDrawing& drawing, std::span<const StrokeGroup> groups,
                               const CameraOptions& options, Progress& progress);

/// With the groups that were drawn.
CameraEstimate estimate_camera(const PerspectiveDrawing& drawing, const CameraOptions& options, Progress& progress);

/// How far the ends of the segment a-b are off the line from its middle to a vanishing point, in the unit of a and b.
/// Has the deviation of one coordinate of an end point.
double vanishing_residual(const Vec3& vanishing_point, const Vec2& a, const Vec2& b);

/// The groups of all strokes as drawn.
std::vector<StrokeGroup> drawn_groups(const PerspectiveDrawing& drawing);

}  // namespace croquis
