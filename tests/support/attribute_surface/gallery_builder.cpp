// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/attribute_surface/gallery_builder.h"

#include <algorithm>
#include <stdexcept>

namespace croquis::test {

GalleryBuilder::GalleryBuilder(const std::string& name) : builder_(name) { builder_.network.units = "m"; }

void GalleryBuilder::crease(const std::string& id, const std::vector<Vec3>& control) {
  builder_.network.curves[builder_.curve(control, CurveJoin::Crease)].id = id;
}

void GalleryBuilder::smooth(const std::string& id, const std::vector<Vec3>& control) {
  builder_.network.curves[builder_.curve(control, CurveJoin::Smooth)].id = id;
}

Index GalleryBuilder::curve_named(const std::string& id) const {
  const auto& curves = builder_.network.curves;
  const auto found = std::ranges::find(curves, id, &AttributeCurve::id);
  if (found == curves.end()) throw std::invalid_argument("no curve is named " + id);
  return static_cast<Index>(found - curves.begin());
}

AttributeFace& GalleryBuilder::face_named(const std::string& id) {
  auto& faces = builder_.network.faces;
  const auto found = std::ranges::find(faces, id, &AttributeFace::id);
  if (found == faces.end()) throw std::invalid_argument("no face is named " + id);
  return *found;
}

void GalleryBuilder::face(const std::string& id, const std::vector<std::string>& loop) {
  std::vector<AttributeSide> sides;
  for (const std::string& side : loop) sides.push_back({curve_named(side.substr(1)), side[0] == '-'});
  builder_.network.faces[builder_.face(std::move(sides))].id = id;
}

void GalleryBuilder::inner(const std::string& id, const std::string& face, const std::vector<Vec3>& control,
                           InnerCurve how) {
  builder_.network.curves.push_back({id, no_index, no_index, control, CurveJoin::Crease});
  how.curve = static_cast<Index>(builder_.network.curves.size() - 1);
  face_named(face).inner.push_back(how);
}

void GalleryBuilder::point(const std::string& id, const std::string& face, const Vec3& at, double radius) {
  const auto index = static_cast<Index>(&face_named(face) - builder_.network.faces.data());
  builder_.network.points.push_back({id, index, at, {}, radius, PointProfile::Smooth, {}});
}

}  // namespace croquis::test
