// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/surface/drawn_curves.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/tools/surface/stroke_curves.h"
#include "tools/surface/surface_words.h"

namespace croquis {
namespace {

constexpr double end_of_curve = 1e-6;  // fractions of a curve: nearer places are its end

/// Ties ends of strokes to a network, which they may split.
class StrokeTies {
 public:
  explicit StrokeTies(AttributeNetwork network) : network_(std::move(network)) {}

  /// The node at an end of the stroke; empty where it goes to nothing.
  std::string tie(const recorded::CurveEnd& end, const Vec3& place) {
    if (!end.node.empty()) return end.node;
    return end.curve.empty() ? std::string() : node_on(end.curve, place);
  }

  AttributeNetwork take() { return std::move(network_); }

 private:
  /// The node on a curve, or on one of the parts that an earlier end has split it into.
  std::string node_on(const std::string& curve, const Vec3& place) {
    std::string nearest;
    double at = 0;
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::string> parts = {curve};
    parts.insert(parts.end(), split_off_.begin(), split_off_.end());
    for (const std::string& part : parts) {
      const Index index = require_element(network_, NetworkElement::Curve, part);
      const double fraction = nearest_fraction(network_, index, place);
      const ArcLengthCurve shape(control_polygon(network_, network_.curves[index]));
      const double distance = (shape.at(fraction) - place).norm();
      if (distance >= least) continue;
      least = distance;
      nearest = part;
      at = fraction;
    }
    const AttributeCurve& split = network_.curves[require_element(network_, NetworkElement::Curve, nearest)];
    const Index end = at < end_of_curve ? split.from : at > 1 - end_of_curve ? split.to : no_index;
    if (end != no_index) return network_.nodes[end].id;
    if (at < end_of_curve || at > 1 - end_of_curve) return {};
    SplitCurve made = split_curve(std::move(network_), nearest, at);
    network_ = std::move(made.network);
    split_off_.push_back(made.second);
    return made.node;
  }

  AttributeNetwork network_;
  std::vector<std::string> split_off_;
};

StrokeCurveOptions stroke_options(const recorded::SurfaceStroke& stroke) {
  StrokeCurveOptions options;
  options.unit = stroke.unit;
  return options;
}

/// As one curve, however it bends: looser until one will do.
std::vector<Vec3> single_curve(const recorded::SurfaceStroke& stroke) {
  StrokeCurveOptions options = stroke_options(stroke);
  options.corner_degrees = 180;
  std::vector<std::vector<Vec3>> curves = curves_of_stroke(stroke.points, options);
  for (int round = 0; round < 6 && curves.size() > 1; ++round) {
    options.tolerance *= 2;
    curves = curves_of_stroke(stroke.points, options);
  }
  return curves.size() == 1 ? curves.front() : std::vector<Vec3>();
}

/// Curves from node to node. @param start, end nodes, or empty
DrawnStroke drawn_between_nodes(AttributeNetwork network, const std::vector<std::vector<Vec3>>& curves,
                                const std::string& start, const std::string& end) {
  DrawnStroke drawn;
  std::string from = start;
  std::string first = start;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const bool last = i + 1 == curves.size();
    const bool closes = last && curves.size() > 1 && end.empty() && curves[i].back() == curves[0].front();
    const bool straight = curves[i].size() == 2;
    NewCurve curve{from, closes ? first : last ? end : std::string(), curves[i], CurveJoin::Crease, false};
    AddedElement added = add_curve(std::move(network), curve);
    network = std::move(added.network);
    AttributeCurve& made = network.curves.back();
    if (straight) made.control.clear();
    if (i == 0) first = network.nodes[made.from].id;
    from = network.nodes[made.to].id;
    drawn.curves.push_back(added.id);
  }
  drawn.label = element_label("Draw", {{}, drawn.curves, {}, {}});
  drawn.network = std::move(network);
  return drawn;
}

DrawnStroke drawn_inside(AttributeNetwork network, const std::vector<std::vector<Vec3>>& curves,
                         const std::string& face) {
  DrawnStroke drawn;
  for (const std::vector<Vec3>& control : curves) {
    AddedElement added = add_curve(std::move(network), {{}, {}, control, CurveJoin::Crease, true});
    InnerCurve inner;
    inner.curve = static_cast<Index>(added.network.curves.size() - 1);
    network = add_inner_curve(std::move(added.network), face, inner);
    drawn.curves.push_back(added.id);
  }
  drawn.label = element_label("Draw inner", {{}, drawn.curves, {}, {}});
  drawn.network = std::move(network);
  return drawn;
}

}  // namespace

Vec3 place_of_end(const AttributeNetwork& network, const recorded::CurveEnd& end) {
  if (!end.node.empty()) return network.nodes[require_element(network, NetworkElement::Node, end.node)].point;
  const Index curve = require_element(network, NetworkElement::Curve, end.curve);
  return ArcLengthCurve(control_polygon(network, network.curves[curve])).at(end.at);
}

DrawnStroke with_stroke(AttributeNetwork network, const recorded::SurfaceStroke& stroke) {
  const std::vector<std::vector<Vec3>> curves = curves_of_stroke(stroke.points, stroke_options(stroke));
  if (curves.empty()) return {std::move(network), {}, {}};
  const Vec3 first = stroke.start.any() ? place_of_end(network, stroke.start) : curves.front().front();
  const Vec3 last = stroke.end.any() ? place_of_end(network, stroke.end) : curves.back().back();
  if (!stroke.face.empty()) {
    const Index face = require_element(network, NetworkElement::Face, stroke.face);
    const std::vector<Vec3> single = single_curve(stroke);
    if (stroke.start.any() && stroke.end.any() && !single.empty()) {
      const std::vector<Vec3> cut = with_ends_moved_by(single, first - single.front(), last - single.back());
      AddedElement added = add_curve(network, {{}, {}, cut, CurveJoin::Smooth, true});
      const double reach = 0.01 * stroke.unit;
      if (can_split_face(added.network, face, static_cast<Index>(added.network.curves.size() - 1), reach)) {
        SplitFace split = split_face(std::move(added.network), stroke.face, added.id, reach);
        return {std::move(split.network), {added.id}, "Split patch " + stroke.face};
      }
    }
    return drawn_inside(std::move(network), curves, stroke.face);
  }
  StrokeTies ties(std::move(network));
  const std::string start = ties.tie(stroke.start, first);
  const std::string end = ties.tie(stroke.end, last);
  return drawn_between_nodes(ties.take(), curves, start, end);
}

}  // namespace croquis
