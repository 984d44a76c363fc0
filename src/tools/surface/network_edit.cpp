// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/surface/network_edit.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/attribute_surface/loop_search.h"
#include "croquis/base/text.h"
#include "croquis/tools/surface/stroke_curves.h"
#include "croquis/tools/surface/surface_steps.h"

namespace croquis {
namespace {

constexpr NetworkElement all_kinds[] = {NetworkElement::Node, NetworkElement::Curve, NetworkElement::Face,
                                        NetworkElement::Point};
constexpr const char* kind_names[] = {"node", "curve", "patch", "point"};
constexpr const char* kinds_names[] = {"nodes", "curves", "patches", "points"};

/// "Move curve c1", "Move 3 nodes", "Move 5 elements".
std::string element_label(const std::string& verb, const NetworkElements& elements) {
  std::size_t count = 0;
  std::size_t kinds = 0;
  std::string text;
  for (const NetworkElement kind : all_kinds) {
    const std::vector<std::string>& ids = elements.of(kind);
    if (ids.empty()) continue;
    const auto number = static_cast<std::size_t>(kind);
    count += ids.size();
    ++kinds;
    text = ids.size() == 1 ? std::string(kind_names[number]) + " " + ids[0]
                           : counted(ids.size(), kind_names[number], kinds_names[number]);
  }
  return verb + " " + (kinds == 1 ? text : counted(count, "element", "elements"));
}

// ---- Strokes

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
NetworkEdit drawn_between_nodes(AttributeNetwork network, const std::vector<std::vector<Vec3>>& curves,
                                const std::string& start, const std::string& end) {
  std::vector<std::string> ids;
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
    ids.push_back(added.id);
  }
  return {std::move(network), element_label("Draw", {{}, ids, {}, {}}), {}};
}

NetworkEdit drawn_inside(AttributeNetwork network, const std::vector<std::vector<Vec3>>& curves,
                         const std::string& face) {
  std::vector<std::string> ids;
  for (const std::vector<Vec3>& control : curves) {
    AddedElement added = add_curve(std::move(network), {{}, {}, control, CurveJoin::Crease, true});
    InnerCurve inner;
    inner.curve = static_cast<Index>(added.network.curves.size() - 1);
    network = add_inner_curve(std::move(added.network), face, inner);
    ids.push_back(added.id);
  }
  return {std::move(network), element_label("Draw inner", {{}, ids, {}, {}}), {}};
}

Vec3 place_of_end(const AttributeNetwork& network, const recorded::CurveEnd& end) {
  if (!end.node.empty()) return network.nodes[require_element(network, NetworkElement::Node, end.node)].point;
  const Index curve = require_element(network, NetworkElement::Curve, end.curve);
  return ArcLengthCurve(control_polygon(network, network.curves[curve])).at(end.at);
}

/// Curves between nodes; with a face, a curve across it that divides it, or curves inside it.
NetworkEdit edited(AttributeNetwork network, const recorded::SurfaceStroke& stroke) {
  const std::vector<std::vector<Vec3>> curves = curves_of_stroke(stroke.points, stroke_options(stroke));
  if (curves.empty()) return {};
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
        return {std::move(split.network), "Split patch " + stroke.face, {}};
      }
    }
    return drawn_inside(std::move(network), curves, stroke.face);
  }
  StrokeTies ties(std::move(network));
  const std::string start = ties.tie(stroke.start, first);
  const std::string end = ties.tie(stroke.end, last);
  return drawn_between_nodes(ties.take(), curves, start, end);
}

// ---- Elements

/// The network with elements moved: with curves their nodes, with faces all that they are made from.
AttributeNetwork with_moved(AttributeNetwork network, const NetworkElements& elements, const Vec3& by) {
  std::set<std::string> curves(elements.curves.begin(), elements.curves.end());
  std::set<std::string> points(elements.points.begin(), elements.points.end());
  for (const std::string& id : elements.faces) {
    const Index index = require_element(network, NetworkElement::Face, id);
    const AttributeFace& face = network.faces[index];
    for (const AttributeSide& side : face.loop) curves.insert(network.curves[side.curve].id);
    for (const InnerCurve& inner : face.inner) curves.insert(network.curves[inner.curve].id);
    for (const PointAttribute& point : network.points) {
      if (point.face == index) points.insert(point.id);
    }
  }
  std::set<std::string> nodes(elements.nodes.begin(), elements.nodes.end());
  for (const std::string& id : curves) {
    const AttributeCurve& curve = network.curves[require_element(network, NetworkElement::Curve, id)];
    for (const Index node : {curve.from, curve.to}) {
      if (node != no_index) nodes.erase(network.nodes[node].id);  // moved with the curve
    }
  }
  network = move_curves(std::move(network), {curves.begin(), curves.end()}, by);
  network = move_nodes(std::move(network), {nodes.begin(), nodes.end()}, by);
  return move_points(std::move(network), {points.begin(), points.end()}, by);
}

NetworkEdit edited(AttributeNetwork network, const recorded::SurfaceDrag& drag) {
  if (drag.handle)
    return {move_handles(std::move(network), {*drag.handle}, drag.by), "Bend curve " + drag.handle->curve, {}};
  network = with_moved(std::move(network), drag.elements, drag.by);
  if (!drag.into.empty() && drag.elements.nodes.size() == 1)
    network = merge_nodes(std::move(network), drag.elements.nodes.front(), drag.into);
  return {std::move(network), element_label("Move", drag.elements), {}};
}

NetworkEdit edited(AttributeNetwork network, const recorded::SurfaceDelete& removal) {
  if (removal.elements.empty()) return {};
  return {delete_elements(std::move(network), removal.elements), element_label("Delete", removal.elements), {}};
}

NetworkEdit edited(const AttributeNetwork& network, const recorded::SurfaceMirror& mirror) {
  MirroredNetwork mirrored = mirror_network(network, mirror.plane, tolerance_of(network));
  return {std::move(mirrored.network), "Mirror", std::move(mirrored.findings)};
}

// ---- Curves

NetworkEdit edited(AttributeNetwork network, const recorded::SurfaceJoin& set) {
  if (set.curves.empty()) return {};
  return {set_join(std::move(network), set.curves, set.join),
          set.join == CurveJoin::Smooth ? "Make smooth" : "Make crease",
          {}};
}

NetworkEdit edited(AttributeNetwork network, const recorded::SurfaceSlope& slope) {
  if (!slope.handle)
    return {remove_slope(std::move(network), slope.side), "Automatic slope along " + slope.side.curve, {}};
  return {set_slope(std::move(network), slope.side, *slope.handle), "Set slope along " + slope.side.curve, {}};
}

NetworkEdit edited(AttributeNetwork network, const recorded::SurfaceInner& inner) {
  if (inner.face.empty())
    return {set_inner_curve(std::move(network), inner.curve, inner.setting), "Set inner curve " + inner.curve, {}};
  if (inner.removed)
    return {remove_inner_curve(std::move(network), inner.face, inner.curve),
            "Take curve " + inner.curve + " out of patch " + inner.face,
            {}};
  InnerCurve added;
  added.curve = require_element(network, NetworkElement::Curve, inner.curve);
  return {add_inner_curve(std::move(network), inner.face, added),
          "Put curve " + inner.curve + " into patch " + inner.face,
          {}};
}

NetworkEdit edited(AttributeNetwork network, const recorded::SurfaceSplit& split) {
  if (split.at)
    return {split_curve(std::move(network), split.curve, *split.at).network, "Split curve " + split.curve, {}};
  const double reach = 10 * tolerance_of(network);
  return {split_face(std::move(network), split.face, split.curve, reach).network, "Split patch " + split.face, {}};
}

// ---- Patches and their points

NetworkEdit edited(const AttributeNetwork& network, const recorded::SurfacePatch& patch) {
  std::vector<Index> curves;
  for (const std::string& id : patch.curves) curves.push_back(require_element(network, NetworkElement::Curve, id));
  const SortedLoop loop = sort_loop(network, curves, tolerance_of(network));
  if (!loop.closed()) return {{}, {}, loop.findings};
  return {close_loop(network, loop).network, "Fill loop", loop.findings};
}

NetworkEdit edited(AttributeNetwork network, const recorded::SurfaceFaceSetting& set) {
  if (set.turned)
    return {turn_faces(std::move(network), set.faces), element_label("Turn round", {{}, {}, set.faces, {}}), {}};
  return {set_faces(std::move(network), set.faces, set.setting), element_label("Set", {{}, {}, set.faces, {}}), {}};
}

NetworkEdit edited(AttributeNetwork network, const recorded::SurfaceMerge& merge) {
  return {merge_faces(std::move(network), merge.curve), "Merge patches at " + merge.curve, {}};
}

NetworkEdit edited(AttributeNetwork network, const recorded::SurfacePoint& added) {
  return {add_point(std::move(network), added.point).network, "Add point to patch " + added.point.face, {}};
}

NetworkEdit edited(AttributeNetwork network, const recorded::SurfacePointSetting& set) {
  return {set_points(std::move(network), set.points, set.setting), element_label("Set", {{}, {}, {}, set.points}), {}};
}

/// By the function for the step's struct.
template <class... Steps>
std::optional<NetworkEdit> edited_by_one_of(const AttributeNetwork& network, const recorded::Step& step) {
  std::optional<NetworkEdit> edit;
  const auto attempt = [&](const auto* own) {
    if (own != nullptr) edit = edited(network, *own);
  };
  (attempt(step.as<Steps>()), ...);
  return edit;
}

}  // namespace

std::optional<NetworkEdit> edited_by(const AttributeNetwork& network, const recorded::Step& step) {
  using namespace recorded;
  return edited_by_one_of<SurfaceStroke, SurfaceDrag, SurfaceDelete, SurfaceMirror, SurfaceJoin, SurfaceSlope,
                          SurfaceInner, SurfaceSplit, SurfacePatch, SurfaceFaceSetting, SurfaceMerge, SurfacePoint,
                          SurfacePointSetting>(network, step);
}

NetworkElements one_element(NetworkElement kind, const std::string& id) {
  NetworkElements elements;
  elements.of(kind).push_back(id);
  return elements;
}

}  // namespace croquis
