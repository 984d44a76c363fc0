// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/network_interaction.h"

#include <utility>

#include "app/studio/own_space.h"
#include "app/tools/surface/network_sight.h"
#include "app/views/pick_box.h"
#include "app/views/viewport.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr int network_watch_ms = 100;
constexpr double network_mark_reach = 12;  // logical pixels

QString network_sentences(const Findings& findings) {
  QStringList sentences;
  for (const Finding& finding : findings) {
    const QString sentence = QString::fromStdString(finding.message);
    sentences << (sentence.endsWith('.') ? sentence : sentence + ".");
  }
  return sentences.join(' ');
}

const std::shared_ptr<const AttributeNetwork>& no_network() {
  static const auto none = std::make_shared<const AttributeNetwork>();
  return none;
}

}  // namespace

NetworkInteraction::NetworkInteraction(Studio& studio, Viewport& views)
    : studio_(studio),
      views_(views),
      tool_(studio.session(), studio.network_options()),
      meshes_(studio),
      network_(no_network()) {
  tool_.set_ground({Vec3::Zero(), Vec3::UnitZ()});
  connect(&pen_watch_, &QTimer::timeout, this,
          [this] { take_pen(pen_.settle(last_time_ + static_cast<double>(since_event_.nsecsElapsed()) * 1e-9)); });
}

Findings NetworkInteraction::findings() const { return shown_.result ? shown_.result->findings : Findings(); }

ViewFrame NetworkInteraction::frame_of(int view) const { return seen_from(views_.frame_of(view), shown_.to_world); }

void NetworkInteraction::act(const std::function<Verdict(SurfaceTool&)>& work) {
  try {
    finish(work(tool_));
  } catch (const Error& error) {
    emit told(network_sentences(error.findings()));
  }
  show_preview();
  emit state_changed();
}

void NetworkInteraction::finish(Verdict verdict) {
  if (verdict == Verdict::Commit && tool_.done()) emit committed(*tool_.done());
  if (!tool_.active()) emit told(network_sentences(tool_.notes()));
}

void NetworkInteraction::set_mode(SurfaceMode mode) {
  tool_.set_mode(mode);
  studio_.hold_results(false);
  show_preview();
}

void NetworkInteraction::take(const PointerEvent& event) {
  last_time_ = event.time;
  since_event_.start();
  take_pen(pen_.handle(event));
  if (event.action == PointerEvent::Action::Leave) {
    told_finding_.clear();
    if (tool_.leave()) show_preview();
  } else if (!pen_.down()) {
    hover(event);
  }
}

bool NetworkInteraction::abandon() {
  if (!pen_.down()) return false;
  take_pen(pen_.cancel());
  return true;
}

void NetworkInteraction::take_pen(const std::vector<PenStep>& steps) {
  const bool was_active = tool_.active();
  for (const PenStep& step : steps) feed(step);
  if (pen_.down() && !pen_watch_.isActive()) pen_watch_.start(network_watch_ms);
  if (!pen_.down()) pen_watch_.stop();
  if (steps.empty()) return;
  // Nothing else changes under a pen that draws: what is computed meanwhile is shown when the stroke has ended.
  studio_.hold_results(tool_.active() && tool_.mode() == SurfaceMode::Draw);
  show_preview();
  if (was_active != tool_.active()) emit state_changed();
}

void NetworkInteraction::feed(const PenStep& step) {
  gesture_view_ = step.view;
  SurfaceEvent event;
  event.pointer.kind = step.kind;
  event.pointer.pixel = step.sample.position;
  event.pointer.modifiers = step.modifiers;
  event.pointer.frame = frame_of(step.view);
  event.pointer.time = step.sample.time;
  event.pressure = step.sample.pressure;
  try {
    const Verdict verdict = tool_.handle(event);
    if (step.kind == PenStep::Kind::End || step.kind == PenStep::Kind::Cancel) finish(verdict);
  } catch (const Error& error) {
    emit told(network_sentences(error.findings()));
  }
}

void NetworkInteraction::hover(const PointerEvent& event) {
  gesture_view_ = event.view;
  const QString before = std::exchange(told_finding_, told_at(event.position, event.view));
  if (tool_.hover(event.position, frame_of(event.view))) show_preview();
}

QString NetworkInteraction::told_at(const Vec2& pixel, int view) const {
  QStringList sentences;
  const ViewFrame frame = views_.frame_of(view);
  for (const NetworkMark& mark : scene_.marks()) {
    const auto seen = frame.project(mark.at);
    const bool under = seen && (seen->pixel - pixel).norm() < network_mark_reach;
    if (under && !sentences.contains(mark.sentence)) sentences << mark.sentence;
  }
  return sentences.join("\n");
}

void NetworkInteraction::show_preview() {
  scene_.show_preview(tool_.preview(), *network_, to_world());
  scene_.show_handles(tool_, *network_, to_world());
  emit changed();
}

void NetworkInteraction::show_jumps(bool on) {
  jumps_ = on;
  scene_.show_jumps(*network_, shown_, jumps_);
  emit changed();
}

void NetworkInteraction::add_to(render::Scene& scene, int view) const {
  scene_.add_to(scene);
  const auto& box = tool_.preview().box;
  if (box && view == gesture_view_) add_box(*box, views_.frame_of(view), scene);
}

void NetworkInteraction::follow_document() {
  const NodeId node = studio_.network_node();
  if (!pen_.down()) tool_.set_node(node);
  const auto network = source_of<AttributeNetwork>(studio_.session().document().find(node));
  network_ = network ? network : no_network();
  follow_result();
}

void NetworkInteraction::follow_result() {
  const NodeId node = studio_.network_node();
  if (node == 0) return;
  const NodeId operation = tool_.operation_node();
  ShownSurface now = shown_surface(studio_, node, operation);
  if (now.result != shown_.result || now.mesh != shown_.mesh || now.to_world != shown_.to_world) {
    const WorkObject* object = studio_.object(operation);
    sight_ = std::make_shared<NetworkSight>(now, object == nullptr ? operation : object->node, meshes_);
    tool_.set_sight(sight_);
  }
  shown_ = std::move(now);
  scene_.show_network(*network_, shown_, tool_.selected());
  scene_.show_findings(*network_, to_world(), findings());
  scene_.show_jumps(*network_, shown_, jumps_);
  show_preview();
}

}  // namespace croquis::app
