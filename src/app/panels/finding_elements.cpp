// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/finding_elements.h"

#include <optional>
#include <utility>

#include "croquis/mesh_editing/tag_edit.h"

namespace croquis::app {
namespace {

std::optional<ComponentKind> kind_of(SubjectKind kind) {
  switch (kind) {
    case SubjectKind::Vertex: return ComponentKind::Vertex;
    case SubjectKind::Edge: return ComponentKind::Edge;
    case SubjectKind::Face: return ComponentKind::Face;
    default: return std::nullopt;
  }
}

/// Its number among the mesh's elements, or no_index when it isn't there.
Index element_of(const Subject& subject, ComponentKind kind, const MeshTopology& topology) {
  const auto below = [](std::int64_t number, std::size_t count) {
    return number >= 0 && static_cast<std::size_t>(number) < count;
  };
  if (subject.vertices) {
    const auto [a, b] = *subject.vertices;
    const bool inside = below(a, topology.vertex_count()) && below(b, topology.vertex_count());
    return inside ? find_edge(topology, static_cast<Index>(a), static_cast<Index>(b)) : no_index;
  }
  const bool inside = subject.index && below(*subject.index, element_count(topology, kind));
  return inside ? static_cast<Index>(*subject.index) : no_index;
}

}  // namespace

std::vector<std::string> strokes_of(const Finding& finding) {
  std::vector<std::string> strokes;
  for (const Subject& subject : finding.subjects) {
    if (subject.kind == SubjectKind::Stroke) strokes.push_back(subject.id);
  }
  return strokes;
}

std::vector<Index> holes_of(const Finding& finding) {
  std::vector<Index> holes;
  for (const Subject& subject : finding.subjects) {
    if (subject.kind == SubjectKind::Hole && subject.index) holes.push_back(static_cast<Index>(*subject.index));
  }
  return sorted_unique(std::move(holes));
}

PickedElements elements_of(const Finding& finding, const MeshTopology& topology) {
  PickedElements found;
  for (const Subject& subject : finding.subjects) {
    const auto kind = kind_of(subject.kind);
    if (!kind || (!found.elements.empty() && *kind != found.kind)) continue;
    const Index element = element_of(subject, *kind, topology);
    if (element == no_index) continue;
    found.kind = *kind;
    found.elements.push_back(element);
  }
  found.elements = sorted_unique(std::move(found.elements));
  return found;
}

}  // namespace croquis::app
