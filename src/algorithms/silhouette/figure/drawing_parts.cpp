// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/drawing_parts.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

using Lines = std::vector<Index>;

/// Units that are solved together and what came of it.
struct Group {
  std::vector<Index> units;             ///< ascending
  Eigen::AlignedBox2d box;              ///< of the lines, then of the completed contours
  std::optional<FigureSearch> outcome;  ///< with the findings of what was left out
};

/// Per line its unit: lines that stop at one another, that something known joins, or of one object.
std::vector<Index> units_of_lines(const FigureContext& context) {
  DisjointSets joined(context.lines.size());
  for (const HiddenEnd& end : context.junctions.ends) joined.unite(end.line, end.bar);
  for (const GivenPiece& given : context.junctions.given) {
    joined.unite(context.junctions.ends[given.from].line, context.junctions.ends[given.to].line);
  }
  std::map<std::string, Index> first_of_object;
  for (Index line = 0; line < context.lines.size(); ++line) {
    const std::string& object = context.lines[line].object;
    if (!object.empty()) joined.unite(line, first_of_object.try_emplace(object, line).first->second);
  }
  std::vector<Index> unit_of;
  joined.number(unit_of);
  return unit_of;
}

/// A fault between two units excludes both, unless one of them is out already for a reason of its own.
std::set<Index> bad_units(const std::vector<Index>& unit_of, const LineFindings& faults) {
  std::vector<std::set<Index>> faulty;
  for (const LineFinding& fault : faults) {
    std::set<Index>& units = faulty.emplace_back();
    for (const Index line : fault.lines) units.insert(unit_of[line]);
  }
  std::set<Index> bad_by_itself;
  for (const std::set<Index>& units : faulty) {
    if (units.size() == 1) bad_by_itself.insert(units.begin(), units.end());
  }
  std::set<Index> bad = bad_by_itself;
  for (const std::set<Index>& units : faulty) {
    const auto is_out = [&](Index unit) { return bad_by_itself.contains(unit); };
    if (std::ranges::none_of(units, is_out)) bad.insert(units.begin(), units.end());
  }
  return bad;
}

/// Joins groups whose boxes overlap, keeping the order of their first units.
void merge_overlapping(std::vector<Group>& groups) {
  for (auto group = groups.begin(); group != groups.end();) {
    const auto overlaps = [&](const Group& other) { return other.box.intersects(group->box); };
    const auto into = std::find_if(groups.begin(), group, overlaps);
    if (into == group) {
      ++group;
      continue;
    }
    into->units.insert(into->units.end(), group->units.begin(), group->units.end());
    std::ranges::sort(into->units);
    into->box.extend(group->box);
    into->outcome.reset();
    groups.erase(group);
    group = groups.begin();  // others may overlap the larger box
  }
}

FigureSearch search_units(const FigureContext& context, const std::vector<Lines>& lines_of,
                          const std::vector<Index>& units, const Progress& progress) {
  Lines lines;
  for (const Index unit : units) lines.insert(lines.end(), lines_of[unit].begin(), lines_of[unit].end());
  std::ranges::sort(lines);
  return search_figure(context, lines, progress);
}

/// All units together; if that fails, those that can be labelled alone, one after the other as far as they go together.
/// What is left out has its reason.
/// @param lines_of per unit
FigureSearch search_without_bad(const FigureContext& context, const std::vector<Lines>& lines_of,
                                const std::vector<Index>& units, const Progress& progress) {
  FigureSearch all = search_units(context, lines_of, units, progress);
  if (all.figure || units.size() == 1) return all;
  FigureSearch result;
  std::vector<Index> accepted;
  for (const Index unit : units) {
    FigureSearch found = search_units(context, lines_of, {unit}, progress);
    std::vector<Index> more = accepted;
    more.push_back(unit);
    if (found.figure && more.size() > 1) found = search_units(context, lines_of, more, progress);
    std::ranges::move(found.findings, std::back_inserter(result.findings));
    if (!found.figure) continue;
    accepted = std::move(more);
    result.figure = std::move(found.figure);
  }
  return result;
}

}  // namespace

LabelledDrawing label_parts(const FigureContext& context, const LineFindings& faults, const Progress& progress) {
  const std::vector<Index> unit_of = units_of_lines(context);
  const std::set<Index> bad = bad_units(unit_of, faults);
  std::map<Index, Group> by_unit;
  std::vector<Lines> lines_of(context.lines.size());
  for (Index line = 0; line < unit_of.size(); ++line) {
    lines_of[unit_of[line]].push_back(line);
    if (bad.contains(unit_of[line])) continue;
    Group& group = by_unit[unit_of[line]];
    group.units = {unit_of[line]};
    for (const Vec2& point : context.lines[line].points) group.box.extend(point);
  }
  std::vector<Group> groups;
  for (auto& [unit, group] : by_unit) groups.push_back(std::move(group));
  // Completions may reach beyond the strokes and into other groups: then those are solved together. Each round has
  // fewer groups than the one before.
  merge_overlapping(groups);
  for (std::size_t before = 0; before != groups.size(); merge_overlapping(groups)) {
    before = groups.size();
    for (Group& group : groups) {
      if (group.outcome) continue;
      group.outcome = search_without_bad(context, lines_of, group.units, progress);
      if (!group.outcome->figure) continue;
      for (const Vec2& point : group.outcome->figure->points) group.box.extend(point);
    }
  }
  LabelledDrawing result;
  for (Group& group : groups) {
    if (group.outcome->figure) result.figures.push_back(std::move(*group.outcome->figure));
    std::ranges::move(group.outcome->findings, std::back_inserter(result.findings));
  }
  return result;
}

}  // namespace croquis::silhouette
