// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/overlap_cycles.h"

#include <algorithm>
#include <utility>

namespace croquis::silhouette {
namespace {

class CycleSearch {
 public:
  explicit CycleSearch(const std::vector<std::vector<Index>>& below)
      : below_(below), number_(below.size(), no_index), lowest_(below.size(), no_index) {
    cycles_.cycle.assign(below.size(), no_index);
  }

  OverlapCycles run() {
    for (Index object = 0; object < below_.size(); ++object) {
      if (number_[object] == no_index) visit(object);
    }
    return std::move(cycles_);
  }

 private:
  struct Visit {
    Index object = 0;
    std::size_t next = 0;  ///< of what lies below it
  };

  void visit(Index first) {
    std::vector<Visit> path{enter(first)};
    while (!path.empty()) {
      Visit& here = path.back();
      if (here.next < below_[here.object].size()) {
        const Index lower = below_[here.object][here.next++];
        if (number_[lower] == no_index) {
          path.push_back(enter(lower));
        } else if (cycles_.cycle[lower] == no_index) {
          lowest_[here.object] = std::min(lowest_[here.object], number_[lower]);
        }
        continue;
      }
      const Index done = here.object;
      path.pop_back();
      if (!path.empty()) lowest_[path.back().object] = std::min(lowest_[path.back().object], lowest_[done]);
      if (lowest_[done] == number_[done]) close_cycle(done);
    }
  }

  Visit enter(Index object) {
    number_[object] = lowest_[object] = entered_++;
    open_.push_back(object);
    return {object, 0};
  }

  /// All that lies below a cycle has been closed before.
  void close_cycle(Index first) {
    Index member = no_index;
    do {
      member = open_.back();
      open_.pop_back();
      cycles_.cycle[member] = cycles_.count;
    } while (member != first);
    ++cycles_.count;
  }

  const std::vector<std::vector<Index>>& below_;
  std::vector<Index> number_;
  std::vector<Index> lowest_;
  std::vector<Index> open_;  ///< entered, in no cycle yet
  OverlapCycles cycles_;
  Index entered_ = 0;
};

}  // namespace

OverlapCycles overlap_cycles(const std::vector<std::vector<Index>>& below) { return CycleSearch(below).run(); }

}  // namespace croquis::silhouette
