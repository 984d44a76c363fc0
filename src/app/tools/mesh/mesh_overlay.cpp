// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/mesh_overlay.h"

#include <algorithm>
#include <map>

#include "app/window/theme.h"
#include "croquis/mesh_editing/tag_edit.h"
#include "croquis/render/render_options.h"
#include "croquis/render/sharpness_color.h"

namespace croquis::app {
namespace {

constexpr std::size_t points_at_most = 300'000;  // vertices of more aren't drawn: they would cover everything
constexpr std::size_t rims_at_most = 50'000;     // more selected faces than this have no lines
constexpr std::size_t edges_at_most = 5'000;     // more have no borders and aren't seen through the surface
constexpr float selected_width = 3.5F;
constexpr float face_rim_width = 2.5F;  // of selected faces
constexpr float casing_width = 1.3F;
constexpr float hovered_width = 4.5F;
constexpr std::uint8_t covered_alpha = 80;  // of lines behind the surface

std::vector<render::StyledEdge> styled(const MeshTopology& topology, std::span<const Index> chosen,
                                       const render::Color& color, float width) {
  std::vector<render::StyledEdge> edges;
  edges.reserve(chosen.size());
  for (const Index edge : chosen) edges.push_back({topology.edge_vertices(edge), color, width});
  return edges;
}

render::PointItemPtr points(const std::vector<Vec3>& places, std::span<const Index> chosen, const QColor& color,
                            double size) {
  render::PointStyle style;
  style.size = size;
  style.color = to_color(color);
  style.outline = {30, 20, 12, 255};
  return chosen.empty() ? nullptr : render::make_point_item(places, chosen, style);
}

render::Mark dot(const Vec3& place, render::MarkShape shape, float size) {
  render::Mark mark{to_glm(place), shape, size, to_color(colors::infinite_edge)};
  mark.outline_width = 1.5F;
  return mark;
}

/// Vertices where tagged edges end (darts) or meet otherwise than in pairs (corners), and pins.
std::vector<render::Mark> special_vertices(const PolyMesh& mesh) {
  std::map<Index, int> degree;
  for (const Crease& crease : mesh.tags.creases) {
    for (const Index vertex : crease.vertices) ++degree[vertex];
  }
  std::vector<render::Mark> marks;
  for (const auto& [vertex, edges] : degree) {
    if (vertex >= mesh.vertex_count() || edges == 2) continue;
    marks.push_back(edges == 1 ? dot(mesh.positions[vertex], render::MarkShape::Ring, 8)
                               : dot(mesh.positions[vertex], render::MarkShape::Disc, 8));
  }
  for (const Index pin : mesh.tags.pins) {
    if (pin < mesh.vertex_count()) marks.push_back(dot(mesh.positions[pin], render::MarkShape::Square, 9));
  }
  return marks;
}

QColor handle_color(ColourRole role, HandleState state) {
  if (state == HandleState::Active) return colors::accent;
  if (state == HandleState::Hovered) return colors::accent.lighter(125);
  switch (role) {
    case ColourRole::X:
    case ColourRole::Y:
    case ColourRole::Z: {
      const render::Color axis = render::AxisCrossOptions().colors.at(static_cast<std::size_t>(role));
      return {axis.r, axis.g, axis.b};
    }
    case ColourRole::Centre: return {70, 76, 88};
    case ColourRole::View: return {110, 118, 130};
    case ColourRole::Faint: break;
  }
  return {160, 166, 176};
}

}  // namespace

SeenThrough MeshOverlay::edges(const MeshTool& tool, std::vector<render::StyledEdge> styled) {
  if (styled.empty()) return {};
  SeenThrough lines;
  lines.clear = render::make_edge_item(tool.editable().mesh()->positions, styled);
  if (styled.size() > edges_at_most) return lines;
  for (render::StyledEdge& edge : styled) edge.color.a = covered_alpha;
  lines.faint = render::make_edge_item(tool.editable().mesh()->positions, styled, render::LineDepth::OnTop);
  return lines;
}

void MeshOverlay::follow(MeshTool& tool, const ComponentSelection& selection, const WorkObject* object,
                         const render::MeshItemPtr& cage, bool shows_cage) {
  *this = MeshOverlay();
  if (object == nullptr || !object->visible || object->cage != tool.editable().node()) return;
  if (!tool.editable().mesh() || !object->cage_mesh) return;  // still being computed
  const bool editing = tool.selection().mode() != MeshMode::Object;
  const bool cage_seen =
      (editing && shows_cage) || object->shown() == object->cage_mesh || object->view == ChainView::Both;
  if (cage_seen) show_tags(tool, *object);
  if (cage_seen && object->shown() != object->cage_mesh) show_chains(*object);
  if (editing) show_selection(tool, selection, cage);
  follow_hover(tool, cage);
}

void MeshOverlay::show_tags(MeshTool& tool, const WorkObject& object) {
  const PolyMesh& mesh = *object.cage_mesh;
  if (mesh.tags.empty()) return;
  const MeshTopology& topology = *tool.editable().topology();
  const std::vector<double>& sharpness = tool.editable().edge_sharpness();
  std::vector<render::StyledEdge> colored;
  for (const Index edge : tagged_edges(mesh.tags, topology)) {
    colored.push_back({topology.edge_vertices(edge), render::sharpness_color(sharpness[edge]),
                       render::sharpness_width(sharpness[edge])});
  }
  tags_ = edges(tool, std::move(colored));
  dots_ = marks_of(special_vertices(mesh));
}

void MeshOverlay::show_chains(const WorkObject& object) {
  if (!object.result) return;
  const auto found = object.result->outputs.find("chains");
  if (found == object.result->outputs.end()) return;
  const render::LineStyle style{2.5, to_color(colors::infinite_edge), {}, render::LineDepth::Tested};
  chains_ = lines_of(found->second.get<PolyMesh>(), style);
}

void MeshOverlay::show_selection(MeshTool& tool, const ComponentSelection& selection, const render::MeshItemPtr& cage) {
  const std::vector<Vec3>& places = tool.editable().mesh()->positions;
  if (tool.selection().mode() == MeshMode::Vertex && places.size() <= points_at_most) {
    render::PointStyle style;
    style.size = 5;
    style.color = to_color(colors::vertex);
    style.outline = {250, 250, 250, 220};
    vertices_ = render::make_point_item(places, style);
  }
  if (selection.node != tool.editable().node() || selection.empty()) return;
  const MeshTopology& topology = *tool.editable().topology();
  const ComponentKind kind = selection.kind;
  if (kind == ComponentKind::Vertex) selected_vertices_ = points(places, selection.elements, colors::accent, 9);
  if (kind == ComponentKind::Edge) {
    show_selected_edges(tool, topology, selection.elements, selected_width);
  }
  if (kind == ComponentKind::Face) {
    Elements rim;
    if (selection.elements.size() <= rims_at_most) {
      rim = converted(topology, ComponentKind::Face, ComponentKind::Edge, selection.elements);
    }
    show_selected_edges(tool, topology, rim, face_rim_width);
    if (cage) faces_.push_back(render::make_face_highlight(cage, selection.elements, to_color(colors::selected_face)));
  }
  for (const Index vertex : converted(topology, kind, ComponentKind::Vertex, selection.elements)) {
    selection_bounds_.add(to_glm(places[vertex]));
  }
}

void MeshOverlay::show_selected_edges(const MeshTool& tool, const MeshTopology& topology, const Elements& chosen,
                                      float width) {
  selected_edges_ = edges(tool, styled(topology, chosen, to_color(colors::accent), width));
  if (chosen.empty() || chosen.size() > edges_at_most) return;
  selected_casing_ =
      render::make_edge_item(tool.editable().mesh()->positions,
                             styled(topology, chosen, to_color(colors::selected_casing), width + 2 * casing_width));
}

void MeshOverlay::follow_hover(MeshTool& tool, const render::MeshItemPtr& cage) {
  hovered_edge_ = {};
  hovered_vertex_.reset();
  hovered_face_.reset();
  cut_.reset();
  if (!tool.editable().mesh()) return;
  const MeshPreview& preview = tool.preview();
  if (preview.cut) {
    cut_ = render::make_line_item(path_of(preview.cut->points, to_glm, preview.cut->closed),
                                  {3, to_color(colors::hover), {}, render::LineDepth::OnSurface});
    return;
  }
  if (!preview.hovered) return;
  const std::vector<Index> chosen{preview.hovered->element};
  switch (tool.selection().mode()) {
    case MeshMode::Vertex:
      hovered_vertex_ = points(tool.editable().mesh()->positions, chosen, colors::hover, 11);
      break;
    case MeshMode::Edge:
      hovered_edge_ = edges(tool, styled(*tool.editable().topology(), chosen, to_color(colors::hover), hovered_width));
      break;
    case MeshMode::Face: {
      const Elements rim = converted(*tool.editable().topology(), ComponentKind::Face, ComponentKind::Edge, chosen);
      hovered_edge_ = edges(tool, styled(*tool.editable().topology(), rim, to_color(colors::hover), 3));
      if (cage) hovered_face_ = render::make_face_highlight(cage, chosen, to_color(colors::hover, 70));
      break;
    }
    case MeshMode::Object: break;
  }
}

void MeshOverlay::add_to(render::Scene& scene, bool with_chains) const {
  add_items(scene, {with_chains ? chains_ : nullptr, tags_.faint, selected_edges_.faint, hovered_edge_.faint,
                    tags_.clear, selected_casing_, selected_edges_.clear, hovered_edge_.clear, cut_});
  for (const render::PointItemPtr& item : {vertices_, selected_vertices_, hovered_vertex_}) {
    if (item) scene.points.push_back(item);
  }
  const auto is_shown = [&](const render::FaceHighlightPtr& highlight) {
    return std::ranges::any_of(scene.meshes, [&](const auto& mesh) { return mesh.item == highlight->mesh; });
  };
  for (const render::FaceHighlightPtr& highlight : faces_) {
    if (highlight && is_shown(highlight)) scene.highlights.push_back(highlight);
  }
  if (hovered_face_ && is_shown(hovered_face_)) scene.highlights.push_back(hovered_face_);
  add_items(scene, {}, {dots_});
}

void add_handles(const ManipulatorPicture& picture, render::Scene& scene) {
  for (const ManipulatorLine& line : picture.lines) {
    if (line.points.size() < 2) continue;
    const double width = line.state == HandleState::Normal ? 2.2 : 3.4;
    const QColor color = handle_color(line.role, line.state);
    add_items(scene,
              {lines_of({path_of(line.points, to_glm)}, {line.filled ? width * 2 : width, to_color(color), {}})});
  }
  std::vector<render::Mark> marks;
  for (const ManipulatorDot& handle : picture.dots) {
    marks.push_back({to_glm(handle.place), handle.square ? render::MarkShape::Square : render::MarkShape::Disc,
                     static_cast<float>(handle.pixels), to_color(handle_color(handle.role, handle.state))});
  }
  add_items(scene, {}, {marks_of(marks)});
}

}  // namespace croquis::app
