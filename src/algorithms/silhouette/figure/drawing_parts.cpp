// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/drawing_parts.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

using Lines = std::vector<Index>;

struct Box {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = Vec2::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  bool overlaps(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// Units solved together and what came of it.
struct Group {
  std::vector<Index> units;  ///< ascending
  Box box;                   ///< of the lines, then of the completed contours
  std::vector<LabelledFigure> figures;
  Findings findings;
  bool solved = false;
};

class PartLabeller {
 public:
  PartLabeller(const FigureContext& context, const LineFindings& faults, const Progress& progress)
      : context_(context), progress_(progress) {
    find_units();
    find_bad_units(faults);
  }

  LabelledDrawing run() {
    LabelledDrawing result;
    for (Group& group : solved_groups()) {
      std::move(group.figures.begin(), group.figures.end(), std::back_inserter(result.figures));
      std::move(group.findings.begin(), group.findings.end(), std::back_inserter(result.findings));
    }
    return result;
  }

 private:
  void find_units() {
    DisjointSets joined(context_.lines.size());
    for (const HiddenEnd& end : context_.junctions.ends) joined.unite(end.line, end.bar);
    for (const GivenPiece& given : context_.junctions.given) {
      joined.unite(context_.junctions.ends[given.from].line, context_.junctions.ends[given.to].line);
    }
    std::map<std::string, Index> first_of_object;
    for (Index line = 0; line < context_.lines.size(); ++line) {
      const std::string& object = context_.lines[line].object;
      if (!object.empty()) joined.unite(line, first_of_object.try_emplace(object, line).first->second);
    }
    units_.resize(joined.number(unit_of_));
    for (Index line = 0; line < unit_of_.size(); ++line) units_[unit_of_[line]].push_back(line);
  }

  /// A fault between two units excludes both, unless one of them is out already for a reason of its own.
  void find_bad_units(const LineFindings& faults) {
    bad_.assign(units_.size(), 0);
    const auto units_in = [this](const LineFinding& fault) {
      Lines units;
      for (const Index line : fault.lines) units.push_back(unit_of_[line]);
      std::sort(units.begin(), units.end());
      units.erase(std::unique(units.begin(), units.end()), units.end());
      return units;
    };
    for (const LineFinding& fault : faults) {
      const Lines units = units_in(fault);
      if (units.size() == 1) bad_[units.front()] = 1;
    }
    const std::vector<char> bad_by_itself = bad_;
    for (const LineFinding& fault : faults) {
      const Lines units = units_in(fault);
      if (std::any_of(units.begin(), units.end(), [&](Index unit) { return bad_by_itself[unit] != 0; })) continue;
      for (const Index unit : units) bad_[unit] = 1;
    }
  }

  Box box_of_unit(Index unit) const {
    Box box;
    for (const Index line : units_[unit]) {
      for (const Vec2& point : context_.lines[line].points) box.add(point);
    }
    return box;
  }

  /// Joins groups whose boxes overlap, keeping the order of their first units.
  static void merge_overlapping(std::vector<Group>& groups) {
    for (bool merged = true; merged;) {
      merged = false;
      for (std::size_t i = 0; i < groups.size(); ++i) {
        for (std::size_t k = i + 1; k < groups.size();) {
          if (!groups[i].box.overlaps(groups[k].box)) {
            ++k;
            continue;
          }
          merge(groups[i], groups[k]);
          groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(k));
          merged = true;
        }
      }
    }
  }

  static void merge(Group& into, const Group& from) {
    into.units.insert(into.units.end(), from.units.begin(), from.units.end());
    std::sort(into.units.begin(), into.units.end());
    into.box.add(from.box.low);
    into.box.add(from.box.high);
    into.solved = false;
    into.figures.clear();
    into.findings.clear();
  }

  std::vector<Group> solved_groups() {
    std::vector<Group> groups;
    for (Index unit = 0; unit < units_.size(); ++unit) {
      if (bad_[unit]) continue;
      Group group;
      group.units = {unit};
      group.box = box_of_unit(unit);
      groups.push_back(std::move(group));
    }
    // Completions may reach beyond the strokes and into other groups: then those are solved together. Each round has
    // fewer groups than the one before.
    merge_overlapping(groups);
    for (;;) {
      for (Group& group : groups) {
        if (!group.solved) solve(group);
      }
      const std::size_t before = groups.size();
      merge_overlapping(groups);
      if (groups.size() == before) return groups;
    }
  }

  FigureSearch search(const std::vector<Index>& units) const {
    Lines lines;
    for (const Index unit : units) lines.insert(lines.end(), units_[unit].begin(), units_[unit].end());
    std::sort(lines.begin(), lines.end());
    return search_figure(context_, lines, progress_);
  }

  void solve(Group& group) {
    group.solved = true;
    FigureSearch found = search(group.units);
    if (!found.figure && group.units.size() > 1) {
      found = solve_without_bad(group);
    } else {
      std::move(found.findings.begin(), found.findings.end(), std::back_inserter(group.findings));
    }
    if (!found.figure) return;
    for (const Vec2& point : found.figure->points) group.box.add(point);
    group.figures.push_back(std::move(*found.figure));
  }

  /// Each unit alone; then those that can be labelled together, and if that fails one after the other as far as they
  /// go together. What is left out has its reason.
  FigureSearch solve_without_bad(Group& group) {
    const auto keep = [&group](Findings& findings) {
      std::move(findings.begin(), findings.end(), std::back_inserter(group.findings));
    };
    std::vector<Index> good;
    for (const Index unit : group.units) {
      FigureSearch alone = search({unit});
      if (alone.figure) good.push_back(unit);
      keep(alone.findings);
    }
    if (good.empty()) return {};
    FigureSearch together = search(good);
    if (together.figure) return together;
    std::vector<Index> accepted{good.front()};
    FigureSearch best = search(accepted);
    for (std::size_t i = 1; i < good.size(); ++i) {
      std::vector<Index> more = accepted;
      more.push_back(good[i]);
      FigureSearch next = search(more);
      if (next.figure) {
        accepted = std::move(more);
        best = std::move(next);
      } else {
        keep(next.findings);
      }
    }
    return best;
  }

  const FigureContext& context_;
  const Progress& progress_;
  std::vector<Lines> units_;
  Lines unit_of_;
  std::vector<char> bad_;  ///< per unit
};

}  // namespace

LabelledDrawing label_parts(const FigureContext& context, const LineFindings& faults, Progress& progress) {
  return PartLabeller(context, faults, progress).run();
}

}  // namespace croquis::silhouette
