// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/attachments.h"

#include <algorithm>
#include <utility>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {

void Attachments::add(Index a, Index b, double kappa) {
  release(a, b);
  kappa_[std::minmax(a, b)] = kappa;
}

void Attachments::rest(Index a, Index b) {
  release(a, b);
  const Pair pair = std::minmax(a, b);
  resting_.insert(std::lower_bound(resting_.begin(), resting_.end(), pair), pair);
}

void Attachments::release(Index a, Index b) {
  kappa_.erase(std::minmax(a, b));
  std::erase(resting_, Pair(std::minmax(a, b)));
}

bool Attachments::resting(Index a, Index b) const {
  return std::binary_search(resting_.begin(), resting_.end(), Pair(std::minmax(a, b)));
}

std::optional<double> Attachments::kappa(Index a, Index b) const {
  const auto found = kappa_.find(std::minmax(a, b));
  return found == kappa_.end() ? std::nullopt : std::optional<double>(found->second);
}

bool Attachments::involves(Index object) const {
  return std::any_of(kappa_.begin(), kappa_.end(), [object](const auto& entry) {
    return entry.first.first == object || entry.first.second == object;
  });
}

std::vector<std::vector<Index>> Attachments::groups() const {
  Index count = 0;
  for (const auto& [pair, kappa] : kappa_) count = std::max(count, pair.second + 1);
  DisjointSets sets(count);
  for (const auto& [pair, kappa] : kappa_) sets.unite(pair.first, pair.second);
  std::vector<std::vector<Index>> by_root(count);
  for (Index object = 0; object < count; ++object) by_root[sets.root(object)].push_back(object);
  std::erase_if(by_root, [](const std::vector<Index>& group) { return group.size() < 2; });
  return by_root;
}

double attached_distance(double kappa, double a, double b) {
  constexpr double least_sinking = 0.4;
  return std::min(kappa * (a + b), a + b - least_sinking * std::min(a, b));
}

std::vector<double> object_radii(const Skeleton& skeleton) {
  std::vector<std::vector<double>> radii;
  for (const SkeletonNode& node : skeleton.nodes) {
    if (node.object >= radii.size()) radii.resize(node.object + 1);
    radii[node.object].push_back(node.radius);
  }
  std::vector<double> medians(radii.size(), 0);
  for (std::size_t object = 0; object < radii.size(); ++object) {
    if (!radii[object].empty()) medians[object] = median(std::move(radii[object]));
  }
  return medians;
}

std::vector<double> row_stiffness(const Skeleton& skeleton) {
  std::vector<double> stiffness = object_radii(skeleton);
  for (double& factor : stiffness) factor = factor > 0 ? factor / skeleton.scale : 1;
  return stiffness;
}

}  // namespace croquis::silhouette
