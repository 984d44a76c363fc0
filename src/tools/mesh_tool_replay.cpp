// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "croquis/base/error.h"
#include "tools/mesh_tool_cache.h"

namespace croquis {
namespace {

[[noreturn]] void refuse_step(const std::string& sentence) {
  throw Error(make_error(Category::Usage, "E_INPUT", sentence));
}

MeshTool::How how_of(const std::string& name) {
  using How = MeshTool::How;
  static const std::map<std::string, How> hows = {
      {"replace", How::Replace}, {"add", How::Add},   {"remove", How::Remove}, {"toggle", How::Toggle},
      {"loop", How::Loop},       {"ring", How::Ring}, {"path", How::Path},     {"connected", How::Connected},
      {"chain", How::Chain},     {"all", How::All}};
  const auto found = hows.find(name);
  return found == hows.end() ? How::Replace : found->second;
}

}  // namespace

Verdict MeshTool::replay(const recorded::Pick& step) {
  const Cache* cache = fresh();
  if (cache == nullptr) refuse_step("\"" + step.node + "\" holds no mesh");
  const ComponentKind picked = kind_of_singular(step.kind).value_or(ComponentKind::Edge);
  const std::size_t count = element_count(*cache->topology, picked);
  for (const Index element : step.elements) {
    if (element >= count) refuse_step("The mesh has no " + step.kind + " " + std::to_string(element));
  }
  return pick(picked, step.elements, how_of(step.how));
}

Verdict MeshTool::replay(const recorded::Move& step) { return move_selected(step.by); }
Verdict MeshTool::replay(const recorded::Rotate& step) { return rotate_selected(step.axis, step.degrees, step.pivot); }
Verdict MeshTool::replay(const recorded::Scale& step) { return scale_selected(step.factors, step.pivot); }

Verdict MeshTool::replay(const recorded::Tag& step) {
  const Cache* cache = fresh();
  if (cache == nullptr) refuse_step("\"" + step.node + "\" holds no mesh");
  if (step.change) return change_sharpness(*step.change);
  const double sharpness = step.sharpness.value_or(infinite_sharpness);
  if (step.edges == "boundary") return tag_boundary(sharpness);
  if (step.edges == "sharper-than") return tag_sharper_than(step.degrees, sharpness);
  if (step.edges == "tagged") return tag_edges(tagged_edges(cache->mesh->tags, *cache->topology), sharpness);
  return tag(sharpness);
}

Verdict MeshTool::replay(const recorded::Pin& step) { return pin(step.pinned); }

Verdict MeshTool::replay(const recorded::TagSet& step) {
  if (step.how == "rename") return rename_set(step.name, step.other);
  if (step.how == "sharpness") return set_set_sharpness(step.name, step.sharpness.value_or(infinite_sharpness));
  if (step.how == "select") return select_set(step.name);
  if (step.how == "merge") return merge_sets(step.name, step.other);
  if (step.how == "remove" || step.how == "untag") return remove_set(step.name, step.how == "untag");
  return make_set(step.name, step.sharpness.value_or(infinite_sharpness));
}

Verdict MeshTool::replay(const recorded::Extrude& step) { return extrude(step.by); }
Verdict MeshTool::replay(const recorded::LoopCut& step) { return cut_loop(step.edge, step.at); }

}  // namespace croquis
