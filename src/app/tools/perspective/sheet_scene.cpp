// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/sheet_scene.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/window/language.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double bad_px = 6;  // a line that misses by so much is darkest red

std::vector<std::vector<Vec2>> letter(int axis) {
  if (axis == 0) return {{{-0.3, -0.4}, {0.3, 0.4}}, {{-0.3, 0.4}, {0.3, -0.4}}};
  if (axis == 1) return {{{-0.3, 0.4}, {0, 0}, {0.3, 0.4}}, {{0, 0}, {0, -0.4}}};
  return {{{-0.3, 0.4}, {0.3, 0.4}, {-0.3, -0.4}, {0.3, -0.4}}};
}

/// The letter as polylines in a square of side 1 about (0, 0), y up; planes have a frame around theirs.
std::vector<std::vector<Vec2>> group_glyph(StrokeGroup group) {
  if (group == StrokeGroup::Unknown)
    return {{{-0.25, 0.2}, {-0.1, 0.4}, {0.2, 0.35}, {0.2, 0.1}, {0, -0.05}, {0, -0.2}}, {{0, -0.38}, {0, -0.42}}};
  auto glyph = letter(axis_of(group));
  if (!is_parallel(group)) glyph.push_back({{-0.6, -0.7}, {0.6, -0.7}, {0.6, 0.7}, {-0.6, 0.7}, {-0.6, -0.7}});
  return glyph;
}

/// Lines along an axis are solid, dashed or dash-dotted; those in planes are dotted with their axis' rhythm.
render::DashPattern group_dashes(StrokeGroup group) {
  switch (group) {
    case StrokeGroup::ParallelY: return {14, 5, 0, 0};
    case StrokeGroup::ParallelZ: return {14, 4, 1, 4};
    case StrokeGroup::NormalX: return {24, 3, 0, 0};
    case StrokeGroup::NormalY: return {8, 4, 0, 0};
    case StrokeGroup::NormalZ: return {1, 5, 0, 0};
    default: return {};
  }
}

constexpr double edge_width = 2.4, hidden_width = 1.3, construction_width = 1.1;  // logical pixels
constexpr int construction_alpha = 150, hidden_alpha = 170;
constexpr double seen_residual_px = 1.5;     // smaller ones aren't shown: any hand has them …
constexpr double seen_residual_share = 1.5;  // … nor are those that the drawing's middle line has, times this
constexpr double far_diagonals = 40;         // vanishing points farther away are no handles

render::LinePath sheet_path(const PerspectiveStroke& stroke, const FromSheet& place) {
  return path_of(traced(stroke.pieces, stroke.straight), place);
}

render::LineStyle stroke_style(const PerspectiveStroke& stroke, double opacity) {
  const bool construction = stroke.role == StrokeRole::Construction;
  const int alpha = construction ? construction_alpha : stroke.hidden ? hidden_alpha : 255;
  render::LineStyle style;
  style.width = construction ? construction_width : stroke.hidden ? hidden_width : edge_width;
  style.color = to_color(group_color(stroke.group), static_cast<int>(alpha * opacity));
  style.dash = construction ? render::DashPattern() : group_dashes(stroke.group);
  return style;
}

render::Mark sheet_mark(const Vec2& at, render::MarkShape shape, float size, const QColor& color) {
  return {on_sketch_plane(at), shape, size, to_color(color)};
}

std::optional<Vec2> finite_place(const Vec3& vanishing, const PerspectiveDrawing& drawing) {
  if (vanishing.z() == 0) return std::nullopt;
  const Vec2 place = vanishing.head<2>() / vanishing.z();
  if ((place - drawing.centre()).norm() > far_diagonals * drawing.diagonal()) return std::nullopt;
  return place;
}

/// What any unfinished drawing has: ends that lead nowhere, edges without a face, parts that nothing ties together.
/// Worth a small mark while somebody draws, but no warning sign.
bool is_of_unfinished(const Finding& finding) {
  constexpr std::array codes{"DANGLING", "NOT_CLOSED", "DISCONNECTED"};
  return std::ranges::find(codes, finding.code) != codes.end();
}

/// Where a finding stands: its own place, else its first stroke's middle.
std::optional<Vec2> place_of_finding(const Finding& finding, const PerspectiveDrawing& drawing) {
  for (const Subject& subject : finding.subjects) {
    const PerspectiveStroke* stroke = find_stroke(drawing, subject.id);
    if (stroke != nullptr && is_drawable(*stroke)) return middle_of_stroke(*stroke);
  }
  for (const Subject& subject : finding.subjects) {
    if (subject.at.size() == 2) return Vec2(subject.at[0], subject.at[1]);
  }
  return std::nullopt;
}

/// Ends of strokes that lead nowhere.
std::vector<Vec2> loose_ends(const PerspectiveDrawing& drawing, const Finding& finding) {
  std::vector<Vec2> ends;
  if (finding.code != "DANGLING") return ends;
  for (const Subject& subject : finding.subjects) {
    const PerspectiveStroke* stroke = find_stroke(drawing, subject.id);
    if (stroke == nullptr || !is_drawable(*stroke)) continue;
    for (const bool last : {false, true}) {
      const DrawnEnd end{static_cast<std::size_t>(stroke - drawing.strokes.data()), last};
      if (ends_at_vertex(drawing, end).size() == 1) ends.push_back(place_of(drawing, end));
    }
  }
  return ends;
}

/// Of what stands out among the drawing's lines.
double least_seen_residual(const PerspectiveResult& result) {
  std::vector<double> residuals;
  for (const PerspectiveStrokeResult& stroke : result.strokes) {
    if (stroke.residual) residuals.push_back(*stroke.residual);
  }
  if (residuals.empty()) return seen_residual_px;
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::ranges::nth_element(residuals, middle);
  return std::max(seen_residual_px, seen_residual_share * *middle);
}

// Logical pixels.
constexpr double letter_pixels = 9;
constexpr double letter_offset = 11;  // from the stroke
constexpr double letter_room = 17;    // between the middles of two letters
constexpr double least_lettered = 32;
constexpr double letter_width = 1.4, letter_casing_width = 4.5;

/// The letters with the sheet's colour around them, so that they are read over strokes and pictures of any colour.
std::vector<render::LineItemPtr> letter_items(const std::vector<GroupLetter>& letters, double unit) {
  std::map<StrokeGroup, std::vector<render::LinePath>> by_group;
  std::vector<render::LinePath> casing;
  for (const GroupLetter& letter : letters) {
    for (const std::vector<Vec2>& part : group_glyph(letter.group)) {
      casing.push_back(path_of(part, [&](const Vec2& place) {
        return on_sketch_plane(letter.at) + letter_pixels * unit * on_plane(place);
      }));
      by_group[letter.group].push_back(casing.back());
    }
  }
  std::vector<render::LineItemPtr> items;
  if (casing.empty()) return items;
  items.push_back(render::make_line_item(casing, {letter_casing_width, to_color(colors::paper, 220), {}}));
  for (const auto& [group, paths] : by_group) {
    items.push_back(render::make_line_item(paths, {letter_width, to_color(group_color(group)), {}}));
  }
  return items;
}

/// Along a stroke, the middle first.
constexpr std::array letter_places{0.5, 0.36, 0.64, 0.22, 0.78};

/// Of places along the stroke and both of its sides, the first that no letter is near.
std::optional<Vec2> free_place(const PerspectiveStroke& stroke, const std::vector<GroupLetter>& taken, double unit) {
  const std::vector<Vec2> places = traced(stroke.pieces, false);
  for (const double share : letter_places) {
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(share * static_cast<double>(places.size())), 1,
                                           places.size() - 2);
    const Vec2 way = places[i + 1] - places[i - 1];
    if (!(way.norm() > 0)) continue;
    for (const double side : {1.0, -1.0}) {
      const Vec2 at = places[i] + side * letter_offset * unit * left_of(way).normalized();
      const bool is_free = std::ranges::none_of(
          taken, [&](const GroupLetter& other) { return (other.at - at).norm() < letter_room * unit; });
      if (is_free) return at;
    }
  }
  return std::nullopt;
}

}  // namespace

QColor group_color(StrokeGroup group) {
  static const std::array<QColor, 7> made{QColor(0xF2, 0x8C, 0x00), QColor(0x1F, 0x9D, 0x3A), QColor(0x8A, 0x2B, 0xE2),
                                          QColor(0x1F, 0x4F, 0xD8), QColor(0xD8, 0x1F, 0x2A), QColor(0xC8, 0xA0, 0x00),
                                          QColor(0x70, 0x74, 0x7C)};
  return made[static_cast<std::size_t>(group)];
}

QString group_letter(StrokeGroup group) {
  if (group == StrokeGroup::Unknown) return QStringLiteral("?");
  const QString axis(QStringLiteral("xyz").at(axis_of(group)));
  return is_parallel(group) ? axis : QStringLiteral("⊥") + axis;
}

/// Of a box whose x runs to the right: the faces across x, y and z.
QString group_words(StrokeGroup group) {
  const std::array<QString, 3> faces{QObject::tr("left"), QObject::tr("right"), QObject::tr("top")};
  const bool is_face = group != StrokeGroup::Unknown && !is_parallel(group);
  return is_face ? faces[static_cast<std::size_t>(axis_of(group))] : group_letter(group);
}

QString group_title(StrokeGroup group) {
  if (group == StrokeGroup::Unknown) return QObject::tr("By where it points");
  const QString axis(QStringLiteral("xyz").at(axis_of(group)));
  return is_parallel(group) ? QObject::tr("Parallel to %1").arg(axis)
                            : QObject::tr("In a plane across %1, on a %2 face").arg(axis, group_words(group));
}

/// Lightness falls evenly, so that the order is seen with any colour vision.
QColor residual_color(double px) {
  static const std::array<QColor, 4> scale{QColor(0xFF, 0xE0, 0x8A), QColor(0xFD, 0xA9, 0x4B), QColor(0xE0, 0x4B, 0x2F),
                                           QColor(0x8B, 0x10, 0x2B)};
  const double place = std::clamp(px / bad_px, 0.0, 1.0) * static_cast<double>(scale.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double share = place - static_cast<double>(i);
  const auto mix = [&](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
  const QColor &low = scale[i], &high = scale[i + 1];
  return {mix(low.red(), high.red()), mix(low.green(), high.green()), mix(low.blue(), high.blue())};
}

bool is_drawable(const PerspectiveStroke& stroke) {
  return std::ranges::all_of(stroke.pieces, [](const PictureCubic& piece) {
    return std::ranges::all_of(piece, [](const Vec2& point) { return point.allFinite(); });
  });
}

Vec2 middle_of_stroke(const PerspectiveStroke& stroke) {
  return place_on(stroke.pieces[stroke.pieces.size() / 2], stroke.pieces.size() % 2 == 1 ? 0.5 : 0);
}

std::vector<render::LineItemPtr> stroke_items(const PerspectiveDrawing& drawing, const FromSheet& place,
                                              double opacity) {
  using Key = std::tuple<StrokeRole, bool, StrokeGroup>;
  std::map<Key, std::pair<render::LineStyle, std::vector<render::LinePath>>> alike;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (!is_drawable(stroke)) continue;
    auto& [style, paths] = alike[{stroke.role, stroke.hidden, stroke.group}];
    style = stroke_style(stroke, opacity);
    paths.push_back(sheet_path(stroke, place));
  }
  std::vector<render::LineItemPtr> items;
  for (const auto& [key, content] : alike) items.push_back(lines_of(content.second, content.first));
  return items;
}

void SheetScene::show_drawing(const PerspectiveDrawing& drawing, const std::vector<std::string>& selected,
                              bool points) {
  strokes_ = stroke_items(drawing, on_sketch_plane, 1);
  const std::vector<Vec2> corners = corners_of_box(drawing.origin, drawing.origin + drawing.image_size);
  sheet_ = lines_of({path_of(corners, on_sketch_plane, true)}, {1, to_color(colors::guide), {}});
  bounds_ = sheet_->bounds;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (!is_drawable(stroke)) continue;
    for (const Vec2& place : {stroke.start(), stroke.end()}) bounds_.add(on_sketch_plane(place));
  }
  std::vector<render::LinePath> chosen;
  std::vector<render::Mark> anchors;
  for (const std::string& id : selected) {
    const PerspectiveStroke* stroke = find_stroke(drawing, id);
    if (stroke == nullptr || !is_drawable(*stroke)) continue;
    chosen.push_back(sheet_path(*stroke, on_sketch_plane));
    const std::vector<Vec2> places = points_of(*stroke);
    for (std::size_t k = 0; points && k < places.size(); ++k) {
      const bool joint = k % 3 == 0 || stroke->straight;
      anchors.push_back(sheet_mark(places[k], joint ? render::MarkShape::Square : render::MarkShape::Ring,
                                   joint ? 8 : 7, colors::accent));
    }
  }
  selected_ = lines_of(chosen, {edge_width + 4, to_color(colors::accent, 90), {}});
  points_ = marks_of(anchors);
  std::vector<render::Mark> dots;
  for (const Vec2& place : vertices_of(drawing)) {
    if (place.allFinite()) dots.push_back(sheet_mark(place, render::MarkShape::Disc, 6, colors::ink));
  }
  vertices_ = marks_of(dots);
}

void SheetScene::show_result(const PerspectiveDrawing& drawing, const PerspectiveResult* result,
                             const Findings& findings) {
  show_residuals(drawing, result);
  show_vanishing_points(drawing, result);
  show_findings(drawing, findings);
}

void SheetScene::show_residuals(const PerspectiveDrawing& drawing, const PerspectiveResult* result) {
  std::vector<render::LinePath> heat;
  const double least = result == nullptr ? 0 : least_seen_residual(*result);
  for (const PerspectiveStrokeResult& one :
       result == nullptr ? std::vector<PerspectiveStrokeResult>() : result->strokes) {
    const PerspectiveStroke* stroke = find_stroke(drawing, one.id);
    if (stroke == nullptr || !is_drawable(*stroke) || one.residual.value_or(0) < least) continue;
    heat.push_back(sheet_path(*stroke, on_sketch_plane));
    for (render::LinePoint& point : heat.back().points) point.color = to_color(residual_color(*one.residual), 150);
  }
  residuals_ = lines_of(heat, {edge_width + 7, to_color(colors::warning), {}});
}

void SheetScene::show_vanishing_points(const PerspectiveDrawing& drawing, const PerspectiveResult* result) {
  std::vector<render::LinePath> horizon;
  std::vector<render::Mark> handles;
  std::array<std::optional<Vec2>, 3> places;
  for (std::size_t axis = 0; result != nullptr && axis < 3; ++axis) {
    places[axis] = finite_place(result->vanishing_points[axis], drawing);
    if (!places[axis]) continue;
    handles.push_back(
        sheet_mark(*places[axis], render::MarkShape::Disc, 13, group_color(static_cast<StrokeGroup>(axis))));
    handles.back().outline_width = 2;
  }
  if (places[0] && places[1]) horizon.push_back(path_of(std::array{*places[0], *places[1]}, on_sketch_plane));
  vanishing_ = marks_of(handles);
  horizon_ = lines_of(horizon, {1, to_color(colors::guide), {8, 5, 0, 0}});
}

void SheetScene::show_findings(const PerspectiveDrawing& drawing, const Findings& findings) {
  std::vector<render::Mark> symbols;
  finding_marks_.clear();
  for (const Finding& finding : findings) {
    const QString sentence = localized(finding.message);
    if (is_of_unfinished(finding)) {
      for (const Vec2& end : loose_ends(drawing, finding)) {
        symbols.push_back(sheet_mark(end, render::MarkShape::Ring, 12, colors::warning));
        finding_marks_.push_back({Vec3(end.x(), -end.y(), 0), sentence, false});
      }
      continue;
    }
    const auto at = place_of_finding(finding, drawing);
    if (!at) continue;
    finding_marks_.push_back({Vec3(at->x(), -at->y(), 0), sentence, finding.severity == Severity::Error});
    symbols.push_back(symbol_of(finding_marks_.back()));
  }
  findings_ = marks_of(symbols);
}

void SheetScene::show_preview(const PerspectiveDrawing& drawing, const PerspectivePreview& preview) {
  std::vector<render::LinePath> paths;
  for (const std::string& id : preview.erased) {
    if (const PerspectiveStroke* stroke = find_stroke(drawing, id))
      paths.push_back(sheet_path(*stroke, on_sketch_plane));
  }
  render::LineStyle style{edge_width + 1, to_color(colors::error), {}};
  if (preview.box) {
    const auto& [low, high] = *preview.box;
    paths.push_back(path_of(corners_of_box(low, high), on_sketch_plane, true));
    style = {1, to_color(colors::accent), {4, 3, 0, 0}};
  }
  preview_ = lines_of(paths, style);
  snap_ = preview.snap ? marks_of({sheet_mark(*preview.snap, render::MarkShape::Ring, 16, colors::hover)}) : nullptr;
}

void SheetScene::show_hovered(const PerspectiveDrawing& drawing, const std::optional<std::string>& id) {
  const PerspectiveStroke* stroke = id ? find_stroke(drawing, *id) : nullptr;
  hovered_.reset();
  if (stroke == nullptr || !is_drawable(*stroke)) return;
  hovered_ = lines_of({sheet_path(*stroke, on_sketch_plane)}, {edge_width + 3, to_color(colors::hover, 120), {}});
}

void SheetScene::show_proposed(const std::vector<PerspectiveStroke>& strokes) {
  std::vector<render::LinePath> paths;
  for (const PerspectiveStroke& stroke : strokes) paths.push_back(sheet_path(stroke, on_sketch_plane));
  proposed_ = lines_of(paths, {edge_width, to_color(colors::hover), {3, 5, 0, 0}});
}

void SheetScene::show_guides(const PerspectiveDrawing& drawing, const std::array<std::optional<Vec3>, 3>& vanishing,
                             const std::optional<Vec2>& from) {
  std::vector<render::LinePath> rays;
  for (std::size_t axis = 0; from && axis < 3; ++axis) {
    if (!vanishing[axis]) continue;
    const Vec3& point = *vanishing[axis];
    const Vec2 way = point.head<2>() - point.z() * *from;
    if (!(way.norm() > 0)) continue;
    const Vec2 reach = 2 * drawing.diagonal() * way.normalized();
    rays.push_back(path_of(std::array<Vec2, 2>{*from - reach, *from + reach}, on_sketch_plane));
    const render::Color color = to_color(group_color(static_cast<StrokeGroup>(axis)), 90);
    for (render::LinePoint& end : rays.back().points) end.color = color;
  }
  guides_ = lines_of(rays, {1, to_color(colors::guide), {}});
}

void SheetScene::add_to(render::Scene& scene, const PerspectiveDrawing& drawing, double units_per_pixel) const {
  add_items(scene, {sheet_, horizon_, guides_, residuals_, hovered_, selected_});
  for (const render::LineItemPtr& item : strokes_) scene.lines.emplace_back(item);
  for (const render::LineItemPtr& item : letter_items(group_letters(drawing, units_per_pixel), units_per_pixel))
    scene.lines.emplace_back(item);
  add_items(scene, {proposed_, preview_}, {vertices_, points_, vanishing_, findings_, snap_});
}

std::vector<GroupLetter> group_letters(const PerspectiveDrawing& drawing, double unit) {
  std::vector<GroupLetter> letters;
  for (const StrokeRole role : {StrokeRole::Edge, StrokeRole::Construction}) {
    for (const PerspectiveStroke& stroke : drawing.strokes) {
      const bool has_room = (stroke.end() - stroke.start()).norm() >= least_lettered * unit;
      if (stroke.role != role || !has_room || !is_drawable(stroke)) continue;
      if (const auto at = free_place(stroke, letters, unit)) letters.push_back({stroke.group, *at});
    }
  }
  return letters;
}

}  // namespace croquis::app
