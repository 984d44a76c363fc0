// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/joining/part_joining.h"

#include <algorithm>
#include <map>
#include <optional>

namespace croquis::silhouette {
namespace {

/// Largest first; equals in the order given.
std::vector<UnionPart> by_size(std::span<const UnionPart> parts) {
  std::vector<std::pair<double, UnionPart>> sized;
  for (const UnionPart& part : parts) sized.emplace_back(-projected_area(*part.mesh), part);
  std::stable_sort(sized.begin(), sized.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<UnionPart> result;
  for (const auto& [area, part] : sized) result.push_back(part);
  return result;
}

class PartJoiner {
 public:
  PartJoiner(std::span<const UnionPart> parts, std::span<const ObjectPair> pairs, double sliver)
      : waiting_(by_size(parts)), pairs_(pairs.begin(), pairs.end()), sliver_(sliver) {}

  PartJoining join_all(Progress& progress) {
    PartJoining result;
    while (!waiting_.empty()) {
      if (std::optional<JoinedParts> group = grow(progress)) result.groups.push_back(std::move(*group));
    }
    for (const auto& [pair, fault] : faults_) result.failed.push_back({pair, fault});
    return result;
  }

 private:
  /// Everything that can be joined to the largest part that waits.
  std::optional<JoinedParts> grow(Progress& progress) {
    members_.assign(1, waiting_.front());
    waiting_.erase(waiting_.begin());
    GrowingUnion whole(members_.front(), sliver_);
    for (;;) {
      const auto next = std::find_if(waiting_.begin(), waiting_.end(),
                                     [this](const UnionPart& part) { return !open_pairs(part).empty(); });
      if (next == waiting_.end()) break;
      progress.check();
      const Meeting meeting = whole.add(*next);
      if (meeting == Meeting::Joined) {
        members_.push_back(*next);
        waiting_.erase(next);
      } else {
        blame(*next, meeting);
      }
    }
    return finish(whole);
  }

  /// Attachments of the part to members of the group that haven't failed yet.
  std::vector<ObjectPair> open_pairs(const UnionPart& part) const {
    std::vector<ObjectPair> open;
    for (const UnionPart& member : members_) {
      const ObjectPair pair = std::minmax(part.object, member.object);
      const bool attached = std::find(pairs_.begin(), pairs_.end(), pair) != pairs_.end();
      if (attached && !faults_.contains(pair)) open.push_back(pair);
    }
    return open;
  }

  /// Finds out which of the part's pairs can't be joined: those that fail by themselves, or else all.
  void blame(const UnionPart& part, Meeting meeting) {
    const std::vector<ObjectPair> open = open_pairs(part);
    const JoinFault fault = meeting == Meeting::Apart ? JoinFault::DontMeet : JoinFault::Unsound;
    bool found = false;
    for (const ObjectPair& pair : open) {
      if (fault == JoinFault::DontMeet || open.size() == 1 || joins_alone(part, pair)) continue;
      faults_[pair] = fault;
      found = true;
    }
    for (const ObjectPair& pair : open) {
      if (!found) faults_[pair] = fault;
    }
  }

  bool joins_alone(const UnionPart& part, const ObjectPair& pair) const {
    const Index other = pair.first == part.object ? pair.second : pair.first;
    const auto member = std::find_if(members_.begin(), members_.end(),
                                     [other](const UnionPart& candidate) { return candidate.object == other; });
    return GrowingUnion(*member, sliver_).add(part) == Meeting::Joined;
  }

  /// None for a part that nothing was joined to, and for a surface whose seams can't be cleaned: then its last part's
  /// pairs fail.
  std::optional<JoinedParts> finish(GrowingUnion& whole) {
    if (members_.size() == 1) return std::nullopt;
    std::optional<SurfaceUnion> surface = whole.take();
    if (!surface) {
      const UnionPart last = members_.back();
      members_.pop_back();
      for (const ObjectPair& pair : open_pairs(last)) faults_[pair] = JoinFault::Unsound;
      return std::nullopt;
    }
    JoinedParts joined{std::move(*surface), {}};
    for (const UnionPart& member : members_) joined.objects.push_back(member.object);
    return joined;
  }

  std::vector<UnionPart> waiting_;  ///< largest first
  std::vector<UnionPart> members_;  ///< of the group that grows
  std::vector<ObjectPair> pairs_;
  double sliver_;
  std::map<ObjectPair, JoinFault> faults_;
};

}  // namespace

PartJoining join_parts(std::span<const UnionPart> parts, std::span<const ObjectPair> pairs, double sliver,
                       Progress& progress) {
  return PartJoiner(parts, pairs, sliver).join_all(progress);
}

}  // namespace croquis::silhouette
