// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/perspective_chips.h"

#include <QEvent>
#include <QLabel>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "app/panels/finding_elements.h"
#include "app/panels/number_box.h"
#include "app/views/viewport.h"
#include "app/window/language.h"
#include "app/window/theme.h"
#include "croquis/tools/perspective/drawing_edit.h"

namespace croquis::app {
namespace {

constexpr int curve_parts = 16;
constexpr double hatch_share = 0.012;  // between lines, of the picture's diagonal
constexpr double outline_width = 3, hatch_width = 1.4, removed_width = 2;

using Loop = std::vector<Vec3>;

/// Where a place in the drawing's space lies in a view.
using FromSpace = std::function<glm::dvec3(const Vec3&)>;

std::set<std::string> strokes_of_face(const PerspectiveFace& face) {
  std::set<std::string> strokes;
  for (const std::vector<std::string>& loop : face.strokes) strokes.insert(loop.begin(), loop.end());
  return strokes;
}

std::vector<PerspectiveFace> without(const std::vector<PerspectiveFace>& faces,
                                     const std::vector<PerspectiveFace>& others) {
  std::set<std::set<std::string>> known;
  for (const PerspectiveFace& face : others) known.insert(strokes_of_face(face));
  std::vector<PerspectiveFace> left;
  for (const PerspectiveFace& face : faces) {
    if (!known.contains(strokes_of_face(face))) left.push_back(face);
  }
  return left;
}

/// How another set of faces that would close a solid, too, differs from the one that is shown.
struct FaceDifference {
  std::vector<PerspectiveFace> added;    ///< in the other set alone
  std::vector<PerspectiveFace> removed;  ///< in the one shown alone
};

FaceDifference difference_of(const PerspectiveResult& result, const FaceAlternative& alternative) {
  return {without(alternative.faces, result.faces), without(result.faces, alternative.faces)};
}

/// "s1+s2+s3": as the operation's lists name faces.
std::vector<std::string> names_of(const std::vector<PerspectiveFace>& faces) {
  std::vector<std::string> names;
  for (const PerspectiveFace& face : faces) {
    std::string name;
    for (const std::string& stroke : strokes_of_face(face)) name += (name.empty() ? "" : "+") + stroke;
    names.push_back(std::move(name));
  }
  return names;
}

/// Takes another set of faces, by its number.
void take_alternative(Sheet& sheet, std::size_t alternative) {
  const PerspectiveResult* result = sheet.result();
  if (result == nullptr || alternative >= result->alternatives.size()) return;
  const FaceDifference difference = difference_of(*result, result->alternatives[alternative]);
  sheet.host.attempt([&] {
    sheet.take(recorded::SheetFaces{names_of(difference.added), names_of(difference.removed)});
  });
}

/// The curves of a loop, one after the other.
std::optional<Loop> traced_loop(const CurveNetwork& network, const std::vector<std::string>& strokes) {
  std::vector<const NetworkCurve*> curves;
  for (const std::string& id : strokes) {
    const auto found = std::ranges::find(network.curves, id, &NetworkCurve::id);
    if (found == network.curves.end()) return std::nullopt;
    curves.push_back(&*found);
  }
  Loop loop;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const NetworkCurve &curve = *curves[i], &next = *curves[(i + 1) % curves.size()];
    const bool ahead = curve.end == next.start || curve.end == next.end;
    Loop places;
    for (const RationalCubic& piece : curve.pieces) {
      for (int k = 0; k < curve_parts; ++k) places.push_back(piece.at(static_cast<double>(k) / curve_parts));
    }
    places.push_back(curve.pieces.back().at(1));
    if (!ahead) std::ranges::reverse(places);
    loop.insert(loop.end(), places.begin(), places.end() - 1);
  }
  return loop;
}

struct Plane {
  Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();
};

/// Newell's normal through the mean of the places.
Plane plane_of(const Loop& loop) {
  Plane plane;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    plane.middle += loop[i] / static_cast<double>(loop.size());
    plane.normal += loop[i].cross(loop[(i + 1) % loop.size()]);
  }
  return plane;
}

/// Where the loops cross the line on which `across` has that value, by their places along it.
std::vector<double> crossings(const std::vector<std::vector<Vec2>>& loops, const Vec2& along, const Vec2& across,
                              double value) {
  std::vector<double> places;
  for (const std::vector<Vec2>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double from = across.dot(a) - value, to = across.dot(b) - value;
      if ((from < 0) == (to < 0)) continue;
      places.push_back(along.dot(a + from / (from - to) * (b - a)));
    }
  }
  std::ranges::sort(places);
  return places;
}

/// Lines across a face, equally far from each other in the picture.
std::vector<render::LinePath> hatch_of(const Camera& camera, const std::vector<Loop>& loops, const FromSpace& place) {
  std::vector<render::LinePath> lines;
  const Plane plane = plane_of(loops.front());
  std::vector<std::vector<Vec2>> seen;
  for (const Loop& loop : loops) {
    seen.emplace_back();
    for (const Vec3& point : loop) seen.back().push_back(camera.project(point));
  }
  const Vec2 along = Vec2(1, -1).normalized(), across = Vec2(1, 1).normalized();
  const auto [low, high] = std::ranges::minmax(seen.front(), {}, [&](const Vec2& point) { return across.dot(point); });
  const double step = hatch_share * camera.image_size.norm();
  if (!(step > 0)) return lines;
  const auto lifted = [&](const Vec2& point) {
    const Vec3 ray = camera.ray(point);
    return Vec3(camera.eye + plane.normal.dot(plane.middle - camera.eye) / plane.normal.dot(ray) * ray);
  };
  for (double value = across.dot(low) + step / 2; value < across.dot(high); value += step) {
    const std::vector<double> ends = crossings(seen, along, across, value);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      const Vec3 from = lifted(ends[i] * along + value * across), to = lifted(ends[i + 1] * along + value * across);
      if (!from.allFinite() || !to.allFinite()) continue;
      lines.push_back(path_of(std::array{from, to}, place));
    }
  }
  return lines;
}

/// Hatched, over all else: what is added in blue, what is removed as a dashed red outline.
void add_difference(render::Scene& scene, const PerspectiveResult& result, const FaceDifference& difference,
                    const FromSpace& place) {
  std::vector<render::LinePath> added, hatched, removed;
  const auto loops_of = [&](const PerspectiveFace& face) {
    std::vector<Loop> loops;
    for (const std::vector<std::string>& strokes : face.strokes) {
      if (auto loop = traced_loop(result.network, strokes)) loops.push_back(std::move(*loop));
    }
    return loops;
  };
  for (const PerspectiveFace& face : difference.added) {
    const std::vector<Loop> loops = loops_of(face);
    for (const Loop& loop : loops) added.push_back(path_of(loop, place, true));
    if (loops.empty()) continue;
    for (render::LinePath& line : hatch_of(result.camera, loops, place)) hatched.push_back(std::move(line));
  }
  for (const PerspectiveFace& face : difference.removed) {
    for (const Loop& loop : loops_of(face)) removed.push_back(path_of(loop, place, true));
  }
  add_items(scene, {lines_of(removed, {removed_width, to_color(colors::error), {6, 5, 0, 0}}),
                    lines_of(hatched, {hatch_width, to_color(colors::hover, 200), {}}),
                    lines_of(added, {outline_width, to_color(colors::hover), {}})});
}

constexpr double alternatives_top = 42;  // logical pixels, below the chip that counts faces
constexpr double between_alternatives = 6;
constexpr const char* alternative_style =
    "QToolButton { background: white; color: #3c4654; border: 1px solid #7a8698; border-radius: 9px; padding: 2px 9px }"
    "QToolButton:hover { background: #dbe8fb; border: 1px solid #3a6fc4 }";

/// Of all findings with that code.
std::vector<std::string> strokes_with(const Findings& findings, const std::string& code) {
  std::vector<std::string> strokes;
  for (const Finding& finding : findings) {
    if (finding.code != code) continue;
    for (std::string& id : strokes_of(finding)) strokes.push_back(std::move(id));
  }
  return strokes;
}

/// Edges that bound no face, and of which the result knows.
std::vector<std::string> unused_edges(const PerspectiveDrawing& drawing, const PerspectiveResult& result) {
  std::set<std::string> used;
  for (const PerspectiveFace& face : result.faces) {
    for (const std::vector<std::string>& loop : face.strokes) used.insert(loop.begin(), loop.end());
  }
  std::vector<std::string> unused;
  for (const PerspectiveStrokeResult& one : result.strokes) {
    const PerspectiveStroke* stroke = find_stroke(drawing, one.id);
    if (stroke != nullptr && stroke->role == StrokeRole::Edge && !used.contains(one.id)) unused.push_back(one.id);
  }
  return unused;
}

SolidState state_of_open(const PerspectiveDrawing& drawing, const PerspectiveResult& result) {
  std::vector<std::string> open = unused_edges(drawing, result);
  for (const std::string& id : result.open_strokes) {
    if (std::ranges::find(open, id) == open.end()) open.push_back(id);
  }
  if (result.faces.empty()) {
    const QString edges = counted_words(result.edge_strokes, QObject::tr("1 edge"), QObject::tr("%1 edges"));
    return {edges + QObject::tr(", no face yet"), false, open};
  }
  const QString faces = counted_words(result.faces.size(), QObject::tr("1 face"), QObject::tr("%1 faces"));
  const QString lacking =
      counted_words(open.size(), QObject::tr("1 edge lacks a face"), QObject::tr("%1 edges lack a face"));
  return {faces + ", " + lacking, false, open};
}

/// What is wrong with a solid that is closed, the worst first; nothing: an empty sentence.
SolidState doubt_about(const PerspectiveDrawing& drawing, const PerspectiveResult& result, const Findings& findings) {
  const auto has = [&](const char* code) { return std::ranges::count(findings, code, &Finding::code); };
  const auto doubt = [&](const QString& sentence, const char* code) {
    return SolidState{sentence, false, strokes_with(findings, code)};
  };
  if (const auto bent = has("NONPLANAR_STRAIGHT_FACE"); bent > 0) {
    return doubt(bent == 1 ? QObject::tr("Closed, but one face is bent: a stroke is probably missing")
                           : QObject::tr("Closed, but %1 faces are bent: strokes are probably missing").arg(bent),
                 "NONPLANAR_STRAIGHT_FACE");
  }
  if (has("MISSING_STROKE")) return doubt(QObject::tr("Closed, but a stroke is missing at a corner"), "MISSING_STROKE");
  if (has("PATCH_FOLDED")) return doubt(QObject::tr("Closed, but a face is folded"), "PATCH_FOLDED");
  const std::vector<std::string> contrary = strokes_with(findings, "CONTRADICTION");
  if (contrary.size() == 1) return {QObject::tr("Closed, but one stroke contradicts the others"), false, contrary};
  if (!contrary.empty())
    return {QObject::tr("Closed, but %1 strokes contradict the others").arg(contrary.size()), false, contrary};
  if (const std::vector<std::string> left = unused_edges(drawing, result); !left.empty()) {
    return {left.size() == 1 ? QObject::tr("Closed, but one edge is left out")
                             : QObject::tr("Closed, but %1 edges are left out").arg(left.size()),
            false, left};
  }
  if (has("DISCONNECTED")) return doubt(QObject::tr("Closed, but nothing ties its parts together"), "DISCONNECTED");
  if (!result.alternatives.empty()) return doubt(QObject::tr("Closed, but other faces fit as well"), "AMBIGUOUS");
  return {};
}

constexpr double chip_margin = 10;  // logical pixels
constexpr double hint_width = 620;
constexpr const char* sheet_button_style =
    "QToolButton { background: white; color: #3c4654; border: 1px solid #7a8698; border-radius: 9px;"
    " padding: 2px 9px }"
    "QToolButton:hover { background: #ffe2c2 }"
    "QToolButton:checked { background: #f28c28; color: #1c1c1e; border: 1px solid #a85a10 }";

/// Parted at the blank nearest to the middle.
QString on_two_lines(QString sentence) {
  const qsizetype middle = sentence.size() / 2;
  const qsizetype before = sentence.lastIndexOf(' ', middle), after = sentence.indexOf(' ', middle);
  const qsizetype blank = after < 0 || middle - before < after - middle ? before : after;
  return blank < 0 ? sentence : sentence.replace(blank, 1, '\n');
}

}  // namespace

AlternativeChips::AlternativeChips(Sheet& sheet) : sheet_(sheet), chips_(sheet.host.viewport()) {}

void AlternativeChips::make_button() {
  const std::size_t number = buttons_.size();
  const QString name = QString("perspective-alternative-%1").arg(number + 1);
  QToolButton* button = chips_.button(name, alternative_style, [this, number] {
    set_hovered(std::nullopt);
    take_alternative(sheet_, number);
  });
  button->setText(number == 0 ? tr("Other faces 1") : QString::number(number + 1));
  button->setToolTip(tr("These faces fit as well: the hatched ones instead of the dashed ones"));
  button->installEventFilter(this);
  buttons_.push_back(button);
}

void AlternativeChips::place(ChipPlaces& places, const ViewPane& pane, std::size_t count) {
  while (buttons_.size() < count) make_button();
  double width = 0;
  for (std::size_t i = 0; i < count; ++i) {
    buttons_[i]->adjustSize();
    width += buttons_[i]->width() + between_alternatives;
  }
  double left = pane.rect.center().x() - width / 2;
  chips_.begin(places);
  for (std::size_t i = 0; i < count; ++i) {
    chips_.put(*buttons_[i], QPointF(left, pane.rect.top() + alternatives_top), pane.rect);
    left += buttons_[i]->width() + between_alternatives;
  }
  chips_.end();
  if (hovered_ && *hovered_ >= count) set_hovered(std::nullopt);
}

void AlternativeChips::add_to(render::Scene& scene, bool on_sheet) const {
  const PerspectiveResult* result = sheet_.result();
  if (!hovered_ || result == nullptr || *hovered_ >= result->alternatives.size()) return;
  const Node* node = sheet_.host.studio().session().document().find(sheet_.tool.operation_node());
  const WorkObject* object = sheet_.host.studio().active();
  const Affine3 stands = object == nullptr ? Affine3() : object->placement.map();
  const Affine3 placement = node == nullptr ? Affine3() : composed(stands, node->transform);
  add_difference(scene, *result, difference_of(*result, result->alternatives[*hovered_]), [&](const Vec3& point) {
    return on_sheet ? on_sketch_plane(result->camera.project(point)) : to_glm(placement(point));
  });
}

void AlternativeChips::set_hovered(std::optional<std::size_t> alternative) {
  if (hovered_ == alternative) return;
  hovered_ = alternative;
  emit hovered_changed();
}

bool AlternativeChips::eventFilter(QObject* button, QEvent* event) {
  const auto found = std::ranges::find(buttons_, button);
  if (found != buttons_.end() && event->type() == QEvent::Enter)
    set_hovered(static_cast<std::size_t>(found - buttons_.begin()));
  if (found != buttons_.end() && event->type() == QEvent::Leave) set_hovered(std::nullopt);
  return QObject::eventFilter(button, event);
}

SolidState solid_state(const PerspectiveDrawing& drawing, const PerspectiveResult& result, const Findings& findings) {
  if (result.edge_strokes == 0) return {};
  if (!result.closed) return state_of_open(drawing, result);
  if (SolidState doubt = doubt_about(drawing, result, findings); !doubt.sentence.isEmpty()) return doubt;
  if (result.shells > 1) return {QObject::tr("Solid closed, %1 shells").arg(result.shells), true, {}};
  return {QObject::tr("Solid closed"), true, {}};
}

PerspectiveChips::PerspectiveChips(Sheet& sheet)
    : sheet_(sheet),
      alternatives_(sheet),
      chips_(sheet.host.viewport()),
      hint_(chips_.label("perspective-hint", hint_style)),
      faces_(
          chips_.button("perspective-faces", sheet_button_style, [this] { look_at_strokes(sheet_, faces_strokes_); })),
      fix_(chips_.button("perspective-fix-chip", sheet_button_style, [this] { apply_fix(sheet_); })),
      mirror_(chips_.button("perspective-mirror-chip", sheet_button_style, [this] { complete_mirrored(sheet_); })),
      through_(chips_.button("look-through-chip", sheet_button_style,
                             [this] { look_through(sheet_, through_->isChecked()); })) {
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);
  through_->setCheckable(true);
}

void PerspectiveChips::place(ChipPlaces& places, bool shown) {
  chips_.begin(places);
  const ViewPane& pane = places.layout().pane(SketchView);
  const PerspectiveResult* result = sheet_.result();
  const bool on_sheet = shown && pane.visible();
  if (on_sheet) {
    place_hint(pane.rect);
    place_faces(pane.rect);
  }
  alternatives_.place(places, pane, on_sheet && result != nullptr ? result->alternatives.size() : 0);
  if (on_sheet) {
    place_fix(pane);
    place_mirror(pane.rect);
  }
  if (shown) place_through(places.layout().pane(PerspectiveView));
  chips_.end();
}

/// What to draw first, as long as there is no camera.
void PerspectiveChips::place_hint(const QRectF& rect) {
  if (sheet_.result() != nullptr && !sheet_.drawing().strokes.empty()) return;
  hint_->setText(QObject::tr("Draw two lines along each axis: they take the axis' colour from where they point"));
  const int width = static_cast<int>(std::min(rect.width() - 2 * chip_margin, hint_width));
  hint_->setFixedSize(width, hint_->heightForWidth(width));
  chips_.put(*hint_, QPointF(rect.center().x() - hint_->width() / 2.0, rect.bottom() - 60), rect);
}

void PerspectiveChips::place_faces(const QRectF& rect) {
  const PerspectiveResult* result = sheet_.result();
  if (result == nullptr || result->edge_strokes == 0) return;
  SolidState state = solid_state(sheet_.drawing(), *result, sheet_.findings());
  const char* style = state.sound ? sound_style : lacking_style;
  if (faces_->styleSheet() != style) faces_->setStyleSheet(style);
  faces_->setText(state.sentence);
  faces_->setToolTip(state.strokes.empty() ? QString() : QObject::tr("Click to see the strokes"));
  faces_strokes_ = std::move(state.strokes);
  faces_->adjustSize();
  if (faces_->width() > rect.width() - 2 * chip_margin) faces_->setText(on_two_lines(state.sentence));
  chips_.put_in_middle(*faces_, rect.top() + chip_margin, rect);
}

void PerspectiveChips::place_fix(const ViewPane& pane) {
  const PerspectiveResult* result = sheet_.result();
  if (result == nullptr || result->fixes.empty()) return;
  const ProposedFix& fix = result->fixes.front();
  const PerspectiveStroke* stroke = find_stroke(sheet_.drawing(), fix.stroke);
  if (stroke == nullptr) return;
  fix_->setText(QObject::tr("Fix"));
  fix_->setToolTip(localized(fix.text));
  fix_->setAccessibleName(fix_->toolTip());
  fix_->adjustSize();
  chips_.put(*fix_, widget_place(sheet_, middle_of_stroke(*stroke)) + QPointF(14, 10), pane.rect);
}

void PerspectiveChips::place_mirror(const QRectF& rect) {
  if (!sheet_.proposal) return;
  const auto count = static_cast<int>(sheet_.proposal->strokes.size());
  mirror_->setText(count == 1 ? QObject::tr("Add 1 mirrored stroke (Enter)")
                              : QObject::tr("Add %1 mirrored strokes (Enter)").arg(count));
  chips_.put_in_middle(*mirror_, rect.bottom() - 40, rect);
}

void PerspectiveChips::place_through(const ViewPane& pane) {
  if (sheet_.result() == nullptr || !pane.visible()) return;
  through_->setText(QObject::tr("Look through"));
  through_->setToolTip(QObject::tr("See the solid from the drawing's eye, with the drawing over it (V)"));
  through_->setChecked(sheet_.looks_through());
  chips_.put_in_middle(*through_, pane.rect.top() + chip_margin, pane.rect);
}

}  // namespace croquis::app
