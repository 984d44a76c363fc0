// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/measure/measuring_tool.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <algorithm>
#include <cmath>

#include "app/replay/replays.h"
#include "app/tools/action_rows.h"
#include "app/tools/scene_parts.h"
#include "app/views/viewport.h"
#include "app/window/language.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr QPointF label_offset(10, -26);
constexpr float place_pixels = 9;
constexpr float hover_pixels = 7;
constexpr double line_pixels = 2;

render::Mark mark_at(const Vec3& place, float pixels, const QColor& color) {
  render::Mark mark{to_glm(place), render::MarkShape::Disc, pixels, to_color(color)};
  mark.outline_width = 2;
  return mark;
}

}  // namespace

MeasuringTool::MeasuringTool(ToolHost& host)
    : Tool(host, "Measuring"),
      tool_([this](const ViewFrame& frame, const Vec2& pixel) { return place_under(frame, pixel); }),
      chips_(host.viewport()) {}

void MeasuringTool::make_actions(ActionList& actions) {
  QMenu* edit = actions.menu(MenuId::Edit);
  edit->addSeparator();
  add_mode(host(), actions, MenuId::Edit, "measure", tr("Measure"), "M");
  actions.add(edit, "copy-measurement", tr("Copy measurement"), {QKeySequence::Copy}, [this] {
    QApplication::clipboard()->setText(localized(measured_text(tool_.places())));
    host().say(tr("Copied: %1").arg(QApplication::clipboard()->text().trimmed().replace('\n', QStringLiteral(" · "))));
  });
}

void MeasuringTool::refresh() { host().action("copy-measurement")->setEnabled(active() && tool_.places().size() > 1); }

void MeasuringTool::set_mode(const QString& mode) {
  const bool was_active = active();
  Tool::set_mode(mode);
  if (was_active && !active()) tool_.set_places({});
  tool_.leave();
}

/// The nearest vertex within reach, else the surface; where there is none, the plane of sketches in their view.
std::optional<Vec3> MeasuringTool::place_under(const ViewFrame& frame, const Vec2& pixel) {
  if (const auto place = objects_.place_at(studio().objects(), frame, pixel)) return place;
  if (view_ != SketchView) return std::nullopt;
  const Ray ray = frame.sight(pixel);
  if (std::abs(ray.direction.z()) < 1e-9) return std::nullopt;
  return ray.at(-ray.origin.z() / ray.direction.z());
}

void MeasuringTool::feed(const std::vector<PenStep>& steps) {
  for (const PenStep& step : steps) {
    view_ = step.view;
    const ViewFrame frame = frame_of(host().views(), step.view);
    if (tool_.handle({step.kind, step.sample.position, step.modifiers, frame, step.sample.time})) measured_anew();
  }
  emit changed();
}

void MeasuringTool::hover(const PointerEvent& event) {
  view_ = event.view;
  const bool left = event.action == PointerEvent::Action::Leave;
  if (left ? tool_.leave() : tool_.hover(event.position, frame_of(host().views(), event.view))) emit changed();
}

void MeasuringTool::measured_anew() {
  if (!tool_.places().empty()) emit committed(recorded::Measure{tool_.places()});
  emit state_changed();
}

void MeasuringTool::make_replays(Replays& replays) {
  replays.on<recorded::Measure>([this](const recorded::Measure& step) {
    if (!active()) host().set_mode("measure");
    tool_.set_places(step.places);
    emit changed();
    emit state_changed();
  });
  replays.ranges["measured"] = [this](const std::string&) {
    const std::vector<Vec3>& places = tool_.places();
    if (places.size() < 2) refuse_replay("Nothing is measured");
    const double first = (places[1] - places[0]).norm();
    const double second = places.size() > 2 ? (places[2] - places[1]).norm() : first;
    return std::pair(std::min(first, second), std::max(first, second));
  };
}

bool MeasuringTool::command(EditCommand command) {
  if (!active() || (command != EditCommand::SelectNone && command != EditCommand::Delete)) return false;
  const bool had_places = !tool_.places().empty();
  if (command == EditCommand::Delete)
    tool_.remove_last();
  else
    tool_.set_places({});
  if (had_places) measured_anew();
  emit changed();
  return true;
}

ToolWords MeasuringTool::words() const {
  switch (tool_.places().size()) {
    case 0: return {tr("Click a place of the model: the nearest vertex, or the surface · Q goes back to selecting")};
    case 1: return {tr("Click a second place for the distance · drag a place to move it · Escape starts again")};
    case 2: return {tr("Click a third place for angle and radius · Ctrl+C copies · Escape starts again")};
    default: return {tr("Ctrl+C copies what was measured · drag a place to move it · Escape starts again")};
  }
}

void MeasuringTool::add_to(render::Scene& scene, int) {
  if (!active()) return;
  std::vector<render::Mark> marks;
  for (const Vec3& place : tool_.places()) marks.push_back(mark_at(place, place_pixels, colors::accent));
  if (tool_.hovered() && !down()) marks.push_back(mark_at(*tool_.hovered(), hover_pixels, colors::hover));
  std::vector<render::LinePath> paths;
  if (tool_.places().size() > 1) paths.push_back(path_of(tool_.places(), to_glm));
  add_items(scene, {lines_of(paths, {line_pixels, to_color(colors::accent), {}})}, {marks_of(marks)});
}

void MeasuringTool::place_chips(ChipPlaces& places) {
  chips_.begin(places);
  const std::vector<MeasuredValue> values = active() ? measured(tool_.places()) : std::vector<MeasuredValue>();
  for (const int view : places.layout().shown()) {
    const ViewPane& pane = places.layout().pane(view);
    for (const MeasuredValue& value : values) {
      const auto seen = frame_of(host().views(), view).project(value.at);
      const QPointF at = pane.rect.topLeft() + (seen ? QPointF(seen->pixel.x(), seen->pixel.y()) : QPointF(-1, -1));
      if (!seen || !pane.rect.contains(at)) continue;
      const QString text = localized(value.name + " " + value.text);
      chips_.put_value("measured-value", text, "#f28c28", at + label_offset, pane.rect);
    }
  }
  chips_.end();
}

std::optional<SelectionFrame> MeasuringTool::selection_frame(int) const {
  if (tool_.places().size() < 2) return std::nullopt;
  render::Bounds bounds;
  for (const Vec3& place : tool_.places()) bounds.add(to_glm(place));
  return SelectionFrame{bounds, std::nullopt, true};
}

}  // namespace croquis::app
