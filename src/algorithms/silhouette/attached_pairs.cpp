// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/attached_pairs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "croquis/base/error.h"
#include "croquis/silhouette/attachment.h"

namespace croquis::silhouette {
namespace {

/// Of the seams of pairs that nobody named: a limb grows out of its body rather than stuck to it.
constexpr double suggested_blend = 0.35;

struct ObjectPlace {
  std::size_t figure = 0;
  Index object = 0;

  friend bool operator==(const ObjectPlace&, const ObjectPlace&) = default;
};

using ObjectPlaces = std::map<std::string, std::optional<ObjectPlace>>;

/// Objects by their names, and by those of their strokes; no place for what is drawn in a part that couldn't be
/// labelled.
ObjectPlaces object_places(const LabelledDrawing& labelled, const Drawing& drawing) {
  ObjectPlaces places, by_stroke;
  for (std::size_t f = 0; f < labelled.figures.size(); ++f) {
    for (Index o = 0; o < labelled.figures[f].objects.size(); ++o) {
      const FigureObject& object = labelled.figures[f].objects[o];
      places.try_emplace(object.name, ObjectPlace{f, o});
      for (const Index stroke : object.strokes) by_stroke.try_emplace(drawing.strokes[stroke].id, ObjectPlace{f, o});
    }
  }
  places.merge(by_stroke);
  for (const Stroke& stroke : drawing.strokes) {
    for (const std::string& name : {stroke.id, stroke.object}) {
      if (!name.empty()) places.try_emplace(name);
    }
  }
  return places;
}

std::string pair_text(const AttachedPair& pair) { return "\"" + pair.a + "\" and \"" + pair.b + "\""; }

std::vector<Subject> attach_subject() { return {{SubjectKind::Parameter, "attach", {}, {}, {}}}; }

Finding refusal(const std::string& sentence) {
  return make_error(Category::Usage, "E_ATTACH", sentence, attach_subject());
}

Finding apart(const AttachedPair& pair, const std::string& reason) {
  return make_warning(Category::Geometry, "W_ATTACH_APART",
                      "The objects " + pair_text(pair) + " can't be attached: " + reason, attach_subject());
}

bool overlap(const LabelledFigure& figure, Index a, Index b) {
  return std::any_of(figure.overlaps.begin(), figure.overlaps.end(), [&](const FigureOverlap& overlap) {
    return std::minmax(overlap.upper, overlap.lower) == std::minmax(a, b);
  });
}

/// Errors of a pair whatever was drawn.
Findings refusals(const AttachedPair& pair, const ObjectPlaces& places) {
  Findings errors;
  if (!(pair.kappa >= 0 && pair.kappa <= 1)) {
    errors.push_back(refusal("The attached objects " + pair_text(pair) + " need a depth from 0 to 1"));
  }
  if (!(pair.blend >= 0 && pair.blend <= 1)) {
    errors.push_back(refusal("The seam of " + pair_text(pair) + " needs a radius from 0 to 1"));
  }
  for (const std::string& name : {pair.a, pair.b}) {
    if (places.contains(name)) continue;
    errors.push_back(refusal("There is no object \"" + name + "\" to attach: use the name of an object or stroke"));
  }
  const bool known = places.contains(pair.a) && places.contains(pair.b);
  if (known && places.at(pair.a) && places.at(pair.a) == places.at(pair.b)) {
    errors.push_back(refusal(pair_text(pair) + " are one object: attach two different ones"));
  }
  return errors;
}

/// Of two entries for one pair the later counts.
void hold(HeldObjects& held, Index a, Index b, const AttachedPair& pair) {
  held.attachments.release(a, b);
  held.blends.erase(std::minmax(a, b));
  if (pair.hold == Hold::Resting) held.attachments.rest(a, b);
  if (pair.hold != Hold::Joined) return;
  held.attachments.add(a, b, pair.kappa);
  if (pair.blend > 0) held.blends[std::minmax(a, b)] = pair.blend;
}

}  // namespace

AttachedFigures attached_figures(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options) {
  const ObjectPlaces places = object_places(labelled, drawing);
  std::vector<std::set<Attachments::Pair>> named(labelled.figures.size());
  AttachedFigures result;
  result.figures.resize(labelled.figures.size());
  Findings errors;
  for (const AttachedPair& pair : options.attach) {
    const Findings own = refusals(pair, places);
    errors.insert(errors.end(), own.begin(), own.end());
    if (!own.empty()) continue;
    const std::optional<ObjectPlace> a = places.at(pair.a);
    const std::optional<ObjectPlace> b = places.at(pair.b);
    std::string reason;
    if (!a || !b) {
      reason = "the lines of \"" + (a ? pair.b : pair.a) + "\" make no solid yet";
    } else if (a->figure != b->figure || !overlap(labelled.figures[a->figure], a->object, b->object)) {
      reason = "they don't overlap in the drawing";
    } else {
      named[a->figure].insert(std::minmax(a->object, b->object));
      hold(result.figures[a->figure], a->object, b->object, pair);
    }
    if (!reason.empty() && pair.hold != Hold::Apart) result.warnings.push_back(apart(pair, reason));
  }
  if (!errors.empty()) throw Error(std::move(errors));
  for (std::size_t f = 0; f < labelled.figures.size(); ++f) {
    for (const AttachSuggestion& suggestion : attach_suggestions(labelled.figures[f])) {
      if (named[f].contains({suggestion.a, suggestion.b})) continue;
      if (!suggestion.tube && !options.attach_suggested) continue;
      AttachedPair pair;
      pair.hold = suggestion.hold;
      pair.blend = suggested_blend;
      hold(result.figures[f], suggestion.a, suggestion.b, pair);
    }
  }
  return result;
}

}  // namespace croquis::silhouette
