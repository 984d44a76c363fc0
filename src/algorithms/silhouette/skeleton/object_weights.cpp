// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/object_weights.h"

#include <map>
#include <string>

#include "croquis/base/error.h"
#include "croquis/base/parameter.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

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
        {Subject{SubjectKind::Parameter, name, {}, {}, {}}}));
  }
  return true;
}

}  // namespace

void read_object_weights(const LabelledFigure& figure, const Drawing& drawing, DepthSettings& settings,
                         Findings& findings) {
  constexpr double resting_thickness = 0.85;  // bellies, eyes and buttons are a little flatter than balls
  settings.thickness.assign(figure.objects.size(), 1);
  for (const FigureOverlap& overlap : figure.overlaps) {
    const bool inside = overlap.crossings.empty();
    if (inside && settings.attachments.resting(overlap.upper, overlap.lower)) {
      settings.thickness[overlap.upper] = resting_thickness;
    }
  }
  settings.object_weights.clear();
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

}  // namespace croquis::silhouette
