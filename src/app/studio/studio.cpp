// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/studio.h"

#include <QMetaObject>
#include <utility>

#include "croquis/operators/all_operations.h"

namespace croquis::app {
namespace {

const std::string solid_operation_id = "inflate";

std::shared_ptr<const Drawing> drawing_of(const Node& node) {
  return node.source ? node.source->as<Drawing>() : nullptr;
}

LiveEvaluation::Post post_to(QObject* receiver) {
  return [receiver](std::function<void()> task) {
    QMetaObject::invokeMethod(receiver, std::move(task), Qt::QueuedConnection);
  };
}

Workspace::Listener signals_of(Studio* studio) {
  Workspace::Listener listener;
  listener.loaded = [studio] {
    studio->face_sets() = FaceSets();
    emit studio->loaded();
  };
  listener.changed = [studio] { emit studio->changed(); };
  listener.result_changed = [studio] { emit studio->result_changed(); };
  listener.progress = [studio](double fraction, const std::string& step) {
    emit studio->progress_changed(fraction, QString::fromStdString(step));
  };
  listener.busy_changed = [studio](bool busy) { emit studio->busy_changed(busy); };
  return listener;
}

}  // namespace

Studio::Studio() : Workspace(all_operations(), post_to(this), signals_of(this)) {}

Studio::~Studio() = default;

const Drawing& Studio::drawing() const {
  static const Drawing none;
  const Node* node = session().document().find(drawing_node());
  return node == nullptr ? none : *drawing_of(*node);
}

NodeId Studio::drawing_node() const {
  for (const auto& node : session().document().nodes()) {
    if (drawing_of(*node) != nullptr) return node->id;
  }
  return 0;
}

NodeId Studio::solid_node() const {
  for (const auto& node : session().document().nodes()) {
    if (node->operation == solid_operation_id) return node->id;
  }
  return 0;
}

const OperationDescription* Studio::solid_description() const {
  return solid_node() == 0 ? nullptr : description(solid_operation_id);
}

std::shared_ptr<const Evaluation> Studio::result() const { return result(solid_node()); }

std::shared_ptr<const PolyMesh> Studio::solid() const {
  const auto evaluation = result();
  return evaluation ? mesh_of(*evaluation, *registry().find(solid_operation_id)) : nullptr;
}

SketchToolOptions Studio::tool_options() const {
  SketchToolOptions options;
  options.operation = solid_operation_id;
  options.version = description(solid_operation_id)->version;
  return options;
}

void Studio::start_with(Drawing drawing) {
  SketchToolOptions options = tool_options();
  options.parameters.clear();  // files hold exact lines
  load(add_drawing(Document(), std::make_shared<const Drawing>(std::move(drawing)), options));
}

void Studio::start_empty() { load(Document()); }

}  // namespace croquis::app
