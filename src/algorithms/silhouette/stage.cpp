// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/stage.h"

#include "algorithms/silhouette/sampling/sheet_sampling.h"
#include "algorithms/silhouette/skeleton/skeleton.h"

namespace croquis::silhouette {
namespace {

void add_contour(const FigureContour& contour, StageKey& key) {
  key.add(contour.vertices);
  key.add(contour.drawn);
  key.add(contour.side);
  key.add(contour.object);
}

void add_arc(const FigureArc& arc, StageKey& key) {
  key.add(arc.contour);
  key.add(arc.begin);
  key.add(arc.count);
  key.add(arc.visible);
  key.add(arc.depth);
}

void add_crossing(const FigureCrossing& crossing, StageKey& key) {
  key.add(crossing.vertex);
  key.add(crossing.over_contour);
  key.add(crossing.over_position);
  key.add(crossing.under_contour);
  key.add(crossing.under_position);
}

void add_stroke(const Stroke& stroke, StageKey& key) {
  key.add(stroke.id);
  key.add(stroke.samples.size());
  for (const StrokeSample& sample : stroke.samples) key.add(sample.position);
  key.add(stroke.closed);
  key.add(stroke.object);
  key.add(stroke.line.value_or(-1));
  key.add(stroke.data.size());
  for (const auto& [name, value] : stroke.data) {
    key.add(name);
    key.add(value);
  }
}

template <typename T>
std::size_t bytes_of_list(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

std::size_t bytes_of(const PlanarTriangulation& planar) {
  return bytes_of_list(planar.triangles) + bytes_of_list(planar.neighbours) + bytes_of_list(planar.constraints);
}

}  // namespace

void add_drawing(const Drawing& drawing, StageKey& key) {
  key.add(drawing.file);
  key.add(drawing.strokes.size());
  for (const Stroke& stroke : drawing.strokes) add_stroke(stroke, key);
}

void add_shape(const LabelledFigure& figure, StageKey& key) {
  key.add(figure.unit);
  key.add(figure.step);
  key.add(figure.points);
  key.add(figure.contours.size());
  for (const FigureContour& contour : figure.contours) add_contour(contour, key);
  key.add(figure.arcs.size());
  for (const FigureArc& arc : figure.arcs) add_arc(arc, key);
  key.add(figure.crossings.size());
  for (const FigureCrossing& crossing : figure.crossings) add_crossing(crossing, key);
  key.add(figure.objects.size());
  for (const FigureObject& object : figure.objects) {
    key.add(object.contours);
    key.add(object.euler_region);
  }
  // Segments and triangulation follow from points, contours and arcs; layers and faces from those and the depths.
  key.add(figure.layers);
  key.add(figure.raw_contours);
}

void add_names(const LabelledFigure& figure, const Drawing& drawing, StageKey& key) {
  key.add(drawing.file);
  for (const FigureObject& object : figure.objects) {
    key.add(object.name);
    for (const Index stroke : object.strokes) {
      key.add(stroke);
      key.add(drawing.strokes[stroke].id);
      key.add(drawing.strokes[stroke].line.value_or(-1));
    }
  }
  for (const FigureContour& contour : figure.contours) key.add(contour.strokes);
}

void add_shape(const Skeleton& skeleton, StageKey& key) {
  key.add(skeleton.scale);
  key.add(skeleton.nodes.size());
  for (const SkeletonNode& node : skeleton.nodes) {
    key.add(node.position);
    key.add(node.radius);
    key.add(node.place.triangle);
    key.add(node.place.layer);
    key.add(node.object);
  }
  key.add(skeleton.edges.size());
  for (const auto& [a, b] : skeleton.edges) {
    key.add(a);
    key.add(b);
  }
  key.add(skeleton.contour_radius);
}

std::size_t bytes_of(const PolyMesh& mesh) {
  std::size_t bytes = bytes_of_list(mesh.positions) + bytes_of_list(mesh.face_offsets) + bytes_of_list(mesh.corners) +
                      bytes_of_list(mesh.line_offsets) + bytes_of_list(mesh.line_vertices);
  for (const AttributeChannel& channel : mesh.channels) bytes += channel.size() * sizeof(double);
  return bytes;
}

std::size_t bytes_of(const LabelledDrawing& labelled) {
  std::size_t bytes = 0;
  for (const LabelledFigure& figure : labelled.figures) {
    bytes += bytes_of_list(figure.points) + bytes_of_list(figure.segments) + bytes_of_list(figure.segment_arc) +
             bytes_of(figure.triangulation) + bytes_of_list(figure.layers) + bytes_of_list(figure.faces);
    for (const FigureContour& contour : figure.contours) bytes += 8 * contour.vertices.size();
    for (const std::vector<Vec2>& raw : figure.raw_contours) bytes += bytes_of_list(raw);
  }
  return bytes;
}

std::size_t bytes_of(const Skeleton& skeleton) {
  std::size_t bytes = bytes_of_list(skeleton.nodes) + bytes_of_list(skeleton.edges);
  for (const SkeletonNode& node : skeleton.nodes) bytes += bytes_of_list(node.crossed) + bytes_of_list(node.parts);
  for (const std::vector<double>& radii : skeleton.contour_radius) bytes += bytes_of_list(radii);
  return bytes;
}

std::size_t bytes_of(const SheetSampling& sheets) {
  const LiftedTriangulation& lifted = sheets.lifted;
  return bytes_of_list(sheets.points) + bytes_of_list(sheets.segments) + bytes_of_list(sheets.parents) +
         bytes_of_list(sheets.piece_radii) + bytes_of_list(sheets.row_radii) + bytes_of(sheets.planar) +
         bytes_of_list(sheets.layers) + bytes_of_list(lifted.first_copy) + bytes_of_list(lifted.triangles) +
         bytes_of_list(lifted.neighbours) + bytes_of_list(lifted.planar_triangle) +
         bytes_of_list(lifted.planar_vertex) + bytes_of_list(lifted.on_boundary);
}

}  // namespace croquis::silhouette
