// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/coordinates/seen_vertices.h"

#include "algorithms/perspective/camera/sheet_frame.h"

namespace croquis {

TiedVertices tied_vertices(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                           const CameraEstimate& camera, std::span<const StrokeGroup> groups) {
  const double unit = SheetFrame(drawing).unit;
  TiedVertices tied;
  tied.seen.rotation = camera.camera.rotation;
  tied.seen.focal = camera.camera.focal_length / unit;
  for (const DrawingVertex& vertex : vertices.vertices) {
    tied.seen.places.push_back((vertex.position - camera.camera.principal_point) / unit);
    double weight = 0;
    for (const StrokeEnd& end : vertex.ends) weight += drawing.strokes[end.stroke].weight;
    tied.seen.weights.push_back(weight / static_cast<double>(vertex.ends.size()));
  }
  tied.ties.of_stroke = vertices.of_stroke;
  tied.ties.groups.assign(groups.begin(), groups.end());
  return tied;
}

}  // namespace croquis
