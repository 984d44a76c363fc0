// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/sheet_interaction.h"

#include <utility>

#include "croquis/tools/perspective/axis_guess.h"

namespace croquis::app {
namespace {

constexpr int sheet_watch_ms = 100;
constexpr double sheet_mark_reach = 12;  // logical pixels
constexpr double sheet_stroke_reach = 9;

std::shared_ptr<const SolvedDrawing> solved_by(const PerspectiveResult& result) {
  auto solved = std::make_shared<SolvedDrawing>();
  solved->camera = result.camera;
  solved->vanishing_points = result.vanishing_points;
  solved->network = result.network;
  for (const PerspectiveFace& face : result.faces) solved->faces.push_back(face.strokes.front());
  solved->open_strokes = result.open_strokes;
  return solved;
}

}  // namespace

SheetInteraction::SheetInteraction(Studio& studio, const ViewPane& pane)
    : studio_(studio), pane_(pane), tool_(studio.session(), studio.sheet_options()) {
  connect(&pen_watch_, &QTimer::timeout, this,
          [this] { take_pen(pen_.settle(last_time_ + static_cast<double>(since_event_.nsecsElapsed()) * 1e-9)); });
}

const PerspectiveDrawing& SheetInteraction::drawing() const {
  static const PerspectiveDrawing none;
  const auto drawing = source_of<PerspectiveDrawing>(studio_.session().document().find(studio_.sheet_node()));
  return drawing ? *drawing : none;
}

const PerspectiveResult* SheetInteraction::result() const { return result_of<PerspectiveResult>(shown_.get()); }

Findings SheetInteraction::findings() const { return shown_ ? shown_->findings : Findings(); }

template <typename T>
const T* SheetInteraction::parameter_of(const std::string& name) const {
  const Node* operation = studio_.session().document().find(tool_.operation_node());
  if (operation == nullptr) return nullptr;
  const auto found = operation->parameters.find(name);
  return found == operation->parameters.end() ? nullptr : std::get_if<T>(&found->second);
}

std::string SheetInteraction::parameter_text(const std::string& name) const {
  const std::string* text = parameter_of<std::string>(name);
  return text == nullptr ? std::string() : *text;
}

bool SheetInteraction::parameter_flag(const std::string& name) const {
  const bool* flag = parameter_of<bool>(name);
  return flag != nullptr && *flag;
}

Vec2 SheetInteraction::to_sheet(const Vec2& pixel) const {
  const Vec2 place = pane_.sketch_frame().to_sketch(pixel);
  return {place.x(), -place.y()};
}

void SheetInteraction::set_mode(PerspectiveMode mode) {
  tool_.set_mode(mode);
  studio_.hold_results(false);
  show_guides(std::nullopt);
  show();
}

void SheetInteraction::take(const PointerEvent& event) {
  last_time_ = event.time;
  since_event_.start();
  if (picks_ != Pick::None && event.action == PointerEvent::Action::Press && event.buttons.left)
    return take_pick(event);
  take_pen(pen_.handle(event));
  if (event.action == PointerEvent::Action::Leave) {
    show_guides(std::nullopt);
    emit changed();
  } else if (!pen_.down()) {
    hover(event);
  }
}

void SheetInteraction::pick(Pick wanted) {
  picks_ = wanted;
  emit state_changed();
}

/// A click beside any stroke chooses no length: the next one may.
void SheetInteraction::take_pick(const PointerEvent& event) {
  const double unit = pane_.sketch_frame().units_per_pixel;
  const Vec2 at = to_sheet(event.position);
  if (picks_ == Pick::Point) {
    const auto end = nearest_end(drawing(), at, 2 * sheet_stroke_reach * unit);
    pick(Pick::None);
    emit point_picked(end ? place_of(drawing(), *end) : at);
  } else if (const auto stroke = nearest_stroke(drawing(), at, 2 * sheet_stroke_reach * unit)) {
    pick(Pick::None);
    emit length_picked(*stroke);
  }
}

bool SheetInteraction::abandon() {
  if (std::exchange(picks_, Pick::None) != Pick::None) {
    emit state_changed();
    return true;
  }
  if (!pen_.down()) return false;
  take_pen(pen_.cancel());
  return true;
}

void SheetInteraction::take_pen(const std::vector<PenStep>& steps) {
  for (const PenStep& step : steps) feed(step);
  if (pen_.down() && !pen_watch_.isActive()) pen_watch_.start(sheet_watch_ms);
  if (!pen_.down()) pen_watch_.stop();
  if (steps.empty()) return;
  // Nothing else changes under the pen: what is computed meanwhile is shown when the stroke has ended.
  studio_.hold_results(inking());
  if (inking()) {
    emit inked();
    return;
  }
  show();
}

void SheetInteraction::feed(const PenStep& step) {
  if (tool_.handle(to_sketch(step, pane_.sketch_frame())) == Verdict::Commit && tool_.done())
    emit committed(*tool_.done());
}

void SheetInteraction::show() {
  scene_.show_hovered(drawing(), std::nullopt);
  scene_.show_preview(drawing(), tool_.preview());
  emit changed();
}

QString SheetInteraction::told_at(const Vec2& pixel) const {
  QStringList sentences;
  for (const SheetMark& mark : scene_.marks()) {
    const bool under = (pane_.sketch_frame().to_pixel({mark.at.x(), -mark.at.y()}) - pixel).norm() < sheet_mark_reach;
    if (under && !sentences.contains(mark.sentence)) sentences << mark.sentence;
  }
  return sentences.join("\n");
}

void SheetInteraction::show_guides(const std::optional<Vec2>& from) {
  scene_.show_guides(drawing(), seen_vanishing_points(drawing(), tool_.solved()), from);
}

void SheetInteraction::hover(const PointerEvent& event) {
  told_finding_ = told_at(event.position);
  const Vec2 at = to_sheet(event.position);
  const double unit = pane_.sketch_frame().units_per_pixel;
  if (tool_.mode() == PerspectiveMode::Draw) {
    const auto end = nearest_end(drawing(), at, 14 * unit);
    show_guides(end ? place_of(drawing(), *end) : at);
  } else {
    scene_.show_hovered(drawing(), nearest_stroke(drawing(), at, sheet_stroke_reach * unit));
  }
  emit changed();
}

void SheetInteraction::propose_mirror(bool wanted) {
  proposal_.reset();
  if (wanted && tool_.solved() != nullptr) proposal_ = croquis::propose_mirror(drawing(), *tool_.solved());
  scene_.show_proposed(proposal_ ? proposal_->strokes : std::vector<PerspectiveStroke>());
  emit changed();
}

render::Scene SheetInteraction::scene() const { return scene_.scene(drawing(), pane_.sketch_frame().units_per_pixel); }

void SheetInteraction::follow_document() {
  if (!pen_.down()) tool_.set_node(studio_.sheet_node());
  if (studio_.sheet_node() == 0) return;
  scene_.show_drawing(drawing(), tool_.selected(), tool_.mode() == PerspectiveMode::Select);
  scene_.show_preview(drawing(), tool_.preview());
  propose_mirror(false);
  follow_result();
}

void SheetInteraction::follow_result() {
  if (studio_.sheet_node() == 0) return;
  const NodeId node = tool_.operation_node();
  shown_ = node == 0 ? nullptr : studio_.result(node);
  const PerspectiveResult* found = result();
  tool_.set_solved(found == nullptr ? nullptr : solved_by(*found));
  scene_.show_result(drawing(), found, findings());
  emit changed();
}

}  // namespace croquis::app
