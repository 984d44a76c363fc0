// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/joints.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <variant>

namespace croquis::app {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// "A,B" or "A,B=0.55", in either order of the two.
bool names_pair(const std::string& entry, const std::string& a, const std::string& b) {
  const std::string names = entry.substr(0, entry.rfind('='));
  return names == a + "," + b || names == b + "," + a;
}

}  // namespace

std::vector<Joint> suggested_joints(const Evaluation& evaluation, const std::string& attach) {
  std::vector<Joint> joints;
  const auto details = evaluation.outputs.find("details");
  if (evaluation.failed || details == evaluation.outputs.end()) return joints;
  const Report* list = details->second.as<Report>()->find("attach_suggestions");
  if (list == nullptr) return joints;
  const std::vector<std::string> entries = split(attach, ';');
  for (const Report& suggestion : list->as_array()) {
    Joint joint{suggestion.at("a").as_string(), suggestion.at("b").as_string()};
    const Report::Array& at = suggestion.at("at").as_array();
    joint.at = Vec2(at[0].as_number(), -at[1].as_number());
    joint.attached = std::any_of(entries.begin(), entries.end(),
                                 [&](const std::string& entry) { return names_pair(entry, joint.a, joint.b); });
    joints.push_back(std::move(joint));
  }
  return joints;
}

std::string toggled_joint(const std::string& attach, const Joint& joint) {
  std::vector<std::string> entries = split(attach, ';');
  const auto removed =
      std::erase_if(entries, [&](const std::string& entry) { return names_pair(entry, joint.a, joint.b); });
  if (removed == 0) entries.push_back(joint.a + "," + joint.b);
  std::string text;
  for (const std::string& entry : entries) text += (text.empty() ? "" : ";") + entry;
  return text;
}

}  // namespace croquis::app
