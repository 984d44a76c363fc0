// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/surface/contour_network_operation.h"

#include <memory>
#include <numbers>
#include <utility>

#include "croquis/attribute_surface/contour_network.h"

namespace croquis {
namespace {

constexpr double contour_degree = std::numbers::pi / 180;

}  // namespace

OperationDescription ContourNetworkOperation::describe() const {
  return {
      "contour_network",
      1,
      "Contours as Curves",
      "Makes curves of an attribute network of the strokes of a drawing; faces are spanned between them afterwards.",
      {{"drawing", ValueType::Drawing, "Strokes on their plane."}},
      {{"network", ValueType::AttributeNetwork, "Curves that share nodes where strokes meet."}},
      {number_parameter("tolerance", 0.002, 1e-6, 0.1, "× the drawing's diagonal",
                        "How far curves may be from what was drawn: smaller takes more curves.")
           .titled("Off the strokes by at most"),
       number_parameter("join", 0.01, 0, 0.1, "× the drawing's diagonal",
                        "Ends of strokes that are so near to each other, or to a stroke, meet.")
           .titled("Ends meet within"),
       number_parameter("corner", 40, 5, 180, "degrees", "Strokes that turn more have a corner there; 180 for none.")
           .titled("Corner above")}};
}

OperationResult ContourNetworkOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                                 Context& context) const {
  ContourNetworkOptions options;
  options.tolerance = number_of(parameters, "tolerance");
  options.join = number_of(parameters, "join");
  options.corner = number_of(parameters, "corner") * contour_degree;
  ContourNetwork made = network_of_contours(inputs.at("drawing").get<Drawing>(), options, context.progress);
  OperationResult result;
  result.warnings = std::move(made.warnings);
  result.outputs["network"] = std::make_shared<const AttributeNetwork>(std::move(made.network));
  return result;
}

}  // namespace croquis
