// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/silhouette/drawing_readings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/drawing_reading.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

// A bound of what is labelled for all readings of a drawing, and of what readings may cost more than the first one.
constexpr std::size_t most_labelled = 150;
constexpr double most_cost = 16;
// What is supposed against what shapes or the order of drawing say, see reading_costs.h.
constexpr double cost_of_nesting = 1.5;
constexpr double cost_of_order = 1;
constexpr double cost_of_hidden_order = 0.5;

/// What people see of a stroke: it bounds a part or a hole, is a limb of one line, or bounds nothing.
StrokeKind seen_kind(StrokeKind kind) {
  switch (kind) {
    case StrokeKind::Part:
    case StrokeKind::Blob: return StrokeKind::Contour;
    case StrokeKind::Scribble:
    case StrokeKind::Ignored: return StrokeKind::Detail;
    default: return kind;
  }
}

/// What a reading says. Objects are called by their first strokes.
struct Decisions {
  std::vector<StrokeKind> kinds;                          ///< per stroke: seen_kind
  std::set<EndPair> joined;                               ///< behind something
  std::set<std::pair<Index, Index>> order;                ///< objects: the first one lies in front
  std::set<std::tuple<Index, Index, Index, bool>> tubes;  ///< a tube, another one, which crossing, it is over
  std::map<Index, int> euler;                             ///< per object

  bool operator==(const Decisions&) const = default;
};

Decisions decisions_of(const LabelledDrawing& labelled) {
  Decisions all;
  for (const StrokeKind kind : labelled.kinds) all.kinds.push_back(seen_kind(kind));
  for (const LabelledFigure& figure : labelled.figures) {
    const auto name = [&](Index object) { return figure.objects[object].strokes.front(); };
    for (const FigureCompletion& completion : figure.completions) all.joined.insert(completion.ends);
    for (const FigureOverlap& overlap : figure.overlaps) {
      if (overlap.upper != overlap.lower) all.order.emplace(name(overlap.upper), name(overlap.lower));
    }
    for (Index k = 0; k < figure.objects.size(); ++k) all.euler[name(k)] = figure.objects[k].euler_region;
  }
  for (const TubeCrossing& crossing : labelled.tube_crossings) {
    all.tubes.emplace(crossing.stroke, crossing.other, crossing.word, crossing.over);
  }
  return all;
}

std::string kind_in_words(StrokeKind kind) {
  switch (kind) {
    case StrokeKind::Hole: return "is a hole";
    case StrokeKind::Part:
    case StrokeKind::Blob: return "is a part in front";
    case StrokeKind::Tube: return "is a limb of one line";
    case StrokeKind::Detail:
    case StrokeKind::Scribble: return "is a line on the surface";
    case StrokeKind::Ignored: return "is left out";
    default: return "is an outline";
  }
}

/// @param labelled what `own` are the decisions of
std::vector<std::string> differences(const Drawing& drawing, const Decisions& first, const Decisions& own,
                                     const LabelledDrawing& labelled) {
  std::vector<std::string> all;
  const auto name = [&](Index stroke) { return in_quotes(drawing, stroke); };
  const auto name_of_end = [&](const StrokeEnd& end) {
    return std::string("the ") + (end.at_start ? "start" : "end") + " of " + name(end.stroke);
  };
  for (Index s = 0; s < own.kinds.size(); ++s) {
    if (own.kinds[s] != first.kinds[s]) all.push_back(name(s) + " " + kind_in_words(labelled.kinds[s]));
  }
  for (const auto& [upper, lower] : own.order) {
    if (first.order.contains({lower, upper}) && !first.order.contains({upper, lower}))
      all.push_back(name(lower) + " goes behind " + name(upper));
  }
  for (const auto& [stroke, other, word, over] : own.tubes) {
    if (first.tubes.contains({stroke, other, word, !over}))
      all.push_back(over ? name(stroke) + " passes over " + name(other) : name(other) + " passes over " + name(stroke));
  }
  for (const EndPair& pair : own.joined) {
    if (!first.joined.contains(pair)) all.push_back(name_of_end(pair[0]) + " is joined to " + name_of_end(pair[1]));
  }
  for (const auto& [object, euler] : own.euler) {
    const auto known = first.euler.find(object);
    if (all.empty() && (known == first.euler.end() || known->second != euler))
      all.push_back("the surface of " + name(object) + " goes on in another way");
  }
  if (all.empty()) all.emplace_back("parts lie over one another in another way");
  return all;
}

/// A drawing that says something else than a reading of it does.
struct ReadingChange {
  Drawing drawing;
  double cost = 0;  ///< of what its labelled figure doesn't know
};

void take_from_list(Stroke& stroke, const char* key, const std::string& word) {
  std::string left;
  for (const std::string_view part : data_list(stroke, key)) {
    if (part != word) left.append(left.empty() ? "" : ", ").append(part);
  }
  if (left.empty()) {
    stroke.data.erase(key);
  } else {
    stroke.data[key] = left;
  }
}

/// Sets a stroke to lie behind another one.
void set_behind(Drawing& drawing, Index stroke, Index other) {
  take_from_list(drawing.strokes[other], behind_key, drawing.strokes[stroke].id);
  std::string& list = drawing.strokes[stroke].data[behind_key];
  list += (list.empty() ? "" : ", ") + drawing.strokes[other].id;
}

/// All readings next to one.
class ReadingChanges {
 public:
  ReadingChanges(const Drawing& drawing, const LabelledDrawing& labelled) : drawing_(drawing), labelled_(labelled) {
    for (const LabelledFigure& figure : labelled.figures) {
      change_nesting(figure);
      change_hidden_order(figure);
    }
    change_order();
    for (const LabelledFigure& figure : labelled.figures) part_ends(figure);
    for (Index s = 0; s < drawing.strokes.size(); ++s) change_kind(s);
  }

  std::vector<ReadingChange> take() { return std::move(all_); }

 private:
  Drawing& add(double cost) { return all_.emplace_back(ReadingChange{drawing_, cost}).drawing; }

  void set_kind(Index stroke, StrokeKind kind, double cost) {
    add(cost).strokes[stroke].data[kind_key] = to_string(kind);
  }

  bool has_kind(Index stroke) const { return stroke_kind(drawing_.strokes[stroke]) != StrokeKind::Visible; }

  void change_nesting(const LabelledFigure& figure) {
    for (const NestedOutline& nested : figure.nested) {
      if (nested.chosen || has_kind(nested.stroke)) continue;
      set_kind(nested.stroke, nested.hole ? StrokeKind::Part : StrokeKind::Hole, cost_of_nesting);
    }
  }

  /// Of parts that lie over one another behind others: nothing that is drawn shows which is in front.
  void change_hidden_order(const LabelledFigure& figure) {
    for (const FigureOverlap& overlap : figure.overlaps) {
      const auto is_seen = [&](Index k) { return figure.crossings[k].seen; };
      if (overlap.upper == overlap.lower || overlap.crossings.empty()) continue;
      if (std::ranges::any_of(overlap.crossings, is_seen)) continue;
      const FigureCrossing& crossing = figure.crossings[overlap.crossings.front()];
      const Index over = figure.contours[crossing.over_contour].strokes.front();
      const Index under = figure.contours[crossing.under_contour].strokes.front();
      set_behind(add(cost_of_hidden_order), over, under);
    }
  }

  void change_order() {
    for (const CrossingInView& pair : labelled_.crossings) {
      if (pair.whole && !pair.chosen) set_behind(add(cost_of_order), pair.front, pair.behind);
    }
    Index number = 0;
    for (const LabelledFigure& figure : labelled_.figures) {
      for (const FigureOverlap& overlap : figure.overlaps) {
        const Index own = number++;
        if (overlap.tube_crossing == no_index) continue;
        const TubeCrossing& crossing = labelled_.tube_crossings[overlap.tube_crossing];
        const std::vector<std::string_view> words = over_words(drawing_.strokes[crossing.stroke]);
        if (crossing.word < words.size() && words[crossing.word] != auto_word) continue;
        add(cost_of_order) = swap_overlaps(drawing_, labelled_, {own});
      }
    }
  }

  void part_ends(const LabelledFigure& figure) {
    const std::vector<PinnedEnds> pins = pinned_ends(drawing_);
    for (const FigureCompletion& completion : figure.completions) {
      const PinnedEnds own{completion.ends, true};
      const bool drawn = std::ranges::any_of(
          completion.ends, [&](const StrokeEnd& end) { return labelled_.kinds[end.stroke] == StrokeKind::Hidden; });
      if (!drawn && std::ranges::count(pins, own) == 0) pin_ends(add(0), {completion.ends, false});
    }
  }

  void change_kind(Index s) {
    const Stroke& stroke = drawing_.strokes[s];
    if (has_kind(s)) return;
    switch (labelled_.kinds[s]) {
      case StrokeKind::Contour:
      case StrokeKind::Part:
      case StrokeKind::Blob:
      case StrokeKind::Hole: return set_kind(s, StrokeKind::Detail, 0);
      case StrokeKind::Tube: set_kind(s, StrokeKind::Detail, 0); return set_kind(s, StrokeKind::Contour, 0);
      case StrokeKind::Detail:
      case StrokeKind::Scribble:
      case StrokeKind::Ignored:
        set_kind(s, StrokeKind::Contour, 0);
        if (!stroke.closed) set_kind(s, StrokeKind::Tube, 0);
        return;
      default: return;
    }
  }

  const Drawing& drawing_;
  const LabelledDrawing& labelled_;
  std::vector<ReadingChange> all_;
};

/// Says which ends are joined instead of which aren't: that stays what was chosen when others could be joined, too.
Drawing with_joined_ends(const Drawing& drawing, const Decisions& parent, const Decisions& own) {
  Drawing said = drawing;
  std::set<EndPair> parted;
  for (const auto& [ends, joined] : pinned_ends(drawing)) {
    if (!joined && parent.joined.contains(ends)) parted.insert(ends);
  }
  if (parted.empty()) return drawing;
  for (const EndPair& ends : parted) {
    for (std::size_t k = 0; k < 2; ++k) {
      Stroke& stroke = said.strokes[ends[k].stroke];
      const StrokeEnd& other = ends[1 - k];
      const auto word = [](const StrokeEnd& end) { return std::string(end.at_start ? start_word : end_word); };
      take_from_list(stroke, apart_key, word(ends[k]) + " " + said.strokes[other.stroke].id + " " + word(other));
    }
  }
  for (const EndPair& ends : own.joined) {
    if (!parent.joined.contains(ends)) pin_ends(said, {ends, true});
  }
  return said;
}

std::size_t error_count(const Findings& findings) {
  return static_cast<std::size_t>(std::ranges::count(findings, Severity::Error, &Finding::severity));
}

}  // namespace

Drawing swap_overlaps(Drawing drawing, const LabelledDrawing& labelled, const std::vector<Index>& overlaps) {
  std::vector<Index> crossings;  // per overlap
  for (const LabelledFigure& figure : labelled.figures) {
    for (const FigureOverlap& overlap : figure.overlaps) crossings.push_back(overlap.tube_crossing);
  }
  for (const Index overlap : overlaps) {
    const bool known = overlap < crossings.size();
    if (!known || crossings[overlap] == no_index) {
      const std::string why =
          known ? " isn't of two strands of tubes: say by data-behind what lies behind"
                : " doesn't exist: the drawing has " + counted(crossings.size(), "overlap", "overlaps");
      const std::string sentence = "The overlap " + std::to_string(overlap) + why + ", counted from 0";
      throw Error(make_error(Category::Usage, "E_SWAP", sentence, {{SubjectKind::Parameter, "swap", {}, {}, {}}}));
    }
    const TubeCrossing& crossing = labelled.tube_crossings[crossings[overlap]];
    Stroke& stroke = drawing.strokes[crossing.stroke];
    std::vector<std::string_view> words = over_words(stroke);
    words.resize(std::max<std::size_t>(words.size(), crossing.word + 1), auto_word);
    const bool is_over = words[crossing.word] == auto_word ? crossing.over : words[crossing.word] == over_word;
    words[crossing.word] = is_over ? under_word : over_word;
    std::string list;
    for (const std::string_view word : words) list.append(list.empty() ? "" : ",").append(word);
    stroke.data[over_key] = std::move(list);
  }
  return drawing;
}

/// Best first: what was given last is changed in all ways before the cheapest of all that are known is given.
class DrawingReadings::Search {
 public:
  Search(Drawing drawing, Options options) : options_(std::move(options)) {
    options_.swaps.clear();
    options_.cache = nullptr;
    given_.drawing = std::move(drawing);
  }

  std::optional<DrawingReading> next(Progress& progress) {
    if (labelled_.kinds.empty()) {
      Progress all = progress.silent();
      labelled_ = label(given_.drawing, options_, all);
      given_.decisions = decisions_of(labelled_);
      first_ = given_.decisions;
      first_cost_ = labelled_.cost;
      first_errors_ = error_count(labelled_.findings);
      known_.push_back(first_);
      return DrawingReading{given_.drawing, 0, {}};
    }
    expand(progress);
    while (!open_.empty()) {
      const auto cheapest = std::ranges::min_element(open_, {}, rank);
      Candidate candidate = std::move(*cheapest);
      open_.erase(cheapest);
      given_ = std::move(candidate);
      if (!settle(progress)) continue;
      std::vector<std::string> differs = differences(given_.drawing, first_, given_.decisions, labelled_);
      while (!said_.insert(differs).second) differs.emplace_back("parts lie over one another in another way");
      return DrawingReading{given_.drawing, given_.cost, std::move(differs)};
    }
    return std::nullopt;
  }

 private:
  struct Candidate {
    Drawing drawing;
    Decisions decisions;
    Decisions parent;
    double cost = 0;      ///< more than the first one's
    double supposed = 0;  ///< part of it that labelled drawings don't know
    std::size_t number = 0;
  };

  /// Costs that differ by rounding alone are the same: then what was found first comes first.
  static std::pair<long long, std::size_t> rank(const Candidate& candidate) {
    return {std::llround(1e3 * candidate.cost), candidate.number};
  }

  /// None when the drawing can't be read like that.
  std::optional<LabelledDrawing> try_label(const Drawing& drawing, bool cheapest, const Progress& progress) const {
    progress.check();
    try {
      Progress all = progress.silent();
      LabelledDrawing labelled = cheapest ? label_cheapest(drawing, options_, all) : label(drawing, options_, all);
      if (error_count(labelled.findings) <= first_errors_) return labelled;
    } catch (const Error&) {  // then that is no reading
    }
    return std::nullopt;
  }

  /// Tries all changes of what was given.
  void expand(Progress& progress) {
    std::vector<ReadingChange> changes = ReadingChanges(given_.drawing, labelled_).take();
    std::size_t done = 0;
    for (ReadingChange& change : changes) {
      progress.report(done++, changes.size());
      if (tried_ >= most_labelled) return;
      ++tried_;
      const std::optional<LabelledDrawing> labelled = try_label(change.drawing, true, progress);
      if (!labelled) continue;
      Decisions decisions = decisions_of(*labelled);
      if (std::ranges::count(known_, decisions) > 0) continue;
      const double supposed = given_.supposed + change.cost;
      const double cost = std::max(given_.cost, labelled->cost + supposed - first_cost_);
      if (cost > most_cost) continue;
      known_.push_back(decisions);
      open_.push_back({std::move(change.drawing), std::move(decisions), given_.decisions, cost, supposed, tried_});
    }
  }

  /// Labels what is to be given, with pins that stay.
  bool settle(const Progress& progress) {
    const Drawing said = with_joined_ends(given_.drawing, given_.parent, given_.decisions);
    for (const Drawing& drawing : {said, given_.drawing}) {
      std::optional<LabelledDrawing> labelled = try_label(drawing, false, progress);
      if (!labelled || decisions_of(*labelled) != given_.decisions) continue;
      labelled_ = *std::move(labelled);
      given_.drawing = drawing;
      return true;
    }
    return false;
  }

  Options options_;
  Candidate given_;           ///< last
  LabelledDrawing labelled_;  ///< what was given last
  Decisions first_;
  double first_cost_ = 0;
  std::size_t first_errors_ = 0;
  std::size_t tried_ = 0;
  std::vector<Decisions> known_;
  std::vector<Candidate> open_;
  std::set<std::vector<std::string>> said_;  ///< what differs, of all given
};

DrawingReadings::DrawingReadings(Drawing drawing, Options options)
    : search_(std::make_unique<Search>(std::move(drawing), std::move(options))) {}

DrawingReadings::~DrawingReadings() = default;

DrawingReadings::DrawingReadings(DrawingReadings&&) noexcept = default;

std::optional<DrawingReading> DrawingReadings::next(Progress& progress) { return search_->next(progress); }

}  // namespace croquis::silhouette
