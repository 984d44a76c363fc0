// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/sketch_scene.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "app/window/language.h"
#include "app/window/theme.h"
#include "croquis/geometry/polyline.h"
#include "croquis/operators/inflate_result.h"

namespace croquis::app {
namespace {

/// Of the drawing's diagonal: more than smoothing moves a line.
constexpr double reach_in_diagonals = 0.006;

bool lies_on(const Vec2& place, const std::vector<Vec2>& line, double reach) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double t = nearest_parameter(place, line[i - 1], line[i]);
    if ((line[i - 1] + t * (line[i] - line[i - 1]) - place).norm() <= reach) return true;
  }
  return false;
}

/// None for a result that isn't there, or has failed.
CoveredStrokes covered_strokes(const Evaluation* solid) {
  CoveredStrokes covered;
  const InflateResult* inflated = result_of<InflateResult>(solid);
  if (inflated == nullptr || solid->failed || inflated->crossings_in_view.empty()) return covered;
  const auto labels = solid->outputs.find("labels");
  if (labels == solid->outputs.end()) return covered;
  for (const StrokesInView& crossing : inflated->crossings_in_view) covered.ids.push_back(crossing.behind);
  Eigen::AlignedBox2d box;
  const Drawing& arcs = labels->second.get<Drawing>();
  for (std::size_t i = 0; i < inflated->arcs.size() && i < arcs.strokes.size(); ++i) {
    std::vector<Vec2> line;
    for (const StrokeSample& sample : arcs.strokes[i].samples) {
      line.push_back(sample.position);
      box.extend(sample.position);
    }
    if (inflated->arcs[i].depth > 0) covered.hidden.push_back(std::move(line));
  }
  covered.reach = box.isEmpty() ? 0 : reach_in_diagonals * box.diagonal().norm();
  return covered;
}

/// Whether each sample of a stroke is covered; empty where none is.
std::vector<bool> covered_samples(const Stroke& stroke, const CoveredStrokes& covered) {
  if (std::ranges::find(covered.ids, stroke.id) == covered.ids.end()) return {};
  std::vector<bool> samples;
  for (const StrokeSample& sample : stroke.samples) {
    samples.push_back(std::ranges::any_of(
        covered.hidden, [&](const std::vector<Vec2>& line) { return lies_on(sample.position, line, covered.reach); }));
  }
  return samples;
}

constexpr double other_width = 1.4;   // logical pixels
constexpr int covered_strength = 70;  // of 255

render::LinePath path_of_stroke(const Stroke& stroke) {
  return path_of(
      stroke.samples, [](const StrokeSample& sample) { return on_plane(sample.position); }, stroke.closed);
}

/// What others cover of the path drawn last is pale.
void fade_covered(std::vector<render::LinePath>& paths, const std::vector<bool>& covered) {
  for (std::size_t i = 0; i < covered.size(); ++i) {
    if (covered[i]) paths.back().points[i].color = to_color(colors::guide, covered_strength);
  }
}

/// Of all drawings that are shown, but for the one worked on.
std::vector<render::LinePath> paths_of_others(const Studio& studio) {
  std::vector<render::LinePath> paths;
  for (const WorkObject& object : studio.objects()) {
    const Node* first = studio.session().document().find(object.chain.front());
    const auto drawing = source_of<Drawing>(first);
    if (!drawing || first->id == studio.drawing_node() || !object.visible || !drawing->plane.is_default()) continue;
    for (const Stroke& stroke : drawing->strokes) paths.push_back(path_of_stroke(stroke));
  }
  return paths;
}

/// All arcs of a drawing, and the label of each.
struct Labels {
  const Drawing& drawing;
  const std::vector<ArcLabel>& arcs;
};

/// The hidden arcs of a labelled drawing, coloured by how many surfaces lie in front.
render::LineItemPtr hidden_contours(const Labels& labels) {
  std::vector<render::LinePath> paths;
  for (std::size_t i = 0; i < labels.arcs.size(); ++i) {
    if (labels.arcs[i].depth == 0) continue;
    render::LinePath path = path_of_stroke(labels.drawing.strokes[i]);
    for (render::LinePoint& point : path.points) point.color = to_color(depth_color(labels.arcs[i].depth));
    paths.push_back(std::move(path));
  }
  return lines_of(paths, {1.8, to_color(colors::guide), {7, 5, 0, 0}});
}

std::optional<Labels> labels_of(const Evaluation& evaluation, const InflateResult& inflated) {
  const auto labels = evaluation.outputs.find("labels");
  if (labels == evaluation.outputs.end()) return std::nullopt;
  return Labels{labels->second.get<Drawing>(), inflated.arcs};
}

bool ends_at_corners(const Stroke& arc, const std::vector<Vec2>& corners) {
  const auto is_corner = [&](const Vec2& place) {
    return std::ranges::any_of(corners, [&](const Vec2& c) { return (c - place).norm() < 1e-3; });
  };
  return is_corner(arc.samples.front().position) && is_corner(arc.samples.back().position);
}

/// The strand on top is bounded by the visible arcs between the overlap's corners, the one below by the hidden ones.
void turn_mark(const Labels& labels, const std::vector<Vec2>& corners, render::Mark& mark) {
  for (std::size_t i = 0; i < labels.arcs.size(); ++i) {
    const Stroke& arc = labels.drawing.strokes[i];
    if (arc.samples.size() < 2 || !ends_at_corners(arc, corners)) continue;
    const Vec2 along = arc.samples.back().position - arc.samples.front().position;
    const auto angle = static_cast<float>(std::atan2(along.y(), along.x()));
    (labels.arcs[i].depth == 0 ? mark.angle : mark.under_angle) = angle;
  }
}

void add_overlap_marks(const InflateResult& inflated, const Labels& labels, std::vector<render::Mark>& marks) {
  for (const StrandOverlap& overlap : inflated.overlaps) {
    // Where one end lies over or under a body, a joint is offered instead.
    if (overlap.crossings.size() < 4) continue;
    render::Mark mark{on_plane(overlap.at), render::MarkShape::OverUnder, 16, to_color(colors::hover)};
    turn_mark(labels, overlap.crossings, mark);
    marks.push_back(mark);
  }
}

/// Where a finding without a place of its own is shown: the middle of its first stroke.
std::optional<Vec2> place_of(const Finding& finding, const Drawing& drawing) {
  for (const Subject& subject : finding.subjects) {
    if (subject.at.size() >= 2) return Vec2(subject.at[0], -subject.at[1]);
  }
  for (const Subject& subject : finding.subjects) {
    const Stroke* stroke = find_stroke(drawing, subject.id);
    if (stroke != nullptr) return stroke->samples[stroke->samples.size() / 2].position;
  }
  return std::nullopt;
}

/// The blob that a first stroke may trace.
render::LineItemPtr ghost_item() {
  std::vector<Vec2> blob;
  for (int k = 0; k < 120; ++k) {
    const double angle = 2 * 3.14159265358979 * k / 120;
    const double radius = 150 * (1 + 0.16 * std::cos(2 * angle) + 0.08 * std::sin(3 * angle));
    blob.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return render::make_line_item(path_of(blob, on_plane, true), {3, to_color(colors::guide, 190), {3, 7, 0, 0}});
}

}  // namespace

void SketchScene::show_drawing(const Studio& studio, SketchTool& tool) {
  const Drawing& drawing = studio.drawing();
  const std::vector<std::string> chosen = tool.selected();
  std::vector<render::LinePath> plain;
  std::vector<render::LinePath> selected;
  std::vector<render::Mark> anchors;
  for (const Stroke& stroke : drawing.strokes) {
    const bool is_selected = std::ranges::count(chosen, stroke.id) > 0;
    (is_selected ? selected : plain).push_back(path_of_stroke(stroke));
    fade_covered(plain, is_selected ? std::vector<bool>() : covered_samples(stroke, covered_));
    const StrokeFit* fit = is_selected && tool.mode() == SketchMode::Select ? tool.fit(stroke.id) : nullptr;
    if (fit == nullptr) continue;
    for (const StrokeAnchor& anchor : fit->anchors) {
      anchors.push_back({on_plane(anchor.position), render::MarkShape::Square, 7, to_color(colors::accent)});
    }
  }
  strokes_ = lines_of(plain, {ink_width, to_color(colors::ink), {}});
  selected_ = lines_of(selected, {ink_width, to_color(colors::accent), {}});
  anchors_ = marks_of(anchors);
  others_ = lines_of(paths_of_others(studio), {other_width, to_color(colors::guide, 110), {}});
  axis_.reset();
  if (const auto& axis = tool.options().mirror) {
    const double far = 1e4 * drawn_scale(drawing, {});  // ten times the size of what is drawn
    const std::vector<Vec2> ends{{*axis, -far}, {*axis, far}};
    axis_ = lines_of({path_of(ends, on_plane)}, {1.5, to_color(colors::guide, 200), {10, 5, 2, 5}});
  }
  const bool empty = drawing.strokes.empty() && studio.objects().empty();
  if (!empty)
    ghost_.reset();
  else if (!ghost_)
    ghost_ = ghost_item();
}

void SketchScene::show_result(const Studio& studio) {
  const std::shared_ptr<const Evaluation> result = studio.result();
  covered_ = covered_strokes(result.get());
  hidden_.reset();
  finding_marks_.clear();
  std::vector<render::Mark> marks;
  if (result) {
    // A failed drawing has the labels of the last good one, which lie elsewhere.
    const InflateResult* inflated = result->failed ? nullptr : result->result<InflateResult>();
    if (const auto labels = inflated == nullptr ? std::nullopt : labels_of(*result, *inflated)) {
      hidden_ = hidden_contours(*labels);
      add_overlap_marks(*inflated, *labels, marks);
    }
    for (const Finding& finding : result->findings) {
      const auto at = place_of(finding, studio.drawing());
      if (at && finding.severity != Severity::Info)  // chips say how the drawing is read
        finding_marks_.push_back(
            {Vec3(at->x(), at->y(), 0), localized(finding.message), finding.severity == Severity::Error});
    }
  }
  for (const FindingMark& finding : finding_marks_) {
    marks.push_back(symbol_of(finding));
    marks.back().outline_width = 2;
  }
  marks_ = marks_of(marks);
}

void SketchScene::show_preview(const SketchPreview& preview) {
  std::vector<render::LinePath> paths;
  for (const std::vector<Vec2>& piece : preview.erased) paths.push_back(path_of(piece, on_plane));
  render::LineStyle style{ink_width + 1, to_color(colors::error), {}};
  if (preview.box) {
    const auto& [low, high] = *preview.box;
    paths.push_back(path_of(corners_of_box(low, high), on_plane, true));
    style = {1, to_color(colors::accent), {4, 3, 0, 0}};
  }
  preview_lines_ = lines_of(paths, style);
}

void SketchScene::show_hovered(const std::optional<std::string>& stroke, const Drawing& drawing) {
  const Stroke* found = stroke ? find_stroke(drawing, *stroke) : nullptr;
  hovered_ = found == nullptr
                 ? nullptr
                 : render::make_line_item(path_of_stroke(*found), {ink_width + 2.5, to_color(colors::hover, 120), {}});
}

void SketchScene::add_to(render::Scene& scene) const {
  add_items(scene, {axis_, ghost_, others_, hidden_, hovered_, strokes_, selected_, preview_lines_},
            {anchors_, marks_});
}

render::Bounds SketchScene::bounds(bool selected_only) const {
  render::Bounds bounds;
  if (selected_) bounds.add(selected_->bounds);
  if (selected_only && !bounds.empty()) return bounds;
  for (const render::LineItemPtr& item : {strokes_, hidden_, ghost_}) {
    if (item) bounds.add(item->bounds);
  }
  return bounds;
}

}  // namespace croquis::app
