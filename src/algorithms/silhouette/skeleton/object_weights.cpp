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

/// @return whether the attributes have it
bool read_number(const std::string& object, const Attributes& attributes, const std::string& name, const Range& range,
                 double& number, Findings& findings) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return false;
  ParameterDescription description;
  description.name = name;
  description.default_value = number;
  description.minimum = range.least;
  description.maximum = range.most;
  try {
    ParameterValues values{{name, parse_parameter(description, found->second)}};
    number = std::get<double>(complete({description}, values).at(name));
  } catch (const Error&) {
    findings.push_back(make_error(
        Category::Usage, "E_PARAMETER",
        "The object \"" + object + "\" has " + name + " \"" + found->second + "\": give a number " + range.text,
        {Subject{SubjectKind::Parameter, name, {}, {}, {}}}));
  }
  return true;
}

}  // namespace

std::vector<DepthWeights> object_weights(const LabelledFigure& figure, const Drawing& drawing,
                                         const DepthOptions& options) {
  std::vector<DepthWeights> weights;
  Findings findings;
  for (const FigureObject& object : figure.objects) {
    DepthWeights own{options.weight_curvature, options.weight_orientation, options.weight_distance};
    const auto attributes = drawing.object_data.find(object.name);
    if (attributes != drawing.object_data.end()) {
      read_number(object.name, attributes->second, "weight-curvature", weight_range, own.curvature, findings);
      read_number(object.name, attributes->second, "weight-orientation", weight_range, own.orientation, findings);
      read_number(object.name, attributes->second, "weight-distance", weight_range, own.distance, findings);
    }
    weights.push_back(own);
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return weights;
}

std::vector<double> object_thickness(const LabelledFigure& figure, const Drawing& drawing,
                                     const Attachments& attachments) {
  constexpr double resting_thickness = 0.85;  // bellies, eyes and buttons are a little flatter than balls
  std::vector<double> thickness(figure.objects.size(), 1);
  for (const FigureOverlap& overlap : figure.overlaps) {
    const bool inside = overlap.crossings.empty();
    if (inside && attachments.resting(overlap.upper, overlap.lower)) thickness[overlap.upper] = resting_thickness;
  }
  Findings findings;
  for (Index o = 0; o < figure.objects.size(); ++o) {
    const FigureObject& object = figure.objects[o];
    double& factor = thickness[o];
    const auto group = drawing.object_data.find(object.name);
    bool told = group != drawing.object_data.end() &&
                read_number(object.name, group->second, thickness_key, thickness_range, factor, findings);
    for (std::size_t s = 0; s < object.strokes.size() && !told; ++s) {
      told = read_number(object.name, drawing.strokes[object.strokes[s]].data, thickness_key, thickness_range, factor,
                         findings);
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return thickness;
}

}  // namespace croquis::silhouette
