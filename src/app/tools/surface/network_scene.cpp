// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/network_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <Eigen/LU>

#include "app/window/language.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double crease_width = 2.8, smooth_width = 1.5, inner_width = 1.6;  // logical pixels
constexpr double halo_width = 6;
constexpr int behind_alpha = 70;      // of lines that surfaces hide: faint, but seen
constexpr double seen_degrees = 0.1;  // an angle between patches that nobody sees
constexpr double greatest_shown = 2;  // degrees: where the colours end
constexpr double jump_degree = std::numbers::pi / 180;
const QColor smooth_color(64, 92, 150);
const QColor inner_color(112, 64, 150);
const QColor point_color(242, 140, 40);

/// Seen whole where no surface hides it, faintly elsewhere.
void add_lines(std::vector<render::LineItemPtr>& items, const std::vector<render::LinePath>& paths, double width,
               const QColor& color, const render::DashPattern& dash = {}) {
  if (paths.empty()) return;
  items.push_back(render::make_line_item(paths, {width, to_color(color, behind_alpha), dash}));
  items.push_back(render::make_line_item(paths, {width, to_color(color), dash, render::LineDepth::OnSurface}));
}

std::set<Index> inner_curves(const AttributeNetwork& network) {
  std::set<Index> inner;
  for (const AttributeFace& face : network.faces) {
    for (const InnerCurve& curve : face.inner) inner.insert(curve.curve);
  }
  return inner;
}

render::LinePath path_through(const std::vector<Vec3>& places, const Affine3& to_world, bool closed = false) {
  return path_of(
      places, [&](const Vec3& place) { return to_glm(to_world(place)); }, closed);
}

render::LinePath curve_path(const AttributeNetwork& network, Index curve, const Affine3& to_world) {
  return path_through(traced_curve(network, curve), to_world);
}

render::Mark place_mark(const Vec3& world, render::MarkShape shape, float size, const QColor& color) {
  return {to_glm(world), shape, size, to_color(color)};
}

/// Halfway along a curve, or where its control points are, if it is of no length. World.
Vec3 middle_of(const AttributeNetwork& network, Index curve, const Affine3& to_world) {
  const std::vector<Vec3> places = traced_curve(network, curve, 2);
  return to_world(places.size() == 2 ? Vec3((places[0] + places[1]) / 2) : places[places.size() / 2]);
}

/// The mean of a face's corners. World.
Vec3 middle_of_face(const AttributeNetwork& network, Index face, const Affine3& to_world) {
  Vec3 sum = Vec3::Zero();
  for (const AttributeSide& side : network.faces[face].loop) sum += start_place(network, side);
  const std::size_t corners = network.faces[face].loop.size();
  return to_world(corners == 0 ? sum : Vec3(sum / static_cast<double>(corners)));
}

/// From a network's own space to that of the mesh.
Affine3 placement_of(const Document& document, NodeId network, NodeId operation) {
  const Node* source = document.find(network);
  const Node* step = document.find(operation);
  const Affine3 own = source == nullptr ? Affine3() : source->transform;
  return step == nullptr ? own : composed(step->transform, own);
}

/// The colour of an angle between patches: green where nobody sees it, red from two degrees on.
QColor jump_color(double degrees) {
  const double share = std::clamp((degrees - seen_degrees) / (greatest_shown - seen_degrees), 0.0, 1.0);
  return QColor::fromHsvF(static_cast<float>((1 - share) / 3), 0.85F, 0.75F);
}

/// Where a finding stands: at its first element that is there.
std::optional<Vec3> place_of(const Finding& finding, const AttributeNetwork& network, const Affine3& to_world) {
  for (const Subject& subject : finding.subjects) {
    if (subject.at.size() == 3) return to_world(Vec3(subject.at[0], subject.at[1], subject.at[2]));
    const auto find = [&](NetworkElement kind) { return find_element(network, kind, subject.id); };
    if (const Index node = find(NetworkElement::Node); subject.kind == SubjectKind::Node && node != no_index)
      return to_world(network.nodes[node].point);
    if (const Index point = find(NetworkElement::Point); subject.kind == SubjectKind::Point && point != no_index)
      return to_world(network.points[point].point);
    if (const Index curve = find(NetworkElement::Curve); subject.kind == SubjectKind::Curve && curve != no_index)
      return middle_of(network, curve, to_world);
    if (const Index face = find(NetworkElement::Face); subject.kind == SubjectKind::Face && face != no_index)
      return middle_of_face(network, face, to_world);
  }
  return std::nullopt;
}

}  // namespace

std::vector<Index> failed_faces(const AttributeNetwork& network, const ShownSurface& shown) {
  std::vector<Index> failed;
  for (Index face = 0; shown && face < network.faces.size(); ++face) {
    const Index tried = shown.find(NetworkElement::Face, network.faces[face].id);
    if (tried != no_index && !shown.surface().faces[tried].surface) failed.push_back(face);
  }
  return failed;
}

render::LineItemPtr ground_lines(const render::Bounds& drawn, const Affine3& to_world) {
  constexpr int squares = 10;         // on either side of the middle
  constexpr double least_size = 200;  // model units: as far as an empty view shows
  constexpr int line_alpha = 60, axis_alpha = 130;
  const double reach = drawn.empty() ? least_size : std::max(glm::length(drawn.max - drawn.min), 1e-6);
  const double step = std::pow(5, std::round(std::log(reach / squares) / std::log(5)));
  std::vector<render::LinePath> lines;
  for (int k = -squares; k <= squares; ++k) {
    const double at = k * step, end = squares * step;
    lines.push_back(path_through({Vec3(at, -end, 0), Vec3(at, end, 0)}, to_world));
    lines.push_back(path_through({Vec3(-end, at, 0), Vec3(end, at, 0)}, to_world));
    for (auto line = lines.end() - 2; k == 0 && line != lines.end(); ++line)
      for (render::LinePoint& point : line->points) point.color = to_color(colors::guide, axis_alpha);
  }
  return lines_of(lines, {1, to_color(colors::guide, line_alpha), {}, render::LineDepth::Tested});
}

Affine3 inverse_of(const Affine3& map) {
  if (map.is_identity()) return map;
  Affine3 inverse;
  inverse.linear = map.linear.inverse();
  inverse.offset = -inverse.linear * map.offset;
  return inverse;
}

ShownSurface shown_surface(const Studio& studio, NodeId network, NodeId operation) {
  const Document& document = studio.session().document();
  ShownSurface shown;
  shown.to_mesh = shown.to_world = placement_of(document, network, operation);
  if (const Node* source = document.find(network)) {
    shown.to_result = source->transform;
    shown.to_world = composed(source->placement.map(), shown.to_mesh);
  }
  shown.result = operation == 0 ? nullptr : studio.result(operation);
  shown.found = result_of<SurfaceResult>(shown.result.get());
  shown.mesh = shown.found == nullptr ? nullptr : mesh_at(studio, operation);
  return shown;
}

void NetworkScene::show_network(const AttributeNetwork& network, const ShownSurface& shown,
                                const NetworkElements& selected) {
  const Affine3& to_world = shown.to_world;
  const std::set<Index> inner = inner_curves(network);
  std::vector<render::LinePath> creases, smooth, inside, chosen, failed;
  bounds_ = {};
  for (Index curve = 0; curve < network.curves.size(); ++curve) {
    const render::LinePath path = curve_path(network, curve, to_world);
    for (const render::LinePoint& point : path.points) bounds_.add(point.position);
    (inner.contains(curve)                             ? inside
     : network.curves[curve].join == CurveJoin::Smooth ? smooth
                                                       : creases)
        .push_back(path);
    if (selected.has(NetworkElement::Curve, network.curves[curve].id)) chosen.push_back(path);
  }
  for (const std::string& id : selected.faces) {
    const Index face = find_element(network, NetworkElement::Face, id);
    if (face == no_index) continue;
    for (const AttributeSide& side : network.faces[face].loop)
      chosen.push_back(curve_path(network, side.curve, to_world));
  }
  for (const Index face : failed_faces(network, shown)) {
    for (const AttributeSide& side : network.faces[face].loop)
      failed.push_back(curve_path(network, side.curve, to_world));
  }
  curves_.clear();
  add_lines(curves_, creases, crease_width, colors::ink);
  add_lines(curves_, smooth, smooth_width, smooth_color);
  add_lines(curves_, inside, inner_width, inner_color, {7, 3, 0, 0});
  selected_ = lines_of(chosen, {halo_width, to_color(colors::accent, 150), {}});
  failed_ = lines_of(failed, {crease_width, to_color(colors::error), {6, 4, 0, 0}});
  std::vector<render::Mark> nodes, points;
  for (const AttributeNode& node : network.nodes) {
    const bool is_chosen = selected.has(NetworkElement::Node, node.id);
    nodes.push_back(place_mark(to_world(node.point), is_chosen ? render::MarkShape::Square : render::MarkShape::Disc,
                               is_chosen ? 10 : 7, is_chosen ? colors::accent : colors::ink));
  }
  for (const PointAttribute& point : network.points) {
    const bool is_chosen = selected.has(NetworkElement::Point, point.id);
    points.push_back(place_mark(to_world(point.point), render::MarkShape::Disc, is_chosen ? 12 : 9, point_color));
    points.back().outline = to_color(colors::ink);
    points.back().outline_width = is_chosen ? 2.5F : 1.5F;
    bounds_.add(points.back().position);
  }
  nodes_ = marks_of(nodes);
  points_ = marks_of(points);
}

void NetworkScene::show_handles(const SurfaceTool& tool, const AttributeNetwork& network, const Affine3& to_world) {
  std::vector<render::LinePath> polygons, slopes, ring;
  std::vector<render::Mark> handles, tips;
  const NetworkElements selected = tool.selected();
  for (const std::string& id : selected.curves) {
    const Index curve = find_element(network, NetworkElement::Curve, id);
    if (curve == no_index) continue;
    polygons.push_back(path_through(control_handles(network, network.curves[curve]), to_world));
  }
  for (const ControlHandle& handle : handles_of(tool)) {
    const Index curve = find_element(network, NetworkElement::Curve, handle.curve);
    if (curve == no_index) continue;
    const Vec3 place = control_handles(network, network.curves[curve])[handle.control];
    handles.push_back(place_mark(to_world(place), render::MarkShape::Square, 8, colors::accent));
  }
  for (const SlopeTip& slope : slopes_of(tool)) {
    slopes.push_back(path_through({slope.frame.point, slope.tip}, to_world));
    const auto shape = slope.automatic ? render::MarkShape::Ring : render::MarkShape::Disc;
    tips.push_back(place_mark(to_world(slope.tip), shape, 10, colors::hover));
  }
  if (const std::vector<Vec3> places = ring_of(tool); places.size() > 2)
    ring.push_back(path_through(places, to_world, true));
  polygons_ = lines_of(polygons, {1, to_color(colors::accent, 170), {4, 3, 0, 0}});
  slopes_ = lines_of(slopes, {2, to_color(colors::hover), {}});
  ring_ = lines_of(ring, {2.2, to_color(colors::accent), {}});
  handles_ = marks_of(handles);
  tips_ = marks_of(tips);
}

void NetworkScene::show_findings(const AttributeNetwork& network, const Affine3& to_world, const Findings& findings) {
  std::vector<render::Mark> symbols;
  marks_.clear();
  for (const Finding& finding : findings) {
    const auto at = finding.severity == Severity::Info ? std::nullopt : place_of(finding, network, to_world);
    if (!at) continue;
    marks_.push_back({*at, localized(finding.message), finding.severity == Severity::Error});
    symbols.push_back(symbol_of(marks_.back()));
  }
  findings_ = marks_of(symbols);
}

void NetworkScene::show_preview(const SurfacePreview& preview, const AttributeNetwork& network,
                                const Affine3& to_world) {
  std::vector<render::LinePath> ink, loop, hovered;
  std::vector<render::Mark> marks;
  if (preview.ink.size() > 1) ink.push_back(path_through(preview.ink, to_world));
  if (preview.loop) {
    for (const AttributeSide& side : preview.loop->loop.sides)
      loop.push_back(curve_path(network, side.curve, to_world));
  }
  if (preview.hovered && preview.hovered->kind == NetworkElement::Curve && !preview.hovered->control) {
    const Index curve = find_element(network, NetworkElement::Curve, preview.hovered->id);
    if (curve != no_index) hovered.push_back(curve_path(network, curve, to_world));
  } else if (preview.hovered) {
    marks.push_back(place_mark(to_world(preview.hovered->place), render::MarkShape::Ring, 14, colors::hover));
  }
  if (preview.snap) {
    const bool on_curve = preview.snap->end.node.empty() && !preview.snap->end.curve.empty();
    marks.push_back(place_mark(to_world(preview.snap->place),
                               on_curve ? render::MarkShape::Square : render::MarkShape::Ring, on_curve ? 12 : 16,
                               colors::hover));
    marks.back().outline = to_color(colors::ink);
  }
  if (preview.hit) marks.push_back(place_mark(to_world(preview.hit->point), render::MarkShape::Disc, 6, colors::hover));
  ink_ = lines_of(ink, {crease_width, to_color(colors::accent), {}});
  loop_ = lines_of(loop, {halo_width, to_color(colors::hover, 190), {}});
  hovered_ = lines_of(hovered, {halo_width - 1, to_color(colors::hover, 150), {}});
  snap_ = marks_of(marks);
}

void NetworkScene::show_jumps(const AttributeNetwork& network, const ShownSurface& shown, bool on) {
  std::vector<render::LinePath> paths;
  numbers_.clear();
  for (Index curve = 0; on && shown && curve < network.curves.size(); ++curve) {
    const Index measured = shown.find(NetworkElement::Curve, network.curves[curve].id);
    if (measured == no_index || measured >= shown.found->measures.normal_jumps.size()) continue;
    const auto& jump = shown.found->measures.normal_jumps[measured];
    if (!jump) continue;
    const double degrees = *jump / jump_degree;
    paths.push_back(curve_path(network, curve, shown.to_world));
    for (render::LinePoint& point : paths.back().points) point.color = to_color(jump_color(degrees));
    numbers_.push_back({middle_of(network, curve, shown.to_world),
                        QString::number(degrees, 'f', degrees < seen_degrees ? 3 : 2) + QStringLiteral("°"),
                        jump_color(degrees)});
  }
  jumps_ = lines_of(paths, {halo_width - 1, to_color(colors::warning), {}});
}

void NetworkScene::add_to(render::Scene& scene) const {
  add_items(scene, {selected_, jumps_});
  for (const render::LineItemPtr& item : curves_) scene.lines.emplace_back(item);
  add_items(scene, {failed_, hovered_, loop_, polygons_, slopes_, ring_, ink_},
            {nodes_, handles_, tips_, points_, findings_, snap_});
}

}  // namespace croquis::app
