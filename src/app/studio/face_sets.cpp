// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/face_sets.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace croquis::app {
namespace {

std::string name_of(std::int32_t patch, const std::vector<Index>& holes) {
  if (holes.empty()) return "patch " + std::to_string(patch);
  std::string name = holes.size() == 1 ? "patch of hole " : "patch of holes ";
  for (std::size_t i = 0; i < holes.size(); ++i) name += (i == 0 ? "" : ", ") + std::to_string(holes[i]);
  return name;
}

}  // namespace

std::vector<FaceSet> FaceSets::sets_of(const WorkObject& object) const {
  const AttributeChannel* channel = object.mesh ? object.mesh->channel("patch_id", Domain::Face) : nullptr;
  const auto* ids = channel == nullptr ? nullptr : std::get_if<std::vector<std::int32_t>>(&channel->data);
  if (ids == nullptr) return {};
  std::map<std::int32_t, std::vector<Index>> faces;
  FaceSet all{"patches", {}, {}};
  for (std::size_t face = 0; face < ids->size(); ++face) {
    if ((*ids)[face] < 0) continue;
    faces[(*ids)[face]].push_back(static_cast<Index>(face));
    all.faces.push_back(static_cast<Index>(face));
  }
  if (faces.empty()) return {};
  auto holes = holes_ ? holes_(object) : std::map<std::int32_t, std::vector<Index>>();
  std::vector<FaceSet> sets;
  for (auto& [patch, own] : faces) sets.push_back({name_of(patch, holes[patch]), holes[patch], std::move(own)});
  std::ranges::stable_sort(sets, {}, [](const FaceSet& set) { return set.holes.empty() ? 0 : set.holes.front(); });
  sets.insert(sets.begin(), std::move(all));
  return sets;
}

const std::vector<FaceSet>& FaceSets::of(const WorkObject& object) {
  Known& known = known_[object.node];
  if (known.mesh != object.mesh || known.result != object.result) {
    known = {object.mesh, object.result, sets_of(object)};
  }
  return known.sets;
}

std::vector<Index> FaceSets::selected(const WorkObject& object, const Selection& selection) {
  std::vector<Index> faces;
  for (const SelectedItem& item : selection) {
    if (item.node != object.node || item.part.empty()) continue;
    for (const FaceSet& set : of(object)) {
      if (set.name == item.part) faces.insert(faces.end(), set.faces.begin(), set.faces.end());
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace croquis::app
