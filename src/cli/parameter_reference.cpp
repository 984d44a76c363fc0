// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parameter_reference.h"

#include <cmath>
#include <utility>
#include <variant>

namespace croquis::cli {
namespace {

struct DefaultEntry {
  Report operator()(const ParsedText& value) const { return value.text(); }
  template <typename Plain>
  Report operator()(const Plain& value) const {
    return value;
  }
};

Report describe_parameter(const ParameterDescription& parameter) {
  Report entry;
  entry.set("name", parameter.name).set("type", to_string(parameter.type));
  entry.set("default", std::visit(DefaultEntry(), parameter.default_value));
  if (parameter.type == ParameterType::Integer || parameter.type == ParameterType::Number) {
    entry.set("minimum", parameter.minimum).set("maximum", parameter.maximum);
  }
  if (!parameter.choices.empty()) entry.set("choices", Report::list(parameter.choices));
  return std::move(entry.set("unit", parameter.unit).set("sentence", parameter.sentence));
}

std::string range_text(const ParameterDescription& parameter) {
  if (!parameter.choices.empty()) {
    std::string list;
    for (const std::string& choice : parameter.choices) list += (list.empty() ? "" : ", ") + choice;
    return list;
  }
  if (parameter.type == ParameterType::Integer || parameter.type == ParameterType::Number) {
    const bool low = std::isfinite(parameter.minimum), high = std::isfinite(parameter.maximum);
    std::string range = low && high ? to_text(parameter.minimum) + " to " + to_text(parameter.maximum)
                        : low       ? "at least " + to_text(parameter.minimum)
                        : high      ? "at most " + to_text(parameter.maximum)
                                    : "any number";
    if (parameter.unit.empty()) return range;
    return range + (low || high ? " " : " of ") + parameter.unit;
  }
  return to_string(parameter.type);
}

}  // namespace

Report describe_parameters(const std::vector<ParameterDescription>& parameters) {
  Report list = Report::array();
  for (const ParameterDescription& parameter : parameters) list.push(describe_parameter(parameter));
  return list;
}

std::string parameter_table(const std::vector<ParameterDescription>& parameters) {
  std::string text = "| Parameter | Default | Values | |\n|---|---|---|---|\n";
  for (const ParameterDescription& parameter : parameters) {
    text += "| " + parameter.name + " | " + to_text(parameter.default_value) + " | " + range_text(parameter) + " | " +
            parameter.sentence + " |\n";
  }
  return text;
}

}  // namespace croquis::cli
