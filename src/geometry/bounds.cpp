// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/bounds.h"

#include "croquis/geometry/affine3.h"

namespace croquis {
namespace {

void extend(BoundingBox& bounds, const Vec3& point) {
  if (!bounds) bounds = {point, point};
  (*bounds)[0] = (*bounds)[0].cwiseMin(point);
  (*bounds)[1] = (*bounds)[1].cwiseMax(point);
}

}  // namespace

BoundingBox bounds_of(const PolyMesh& mesh) {
  BoundingBox bounds;
  for (const Vec3& position : mesh.positions) extend(bounds, position);
  return bounds;
}

BoundingBox bounds_of(const Drawing& drawing) {
  BoundingBox bounds;
  const Affine3 frame = frame_of(drawing.plane);
  for (const Stroke& stroke : drawing.strokes) {
    for (const StrokeSample& sample : stroke.samples)
      extend(bounds, frame(Vec3(sample.position.x(), sample.position.y(), 0)));
  }
  return bounds;
}

}  // namespace croquis
