// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the surface tool: what its gestures, panels and recordings do to the document.
#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/tools/strokes/stroke_source.h"
#include "croquis/tools/surface/surface_tool.h"
#include "tools/surface/drawn_curves.h"
#include "tools/surface/surface_words.h"

namespace croquis {
namespace {

constexpr NetworkElement kinds_of_element[] = {NetworkElement::Node, NetworkElement::Curve, NetworkElement::Face,
                                               NetworkElement::Point};
constexpr const char* part_words[] = {"node ", "curve ", "face ", "point "};

std::vector<Index> indices_of(const AttributeNetwork& network, const std::vector<std::string>& curves) {
  std::vector<Index> indices;
  for (const std::string& id : curves) indices.push_back(require_element(network, NetworkElement::Curve, id));
  return indices;
}

}  // namespace

std::string selected_part(NetworkElement kind, const std::string& id) {
  return part_words[static_cast<std::size_t>(kind)] + id;
}

Document add_network(const Document& document, AttributeNetwork network, const SurfaceToolOptions& options) {
  return with_stroke_source(document, std::make_shared<const AttributeNetwork>(std::move(network)), options, {});
}

// ---- The document

NodeId SurfaceTool::node() const { return source_node<AttributeNetwork>(session_.document(), node_); }

std::shared_ptr<const AttributeNetwork> SurfaceTool::network() const {
  return source_of<AttributeNetwork>(session_.document().find(node()));
}

NodeId SurfaceTool::operation_node() const { return operation_on(session_.document(), node(), options_.port); }

AttributeNetwork SurfaceTool::network_or_empty() const {
  const auto now = network();
  return now ? *now : AttributeNetwork();
}

Document SurfaceTool::with_network(AttributeNetwork network) const {
  const NodeId own = node();
  if (own == 0) return add_network(session_.document(), std::move(network), options_);
  Node edited = *session_.document().find(own);
  edited.source = std::make_shared<const AttributeNetwork>(std::move(network));
  return session_.document().with(std::move(edited));
}

AttributeNetwork SurfaceTool::on_both_sides(const AttributeNetwork& before, AttributeNetwork after) const {
  if (!symmetry_) return after;
  const NetworkPartners partners = partners_ ? *partners_ : find_partners(before, *symmetry_, tolerance_of(before));
  return with_symmetric_edit(before, after, *symmetry_, partners);
}

Verdict SurfaceTool::commit(const std::string& label, AttributeNetwork network, recorded::Step step) {
  give_up();
  const std::uint64_t before = session_.state();
  session_.edit(label, with_network(on_both_sides(network_or_empty(), std::move(network))));
  if (session_.state() == before) return Verdict::Continue;
  done_ = std::move(step);
  return Verdict::Commit;
}

// ---- Selection

NetworkElements SurfaceTool::selected() const {
  NetworkElements elements;
  const auto now = network();
  if (!now) return elements;
  const NodeId own = node();
  for (const NetworkElement kind : kinds_of_element) {
    for (const std::string& id : element_ids(*now, kind)) {
      const SelectedItem item{own, selected_part(kind, id)};
      if (std::ranges::binary_search(session_.selection(), item)) elements.of(kind).push_back(id);
    }
  }
  return elements;
}

void SurfaceTool::select(const NetworkElements& elements) {
  Selection selection;
  for (const NetworkElement kind : kinds_of_element) {
    for (const std::string& id : elements.of(kind)) selection.push_back({node(), selected_part(kind, id)});
  }
  session_.select(std::move(selection));
}

Verdict SurfaceTool::choose(const NetworkElements& elements) {
  const std::uint64_t before = session_.revision();
  const Selection selection = session_.selection();
  select(elements);
  if (session_.revision() == before || session_.selection() == selection) return Verdict::Continue;
  done_ = recorded::SurfaceChoice{elements};
  return Verdict::Commit;
}

// ---- Curves

Verdict SurfaceTool::draw(const recorded::SurfaceStroke& stroke) {
  DrawnStroke drawn = with_stroke(network_or_empty(), stroke);
  if (drawn.curves.empty()) return Verdict::Revert;
  return commit(drawn.label, std::move(drawn.network), stroke);
}

Verdict SurfaceTool::move(const NetworkElements& elements, const Vec3& by, const std::string& into) {
  AttributeNetwork network = with_moved(network_or_empty(), elements, by);
  if (!into.empty() && elements.nodes.size() == 1)
    network = merge_nodes(std::move(network), elements.nodes.front(), into);
  return commit(element_label("Move", elements), std::move(network), recorded::SurfaceDrag{elements, {}, by, into});
}

Verdict SurfaceTool::move_handle(const ControlHandle& handle, const Vec3& by) {
  return commit("Bend curve " + handle.curve, move_handles(network_or_empty(), {handle}, by),
                recorded::SurfaceDrag{{}, handle, by, {}});
}

Verdict SurfaceTool::set_join(const std::vector<std::string>& curves, CurveJoin join) {
  return commit(join == CurveJoin::Smooth ? "Make smooth" : "Make crease",
                croquis::set_join(network_or_empty(), curves, join), recorded::SurfaceJoin{curves, join});
}

Verdict SurfaceTool::cycle_join() {
  const std::vector<std::string> curves = selected().curves;
  if (curves.empty()) return Verdict::Continue;
  const AttributeNetwork now = network_or_empty();
  const bool all_smooth = std::ranges::all_of(indices_of(now, curves),
                                              [&](Index curve) { return now.curves[curve].join == CurveJoin::Smooth; });
  return set_join(curves, all_smooth ? CurveJoin::Crease : CurveJoin::Smooth);
}

Verdict SurfaceTool::set_slope(const SlopeSide& side, const SlopeHandle& handle) {
  return commit("Set slope along " + side.curve, croquis::set_slope(network_or_empty(), side, handle),
                recorded::SurfaceSlope{side, handle});
}

Verdict SurfaceTool::remove_slope(const SlopeSide& side) {
  return commit("Automatic slope along " + side.curve, croquis::remove_slope(network_or_empty(), side),
                recorded::SurfaceSlope{side, {}});
}

Verdict SurfaceTool::split_curve(const std::string& curve, double at) {
  return commit("Split curve " + curve, croquis::split_curve(network_or_empty(), curve, at).network,
                recorded::SurfaceSplit{curve, at, {}});
}

// ---- Patches

Verdict SurfaceTool::fill_loop(const std::vector<std::string>& curves) {
  const AttributeNetwork now = network_or_empty();
  const SortedLoop loop = sort_loop(now, indices_of(now, curves), tolerance_of(now));
  notes_ = loop.findings;
  if (!loop.closed()) return Verdict::Revert;
  return commit("Fill loop", close_loop(now, loop).network, recorded::SurfacePatch{curves});
}

Verdict SurfaceTool::fill_selected() { return fill_loop(selected().curves); }

Verdict SurfaceTool::set_faces(const std::vector<std::string>& faces, const FaceSetting& setting) {
  return commit(element_label("Set", {{}, {}, faces, {}}), croquis::set_faces(network_or_empty(), faces, setting),
                recorded::SurfaceFaceSetting{faces, setting, false});
}

Verdict SurfaceTool::turn_faces(const std::vector<std::string>& faces) {
  return commit(element_label("Turn round", {{}, {}, faces, {}}), croquis::turn_faces(network_or_empty(), faces),
                recorded::SurfaceFaceSetting{faces, {}, true});
}

Verdict SurfaceTool::split_face(const std::string& face, const std::string& curve) {
  const AttributeNetwork now = network_or_empty();
  const double reach = 10 * tolerance_of(now);
  return commit("Split patch " + face, croquis::split_face(now, face, curve, reach).network,
                recorded::SurfaceSplit{curve, {}, face});
}

Verdict SurfaceTool::merge_faces(const std::string& curve) {
  return commit("Merge patches at " + curve, croquis::merge_faces(network_or_empty(), curve),
                recorded::SurfaceMerge{curve});
}

// ---- Points and inner curves

Verdict SurfaceTool::put_point(const NewPoint& point) {
  AddedElement added = add_point(network_or_empty(), point);
  const Verdict verdict =
      commit("Add point to patch " + point.face, std::move(added.network), recorded::SurfacePoint{point});
  select(one_element(NetworkElement::Point, added.id));
  return verdict;
}

Verdict SurfaceTool::set_points(const std::vector<std::string>& points, const PointSetting& setting) {
  return commit(element_label("Set", {{}, {}, {}, points}), croquis::set_points(network_or_empty(), points, setting),
                recorded::SurfacePointSetting{points, setting});
}

Verdict SurfaceTool::set_inner(const std::string& curve, const InnerSetting& setting) {
  return commit("Set inner curve " + curve, set_inner_curve(network_or_empty(), curve, setting),
                recorded::SurfaceInner{curve, {}, false, setting});
}

Verdict SurfaceTool::add_inner(const std::string& face, const std::string& curve) {
  AttributeNetwork now = network_or_empty();
  InnerCurve inner;
  inner.curve = require_element(now, NetworkElement::Curve, curve);
  return commit("Put curve " + curve + " into patch " + face, add_inner_curve(std::move(now), face, inner),
                recorded::SurfaceInner{curve, face, false, {}});
}

Verdict SurfaceTool::remove_inner(const std::string& face, const std::string& curve) {
  return commit("Take curve " + curve + " out of patch " + face, remove_inner_curve(network_or_empty(), face, curve),
                recorded::SurfaceInner{curve, face, true, {}});
}

// ---- All of it

Verdict SurfaceTool::remove(const NetworkElements& elements) {
  return commit(element_label("Delete", elements), delete_elements(network_or_empty(), elements),
                recorded::SurfaceDelete{elements});
}

Verdict SurfaceTool::delete_selected() {
  const NetworkElements elements = selected();
  return elements.empty() ? Verdict::Continue : remove(elements);
}

Verdict SurfaceTool::mirror(const SymmetryPlane& plane) {
  const AttributeNetwork now = network_or_empty();
  MirroredNetwork mirrored = mirror_network(now, plane, tolerance_of(now));
  const std::optional<SymmetryPlane> symmetry = std::exchange(symmetry_, std::nullopt);  // it is both sides already
  const Verdict verdict = commit("Mirror", std::move(mirrored.network), recorded::SurfaceMirror{plane});
  symmetry_ = symmetry;
  notes_ = std::move(mirrored.findings);
  return verdict;
}

Verdict SurfaceTool::set_symmetry(const std::optional<SymmetryPlane>& plane) {
  if (plane == symmetry_) return Verdict::Continue;
  give_up();
  symmetry_ = plane;
  done_ = recorded::SurfaceSymmetry{plane};
  return Verdict::Commit;
}

Verdict SurfaceTool::replay(const recorded::Step& step) {
  if (const auto* stroke = step.as<recorded::SurfaceStroke>()) return draw(*stroke);
  if (const auto* drag = step.as<recorded::SurfaceDrag>())
    return drag->handle ? move_handle(*drag->handle, drag->by) : move(drag->elements, drag->by, drag->into);
  if (const auto* patch = step.as<recorded::SurfacePatch>()) return fill_loop(patch->curves);
  if (const auto* point = step.as<recorded::SurfacePoint>()) return put_point(point->point);
  if (const auto* set = step.as<recorded::SurfacePointSetting>()) return set_points(set->points, set->setting);
  if (const auto* join = step.as<recorded::SurfaceJoin>()) return set_join(join->curves, join->join);
  if (const auto* set = step.as<recorded::SurfaceFaceSetting>()) {
    if (set->turned) turn_faces(set->faces);
    return set->setting.any() ? set_faces(set->faces, set->setting) : Verdict::Commit;
  }
  if (const auto* slope = step.as<recorded::SurfaceSlope>())
    return slope->handle ? set_slope(slope->side, *slope->handle) : remove_slope(slope->side);
  if (const auto* inner = step.as<recorded::SurfaceInner>()) {
    if (inner->face.empty()) return set_inner(inner->curve, inner->setting);
    return inner->removed ? remove_inner(inner->face, inner->curve) : add_inner(inner->face, inner->curve);
  }
  if (const auto* split = step.as<recorded::SurfaceSplit>())
    return split->at ? split_curve(split->curve, *split->at) : split_face(split->face, split->curve);
  if (const auto* merge = step.as<recorded::SurfaceMerge>()) return merge_faces(merge->curve);
  if (const auto* removal = step.as<recorded::SurfaceDelete>()) return remove(removal->elements);
  if (const auto* mirrored = step.as<recorded::SurfaceMirror>()) return mirror(mirrored->plane);
  if (const auto* symmetry = step.as<recorded::SurfaceSymmetry>()) return set_symmetry(symmetry->plane);
  if (const auto* choice = step.as<recorded::SurfaceChoice>()) return choose(choice->elements);
  throw Error(make_error(Category::Usage, "E_INPUT", "This step is none of the surface tool."));
}

}  // namespace croquis
