// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "algorithms/silhouette/drawing_reading.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

std::optional<bool> is_start(std::string_view word) {
  if (word == start_word) return true;
  return word == end_word ? std::optional(false) : std::nullopt;
}

Finding wrong_pin(const Drawing& drawing, std::string why, std::vector<Index> strokes) {
  std::vector<Subject> subjects;
  for (const Index stroke : strokes) subjects.push_back(stroke_subject(drawing, stroke));
  return make_error(Category::Geometry, "E_PIN", std::move(why), std::move(subjects));
}

std::string end_in_words(const Drawing& drawing, const StrokeEnd& end) {
  return std::string("the ") + (end.at_start ? "start" : "end") + " of " + in_quotes(drawing, end.stroke);
}

/// One entry such as "end s3 start"; none of a stroke that doesn't exist.
/// @throws Error (E_PIN)
std::optional<EndPair> read_pair(const Drawing& drawing, const std::map<std::string_view, Index>& strokes, Index own,
                                 std::string_view entry) {
  const std::size_t first = entry.find(' '), last = entry.rfind(' ');
  const bool has_words = first != std::string_view::npos && last > first;
  const auto start = has_words ? is_start(entry.substr(0, first)) : std::nullopt;
  const auto other_start = has_words ? is_start(entry.substr(last + 1)) : std::nullopt;
  if (!start || !other_start) {
    throw Error(wrong_pin(drawing,
                          "What " + in_quotes(drawing, own) + " is joined to or apart from, \"" + std::string(entry) +
                              "\", names no two ends: write it as \"end OTHER start\"",
                          {own}));
  }
  const auto other = strokes.find(entry.substr(first + 1, last - first - 1));
  if (other == strokes.end()) return std::nullopt;
  EndPair pair{StrokeEnd{own, *start}, StrokeEnd{other->second, *other_start}};
  std::ranges::sort(pair);
  return pair;
}

/// Strokes that are no contours have no ends to join.
bool is_no_contour(const Stroke& stroke) {
  const StrokeKind kind = stroke_kind(stroke).value_or(StrokeKind::Visible);
  return stroke.closed || kind == StrokeKind::Hidden || kind == StrokeKind::Detail || kind == StrokeKind::Scribble ||
         kind == StrokeKind::Tube || kind == StrokeKind::Ignored;
}

/// @throws Error (E_PIN) where pins contradict one another or a stroke's kind
void check_pins(const Drawing& drawing, const std::vector<PinnedEnds>& pins) {
  std::map<StrokeEnd, StrokeEnd> partner;
  for (const auto& [ends, joined] : pins) {
    const auto& [a, b] = ends;
    const std::string pair = end_in_words(drawing, a) + " and " + end_in_words(drawing, b);
    if (a == b) throw Error(wrong_pin(drawing, "An end can't be joined to itself: " + pair, {a.stroke}));
    for (const StrokeEnd& end : ends) {
      if (!joined || !is_no_contour(drawing.strokes[end.stroke])) continue;
      throw Error(wrong_pin(drawing,
                            "They can't be joined, for " + in_quotes(drawing, end.stroke) +
                                " is no open outline: " + pair + "; give it another kind, or join other ends",
                            {a.stroke, b.stroke}));
    }
    const PinnedEnds opposite{ends, !joined};
    if (std::ranges::find(pins, opposite) != pins.end()) {
      throw Error(wrong_pin(drawing, "Two ends are set both to be joined and to be apart: " + pair + "; take one back",
                            {a.stroke, b.stroke}));
    }
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
      const StrokeEnd& known = joined ? partner.try_emplace(one, other).first->second : other;
      if (known == other) continue;
      throw Error(wrong_pin(drawing,
                            "An end can be joined to one other end only: " + end_in_words(drawing, one) + " to " +
                                end_in_words(drawing, known) + ", or to " + end_in_words(drawing, other),
                            {one.stroke, known.stroke, other.stroke}));
    }
  }
}

}  // namespace

std::vector<PinnedEnds> pinned_ends(const Drawing& drawing) {
  std::vector<PinnedEnds> pins;
  std::map<std::string_view, Index> strokes;
  for (Index s = 0; s < drawing.strokes.size(); ++s) {
    for (const auto& [key, joined] : {std::pair(joined_key, true), std::pair(apart_key, false)}) {
      for (const std::string_view entry : data_list(drawing.strokes[s], key)) {
        if (strokes.empty()) {
          for (Index k = 0; k < drawing.strokes.size(); ++k) strokes.try_emplace(drawing.strokes[k].id, k);
        }
        const std::optional<EndPair> pair = read_pair(drawing, strokes, s, entry);
        if (pair) pins.push_back({*pair, joined});
      }
    }
  }
  check_pins(drawing, pins);
  return pins;
}

void pin_ends(Drawing& drawing, const PinnedEnds& pin) {
  const auto& [own, other] = pin.ends;
  const auto word = [](const StrokeEnd& end) { return std::string(end.at_start ? start_word : end_word); };
  std::string& list = drawing.strokes[own.stroke].data[pin.joined ? joined_key : apart_key];
  list += (list.empty() ? "" : ", ") + word(own) + " " + drawing.strokes[other.stroke].id + " " + word(other);
}

std::vector<PinnedEnds> pins_lost(const std::vector<PinnedEnds>& pins, const LabelledDrawing& labelled) {
  std::vector<PinnedEnds> lost;
  for (const PinnedEnds& pin : pins) {
    const bool found = std::ranges::count(labelled.joined, pin.ends) > 0 ||
                       std::ranges::any_of(labelled.figures, [&](const LabelledFigure& figure) {
                         return std::ranges::count(figure.completions, pin.ends, &FigureCompletion::ends) > 0;
                       });
    if (found != pin.joined) lost.push_back(pin);
  }
  return lost;
}

Finding pins_not_kept(const Drawing& drawing, const std::vector<PinnedEnds>& pins) {
  std::string pairs;
  std::vector<Index> strokes;
  for (const auto& [ends, joined] : pins) {
    pairs += (pairs.empty() ? "" : "; ") + end_in_words(drawing, ends[0]) + " and " + end_in_words(drawing, ends[1]) +
             (joined ? " joined" : " apart");
    strokes.insert(strokes.end(), {ends[0].stroke, ends[1].stroke});
  }
  return wrong_pin(drawing,
                   "No solid looks like what is set for ends of strokes: " + pairs +
                       "; it is left out, or the strokes have to change",
                   strokes);
}

}  // namespace croquis::silhouette
