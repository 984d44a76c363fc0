// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/tools/pointer/view_frame.h"

/// The handles that move, rotate and scale: where they are, which one a pixel meets, what a drag does.
/// They have the same size on the screen in every view. Pure; O(1).
namespace croquis {

enum class ManipulatorKind { None, Move, Rotate, Scale };

/// X, Y, Z: along (Move, Scale) or about (Rotate) that axis. YZ, ZX, XY: in that plane (Move, Scale). Centre: in the
/// view's plane (Move), evenly (Scale), freely like a ball (Rotate). View: about the view's direction (Rotate).
enum class ManipulatorHandle { None, X, Y, Z, YZ, ZX, XY, Centre, View };

struct Manipulator {
  ManipulatorKind kind = ManipulatorKind::None;
  Vec3 pivot = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns, orthonormal
  double pixels = 80;                                  ///< length of its arrows, radius of its rings; > 0
};

/// The handle at a pixel; axes that point at the eye and rings seen from their edge stay usable or are left out.
ManipulatorHandle handle_at(const Manipulator& manipulator, const ViewFrame& frame, const Vec2& pixel,
                            double reach_pixels = 7);

struct ManipulatorSnap {
  double move = 0;     ///< model units per step along axes; 0 for none
  double degrees = 0;  ///< per step
  double scale = 0;    ///< per step of the factor
};

/// What a drag has done since it began.
struct ManipulatorMotion {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  Vec3 by = Vec3::Zero();    ///< Move: model units
  Vec3 axis = Vec3::Zero();  ///< Rotate: unit, or zero while nothing turned
  double degrees = 0;        ///< Rotate: about `axis`; counts on beyond a full turn
  Vec3 factors = {1, 1, 1};  ///< Scale: along the manipulator's axes
};

/// One drag of a handle. Every handle answers with a finite map wherever the pointer goes.
class ManipulatorDrag {
 public:
  ManipulatorDrag(const Manipulator& manipulator, ManipulatorHandle handle, const Vec2& pixel);

  /// The motion since the beginning, with the pointer there now. Call it for every event: turns count on.
  const ManipulatorMotion& to(const ViewFrame& frame, const Vec2& pixel, const ManipulatorSnap& snap = {});

  const ManipulatorMotion& motion() const { return motion_; }
  ManipulatorHandle handle() const { return handle_; }
  /// As it is to be drawn now: it moves along, or shows how far it has turned or grown.
  Manipulator moved() const;

 private:
  void move(const ViewFrame& frame, const Vec2& pixel, const ManipulatorSnap& snap);
  void turn(const ViewFrame& frame, const Vec2& pixel, const ManipulatorSnap& snap);
  void turn_freely(const ViewFrame& frame, const Vec2& pixel);
  void scale(const ViewFrame& frame, const Vec2& pixel, const ManipulatorSnap& snap);

  Manipulator manipulator_;
  ManipulatorHandle handle_;
  Vec2 start_;
  Vec2 last_;
  double turned_ = 0;  ///< radians, unsnapped
  ManipulatorMotion motion_;
};

// ---- The picture

enum class ColourRole { X, Y, Z, Centre, View, Faint };  ///< red, green, blue, …: the host has the colours
enum class HandleState { Normal, Hovered, Active };

struct ManipulatorLine {
  std::vector<Vec3> points;  ///< joined in order; a closed one repeats its first point
  ColourRole role = ColourRole::X;
  HandleState state = HandleState::Normal;
  bool filled = false;  ///< a convex area (arrow heads, plane squares): fill it, too
};
struct ManipulatorDot {
  Vec3 place = Vec3::Zero();
  ColourRole role = ColourRole::Centre;
  HandleState state = HandleState::Normal;
  double pixels = 9;  ///< across
  bool square = false;
};
struct ManipulatorPicture {
  std::vector<ManipulatorLine> lines;  ///< drawn in this order, over everything else
  std::vector<ManipulatorDot> dots;
};
ManipulatorPicture picture(const Manipulator& manipulator, const ViewFrame& frame,
                           ManipulatorHandle hovered = ManipulatorHandle::None,
                           ManipulatorHandle active = ManipulatorHandle::None);

}  // namespace croquis
