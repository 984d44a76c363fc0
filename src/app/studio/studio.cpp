// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/studio.h"

#include <QMetaObject>
#include <QThreadPool>
#include <algorithm>
#include <utility>

#include <malloc.h>

#include "croquis/base/error.h"
#include "croquis/operators/all_operations.h"
#include "croquis/operators/attach_text.h"
#include "croquis/workspace/chain.h"

#ifdef __GLIBC__
#endif

namespace croquis::app {
namespace {

std::string name_of(std::int32_t patch, const std::vector<Index>& holes) {
  if (holes.empty()) return "patch " + std::to_string(patch);
  std::string name = holes.size() == 1 ? "patch of hole " : "patch of holes ";
  for (std::size_t i = 0; i < holes.size(); ++i) name += (i == 0 ? "" : ", ") + std::to_string(holes[i]);
  return name;
}

constexpr std::int64_t shown_samples = 32;  // of curves of a network: dents of points look round

/// A tool's options, for drawings that this operation goes on from.
template <class Options>
Options options_for(const OperationDescription& operation) {
  Options options;
  options.operation = operation.id;
  options.version = operation.version;
  options.port = operation.inputs.front().name;
  return options;
}

/// What the active object begins with, where that is of such a type; else 0.
template <class Source>
NodeId beginning(const Studio& studio) {
  const WorkObject* object = studio.active();
  const NodeId first = object == nullptr ? 0 : object->chain.front();
  return source_of<Source>(studio.session().document().find(first)) ? first : 0;
}

/// How objects are held is kept for those that are still drawn.
ParameterValues without_lost_pairs(ParameterValues parameters, const Drawing& drawing) {
  const auto text = parameters.find("attach");
  if (text == parameters.end()) return parameters;
  const auto is_lost = [&](const std::string& name) {
    return std::ranges::none_of(drawing.strokes,
                                [&](const Stroke& stroke) { return stroke.id == name || stroke.object == name; });
  };
  try {
    AttachText attach = read_attach_text(std::get<std::string>(text->second));
    const auto lost = std::erase_if(
        attach.pairs, [&](const silhouette::AttachedPair& pair) { return is_lost(pair.a) || is_lost(pair.b); });
    if (lost > 0) text->second = to_text(attach);
  } catch (const Error&) {
    // What somebody typed and isn't read yet stays.
  }
  return parameters;
}

/// What the threads that compute have freed lies in pieces that the C library keeps for them: it goes to the system.
void give_memory_back() {
#ifdef __GLIBC__
  QThreadPool::globalInstance()->start([] { malloc_trim(0); });
#endif
}

LiveEvaluation::Post post_to(QObject* receiver) {
  return [receiver](std::function<void()> task) {
    QMetaObject::invokeMethod(receiver, std::move(task), Qt::QueuedConnection);
  };
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

Workspace::Listener Studio::listener_of(Studio* studio) {
  Workspace::Listener listener;
  listener.loaded = [studio] {
    studio->begun_ = true;
    studio->face_sets().clear();
    emit studio->loaded();
  };
  listener.changed = [studio] {
    studio->follow_sketch();
    emit studio->changed();
  };
  listener.result_changed = [studio] { emit studio->result_changed(); };
  listener.progress = [studio](double fraction, const std::string& step) {
    emit studio->progress_changed(fraction, QString::fromStdString(step));
  };
  listener.busy_changed = [studio](bool busy) {
    emit studio->busy_changed(busy);
    if (!busy) give_memory_back();
  };
  return listener;
}

Studio::Studio() : Workspace(all_operations(), post_to(this), listener_of(this)) {}

Studio::~Studio() = default;

const Drawing& Studio::drawing() const {
  static const Drawing none;
  const auto drawing = source_of<Drawing>(session().document().find(drawing_node()));
  return drawing ? *drawing : none;
}

NodeId Studio::sheet_node() const { return beginning<PerspectiveDrawing>(*this); }

NodeId Studio::network_node() const { return beginning<AttributeNetwork>(*this); }

NodeId Studio::drawing_node() const {
  const auto is_drawing = [&](NodeId id) { return source_of<Drawing>(session().document().find(id)) != nullptr; };
  const WorkObject* object = active();
  if (object != nullptr && is_drawing(object->chain.front())) return object->chain.front();
  if (is_drawing(sketch_)) return sketch_;
  for (const auto& node : session().document().nodes()) {
    if (is_drawing(node->id)) return node->id;
  }
  return 0;
}

NodeId Studio::solid_node() const {
  const std::vector<const Node*> made = steps_after(session().document(), registry(), drawing_node());
  return made.empty() || drawing_node() == 0 ? 0 : made.front()->id;
}

std::shared_ptr<const Evaluation> Studio::result() const { return solid_node() == 0 ? nullptr : result(solid_node()); }

std::shared_ptr<const PolyMesh> Studio::solid() const { return mesh_at(*this, solid_node()); }

SketchToolOptions Studio::tool_options() const {
  SketchToolOptions options = options_for<SketchToolOptions>(*first_operation_on(registry(), ValueType::Drawing));
  options.follow_removal = without_lost_pairs;
  return options;
}

std::string Studio::unit() const {
  for (const auto& node : session().document().nodes()) {
    const auto sheet = source_of<PerspectiveDrawing>(node.get());
    const auto network = source_of<AttributeNetwork>(node.get());
    if (sheet && !sheet->unit.empty()) return sheet->unit;
    if (network && !network->units.empty()) return network->units;
  }
  return {};
}

PerspectiveToolOptions Studio::sheet_options() const {
  return options_for<PerspectiveToolOptions>(*first_operation_on(registry(), ValueType::PerspectiveDrawing));
}

SurfaceToolOptions Studio::network_options() const {
  const SurfaceToolOptions usual;
  const OperationDescription* operation = description(usual.operation);
  return operation == nullptr ? usual : options_for<SurfaceToolOptions>(*operation);
}

Document Studio::with_network(const Document& document, AttributeNetwork network,
                              const SurfaceToolOptions& options) const {
  const Document made = add_network(document, std::move(network), options);
  Node operation = *made.nodes().back();
  operation.transform = upright_placement();
  operation.parameters["samples"] = shown_samples;
  return made.with(std::move(operation));
}

/// A sketch stays the one worked on while objects are chosen that come from none.
void Studio::follow_sketch() { sketch_ = drawing_node(); }

}  // namespace croquis::app
