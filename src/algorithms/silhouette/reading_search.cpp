// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading_search.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

// Bounds per independent part: readings, those that get as far as being labelled, changes of one reading that are
// tried.
constexpr int most_readings = 24;
constexpr int most_labellings = 6;
// A reading that is right can nearly always be labelled by its first matchings; one that is wrong tries them all.
constexpr int most_matchings = 12;
constexpr std::size_t most_changes = 12;
// Ends nearer to a fault than this share of their part's extent may have to do with it.
constexpr double near_fault = 0.05;

using Box = Eigen::AlignedBox2d;

Box box_of(const Stroke& stroke) {
  Box box;
  for (const StrokeSample& sample : stroke.samples) box.extend(sample.position);
  return box;
}

/// Strokes that have nothing to do with those of other parts: their boxes, and what ends may miss, are apart.
std::vector<std::vector<Index>> independent_parts(const Drawing& drawing, double margin) {
  std::vector<Box> boxes;
  for (const Stroke& stroke : drawing.strokes) {
    Box box = box_of(stroke);
    const Vec2 around = Vec2::Constant(margin * box.diagonal().norm());
    boxes.emplace_back(box.min() - around, box.max() + around);
  }
  DisjointSets joined(boxes.size());
  std::map<std::string, Index> first_of_object;
  for (Index i = 0; i < boxes.size(); ++i) {
    for (Index k = 0; k < i; ++k) {
      if (boxes[i].intersects(boxes[k])) joined.unite(i, k);
    }
    const std::string& object = drawing.strokes[i].object;
    if (!object.empty()) joined.unite(i, first_of_object.try_emplace(object, i).first->second);
  }
  std::vector<Index> part_of;
  std::vector<std::vector<Index>> parts(joined.number(part_of));
  for (Index i = 0; i < part_of.size(); ++i) parts[part_of[i]].push_back(i);
  return parts;
}

/// Errors of a reading by the stage that found them: a reading whose lines agree is nearer to the truth than any whose
/// lines contradict one another.
struct Faults {
  std::size_t of_lines = 0;
  std::size_t of_figures = 0;

  bool none() const { return of_lines + of_figures == 0; }
  friend auto operator<=>(const Faults&, const Faults&) = default;
};

/// What an end of a line was found to pass behind.
struct Meeting {
  EndElsewhere end;
  Vec2 at = Vec2::Zero();
  int side = 0;
};

/// A reading and what came of it.
struct Node {
  StrokeReading reading;
  std::vector<EndPair> joined;
  std::vector<EndPair> possible;
  std::vector<Meeting> meetings;
  Findings errors;
  Faults faults;
};

std::vector<Meeting> meetings_of(const ReadStrokes& read) {
  std::vector<Meeting> meetings;
  for (const HiddenEnd& end : read.junctions.ends) {
    const CleanLine& line = read.clean.lines[end.line];
    const std::vector<Index>& bar = read.clean.lines[end.bar].stroke;
    const auto at = std::min(static_cast<std::size_t>(end.bar_parameter), bar.size() - 1);
    meetings.push_back({{{line.end_stroke(end.at_start), end.at_start}, bar[at]}, end.at, end.bar_side});
  }
  return meetings;
}

class PartSearch {
 public:
  PartSearch(const Drawing& drawing, const Options& options, std::vector<char> included, const Progress& progress)
      : drawing_(drawing), options_(options), progress_(progress) {
    options_.completion.maximum_matchings = std::min(options_.completion.maximum_matchings, most_matchings);
    for (Index s = 0; s < drawing.strokes.size(); ++s) {
      index_of_[drawing.strokes[s].id] = s;
      if (included[s] != 0) box_.extend(box_of(drawing.strokes[s]));
    }
    best_.reading.included = std::move(included);
  }

  /// The best reading found; its faults are none when everything in it can be labelled.
  Node run() {
    const std::optional<Node> first = evaluate(best_.reading);
    if (!first) return best_;
    best_ = *first;
    search({*first}, [this](const Node& node) { return joined_otherwise(node); });
    // What passes behind what is doubted last: lines that agree by chance hide what was joined wrongly.
    readings_ = 0;
    labellings_ = 0;
    if (!best_.faults.none()) search({*first, best_}, [this](const Node& node) { return passing_elsewhere(node); });
    return best_;
  }

 private:
  /// Best first: changes the reading with the fewest faults until one has none.
  /// @param changed the readings that differ from a node's in one thing that may have caused its errors
  template <typename Changed>
  void search(std::vector<Node> open, Changed changed) {
    while (!open.empty() && !best_.faults.none() && readings_ < most_readings) {
      const auto next = std::min_element(open.begin(), open.end(), [](const Node& a, const Node& b) {
        return std::tuple(a.faults, a.reading.changes()) < std::tuple(b.faults, b.reading.changes());
      });
      const Node node = std::move(*next);
      open.erase(next);
      for (const StrokeReading& reading : changed(node)) {
        if (readings_ >= most_readings) break;
        std::optional<Node> found = evaluate(reading);
        if (!found) continue;
        if (found->faults < best_.faults) best_ = *found;
        if (best_.faults.none()) break;
        open.push_back(std::move(*found));
      }
    }
  }

  std::optional<Node> evaluate(const StrokeReading& reading) {
    if (!seen_.insert(signature(reading)).second) return std::nullopt;
    ++readings_;
    progress_.check();
    try {
      Progress silent = progress_.silent();
      ReadStrokes read = read_strokes(drawing_, options_, reading, silent);
      Node node{reading, read.clean.joined, read.clean.possible, meetings_of(read), {}, {}};
      for (const LineFinding& fault : read.junctions.findings) node.errors.push_back(fault.finding);
      node.faults.of_lines = node.errors.size();
      if (node.faults.of_lines > 0) return node;
      if (labellings_++ >= most_labellings) return std::nullopt;
      for (Finding& finding : label_strokes(drawing_, options_, read, silent).findings) {
        if (finding.severity == Severity::Error) node.errors.push_back(std::move(finding));
      }
      node.faults.of_figures = node.errors.size();
      return node;
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  using Signature = std::vector<std::tuple<int, Index, bool, Index, bool>>;

  static Signature signature(const StrokeReading& reading) {
    Signature all;
    for (const EndPair& pair : reading.together) {
      all.emplace_back(0, pair.a.stroke, pair.a.at_start, pair.b.stroke, pair.b.at_start);
    }
    for (const EndPair& pair : reading.apart) {
      all.emplace_back(1, pair.a.stroke, pair.a.at_start, pair.b.stroke, pair.b.at_start);
    }
    for (const Index stroke : reading.farther) all.emplace_back(2, stroke, false, 0, false);
    for (const EndElsewhere& told : reading.elsewhere) {
      all.emplace_back(3, told.end.stroke, told.end.at_start, told.bar, false);
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  /// What the errors of a reading are about.
  struct Suspects {
    std::set<Index> strokes;
    std::vector<Vec2> places;
    std::set<Index> short_of;   ///< strokes whose ends touch nothing or cross something
    std::set<Index> two_sided;  ///< strokes with ends on both sides
  };

  Suspects suspects(const Node& node) const {
    Suspects found;
    for (const Finding& error : node.errors) {
      const bool ends = error.code == "E_FREE_END" || error.code == "E_CROSS" || error.code == "E_TOUCH";
      if (error.code == "E_TWO_SIDED" && !error.subjects.empty()) {
        const auto bar = index_of_.find(error.subjects.front().id);
        if (bar != index_of_.end()) found.two_sided.insert(bar->second);
      }
      for (const Subject& subject : error.subjects) {
        if (!subject.at.empty()) found.places.emplace_back(subject.at[0], -subject.at[1]);
        const auto stroke = index_of_.find(subject.id);
        if (subject.kind != SubjectKind::Stroke || stroke == index_of_.end()) continue;
        found.strokes.insert(stroke->second);
        if (ends) found.short_of.insert(stroke->second);
      }
    }
    return found;
  }

  Vec2 place_of(const StrokeEnd& end) const {
    const std::vector<StrokeSample>& samples = drawing_.strokes[end.stroke].samples;
    return end.at_start ? samples.front().position : samples.back().position;
  }

  bool concerns(const Suspects& suspects, const StrokeEnd& end) const {
    if (suspects.strokes.contains(end.stroke)) return true;
    const double near = near_fault * box_.diagonal().norm();
    return std::any_of(suspects.places.begin(), suspects.places.end(),
                       [&](const Vec2& place) { return (place - place_of(end)).norm() < near; });
  }

  /// Other ends joined or kept apart, or reaching farther; likeliest first.
  std::vector<StrokeReading> joined_otherwise(const Node& node) const {
    const Suspects suspect = suspects(node);
    std::vector<StrokeReading> readings;
    StrokeReading farther = node.reading;
    for (const Index stroke : suspect.short_of) {
      if (std::find(farther.farther.begin(), farther.farther.end(), stroke) == farther.farther.end()) {
        farther.farther.push_back(stroke);
      }
    }
    if (farther.changes() > node.reading.changes()) readings.push_back(std::move(farther));
    const auto concerned = [&](const EndPair& pair) { return concerns(suspect, pair.a) || concerns(suspect, pair.b); };
    const auto add = [&](const EndPair& pair, std::vector<EndPair> StrokeReading::*list) {
      if (readings.size() >= most_changes || !concerned(pair)) return;
      readings.push_back(node.reading);
      (readings.back().*list).push_back(pair);
    };
    for (const bool own : {true, false}) {
      for (const EndPair& pair : node.possible) {
        if ((pair.a.stroke == pair.b.stroke) == own) add(pair, &StrokeReading::together);
      }
      if (!own) continue;
      for (const EndPair& pair : node.joined) add(pair, &StrokeReading::apart);
    }
    return readings;
  }

  /// One of the ends on a stroke that has ends on both sides passes behind something else, those on its less frequent
  /// side first.
  std::vector<StrokeReading> passing_elsewhere(const Node& node) const {
    std::vector<StrokeReading> readings;
    for (const Index bar : suspects(node).two_sided) {
      std::vector<const Meeting*> stems;
      int sum = 0;
      for (const Meeting& meeting : node.meetings) {
        if (meeting.end.bar != bar) continue;
        stems.push_back(&meeting);
        sum += meeting.side;
      }
      std::stable_sort(stems.begin(), stems.end(),
                       [sum](const Meeting* a, const Meeting* b) { return a->side * sum < b->side * sum; });
      for (const Meeting* stem : stems) {
        if (readings.size() >= most_changes) return readings;
        readings.push_back(node.reading);
        readings.back().elsewhere.push_back(stem->end);
      }
    }
    return readings;
  }

  const Drawing& drawing_;
  Options options_;
  const Progress& progress_;
  std::map<std::string, Index> index_of_;
  Box box_;
  std::set<Signature> seen_;
  Node best_;
  int readings_ = 0;
  int labellings_ = 0;
};

/// The strokes that errors are about.
std::set<Index> faulty_strokes(const Drawing& drawing, const Findings& findings) {
  std::map<std::string, Index> index_of;
  for (Index s = 0; s < drawing.strokes.size(); ++s) index_of[drawing.strokes[s].id] = s;
  std::set<Index> strokes;
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::Error) continue;
    for (const Subject& subject : finding.subjects) {
      const auto stroke = index_of.find(subject.id);
      if (subject.kind == SubjectKind::Stroke && stroke != index_of.end()) strokes.insert(stroke->second);
    }
  }
  return strokes;
}

/// Read as a steady hand would have drawn it; none when that has errors too.
std::optional<LabelledDrawing> read_as_steady(const Drawing& drawing, const Options& options,
                                              const Progress& progress) {
  StrokeReading reading;
  reading.steady = true;
  Progress silent = progress.silent();
  try {
    LabelledDrawing found = label_strokes(drawing, options, read_strokes(drawing, options, reading, silent), silent);
    if (!has_errors(found.findings)) return found;
  } catch (const Error&) {
  }
  return std::nullopt;
}

}  // namespace

LabelledDrawing read_again(const Drawing& drawing, const Options& options, LabelledDrawing first, double tremble,
                           const Progress& progress) {
  if (tremble > 0) {
    if (std::optional<LabelledDrawing> steady = read_as_steady(drawing, options, progress)) return *std::move(steady);
  }
  const std::set<Index> faulty = faulty_strokes(drawing, first.findings);
  const double margin = std::max(options.strokes.close_share, options.strokes.reach_share);
  StrokeReading reading;
  for (const std::vector<Index>& part : independent_parts(drawing, margin)) {
    if (std::none_of(part.begin(), part.end(), [&](Index stroke) { return faulty.contains(stroke); })) continue;
    std::vector<char> included(drawing.strokes.size(), 0);
    for (const Index stroke : part) included[stroke] = 1;
    const Node best = PartSearch(drawing, options, std::move(included), progress).run();
    const auto append = [](const auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
    append(best.reading.together, reading.together);
    append(best.reading.apart, reading.apart);
    append(best.reading.farther, reading.farther);
    append(best.reading.elsewhere, reading.elsewhere);
  }
  if (reading.changes() == 0) return first;
  Progress silent = progress.silent();
  return label_strokes(drawing, options, read_strokes(drawing, options, reading, silent), silent);
}

}  // namespace croquis::silhouette
