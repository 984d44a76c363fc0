// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/attribute_surface/network_builder.h"

namespace croquis::test {

/// Puts networks together whose elements have names. Nodes are found by their places.
class GalleryBuilder {
 public:
  explicit GalleryBuilder(const std::string& name);

  void crease(const std::string& id, const std::vector<Vec3>& control);
  void smooth(const std::string& id, const std::vector<Vec3>& control);

  /// @param loop ids of curves with "+" or "-" before them, as files have them
  void face(const std::string& id, const std::vector<std::string>& loop);

  /// A free curve inside a face; `how` needs no curve.
  void inner(const std::string& id, const std::string& face, const std::vector<Vec3>& control, InnerCurve how);

  /// A point of the profile Smooth, its footprint the place nearest to it.
  void point(const std::string& id, const std::string& face, const Vec3& at, double radius);

  AttributeNetwork take() { return std::move(builder_.network); }

 private:
  Index curve_named(const std::string& id) const;
  AttributeFace& face_named(const std::string& id);

  NetworkBuilder builder_;
};

}  // namespace croquis::test
