// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/project_settings.h"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "croquis/base/error.h"

namespace croquis::cli {
namespace {

struct Setting {
  std::string node;
  std::string parameter;
  std::string value;
};

Error refused(const char* code, std::string message, const std::string& subject, SubjectKind kind) {
  return Error(make_error(Category::Usage, code, std::move(message), {{kind, subject, {}, {}, {}}}));
}

/// Names may hold dots, parameters don't.
bool parse(const std::string& text, Setting& setting) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) return false;
  const auto dot = text.rfind('.', equals);
  if (dot == std::string::npos || dot == 0 || dot + 1 == equals) return false;
  setting = {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1)};
  return true;
}

std::vector<Setting> split(const std::string& settings) {
  std::vector<Setting> list;
  std::istringstream stream(settings);
  for (std::string piece; std::getline(stream, piece, ';');) {
    Setting setting;
    if (parse(piece, setting)) {
      list.push_back(std::move(setting));
    } else if (list.empty()) {
      throw refused("E_USAGE", "'" + piece + "' is no setting: write NODE.PARAMETER=VALUE.", "set",
                    SubjectKind::Parameter);
    } else {
      list.back().value += ";" + piece;
    }
  }
  return list;
}

const Node& find_node(const Document& document, const std::string& wanted) {
  const Node* found = nullptr;
  for (const auto& node : document.nodes()) {
    if (std::to_string(node->id) == wanted) return *node;
    if (node->name != wanted) continue;
    if (found != nullptr) {
      throw refused("E_USAGE", "Several nodes are called '" + wanted + "'; name the one you mean by its id.", wanted,
                    SubjectKind::Node);
    }
    found = node.get();
  }
  if (found != nullptr) return *found;
  std::string names;
  for (const auto& node : document.nodes()) {
    names += (names.empty() ? "" : ", ") + std::to_string(node->id) + " ('" + node->name + "')";
  }
  throw refused("E_USAGE",
                "There is no node '" + wanted + "' in the project; there are " + (names.empty() ? "none" : names) + ".",
                wanted, SubjectKind::Node);
}

Document with_setting(const Document& document, const Setting& setting, const Registry& registry) {
  Node node = find_node(document, setting.node);
  const Operation* operation = registry.find(node.operation);
  const auto parameters = operation == nullptr ? std::vector<ParameterDescription>() : operation->describe().parameters;
  const ParameterDescription* found = find_parameter(parameters, setting.parameter);
  if (found == nullptr) {
    throw refused("E_PARAMETER",
                  "Node '" + setting.node + "' has no parameter '" + setting.parameter +
                      "'; croquis-cli operations lists them all.",
                  setting.parameter, SubjectKind::Parameter);
  }
  node.parameters[setting.parameter] = parse_parameter(*found, setting.value);
  return document.with(std::move(node));
}

}  // namespace

Document with_settings(const Document& document, const std::string& settings, const Registry& registry) {
  Document edited = document;
  Findings findings;
  for (const Setting& setting : split(settings)) {
    try {
      edited = with_setting(edited, setting, registry);
    } catch (const Error& error) {
      findings.insert(findings.end(), error.findings().begin(), error.findings().end());
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return edited;
}

}  // namespace croquis::cli
