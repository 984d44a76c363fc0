// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/patch_preview.h"

#include <QMetaObject>
#include <algorithm>
#include <set>
#include <utility>

#include "app/tools/holes/filling.h"
#include "app/tools/holes/hole_plan.h"
#include "app/tools/holes/hole_rows.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

/// Where the previewed operation stands in the document that is evaluated for it; comparisons stand elsewhere.
constexpr NodeId previewed_node = NodeId{1} << 61;

}  // namespace

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
    return;  // the operation itself reports errors in its wishes
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
