// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/curve_taking.h"

#include <QMetaObject>
#include <algorithm>
#include <utility>

#include "app/tools/surface/shown_surface.h"
#include "croquis/tools/surface/surface_tool.h"
#include "croquis/workspace/chain.h"

namespace croquis::app {
namespace {

/// Where the operation stands in the document that is evaluated for it; comparisons and previews stand elsewhere.
constexpr NodeId taking_node = NodeId{1} << 60;

/// The network that an evaluation gives, or null.
std::shared_ptr<const AttributeNetwork> network_in(const Evaluation& evaluation) {
  for (const auto& [port, value] : evaluation.outputs) {
    if (auto network = value.as<AttributeNetwork>()) return network;
  }
  return nullptr;
}

}  // namespace

std::vector<const OperationDescription*> CurveTaking::ways() const {
  std::vector<const OperationDescription*> found;
  for (const OperationDescription& operation : studio_.registry().descriptions()) {
    const PortDescription* output = main_output(operation);
    if (output != nullptr && output->type == ValueType::AttributeNetwork) found.push_back(&operation);
  }
  return found;
}

/// The step nearest to the chain's end that gives what the operation takes.
std::optional<Link> CurveTaking::source_for(const OperationDescription& operation) const {
  const PortDescription* input = main_input(operation);
  const WorkObject* object = studio_.active();
  if (input == nullptr || object == nullptr) return std::nullopt;
  for (auto step = object->chain.rbegin(); step != object->chain.rend(); ++step) {
    const Node* node = studio_.session().document().find(*step);
    const auto link = node == nullptr ? std::nullopt : link_to(*node, studio_.registry(), input->type);
    if (link) return link;
  }
  return std::nullopt;
}

bool CurveTaking::can_take(const OperationDescription& operation) const { return source_for(operation).has_value(); }

void CurveTaking::take(const std::string& id) {
  const OperationDescription* operation = studio_.description(id);
  const auto source = operation == nullptr ? std::nullopt : source_for(*operation);
  if (!source) return;
  Node node;
  node.id = taking_node;
  node.name = operation->id;
  node.operation = operation->id;
  node.version = operation->version;
  node.inputs[main_input(*operation)->name] = *source;
  placement_ = studio_.active()->placement;
  name_ = "Curves of " + studio_.active()->name;
  live_ = studio_.live_beside(taking_node, [this] { follow(); });
  live_->follow(studio_.session().document().with(std::move(node)));
}

void CurveTaking::follow() {
  if (!live_ || !live_->result() || live_->busy()) return;
  const auto result = live_->result();
  // Not from inside of its own call.
  QMetaObject::invokeMethod(
      this, [gone = std::shared_ptr<LiveNode>(std::move(live_))] { (void)gone; }, Qt::QueuedConnection);
  const auto network = result->failed ? nullptr : network_in(*result);
  if (!network) {
    emit failed(result->findings);
    return;
  }
  SurfaceToolOptions options = studio_.network_options();
  const Document& document = studio_.session().document();
  options.name = free_name(document, name_);
  const NodeId node = document.next_id();
  AttributeNetwork lying = transformed(*network, inverse_of(upright_placement()));
  Document taken_from = studio_.with_network(document, std::move(lying), options);
  Node placed = *taken_from.find(node);
  placed.placement = placement_;
  studio_.session().edit("Take curves", taken_from.with(std::move(placed)));
  studio_.session().select({{node, ""}});
  emit taken();
}

}  // namespace croquis::app
