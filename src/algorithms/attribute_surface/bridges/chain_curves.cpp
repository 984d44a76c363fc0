// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/bridges/chain_curves.h"

#include <utility>

#include "croquis/geometry/bezier_fit.h"

namespace croquis {

Index ChainCurves::add_node(const Vec3& point) {
  const auto number = static_cast<Index>(network_.nodes.size());
  network_.nodes.push_back({"n" + std::to_string(number), point});
  return number;
}

std::string ChainCurves::free_name(const std::string& name) {
  std::string free = name.empty() ? "c" : name;
  for (int number = 2; !names_.insert(free).second; ++number) free = name + "~" + std::to_string(number);
  return free;
}

std::vector<ChainCurve> ChainCurves::add(const CurveChain& chain) {
  BezierFitOptions options;
  options.tolerance = tolerance_;
  options.start_direction = chain.start_direction;
  options.end_direction = chain.end_direction;
  std::vector<FittedBezier> fitted = fit_beziers(chain.points, options);
  std::vector<ChainCurve> made;
  Index from = chain.from;
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    const bool is_last = k + 1 == fitted.size();
    const Index to = is_last ? chain.to : add_node(chain.points[fitted[k].last]);
    const std::string name = fitted.size() == 1 ? chain.name : chain.name + "/" + std::to_string(k + 1);
    AttributeCurve curve{free_name(name), from, to, {}, CurveJoin::Crease};
    if (fitted[k].control.size() > 2) curve.control = std::move(fitted[k].control);
    made.push_back({static_cast<Index>(network_.curves.size()), fitted[k].first, fitted[k].last});
    network_.curves.push_back(std::move(curve));
    from = to;
  }
  return made;
}

}  // namespace croquis
