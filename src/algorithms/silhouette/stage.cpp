// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/stage.h"

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "algorithms/silhouette/surface/sheet_sampling.h"

namespace croquis::silhouette {
namespace {

void add_contour(const FigureContour& contour, ContentWriter& content) {
  content.add(contour.vertices);
  content.add(contour.drawn);
  content.add(contour.side);
  content.add(contour.object);
}

void add_arc(const FigureArc& arc, ContentWriter& content) {
  content.add(arc.contour);
  content.add(arc.begin);
  content.add(arc.count);
  content.add(arc.visible);
  content.add(arc.depth);
}

void add_crossing(const FigureCrossing& crossing, ContentWriter& content) {
  content.add(crossing.vertex);
  content.add(crossing.over_contour);
  content.add(crossing.over_position);
  content.add(crossing.under_contour);
  content.add(crossing.under_position);
}

void add_stroke(const Stroke& stroke, ContentWriter& content) {
  content.add(stroke.id);
  content.add(stroke.samples.size());
  for (const StrokeSample& sample : stroke.samples) content.add(sample.position);
  content.add(stroke.closed);
  content.add(stroke.object);
  content.add(stroke.line.value_or(-1));
  content.add(stroke.data.size());
  for (const auto& [name, value] : stroke.data) {
    content.add(name);
    content.add(value);
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

void ContentWriter::add(const Drawing& drawing) {
  add(drawing.file);
  add(drawing.strokes.size());
  for (const Stroke& stroke : drawing.strokes) add_stroke(stroke, *this);
}

void ContentWriter::add(const StrokeOptions& options) {
  for (const double length : {options.step, options.tiny, options.close, options.gap, options.snap}) add(length);
  add(options.smoothing_passes);
}

void ContentWriter::add(const CompletionOptions& options) {
  for (const double value : {options.length_weight, options.curvature_weight, options.maximum_cost}) add(value);
  add(options.maximum_matchings);
}

void ContentWriter::add(const DepthOptions& options) {
  for (const double value : {options.weight_curvature, options.weight_orientation, options.weight_distance,
                             options.minimum_gap, options.node_spacing, options.accuracy, options.depth_allowance}) {
    add(value);
  }
}

void ContentWriter::add_shape(const LabelledFigure& figure) {
  add(figure.unit);
  add(figure.step);
  add(figure.points);
  add(figure.contours.size());
  for (const FigureContour& contour : figure.contours) add_contour(contour, *this);
  add(figure.arcs.size());
  for (const FigureArc& arc : figure.arcs) add_arc(arc, *this);
  add(figure.crossings.size());
  for (const FigureCrossing& crossing : figure.crossings) add_crossing(crossing, *this);
  add(figure.objects.size());
  for (const FigureObject& object : figure.objects) {
    add(object.contours);
    add(object.euler_region);
  }
  // Segments and triangulation follow from points, contours and arcs; layers and faces from those and the depths.
  add(figure.layers);
  add(figure.raw_contours);
}

void ContentWriter::add_names(const LabelledFigure& figure, const Drawing& drawing) {
  add(drawing.file);
  for (const FigureObject& object : figure.objects) {
    add(object.name);
    for (const Index stroke : object.strokes) {
      add(stroke);
      add(drawing.strokes[stroke].id);
      add(drawing.strokes[stroke].line.value_or(-1));
    }
  }
  for (const FigureContour& contour : figure.contours) add(contour.strokes);
}

void ContentWriter::add_shape(const Skeleton& skeleton) {
  add(skeleton.scale);
  add(skeleton.nodes.size());
  for (const SkeletonNode& node : skeleton.nodes) {
    add(node.position);
    add(node.radius);
    add(node.place.triangle);
    add(node.place.layer);
    add(node.object);
  }
  add(skeleton.edges.size());
  for (const auto& [a, b] : skeleton.edges) {
    add(a);
    add(b);
  }
  add(skeleton.contour_radius);
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
         bytes_of_list(sheets.piece_radii) + bytes_of(sheets.planar) + bytes_of_list(sheets.layers) +
         bytes_of_list(lifted.first_copy) + bytes_of_list(lifted.triangles) + bytes_of_list(lifted.neighbours) +
         bytes_of_list(lifted.planar_triangle) + bytes_of_list(lifted.planar_vertex) +
         bytes_of_list(lifted.on_boundary);
}

}  // namespace croquis::silhouette
