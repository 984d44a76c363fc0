// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio.h"

#include <QMetaObject>
#include <algorithm>
#include <utility>

#include "croquis/operators/all_operations.h"

namespace croquis::app {
namespace {

const std::string solid_operation_id = "inflate";
constexpr int patience_ms = 400;  // a draft that takes longer gives way to a newer one

const std::shared_ptr<const Drawing>* drawing_of(const Node& node) {
  return node.source ? std::get_if<std::shared_ptr<const Drawing>>(&*node.source) : nullptr;
}

}  // namespace

Studio::Studio() : registry_(all_operations()), evaluator_(registry_) {
  LiveEvaluation::Post post = [this](std::function<void()> task) {
    QMetaObject::invokeMethod(this, std::move(task), Qt::QueuedConnection);
  };
  LiveEvaluation::Callbacks callbacks;
  callbacks.result = [this](NodeId, std::shared_ptr<const Evaluation> result, Quality quality) {
    take_result(std::move(result), quality);
  };
  callbacks.progress = [this](double fraction, const std::string& step) {
    emit progress_changed(fraction, QString::fromStdString(step));
  };
  callbacks.busy = [this](bool) { emit busy_changed(busy()); };
  live_ = std::make_unique<LiveEvaluation>(evaluator_, std::move(post), std::move(callbacks));
  session_.on_change([this] { follow_session(); });
}

Studio::~Studio() = default;

const Drawing& Studio::drawing() const {
  static const Drawing none;
  const Node* node = session_.document().find(drawing_node());
  return node == nullptr ? none : **drawing_of(*node);
}

NodeId Studio::drawing_node() const {
  for (const auto& node : session_.document().nodes()) {
    if (drawing_of(*node) != nullptr) return node->id;
  }
  return 0;
}

NodeId Studio::solid_node() const {
  for (const auto& node : session_.document().nodes()) {
    if (node->operation == solid_operation_id) return node->id;
  }
  return 0;
}

const OperationDescription* Studio::solid_description() const {
  // Descriptions never change while the program runs.
  static const OperationDescription description = registry_.find(solid_operation_id)->describe();
  return solid_node() == 0 ? nullptr : &description;
}

std::shared_ptr<const PolyMesh> Studio::solid() const {
  if (!result_) return nullptr;
  const auto mesh = result_->outputs.find("mesh");
  if (mesh == result_->outputs.end()) return nullptr;
  const auto* value = std::get_if<std::shared_ptr<const PolyMesh>>(&mesh->second);
  return value == nullptr ? nullptr : *value;
}

Findings Studio::findings() const {
  if (!result_) return {};
  Findings findings = result_->findings;
  std::stable_partition(findings.begin(), findings.end(),
                        [](const Finding& finding) { return finding.severity == Severity::Error; });
  return findings;
}

SketchToolOptions Studio::tool_options() const {
  SketchToolOptions options;
  options.operation = solid_operation_id;
  options.version = registry_.find(solid_operation_id)->describe().version;
  return options;
}

void Studio::start_with(Drawing drawing) {
  SketchToolOptions options = tool_options();
  options.parameters.clear();  // files hold exact lines
  load(add_drawing(Document(), std::make_shared<const Drawing>(std::move(drawing)), options));
}

void Studio::start_empty() { load(Document()); }

void Studio::load(Document document, bool modified) {
  cancel();
  result_.reset();
  evaluated_ = Document();
  evaluator_.forget_last_good();
  emit loaded();
  session_.load(std::move(document), modified);
  emit result_changed();
}

void Studio::set_parameter(NodeId id, const std::string& name, const ParameterValue& value, bool dragging) {
  const Node* node = session_.document().find(id);
  const Operation* operation = node == nullptr ? nullptr : registry_.find(node->operation);
  if (operation == nullptr) return;
  Node edited = *node;
  edited.parameters[name] = value;
  for (const ParameterDescription& parameter : operation->describe().parameters) {
    if (parameter.name == name && parameter.default_value == value) edited.parameters.erase(name);
  }
  Document document = session_.document().with(std::move(edited));
  const std::string label = "Set " + name;
  if (dragging && !dragging_parameter_) session_.begin_drag(label);
  const bool in_drag = dragging || dragging_parameter_;
  dragging_parameter_ = dragging;
  if (!in_drag) {
    session_.edit(label, std::move(document));
    return;
  }
  session_.drag(std::move(document));
  if (!dragging) session_.end_drag();
}

void Studio::cancel() {
  waiting_ = false;
  drafting_ = false;
  live_->cancel();
}

void Studio::follow_session() {
  const Document& document = session_.document();
  if (!same_nodes(document, evaluated_)) {
    evaluated_ = document;
    if (solid_node() == 0 || drawing().strokes.empty()) {
      cancel();
      result_.reset();
      emit result_changed();
    } else if (drafting_ && !since_request_.hasExpired(patience_ms)) {
      // A hand moves faster than solids are made: the draft under way is shown before the next one begins.
      waiting_ = true;
    } else {
      evaluate();
    }
  }
  emit changed();
}

void Studio::evaluate() {
  waiting_ = false;
  drafting_ = true;
  since_request_.start();
  live_->request(session_.document(), solid_node());
}

void Studio::take_result(std::shared_ptr<const Evaluation> result, Quality quality) {
  result_ = std::move(result);
  quality_ = quality;
  drafting_ = false;
  if (waiting_) evaluate();
  emit result_changed();
}

}  // namespace croquis::app
