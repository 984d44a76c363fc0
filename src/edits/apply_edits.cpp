// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/edits/apply_edits.h"

#include <string>
#include <utility>

#include "croquis/base/error.h"

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

}  // namespace

MeshEdit apply_edit(const PolyMesh& mesh, const MeshTopology& topology, const EditLine& line,
                    const EditRegistry& registry) {
  const Edit* edit = registry.find(line.edit);
  if (edit == nullptr) {
    throw Error(make_error(Category::Usage, "E_EDIT", "There is no edit '" + line.edit + "'."));
  }
  const Elements elements = existing_elements(line, topology);
  if (elements.empty()) {
    throw Error(make_error(Category::Usage, "E_EDIT",
                           "'" + to_text(line) + "': the mesh has no " + plural(line.target.kind) + "."));
  }
  return edit->apply(mesh, topology, line.target.kind, elements,
                     complete(edit->describe().parameters, line.parameters));
}

EditedMesh apply_edits(PolyMesh mesh, std::span<const EditLine> lines, const EditRegistry& registry,
                       Progress& progress) {
  EditedMesh begun;
  begun.vertex_source = all_elements(mesh.vertex_count());
  begun.face_source = all_elements(mesh.face_count());
  begun.mesh = std::move(mesh);
  return apply_edits(std::move(begun), lines, registry, progress);
}

EditedMesh apply_edits(EditedMesh result, std::span<const EditLine> lines, const EditRegistry& registry,
                       Progress& progress) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    progress.check();
    MeshEdit step = apply_edit(result.mesh, MeshTopology(result.mesh), lines[i], registry);
    result.vertex_source = composed(result.vertex_source, step.vertex_source);
    result.face_source = composed(result.face_source, step.face_source);
    result.mesh = std::move(step.mesh);
    for (Finding& finding : step.lost) result.warnings.push_back(std::move(finding));
    progress.report(static_cast<double>(i + 1) / static_cast<double>(lines.size()));
  }
  return result;
}

}  // namespace croquis
