// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// One sample of a pen stroke. Files without pen data leave pressure, tilt and time at their defaults.
struct StrokeSample {
  Vec2 position = Vec2::Zero();  ///< sketch units on the drawing's plane, x right, y UP
  double pressure = 1;           ///< 0..1
  Vec2 tilt = Vec2::Zero();      ///< radians from the surface's normal towards x and y
  double time = 0;               ///< seconds since the stroke began
};

/// A stroke exactly as drawn; nothing downstream changes it.
struct Stroke {
  std::string id;                           ///< its name in findings and reports; unique in a drawing
  std::vector<StrokeSample> samples;        ///< at least one
  bool closed = false;                      ///< the last sample joins the first (which is not repeated)
  std::string object;                       ///< name of the object it was forced into, empty for none
  std::map<std::string, std::string> data;  ///< the source's own data attributes without "data-" ("kind" → "hidden")
  std::optional<std::int64_t> line;         ///< 1-based line of the file it came from
};

/// Where a drawing lies in space: a sample at (x, y) is at origin + x u + y v, seen from where u × v points.
struct DrawingPlane {
  Vec3 origin = Vec3::Zero();  ///< model units
  Vec3 u = Vec3::UnitX();      ///< unit vector, the sketch's right
  Vec3 v = Vec3::UnitY();      ///< unit vector at a right angle to u, the sketch's UP

  /// Whether it is z = 0 with x and y.
  bool is_default() const { return *this == DrawingPlane(); }

  /// Whether all numbers are finite and both axes are of length 1 and at a right angle, up to 1e-9.
  bool is_orthonormal() const;

  friend bool operator==(const DrawingPlane& a, const DrawingPlane& b) {
    return a.origin == b.origin && a.u == b.u && a.v == b.v;
  }
};

/// Strokes on a plane.
struct Drawing {
  std::vector<Stroke> strokes;
  std::map<std::string, std::map<std::string, std::string>>
      object_data;     ///< per named object: its group's data attributes
  std::string file;    ///< where it came from, for findings
  DrawingPlane plane;  ///< orthonormal
};

}  // namespace croquis
