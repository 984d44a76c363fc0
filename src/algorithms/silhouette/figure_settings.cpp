// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "algorithms/silhouette/figure_solid.h"
#include "croquis/base/error.h"
#include "croquis/base/parameter.h"
#include "croquis/silhouette/attachment.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

/// Of the seams of pairs that nobody named: a limb grows out of its body rather than stuck to it.
constexpr double suggested_blend = 0.35;

/// Bellies, eyes and buttons are a little flatter than balls.
constexpr double resting_thickness = 0.85;

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

std::vector<Subject> parameter_subject(const std::string& name) { return {{SubjectKind::Parameter, name, {}, {}, {}}}; }

/// Errors of a pair whatever was drawn.
Findings refusals(const AttachedPair& pair, const ObjectPlaces& places) {
  Findings errors;
  const auto refuse = [&](const std::string& sentence) {
    errors.push_back(make_error(Category::Usage, "E_ATTACH", sentence, parameter_subject("attach")));
  };
  if (!(pair.kappa >= 0 && pair.kappa <= 1)) {
    refuse("The attached objects " + pair_text(pair) + " need a depth from 0 to 1");
  }
  if (!(pair.blend >= 0 && pair.blend <= 1)) refuse("The seam of " + pair_text(pair) + " needs a radius from 0 to 1");
  for (const std::string& name : {pair.a, pair.b}) {
    if (places.contains(name)) continue;
    refuse("There is no object \"" + name + "\" to attach: use the name of an object or stroke");
  }
  const bool known = places.contains(pair.a) && places.contains(pair.b);
  if (known && places.at(pair.a) && places.at(pair.a) == places.at(pair.b)) {
    refuse(pair_text(pair) + " are one object: attach two different ones");
  }
  return errors;
}

bool overlap(const LabelledFigure& figure, Index a, Index b) {
  return std::ranges::any_of(figure.overlaps, [&](const FigureOverlap& overlap) {
    return std::minmax(overlap.upper, overlap.lower) == std::minmax(a, b);
  });
}

/// Per figure.
std::vector<Attachments> attached_objects(const LabelledDrawing& labelled, const Drawing& drawing,
                                          const Options& options, Findings& warnings) {
  const ObjectPlaces places = object_places(labelled, drawing);
  std::vector<std::set<ObjectPair>> named(labelled.figures.size());
  std::vector<Attachments> result(labelled.figures.size());
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
      // Of two entries for one pair the later counts.
      const ObjectPair objects = std::minmax(a->object, b->object);
      named[a->figure].insert(objects);
      result[a->figure].held[objects] = {pair.hold, pair.kappa, pair.blend};
      if (pair.hold == Hold::Apart) result[a->figure].held.erase(objects);
    }
    if (reason.empty() || pair.hold == Hold::Apart) continue;
    warnings.push_back(make_warning(Category::Geometry, "W_ATTACH_APART",
                                    "The objects " + pair_text(pair) + " can't be attached: " + reason,
                                    parameter_subject("attach")));
  }
  if (!errors.empty()) throw Error(std::move(errors));
  for (std::size_t f = 0; f < labelled.figures.size(); ++f) {
    for (const AttachSuggestion& suggestion : attach_suggestions(labelled.figures[f])) {
      if (named[f].contains({suggestion.a, suggestion.b})) continue;
      if (!suggestion.tube && !options.attach_suggested) continue;
      result[f].held[{suggestion.a, suggestion.b}] = {suggestion.hold, AttachedPair().kappa, suggested_blend};
    }
  }
  return result;
}

using Attributes = std::map<std::string, std::string>;

struct Range {
  double least;
  double most;
  std::string text;
};

const Range weight_range{1e-3, 1, "from 0.001 to 1"};
const Range thickness_range{0.05, 4, "from 0.05 to 4"};

/// Reads a number of an object.
/// @return whether the attributes have it
bool read_number(const FigureObject& object, const Attributes& attributes, const std::string& name, const Range& range,
                 double& number, Findings& findings) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return false;
  ParameterDescription description;
  description.name = name;
  description.default_value = number;
  description.minimum = range.least;
  description.maximum = range.most;
  try {
    const ParameterValues values{{name, parse_parameter(description, found->second)}};
    number = std::get<double>(complete({description}, values).at(name));
  } catch (const Error&) {
    findings.push_back(make_error(
        Category::Usage, "E_PARAMETER",
        "The object \"" + object.name + "\" has " + name + " \"" + found->second + "\": give a number " + range.text,
        parameter_subject(name)));
  }
  return true;
}

/// Reads what the drawing says of the objects of a figure into its settings, whose options and attachments are set.
void read_objects(const LabelledFigure& figure, const Drawing& drawing, DepthSettings& settings, Findings& findings) {
  settings.thickness.assign(figure.objects.size(), 1);
  for (const FigureOverlap& overlap : figure.overlaps) {
    const bool inside = overlap.crossings.empty();
    if (inside && settings.attachments.resting(overlap.upper, overlap.lower)) {
      settings.thickness[overlap.upper] = resting_thickness;
    }
  }
  for (Index o = 0; o < figure.objects.size(); ++o) {
    const FigureObject& object = figure.objects[o];
    DepthWeights weights{settings.options.weight_curvature, settings.options.weight_orientation,
                         settings.options.weight_distance};
    double& thickness = settings.thickness[o];
    bool is_given = false;
    if (const auto group = drawing.object_data.find(object.name); group != drawing.object_data.end()) {
      read_number(object, group->second, "weight-curvature", weight_range, weights.curvature, findings);
      read_number(object, group->second, "weight-orientation", weight_range, weights.orientation, findings);
      read_number(object, group->second, "weight-distance", weight_range, weights.distance, findings);
      is_given = read_number(object, group->second, thickness_key, thickness_range, thickness, findings);
    }
    for (std::size_t s = 0; s < object.strokes.size() && !is_given; ++s) {
      const Attributes& data = drawing.strokes[object.strokes[s]].data;
      is_given = read_number(object, data, thickness_key, thickness_range, thickness, findings);
    }
    settings.object_weights.push_back(weights);
  }
}

/// Ascending.
std::vector<Index> copied_objects(const LabelledFigure& figure, const Drawing& drawing) {
  std::vector<Index> copied;
  for (Index o = 0; o < figure.objects.size(); ++o) {
    const FigureObject& object = figure.objects[o];
    const auto group = drawing.object_data.find(object.name);
    if ((group != drawing.object_data.end() && has_far_copy(group->second)) ||
        std::ranges::any_of(object.strokes, [&](Index s) { return has_far_copy(drawing.strokes[s].data); }))
      copied.push_back(o);
  }
  return copied;
}

}  // namespace

std::vector<FigureSettings> figure_settings(const LabelledDrawing& labelled, const Drawing& drawing,
                                            const Options& options, Findings& warnings) {
  std::vector<Attachments> attached = attached_objects(labelled, drawing, options, warnings);
  std::vector<FigureSettings> all;
  Findings errors;
  for (std::size_t f = 0; f < attached.size(); ++f) {
    FigureSettings& settings = all.emplace_back(FigureSettings{{}, options.quality, options.cache});
    settings.depth.options = options.depth;
    settings.depth.attachments = std::move(attached[f]);
    read_objects(labelled.figures[f], drawing, settings.depth, errors);
    settings.copied = copied_objects(labelled.figures[f], drawing);
  }
  if (!errors.empty()) throw Error(std::move(errors));
  return all;
}

}  // namespace croquis::silhouette
