// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/edits/apply_edits.h"

#include <cmath>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/bounds.h"
#include "croquis/implicit/point_tree.h"

namespace croquis {
namespace {

SubjectKind subject_of(ComponentKind kind) {
  if (kind == ComponentKind::Vertex) return SubjectKind::Vertex;
  return kind == ComponentKind::Edge ? SubjectKind::Edge : SubjectKind::Face;
}

/// The target's elements, sorted, each once.
Elements existing_elements(const EditLine& line, const MeshTopology& topology) {
  const ComponentKind kind = line.target.kind;
  const std::size_t count = element_count(topology, kind);
  if (line.target.all) return all_elements(count);
  Elements elements = sorted_unique(line.target.elements);
  if (elements.empty() || elements.back() < count) return elements;
  const std::string number = std::to_string(elements.back());
  throw Error(make_error(Category::Usage, "E_EDIT",
                         "'" + to_text(line) + "': there is no " + singular(kind) + ' ' + number + ", only " +
                             std::to_string(count) + ' ' + plural(kind) + ", counted from 0.",
                         {numbered_subject(subject_of(kind), elements.back())}));
}

/// What comes from where, through one more edit.
std::vector<Index> composed(const std::vector<Index>& before, const std::vector<Index>& step) {
  std::vector<Index> sources(step.size(), no_index);
  for (std::size_t i = 0; i < step.size(); ++i) {
    if (step[i] != no_index) sources[i] = before[step[i]];
  }
  return sources;
}

Vec3 mean_place(const PolyMesh& mesh, std::span<const Index> vertices) {
  Vec3 sum = Vec3::Zero();
  for (const Index vertex : vertices) sum += mesh.positions[vertex];
  return sum / static_cast<double>(vertices.size());
}

Vec3 place_of(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind, Index element) {
  if (kind == ComponentKind::Vertex) return mesh.positions[element];
  if (kind == ComponentKind::Edge) return mean_place(mesh, topology.edge_vertices(element));
  return mean_place(mesh, mesh.face(element));
}

/// The element of each place's nearest one.
Elements nearest_elements(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind,
                          const std::vector<Vec3>& places) {
  std::vector<Vec3> known;
  for (const Index element : all_elements(element_count(topology, kind))) {
    known.push_back(place_of(mesh, topology, kind, element));
  }
  const implicit::PointTree tree(known);
  Elements elements;
  for (const Vec3& place : places) {
    const Index element = tree.nearest(place);
    if (element != no_index) elements.push_back(element);
  }
  return sorted_unique(std::move(elements));
}

constexpr int most_halvings = 10;

/// The diagonal of the box around the elements; of all vertices where that has no size.
double size_of(const PolyMesh& mesh, const MeshTopology& topology, const EditTarget& target) {
  const auto diagonal = [](const PolyMesh& part) {
    const BoundingBox box = bounds_of(part);
    return box ? ((*box)[1] - (*box)[0]).norm() : 0;
  };
  if (target.all) return diagonal(mesh);
  PolyMesh part;
  for (const Index vertex : converted(topology, target.kind, ComponentKind::Vertex, sorted_unique(target.elements))) {
    part.positions.push_back(mesh.positions[vertex]);
  }
  const double own = diagonal(part);
  return own > 0 ? own : diagonal(mesh);
}

/// Two digits, as people would type it.
double rounded(double value) {
  if (!(value > 0)) return 0;
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::round(value / step) * step;
}

bool is_refused(const PolyMesh& mesh, const MeshTopology& topology, const EditLine& line) {
  try {
    apply_edit(mesh, topology, line);
  } catch (const Error&) {
    return true;
  }
  return false;
}

}  // namespace

MeshEdit apply_edit(const PolyMesh& mesh, const MeshTopology& topology, const EditLine& line) {
  const Edit* edit = find_edit(line.edit);
  if (edit == nullptr) {
    throw Error(make_error(Category::Usage, "E_EDIT", "There is no edit '" + line.edit + "'."));
  }
  const Elements elements = existing_elements(line, topology);
  if (elements.empty()) {
    throw Error(make_error(Category::Usage, "E_EDIT",
                           "'" + to_text(line) + "': the mesh has no " + plural(line.target.kind) + "."));
  }
  return edit->apply({mesh, topology, line.target.kind, elements},
                     complete(edit->description.parameters, line.parameters));
}

EditedMesh apply_edits(PolyMesh mesh, std::span<const EditLine> lines, Progress& progress) {
  EditedMesh begun;
  begun.vertex_source = all_elements(mesh.vertex_count());
  begun.face_source = all_elements(mesh.face_count());
  begun.mesh = std::move(mesh);
  return apply_edits(std::move(begun), lines, progress);
}

EditedMesh apply_edits(EditedMesh result, std::span<const EditLine> lines, Progress& progress) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    progress.check();
    MeshEdit step = apply_edit(result.mesh, MeshTopology(result.mesh), lines[i]);
    result.vertex_source = composed(result.vertex_source, step.vertex_source);
    result.face_source = composed(result.face_source, step.face_source);
    result.mesh = std::move(step.mesh);
    for (Finding& finding : step.lost) result.warnings.push_back(std::move(finding));
    progress.report(static_cast<double>(i + 1) / static_cast<double>(lines.size()));
  }
  return result;
}

std::vector<EditLine> lines_by_position(PolyMesh before, PolyMesh now, std::span<const EditLine> lines,
                                        Progress& progress) {
  std::vector<EditLine> found;
  for (const EditLine& line : lines) {
    progress.check();
    const MeshTopology old_topology(before);
    const MeshTopology topology(now);
    // First: it refuses elements that aren't there.
    MeshEdit old_edit = apply_edit(before, old_topology, line);
    EditLine moved = line;
    std::vector<Vec3> places;
    for (const Index element : line.target.elements) {
      places.push_back(place_of(before, old_topology, line.target.kind, element));
    }
    moved.target.elements = nearest_elements(now, topology, line.target.kind, places);
    MeshEdit edit = apply_edit(now, topology, moved);
    before = std::move(old_edit.mesh);
    now = std::move(edit.mesh);
    found.push_back(std::move(moved));
    progress.report(static_cast<double>(found.size()) / static_cast<double>(lines.size()));
  }
  return found;
}

EditLine starting_line(const PolyMesh& mesh, const MeshTopology& topology, const Edit& edit, EditTarget target) {
  const EditDescription& description = edit.description;
  EditLine line{description.id, std::move(target), {}};
  if (!description.start) return line;
  double value = rounded(description.start->share * size_of(mesh, topology, line.target));
  line.parameters[description.start->parameter] = value;
  for (int k = 0; k < most_halvings && is_refused(mesh, topology, line); ++k) {
    value = rounded(value / 2);
    line.parameters[description.start->parameter] = value;
  }
  return line;
}

}  // namespace croquis
