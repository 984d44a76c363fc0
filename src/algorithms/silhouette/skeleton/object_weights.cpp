// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/object_weights.h"

#include <map>
#include <string>

#include "croquis/base/error.h"
#include "croquis/base/parameter.h"

namespace croquis::silhouette {
namespace {

using Attributes = std::map<std::string, std::string>;

void read_weight(const std::string& object, const Attributes& attributes, const std::string& name, double& weight,
                 Findings& findings) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return;
  ParameterDescription description;
  description.name = name;
  description.default_value = weight;
  description.minimum = 1e-3;
  description.maximum = 1;
  try {
    ParameterValues values{{name, parse_parameter(description, found->second)}};
    weight = std::get<double>(complete({description}, values).at(name));
  } catch (const Error&) {
    findings.push_back(make_error(
        Category::Usage, "E_PARAMETER",
        "The object \"" + object + "\" has " + name + " \"" + found->second + "\": give a number from 0.001 to 1",
        {Subject{SubjectKind::Parameter, name, {}, {}, {}}}));
  }
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
      read_weight(object.name, attributes->second, "weight-curvature", own.curvature, findings);
      read_weight(object.name, attributes->second, "weight-orientation", own.orientation, findings);
      read_weight(object.name, attributes->second, "weight-distance", own.distance, findings);
    }
    weights.push_back(own);
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return weights;
}

}  // namespace croquis::silhouette
