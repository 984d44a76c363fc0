// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/subdivision/smoothing.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/subdivision/shape_keeping.h"
#include "croquis/workspace/node_values.h"

namespace croquis::app {
namespace {

const std::string smoothing_operation = "subdivide";
const std::string level_parameter = "levels";
constexpr int finest_shown = 6;  // finer levels are for files

const Node* smoothing_node(const Studio& studio) {
  const Node* node = studio.active_operation();
  return node == nullptr || node->operation != smoothing_operation ? nullptr : node;
}

const ParameterDescription* level_description(const Studio& studio) {
  const OperationDescription* operation = studio.description(smoothing_operation);
  if (operation == nullptr) return nullptr;
  return find_parameter(operation->parameters, level_parameter);
}

}  // namespace

void show_smooth(Studio& studio, ChainView view) {
  const WorkObject* object = studio.active();
  if (object == nullptr || object->cage == 0) return;
  NodeId node = object->node;
  if (object->is_source()) {
    if (view == ChainView::Cage) return;
    const std::string label = "Smooth " + object->name;
    AddedNode added = with_step(studio.session().document(), studio.registry(), object->cage, smoothing_operation);
    node = added.node;
    studio.session().edit(label, std::move(added.document));
    studio.set_active(node);
  }
  studio.set_view(node, view);
}

int shown_level(const Studio& studio) {
  const Node* node = smoothing_node(studio);
  if (node == nullptr || level_description(studio) == nullptr) return -1;
  return static_cast<int>(integer_of(values_of(*node, *studio.description(smoothing_operation)), level_parameter));
}

void change_level(Studio& studio, int by) {
  const ParameterDescription* level = level_description(studio);
  const int shown = shown_level(studio);
  if (shown < 0) return;
  const int finest = std::min(std::max(finest_shown, shown), static_cast<int>(level->maximum));
  const int wanted = std::clamp(shown + by, static_cast<int>(level->minimum), finest);
  if (wanted != shown) set_smoothing(studio, level_parameter, std::int64_t{wanted});
}

bool set_smoothing(Studio& studio, const std::string& parameter, const ParameterValue& value) {
  const Node* node = smoothing_node(studio);
  if (node == nullptr) return false;
  studio.set_parameter(node->id, parameter, value, false);
  return true;
}

void freeze_level(Studio& studio) {
  const WorkObject* object = studio.active();
  const bool finished = object != nullptr && !object->is_source() && object->cage != 0 && object->mesh &&
                        object->result && !object->result->failed && object->quality == Quality::Final;
  if (!finished) {
    throw Error(
        make_error(Category::Usage, "E_EMPTY", "There is no finished mesh to freeze: press 3 or fill holes first"));
  }
  const Document& before = studio.session().document();
  const int level = shown_level(studio);
  const std::string name = object->name + (level < 0 ? " filled" : " level " + std::to_string(level));
  Node hidden = *before.find(object->node);
  hidden.visible = false;
  Node frozen;
  frozen.name = free_name(before, name);
  frozen.source = object->mesh;
  frozen.placement = object->placement;
  frozen.group = object->group;
  const NodeId id = before.next_id();
  studio.session().edit("Freeze " + name, before.with(std::move(hidden)).with(std::move(frozen)));
  studio.set_active(id);
  studio.session().select({{id, ""}});
}

Findings keep_selected_faces(Studio& studio, KeptShape kept) {
  const WorkObject* object = studio.active();
  const ComponentSelection& selected = studio.session().components();
  const bool has_faces = object != nullptr && object->cage_mesh && selected.node == object->cage &&
                         selected.kind == ComponentKind::Face && !selected.empty();
  if (!has_faces) {
    throw Error(make_error(Category::Usage, "E_EMPTY", "No faces are selected: pick those to keep first (F11)"));
  }
  const Document& before = studio.session().document();
  Node cage = *before.find(object->cage);
  if (!cage.source) {
    throw Error(make_error(Category::Usage, "E_INPUT", "The mesh is computed: freeze its last step first"));
  }
  Findings notices;
  PolyMesh mesh;
  if (kept == KeptShape::Faces) {
    subdivision::KeptRegion region = subdivision::keep_region(*object->cage_mesh, selected.elements);
    notices = std::move(region.notices);
    mesh = std::move(region.mesh);
  } else {
    mesh = subdivision::keep_outline(*object->cage_mesh, selected.elements);
  }
  cage.source = std::make_shared<const PolyMesh>(std::move(mesh));
  studio.session().edit(kept == KeptShape::Faces ? "Keep the shape of faces" : "Keep the outline of faces",
                        before.with(std::move(cage)));
  return notices;
}

}  // namespace croquis::app
