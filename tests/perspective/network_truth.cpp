// SPDX-License-Identifier: GPL-3.0-or-later
#include "perspective/network_truth.h"

#include <algorithm>
#include <set>

#include <Eigen/Geometry>

#include "support/random.h"

namespace croquis::test {
namespace {

Index nearer_end(const SolidDrawing& truth, const NetworkCurve& curve, const Vec2& relative_place, double scale,
                 const Vec2& move) {
  const Vec2 place = (relative_place - move) / scale;
  const double start = (truth.camera.project(truth.network.vertices[curve.start]) - place).norm();
  const double end = (truth.camera.project(truth.network.vertices[curve.end]) - place).norm();
  return start <= end ? curve.start : curve.end;
}

}  // namespace

std::vector<Index> true_vertices(const SolidDrawing& truth, const PerspectiveDrawing& drawing,
                                 const DrawingVertices& vertices) {
  // The drawing may be an enlarged and moved copy.
  const double scale = drawing.image_size.x() / truth.drawing.image_size.x();
  const Vec2 move = drawing.origin - scale * truth.drawing.origin;
  std::vector<Index> result(vertices.vertices.size(), no_index);
  for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
    const PerspectiveStroke& stroke = drawing.strokes[s];
    if (stroke.role != StrokeRole::Edge || vertices.of_stroke[s][0] == no_index) continue;
    const std::string id = stroke.id.substr(stroke.id.find('e'));  // renamed strokes have something before it
    const auto curve = std::ranges::find(truth.network.curves, id, &NetworkCurve::id);
    if (curve == truth.network.curves.end()) continue;
    result[vertices.of_stroke[s][0]] = nearer_end(truth, *curve, stroke.start(), scale, move);
    result[vertices.of_stroke[s][1]] = nearer_end(truth, *curve, stroke.end(), scale, move);
  }
  return result;
}

double true_diagonal(const SolidDrawing& truth) {
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : truth.network.vertices) box.extend(vertex);
  return box.diagonal().norm();
}

double greatest_error(const SolidDrawing& truth, const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                      const std::vector<Vec3>& positions) {
  const std::vector<Index> to = true_vertices(truth, drawing, vertices);
  double greatest = 0;
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] != no_index) greatest = std::max(greatest, (positions[v] - truth.network.vertices[to[v]]).norm());
  }
  return greatest / true_diagonal(truth);
}

double shape_error(const SolidDrawing& truth, const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                   const std::vector<Vec3>& positions) {
  const std::vector<Index> to = true_vertices(truth, drawing, vertices);
  std::vector<Vec3> found;
  std::vector<Vec3> wanted;
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] == no_index) continue;
    found.push_back(positions[v]);
    wanted.push_back(truth.network.vertices[to[v]]);
  }
  const auto centred = [](std::vector<Vec3>& points) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& point : points) sum += point;
    for (Vec3& point : points) point -= sum / static_cast<double>(points.size());
  };
  centred(found);
  centred(wanted);
  double products = 0;
  double squares = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    products += found[i].dot(wanted[i]);
    squares += found[i].squaredNorm();
  }
  double sum = 0;
  for (std::size_t i = 0; i < found.size(); ++i) sum += (products / squares * found[i] - wanted[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(found.size())) / true_diagonal(truth);
}

std::size_t count_planes(const std::vector<Vec3>& positions) {
  std::set<std::pair<int, double>> planes;
  for (const Vec3& position : positions) {
    for (int k = 0; k < 3; ++k) planes.emplace(k, position[k]);
  }
  return planes.size();
}

std::size_t count_true_planes(const SolidDrawing& truth) {
  std::vector<Vec3> rounded;
  for (const Vec3& vertex : truth.network.vertices) rounded.push_back((vertex * 1e9).array().round().matrix() * 1e-9);
  return count_planes(rounded);
}

ReconstructedNetwork reconstructed(const PerspectiveDrawing& drawing, const NetworkReconstructionOptions& options) {
  Progress progress;
  return reconstruct_network(drawing, options, progress);
}

std::vector<std::string> codes_of(const Findings& findings) {
  std::vector<std::string> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  return codes;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

PerspectiveStroke construction(const std::string& id, StrokeGroup group, const Vec2& a, const Vec2& b) {
  PerspectiveStroke stroke;
  stroke.id = id;
  stroke.role = StrokeRole::Construction;
  stroke.group = group;
  stroke.pieces = {{a, a + (b - a) / 3, b - (b - a) / 3, b}};
  stroke.straight = true;
  return stroke;
}

PerspectiveDrawing scaled_and_moved(PerspectiveDrawing drawing, double scale, const Vec2& move) {
  const auto moved = [&](const Vec2& place) { return Vec2(scale * place + move); };
  drawing.origin = moved(drawing.origin);
  drawing.image_size *= scale;
  if (drawing.known_point) drawing.known_point->at = moved(drawing.known_point->at);
  if (drawing.principal_point) drawing.principal_point = moved(*drawing.principal_point);
  for (PerspectiveStroke& stroke : drawing.strokes) {
    for (PictureCubic& piece : stroke.pieces) {
      for (Vec2& point : piece) point = moved(point);
    }
  }
  return drawing;
}

PerspectiveDrawing shuffled_and_renamed(PerspectiveDrawing drawing, std::uint64_t seed) {
  Random random(seed);
  auto& strokes = drawing.strokes;
  for (std::size_t i = strokes.size(); i > 1; --i) {
    std::swap(strokes[i - 1], strokes[random.below(static_cast<std::uint32_t>(i))]);
  }
  for (PerspectiveStroke& stroke : strokes) {
    const std::string name = std::to_string(random.below(1000)) + "-" + stroke.id;
    for (KnownLength& known : drawing.known_lengths) {
      if (known.stroke == stroke.id) known.stroke = name;
    }
    stroke.id = name;
    if (random.below(2) == 0) continue;
    std::ranges::reverse(stroke.pieces);
    for (PictureCubic& piece : stroke.pieces) std::ranges::reverse(piece);
    std::swap(stroke.from, stroke.to);
    std::swap(stroke.start_lock, stroke.end_lock);
  }
  return drawing;
}

}  // namespace croquis::test
