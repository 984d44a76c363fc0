// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_plan.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/workspace/node_values.h"
#include "croquis/workspace/object_names.h"

namespace croquis::app {
namespace {

bool has(std::span<const Index> holes, Index hole) { return std::ranges::count(holes, hole) > 0; }

bool says_nothing(const HoleRequest& request) {
  HoleRequest empty;
  empty.holes = request.holes;
  return request == empty;
}

/// The values given in the later one, and else those of the earlier one.
void merge(HoleRequest& earlier, const HoleRequest& later) {
  if (later.fill) earlier.fill = later.fill;
  if (later.fairness) earlier.fairness = later.fairness;
  if (later.kernel) earlier.kernel = later.kernel;
  if (later.bulge) earlier.bulge = later.bulge;
  if (later.trim_rim) earlier.trim_rim = later.trim_rim;
  earlier.through.insert(earlier.through.end(), later.through.begin(), later.through.end());
}

bool same_but_holes(const HoleRequest& a, HoleRequest b) {
  b.holes = a.holes;
  return a == b;
}

/// Where the previewed operation stands in the document that is evaluated for it; comparisons stand elsewhere.
constexpr NodeId previewed_node = NodeId{1} << 61;

}  // namespace

const Node* filling_node(const Studio& studio) {
  const Node* node = active_operation(studio);
  return node == nullptr || node->operation != filling_operation ? nullptr : node;
}

bool can_fill(const Studio& studio) {
  const WorkObject* object = studio.active();
  return object != nullptr && object->shown() != nullptr && studio.description(filling_operation) != nullptr;
}

void start_filling(Studio& studio) {
  if (filling_node(studio) != nullptr) return;
  if (!can_fill(studio)) {
    throw Error(make_error(Category::Usage, "E_EMPTY", "There is no mesh whose holes could be filled: open one first"));
  }
  const WorkObject& object = *studio.active();
  if (MeshTopology(*object.shown()).boundary_loops().size() == 0) {
    throw Error(
        make_error(Category::Usage, "E_EMPTY",
                   readable_name(object.name) +
                       " has no holes: every edge has faces on both sides; to remesh it choose Modify > Add step"));
  }
  AddedNode added = with_step(studio.session().document(), studio.registry(), object.node, filling_operation,
                              {{"select", std::string("none")}});
  studio.session().edit("Find holes of " + readable_name(object.name), std::move(added.document));
  studio.set_active(added.node);
  studio.session().select({{added.node, ""}});
}

ParameterValue filling_value(const Studio& studio, const Node& node, const std::string& parameter) {
  const OperationDescription* operation = studio.description(node.operation);
  const ParameterDescription* found = operation == nullptr ? nullptr : find_parameter(operation->parameters, parameter);
  return found == nullptr ? ParameterValue(std::string()) : values_of(node, *operation).at(parameter);
}

Document with_values(const Studio& studio, const Node& node, const ParameterValues& values) {
  const Document& document = studio.session().document();
  const OperationDescription* operation = studio.description(node.operation);
  return operation == nullptr ? document : document.with(croquis::with_values(node, *operation, values));
}

std::vector<HoleRow> hole_rows(const Evaluation* result) {
  const FillResult* found = result_of<FillResult>(result);
  return found == nullptr ? std::vector<HoleRow>() : found->holes;
}

std::vector<Index> named_rows(const std::vector<HoleRow>& rows, hole_filling::Selection selection,
                              double max_diameter) {
  std::vector<hole_filling::HoleSize> sizes;
  for (const HoleRow& row : rows) sizes.push_back({row.kind, row.diameter});
  const std::vector<hole_filling::Naming> named = named_holes(sizes, selection, max_diameter);
  std::vector<Index> ids;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (named[i] == hole_filling::Naming::Named) ids.push_back(rows[i].id);
  }
  return ids;
}

std::vector<Index> with_islands(const std::vector<HoleRow>& rows, const std::vector<Index>& holes) {
  std::set<Index> all(holes.begin(), holes.end());
  for (const HoleRow& row : rows) {
    if (row.kind == hole_filling::HoleClass::Islands && has(holes, row.id))
      all.insert(row.companions.begin(), row.companions.end());
  }
  return {all.begin(), all.end()};
}

QString numbers_of(const std::set<Index>& holes) {
  constexpr std::size_t shown_at_most = 6;
  QStringList parts;
  std::size_t shown = 0;
  for (auto hole = holes.begin(); hole != holes.end() && shown < shown_at_most; ++hole, ++shown) {
    parts << QString::number(*hole);
  }
  const QString list = parts.join(", ");
  return holes.size() > shown_at_most ? QObject::tr("%1 and %2 more").arg(list).arg(holes.size() - shown_at_most)
                                      : list;
}

HolePlan::HolePlan(const Studio& studio, const Node& node) {
  ParameterValues values;
  for (const char* name : {"select", "only", "holes"}) values[name] = filling_value(studio, node, name);
  choice_ = read_fill_choice(values);
  for (const HoleRequest& request : std::exchange(choice_.requests, {})) {
    if (request.bridge) {
      bridges_.push_back(request);
      continue;
    }
    for (const Index hole : request.holes) merge(entry(hole), request);
  }
}

HoleRequest HolePlan::request(Index hole) const {
  const auto found = single_.find(hole);
  return found == single_.end() ? HoleRequest{.holes = {hole}} : found->second;
}

bool HolePlan::is_bridged(Index hole) const {
  return std::ranges::any_of(bridges_, [&](const HoleRequest& request) { return has(request.holes, hole); });
}

HoleRequest& HolePlan::entry(Index hole) {
  HoleRequest& request = single_[hole];
  request.holes = {hole};
  return request;
}

void HolePlan::keep_as_is(HoleRequest& request, std::span<const Index> filled) {
  // Any request fills the hole, unless its `fill` is false.
  if (!request.fill && !has(filled, request.holes.front())) request.fill = false;
}

void HolePlan::forget_empty() {
  std::erase_if(single_, [](const auto& entry) { return says_nothing(entry.second); });
}

void HolePlan::part_bridges(std::span<const Index> holes) {
  std::erase_if(bridges_, [&](const HoleRequest& request) {
    return std::ranges::any_of(request.holes, [&](Index hole) { return has(holes, hole); });
  });
}

void HolePlan::fill(std::span<const Index> holes) {
  for (const Index hole : holes) {
    if (!is_bridged(hole)) entry(hole).fill = true;
  }
}

void HolePlan::fill_all(hole_filling::Selection select, std::span<const Index> open) {
  choice_.select = select;
  choice_.only.clear();
  for (auto& [hole, request] : single_) request.fill.reset();
  forget_empty();
  for (auto& [hole, request] : single_) request.fill = !has(open, hole);
  part_bridges(open);
}

void HolePlan::reopen(std::span<const Index> holes) {
  part_bridges(holes);
  for (const Index hole : holes) {
    single_.erase(hole);
    if (choice_.select != hole_filling::Selection::None || !choice_.only.empty()) entry(hole).fill = false;
  }
}

void HolePlan::bridge(std::span<const Index> holes) {
  part_bridges(holes);
  HoleRequest request;
  request.holes.assign(holes.begin(), holes.end());
  request.bridge = true;
  for (const Index hole : holes) single_.erase(hole);
  bridges_.push_back(std::move(request));
}

ParameterValues HolePlan::values() const {
  FillChoice choice = choice_;
  std::vector<HoleRequest>& requests = choice.requests;
  for (const auto& [hole, request] : single_) {
    const auto same = std::ranges::find_if(
        requests, [&, &own = request](const HoleRequest& other) { return same_but_holes(own, other); });
    if (same == requests.end() || !request.through.empty())
      requests.push_back(request);
    else
      same->holes.push_back(hole);
  }
  requests.insert(requests.end(), bridges_.begin(), bridges_.end());
  return to_parameters(choice);
}

PatchPreview::PatchPreview(Studio& studio, QThreadPool& threads, QObject* parent)
    : QObject(parent), studio_(studio), item_(threads) {
  connect(&item_, &LiveItem::ready, this, &PatchPreview::changed);
}

void PatchPreview::show(NodeId node, std::vector<Index> holes) {
  if (node_ == node && holes_ == holes) return;
  node_ = node;
  holes_ = std::move(holes);
  forget();
  follow();
  emit changed();
}

void PatchPreview::follow() {
  const Document& document = studio_.session().document();
  const Node* node = holes_.empty() ? nullptr : document.find(node_);
  if (node == nullptr) {
    if (live_) live_->cancel();
    live_.reset();
    forget();
    return;
  }
  Node other = *node;
  try {
    HolePlan plan(studio_, *node);
    plan.fill(holes_);
    other.parameters = with_values(studio_, *node, plan.values()).find(node->id)->parameters;
  } catch (const Error&) {
    return;  // the operation itself reports errors in its requests
  }
  other.id = previewed_node;
  if (!live_) {
    live_ = studio_.live_beside(previewed_node, [this] { take(); });
  }
  since_.start();
  live_->follow(document.with(std::move(other)));
}

void PatchPreview::forget() {
  shown_.reset();
  patches_ = {};
  rows_.clear();
  item_.show(nullptr, {});
}

void PatchPreview::take() {
  const Node* node = studio_.session().document().find(node_);
  const OperationDescription* operation = node == nullptr ? nullptr : studio_.description(node->operation);
  if (operation == nullptr || !live_ || !live_->result() || live_->result() == shown_) return;
  shown_ = live_->result();
  const FillResult* found = shown_->result<FillResult>();
  const auto filled = mesh_of(*shown_, *operation);
  if (!filled || found == nullptr) return;
  rows_ = found->holes;
  std::set<Index> wanted;
  for (const HoleRow& row : rows_) {
    if (row.patch && std::binary_search(holes_.begin(), holes_.end(), row.id)) wanted.insert(*row.patch);
  }
  render::MeshItemOptions options;
  options.use_normal_channel = true;
  patches_ = patches_of(*filled, nullptr, &wanted);
  item_.show(colored(patches_, PatchLook::Preview), options);
  latency_ms_ = static_cast<double>(since_.nsecsElapsed()) * 1e-6;
  emit changed();
}

}  // namespace croquis::app
