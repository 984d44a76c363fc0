// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/parameter_list.h"
#include "croquis/edits/edit.h"
#include "croquis/mesh_editing/tag_edit.h"

namespace croquis {
namespace {

constexpr double unlimited_value = std::numeric_limits<double>::infinity();

/// What people set of edits; each lists its own.
struct EditValues {
  std::optional<Vec3> by, axis, about, factors;
  double distance = 0, width = 0;  ///< model units
  double angle = std::numbers::pi / 2;
  double at = 0.5;  ///< share of an edge
  double sharpness = greatest_sharpness;
  bool pinned = true;
};

/// Three numbers, "0,0,1"; none in an empty text.
std::optional<Vec3> read_vector(const std::string& name, const std::string& text) {
  if (text.empty()) return std::nullopt;
  Vec3 vector = Vec3::Zero();
  const char* at = text.data();
  const char* end = at + text.size();
  bool sound = true;
  for (int axis = 0; axis < 3 && sound; ++axis) {
    if (axis > 0) sound = at != end && *at++ == ',';
    if (!sound) break;
    const auto [stopped, error] = std::from_chars(at, end, vector[axis]);
    sound = error == std::errc{} && is_usable_number(vector[axis]);
    at = stopped;
  }
  if (!sound || at != end) throw Error(refused_value(name, text, "three numbers, such as 0,0,1"));
  return vector;
}

ParameterList& list_vector(ParameterList& list, const std::string& name, std::optional<Vec3>& value,
                           const std::string& usual, const std::string& sentence) {
  return list.text(name, usual, sentence, [name, &value](const std::string& text) { value = read_vector(name, text); });
}

void list_nothing(EditValues&, ParameterList&) {}

Edit edit_of(EditDescription description, ListParameters<EditValues> list_parameters,
             MeshEdit (*apply)(const EditInput&, const EditValues&)) {
  description.parameters = parameters_of(list_parameters);
  return {std::move(description), [=](const EditInput& input, const ParameterValues& parameters) {
            return apply(input, settings_of(list_parameters, parameters));
          }};
}

/// The mesh as it is: everything comes from itself.
MeshEdit with_same_elements(PolyMesh mesh) {
  MeshEdit edit;
  edit.mesh = std::move(mesh);
  edit.vertex_source = all_elements(edit.mesh.vertex_count());
  edit.face_source = all_elements(edit.mesh.face_count());
  return edit;
}

Elements vertices_of(const EditInput& input) {
  return converted(input.topology, input.kind, ComponentKind::Vertex, input.elements);
}

MeshEdit with_vertices_moved(const EditInput& input, const Eigen::Affine3d& map) {
  return with_same_elements(transformed(input.mesh, vertices_of(input), map));
}

/// The point given, else the mean of the elements' vertices.
Vec3 pivot_of(const EditInput& input, const EditValues& values) {
  if (values.about) return *values.about;
  const Elements vertices = vertices_of(input);
  Vec3 sum = Vec3::Zero();
  for (const Index vertex : vertices) sum += input.mesh.positions[vertex];
  return sum / static_cast<double>(vertices.size());
}

std::vector<ComponentKind> any_kind() { return {ComponentKind::Vertex, ComponentKind::Edge, ComponentKind::Face}; }

Edit move_edit() {
  return edit_of(
      {"move", "Move", "Moves vertices, or those of edges and faces.", any_kind(), {}},
      [](EditValues& values, ParameterList& list) {
        list_vector(list, "by", values.by, "0,0,0", "How far, along x, y and z, in model units.").titled("By x, y, z");
      },
      [](const EditInput& input, const EditValues& values) {
        const Eigen::Translation3d along(values.by.value_or(Vec3::Zero()));
        return with_vertices_moved(input, Eigen::Affine3d(along));
      });
}

Edit rotate_edit() {
  return edit_of(
      {"rotate", "Rotate", "Rotates vertices, or those of edges and faces, about a point.", any_kind(), {}},
      [](EditValues& values, ParameterList& list) {
        list_vector(list, "axis", values.axis, "0,0,1", "The axis; its length doesn't matter.").titled("Axis x, y, z");
        list.angle("degrees", values.angle, -3600, 3600, "The angle, counter-clockwise seen against the axis.")
            .titled("Angle");
        list_vector(list, "about", values.about, "", "A point on the axis; if not given, the mean of the vertices.")
            .titled("About x, y, z");
      },
      [](const EditInput& input, const EditValues& values) {
        const Vec3 axis = values.axis.value_or(Vec3::UnitZ());
        if (axis.isZero(0))
          throw Error(make_error(Category::Usage, "E_INPUT", "The axis of the rotation has no length"));
        const Vec3 about = pivot_of(input, values);
        Eigen::Affine3d map = Eigen::Affine3d::Identity();
        map.translate(about).rotate(Eigen::AngleAxisd(values.angle, axis.normalized())).translate(-about);
        return with_vertices_moved(input, map);
      });
}

Edit scale_edit() {
  return edit_of(
      {"scale", "Scale", "Scales vertices, or those of edges and faces, from a point.", any_kind(), {}},
      [](EditValues& values, ParameterList& list) {
        list_vector(list, "factors", values.factors, "1,1,1", "The factors along x, y and z.").titled("Times x, y, z");
        list_vector(list, "about", values.about, "", "The point that stays; if not given, the mean of the vertices.")
            .titled("About x, y, z");
      },
      [](const EditInput& input, const EditValues& values) {
        const Vec3 about = pivot_of(input, values);
        Eigen::Affine3d map = Eigen::Affine3d::Identity();
        map.translate(about).scale(values.factors.value_or(Vec3::Ones())).translate(-about);
        return with_vertices_moved(input, map);
      });
}

Edit extrude_edit() {
  return edit_of(
      {"extrude",
       "Extrude",
       "Lifts faces off and joins them to where they were by walls.",
       {ComponentKind::Face},
       {},
       EditStart{"distance", 0.1}},
      [](EditValues& values, ParameterList& list) {
        list_vector(list, "by", values.by, "",
                    "How far, along x, y and z, in model units; if not given, `distance` counts.")
            .titled("By x, y, z");
        list.number("distance", values.distance, -unlimited_value, unlimited_value, "model units",
                    "How far along the mean normal of the faces; not used where `by` is given.");
      },
      [](const EditInput& input, const EditValues& values) {
        if (!values.by && values.distance == 0)
          throw Error(
              make_error(Category::Usage, "E_INPUT", "Give `by` or `distance`: how far the faces are extruded"));
        const Vec3 along = values.distance * mean_normal(input.mesh, input.elements);
        return extrude_faces(input.mesh, input.topology, input.elements, values.by.value_or(along));
      });
}

Edit inset_edit() {
  return edit_of(
      {"inset",
       "Inset",
       "Draws the border of faces inwards and fills the strip between with quads.",
       {ComponentKind::Face},
       {},
       EditStart{"width", 0.1}},
      [](EditValues& values, ParameterList& list) {
        list.number("width", values.width, 0, unlimited_value, "model units", "Width of the strip.");
      },
      [](const EditInput& input, const EditValues& values) {
        return inset_faces(input.mesh, input.topology, input.elements, values.width);
      });
}

Edit loop_cut_edit() {
  return edit_of(
      {"loop-cut",
       "Loop cut",
       "Cuts the quads that lie opposite to each other across an edge, all around.",
       {ComponentKind::Edge},
       {}},
      [](EditValues& values, ParameterList& list) {
        list.number("at", values.at, 0, 1, "share of the edge", "Where the edge is cut, from its first vertex.");
      },
      [](const EditInput& input, const EditValues& values) {
        if (input.elements.size() != 1)
          throw Error(
              make_error(Category::Usage, "E_INPUT",
                         "A loop is cut from one edge, and " + std::to_string(input.elements.size()) + " are given"));
        return loop_cut(input.mesh, input.topology, input.elements.front(), values.at);
      });
}

Edit dissolve_edit() {
  return edit_of({"dissolve",
                  "Dissolve",
                  "Removes edges or vertices and makes one face of those around each.",
                  {ComponentKind::Edge, ComponentKind::Vertex},
                  {}},
                 list_nothing, [](const EditInput& input, const EditValues&) {
                   return input.kind == ComponentKind::Edge
                              ? dissolve_edges(input.mesh, input.topology, input.elements)
                              : dissolve_vertices(input.mesh, input.topology, input.elements);
                 });
}

Edit delete_edit() {
  return edit_of({"delete", "Delete", "Removes faces, and the vertices that only they had.", {ComponentKind::Face}, {}},
                 list_nothing, [](const EditInput& input, const EditValues&) {
                   return delete_faces(input.mesh, input.topology, input.elements);
                 });
}

Edit sharpness_edit() {
  return edit_of(
      {"sharpness", "Sharpen", "Tags edges, so that subdivision keeps them sharp.", {ComponentKind::Edge}, {}},
      [](EditValues& values, ParameterList& list) {
        list.number("value", values.sharpness, 0, unlimited_value, "levels",
                    "For how many levels edges stay sharp; 0 removes their tags, from 10 on they stay sharp.")
            .titled("Sharp for");
      },
      [](const EditInput& input, const EditValues& values) {
        MeshEdit edit = with_same_elements(input.mesh);
        edit.mesh.tags = with_sharpness(input.mesh.tags, input.topology, input.elements, values.sharpness);
        return edit;
      });
}

Edit pin_edit() {
  return edit_of(
      {"pin",
       "Pin",
       "Pins vertices, so that subdivision keeps them where they are, or lets them go.",
       {ComponentKind::Vertex},
       {}},
      [](EditValues& values, ParameterList& list) {
        list.flag("pinned", values.pinned, "false lets the vertices go.");
      },
      [](const EditInput& input, const EditValues& values) {
        MeshEdit edit = with_same_elements(input.mesh);
        edit.mesh.tags = with_pins(input.mesh.tags, input.elements, values.pinned);
        return edit;
      });
}

}  // namespace

const std::vector<Edit>& all_edits() {
  static const std::vector<Edit> edits = {move_edit(),      rotate_edit(),   scale_edit(),    extrude_edit(),
                                          inset_edit(),     loop_cut_edit(), dissolve_edit(), delete_edit(),
                                          sharpness_edit(), pin_edit()};
  return edits;
}

const Edit* find_edit(std::string_view id) {
  const auto found = std::ranges::find_if(all_edits(), [&](const Edit& edit) { return edit.description.id == id; });
  return found == all_edits().end() ? nullptr : &*found;
}

}  // namespace croquis
