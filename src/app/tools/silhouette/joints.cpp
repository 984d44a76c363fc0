// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/joints.h"

#include <algorithm>
#include <sstream>

#include "croquis/operators/inflate_result.h"

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
  const InflateResult* inflated = evaluation.failed ? nullptr : evaluation.result<InflateResult>();
  if (inflated == nullptr) return joints;
  const std::vector<std::string> entries = split(attach, ';');
  for (const SuggestedJoint& suggestion : inflated->suggested) {
    Joint joint{suggestion.a, suggestion.b, suggestion.at};
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
