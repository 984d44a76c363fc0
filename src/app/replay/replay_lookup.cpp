// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/replay_lookup.h"

#include <algorithm>

#include "app/views/viewport.h"
#include "croquis/base/error.h"

namespace croquis::app {

void refuse_replay(const std::string& sentence) { throw Error(make_error(Category::Geometry, "E_REPLAY", sentence)); }

Modifiers modifiers_of(const std::vector<std::string>& names) {
  const auto has = [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  return {has("shift"), has("ctrl"), has("alt"), has("super")};
}

int view_of(const std::string& name) {
  if (name.empty() || name == "sketch") return View::SketchView;
  const std::vector<std::string> names{"front", "perspective", "top", "side", "comparison"};
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) refuse_replay("There is no view \"" + name + "\"");
  return static_cast<int>(found - names.begin());
}

const WorkObject& object_named(const Studio& studio, const std::string& name) {
  const WorkObject* found = name.empty() ? studio.active() : nullptr;
  for (const WorkObject& object : studio.objects()) {
    const Node* node = studio.session().document().find(object.node);
    if (!name.empty() && (object.name == name || node->name == name)) found = &object;
  }
  if (found == nullptr) refuse_replay(name.empty() ? "There is no object" : "There is no object \"" + name + "\"");
  if (!found->shown()) refuse_replay("\"" + found->name + "\" has no mesh");
  return *found;
}

NodeId node_named(const Studio& studio, const std::string& name) {
  for (const auto& node : studio.session().document().nodes()) {
    if (node->name == name || node->operation == name) return node->id;
  }
  refuse_replay("The document has no node \"" + name + "\"");
}

}  // namespace croquis::app
