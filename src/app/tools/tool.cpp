// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/tool.h"

#include <QMainWindow>
#include <QStatusBar>
#include <algorithm>
#include <utility>

#include "app/files/file_reader.h"
#include "app/panels/number_box.h"
#include "app/views/viewport.h"
#include "croquis/base/error.h"
#include "croquis/workspace/chain.h"

namespace croquis::app {
namespace {

constexpr int watch_ms = 100;

void watch(QTimer& timer, bool down) {
  if (down && !timer.isActive()) timer.start(watch_ms);
  if (!down) timer.stop();
}

}  // namespace

Views& ToolHost::views() { return viewport().views(); }

void ToolHost::set_mode(const QString& mode) { app::set_mode(views(), mode); }

bool ToolHost::shows_views() { return !viewport().isHidden(); }

void ToolHost::add_status_widget(QWidget& widget) {
  static_cast<QMainWindow*>(viewport().window())->statusBar()->insertPermanentWidget(1, &widget);
}

bool pick(const ToolHost& host, ComponentKind kind, const std::vector<Index>& elements) {
  return std::ranges::any_of(host.tools(), [&](const auto& tool) {
    return tool->show(PickedElements{kind, elements});
  });
}

bool picks_elements(const ToolHost& host) {
  return std::ranges::any_of(host.tools(), [](const auto& tool) { return tool->state().picks_elements; });
}

void select_face_sets(ToolHost& host, NodeId node, const std::vector<std::string>& names) {
  Studio& studio = host.studio();
  const WorkObject* object = studio.object(node);
  if (object == nullptr) return;
  const std::vector<FaceSet>& sets = studio.face_sets().of(*object);
  Selection selection;
  ChosenFaceSets chosen;
  for (const std::string& name : names) {
    const auto set = std::ranges::find(sets, name, &FaceSet::name);
    if (set == sets.end()) {
      throw Error(
          make_error(Category::Usage, "E_INPUT", "There are no faces named \"" + name + "\" in " + object->name));
    }
    selection.push_back({object->node, name});
    chosen.push_back(&*set);
  }
  const bool is_source = object->is_source();
  studio.set_active(object->node);
  studio.session().select(std::move(selection));
  for (const auto& tool : host.tools()) tool->show(chosen);
  if (!is_source) return emit host.views().changed();
  pick(host, ComponentKind::Face, studio.face_sets().selected(*studio.active(), studio.session().selection()));
}

QString offer(const ToolHost& host) {
  for (const auto& tool : host.tools()) {
    if (const QString offer = tool->offer(); !offer.isEmpty()) return offer;
  }
  return {};
}

Tool::Tool(ToolHost& host, const QString& about) : help_topic(about), host_(host) {
  connect(&watch_, &QTimer::timeout, this, [this] {
    const auto steps = input_.settle(last_time_ + static_cast<double>(since_event_.nsecsElapsed()) * 1e-9);
    if (!steps.empty()) feed(steps);
    watch(watch_, down());
  });
}

void Tool::take(const PointerEvent& event) {
  const bool leaves = event.action == PointerEvent::Action::Leave;
  if (!leaves) pointer = {event.view, event.position};
  if (!leaves || !drags_leave_views_) {
    last_time_ = event.time;
    since_event_.start();
    const auto steps = input_.handle(event);
    if (!steps.empty()) feed(steps);
    watch(watch_, down());
  }
  if (!down() || leaves) hover(event);
}

bool Tool::abandon() {
  if (!down()) return false;
  const auto steps = input_.cancel();
  if (!steps.empty()) feed(steps);
  watch(watch_, down());
  return true;
}

bool works_on(const Studio& studio, const Node& step, ValueType type) {
  const OperationDescription* operation = studio.description(step.operation);
  const PortDescription* input = operation == nullptr ? nullptr : main_input(*operation);
  return (step.source && step.source->type() == type) || (input != nullptr && input->type == type);
}

void show_sketch_view(Viewport& views) {
  PaneLayout& layout = views.views().layout;
  if (!layout.pane(SketchView).visible()) layout.arrange(Arrangement::SketchAndSolid);
}

std::optional<SelectionFrame> frame_around(render::Bounds selected, const glm::dvec3& around) {
  if (selected.empty()) return std::nullopt;
  const glm::dvec3 middle = selected.center();
  selected.add(middle - around / 2.0);
  selected.add(middle + around / 2.0);
  return SelectionFrame{selected, std::nullopt, true};
}

QString axes_text(Eigen::Ref<const Eigen::VectorXd> vector) {
  QStringList parts;
  for (int axis = 0; axis < vector.size(); ++axis) parts << QChar('x' + axis) + (' ' + number_words(vector[axis]));
  return parts.join(QStringLiteral("  "));
}

QString way_text(Eigen::Ref<const Eigen::VectorXd> by, const Studio& studio) {
  const QString unit = QString::fromStdString(studio.unit());
  return (number_words(by.norm()) + ' ' + unit).trimmed() + QStringLiteral("   ") + axes_text(by);
}

QString sentences_of(const Findings& findings) { return sentences_of(findings, {}).join(' '); }

}  // namespace croquis::app
