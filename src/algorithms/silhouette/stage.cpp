// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/stage.h"

#include "algorithms/silhouette/sampling/sheet_sampling.h"
#include "algorithms/silhouette/skeleton/skeleton.h"

namespace croquis::silhouette {
namespace {

template <typename... Lists>
std::size_t bytes_of_lists(const Lists&... lists) {
  return (std::size_t{0} + ... + (lists.size() * sizeof(typename Lists::value_type)));
}

std::size_t bytes_of(const PlanarTriangulation& planar) {
  return bytes_of_lists(planar.triangles, planar.neighbours, planar.constraints);
}

}  // namespace

void add_drawing(const Drawing& drawing, StageKey& key) {
  key.add(drawing.file).add(drawing.strokes.size());
  for (const Stroke& stroke : drawing.strokes) {
    key.add(stroke.id).add(stroke.closed).add(stroke.object).add(stroke.line.value_or(-1)).add(stroke.data);
    key.add(stroke.samples.size());
    for (const StrokeSample& sample : stroke.samples) key.add(sample.position).add(sample.pressure);
  }
}

void add_shape(const LabelledFigure& figure, StageKey& key) {
  key.add(figure.unit).add(figure.step).add(figure.points);
  key.add(figure.contours.size());
  for (const FigureContour& contour : figure.contours) {
    key.add(contour.vertices).add(contour.drawn).add(contour.side).add(contour.object);
  }
  key.add(figure.arcs.size());
  for (const FigureArc& arc : figure.arcs) {
    key.add(arc.contour).add(arc.begin).add(arc.count).add(arc.visible).add(arc.depth);
  }
  key.add(figure.crossings.size());
  for (const FigureCrossing& crossing : figure.crossings) {
    key.add(crossing.vertex).add(crossing.over_contour).add(crossing.over_position);
    key.add(crossing.under_contour).add(crossing.under_position);
  }
  key.add(figure.objects.size());
  for (const FigureObject& object : figure.objects) key.add(object.contours).add(object.euler_region);
  // Segments and triangulation follow from points, contours and arcs; layers and faces from those and the depths.
  key.add(figure.layers).add(figure.raw_contours);
}

void add_names(const LabelledFigure& figure, const Drawing& drawing, StageKey& key) {
  key.add(drawing.file);
  for (const FigureObject& object : figure.objects) {
    key.add(object.name);
    for (const Index s : object.strokes) {
      const Stroke& stroke = drawing.strokes[s];
      key.add(s).add(stroke.id).add(stroke.line.value_or(-1));
    }
  }
  for (const FigureContour& contour : figure.contours) key.add(contour.strokes);
}

void add_shape(const Skeleton& skeleton, StageKey& key) {
  key.add(skeleton.scale).add(skeleton.nodes.size());
  for (const SkeletonNode& node : skeleton.nodes) {
    key.add(node.position).add(node.radius).add(node.place.triangle).add(node.place.layer).add(node.object);
  }
  key.add(skeleton.edges).add(skeleton.contour_radius);
}

std::size_t bytes_of(const PolyMesh& mesh) {
  std::size_t bytes =
      bytes_of_lists(mesh.positions, mesh.face_offsets, mesh.corners, mesh.line_offsets, mesh.line_vertices);
  for (const AttributeChannel& channel : mesh.channels) bytes += channel.size() * sizeof(double);
  return bytes;
}

std::size_t bytes_of(const LabelledDrawing& labelled) {
  std::size_t bytes = 0;
  for (const LabelledFigure& figure : labelled.figures) {
    bytes += bytes_of_lists(figure.points, figure.segments, figure.segment_arc, figure.layers, figure.faces) +
             bytes_of(figure.triangulation);
    for (const FigureContour& contour : figure.contours) bytes += 8 * contour.vertices.size();
    for (const std::vector<Vec2>& raw : figure.raw_contours) bytes += bytes_of_lists(raw);
  }
  return bytes;
}

std::size_t bytes_of(const Skeleton& skeleton) {
  std::size_t bytes = bytes_of_lists(skeleton.nodes, skeleton.edges);
  for (const SkeletonNode& node : skeleton.nodes) bytes += bytes_of_lists(node.crossed, node.parts);
  for (const std::vector<double>& radii : skeleton.contour_radius) bytes += bytes_of_lists(radii);
  return bytes;
}

std::size_t bytes_of(const SheetSampling& sheets) {
  const LiftedTriangulation& lifted = sheets.lifted;
  return bytes_of_lists(sheets.points, sheets.pieces, sheets.layers) + bytes_of(sheets.planar) +
         bytes_of_lists(lifted.first_copy, lifted.triangles, lifted.neighbours, lifted.planar_triangle,
                        lifted.planar_vertex, lifted.on_boundary);
}

}  // namespace croquis::silhouette
