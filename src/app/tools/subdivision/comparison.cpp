// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/subdivision/comparison.h"

#include <algorithm>

#include "croquis/workspace/node_values.h"

namespace croquis::app {
namespace {

/// An id that no document reaches.
constexpr NodeId compared_node = NodeId{1} << 62;

/// The first choice is compared with the second, every other one with the first.
std::string another_choice(const ParameterDescription& parameter, const std::string& value) {
  const bool first = value == parameter.choices.front();
  return parameter.choices[first && parameter.choices.size() > 1 ? 1 : 0];
}

}  // namespace

Comparison::Comparison(Studio& studio, QThreadPool& threads, QObject* parent)
    : QObject(parent), studio_(studio), item_(threads) {
  connect(&item_, &LiveItem::ready, this, &Comparison::changed);
}

void Comparison::show(bool shown) {
  shown_ = shown;
  follow();
}

void Comparison::choose(const std::string& parameter, const std::string& value) {
  parameter_ = parameter;
  value_ = value;
  follow();
}

QString Comparison::title() const { return title_; }

void Comparison::follow() {
  const Node* node = studio_.active_operation();
  const OperationDescription* operation = node == nullptr ? nullptr : studio_.description(node->operation);
  const ParameterDescription* parameter =
      operation == nullptr ? nullptr : find_parameter(operation->parameters, parameter_);
  if (!shown_ || parameter == nullptr || parameter->choices.empty()) {
    object_ = 0;
    live_.reset();
    item_.show(nullptr, {});
    return;
  }
  object_ = node->id;
  shown_value_ =
      value_.empty() ? another_choice(*parameter, text_of(values_of(*node, *operation), parameter_)) : value_;
  const auto chosen = std::ranges::find(parameter->choices, shown_value_) - parameter->choices.begin();
  const bool is_titled = chosen < std::ssize(parameter->choice_titles);
  title_ =
      QString::fromStdString(is_titled ? parameter->choice_titles[static_cast<std::size_t>(chosen)] : shown_value_);
  Node other = *node;
  other.id = compared_node;
  other.parameters[parameter_] = shown_value_;
  if (!live_) {
    live_ = studio_.live_beside(compared_node, [this] { take(); });
  }
  live_->follow(studio_.session().document().with(std::move(other)));
}

void Comparison::take() {
  const Node* node = studio_.session().document().find(object_);
  const OperationDescription* operation = node == nullptr ? nullptr : studio_.description(node->operation);
  if (operation == nullptr || !live_ || !live_->result()) return;
  item_.show(mesh_of(*live_->result(), *operation), {});
  emit changed();
}

}  // namespace croquis::app
