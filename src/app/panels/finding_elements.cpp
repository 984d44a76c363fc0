// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/finding_elements.h"

#include <cctype>
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

/// All whole numbers in a text.
std::vector<Index> numbers_in(const std::string& text) {
  std::vector<Index> numbers;
  bool inside = false;
  for (const char c : text) {
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (digit && !inside) numbers.push_back(0);
    if (digit) numbers.back() = numbers.back() * 10 + static_cast<Index>(c - '0');
    inside = digit;
  }
  return numbers;
}

Index element_of(ComponentKind kind, const std::string& id, const MeshTopology& topology) {
  const std::vector<Index> numbers = numbers_in(id);
  if (numbers.empty()) return no_index;
  if (kind == ComponentKind::Edge && numbers.size() == 2) {
    const bool inside = numbers[0] < topology.vertex_count() && numbers[1] < topology.vertex_count();
    return inside ? find_edge(topology, numbers[0], numbers[1]) : no_index;
  }
  return numbers[0] < element_count(topology, kind) ? numbers[0] : no_index;
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
    if (subject.kind != SubjectKind::Hole) continue;
    for (const Index hole : numbers_in(subject.id)) holes.push_back(hole);
  }
  return sorted_unique(std::move(holes));
}

FoundElements elements_of(const Finding& finding, const MeshTopology& topology) {
  FoundElements found;
  for (const Subject& subject : finding.subjects) {
    const auto kind = kind_of(subject.kind);
    if (!kind || (!found.elements.empty() && *kind != found.kind)) continue;
    const Index element = element_of(*kind, subject.id, topology);
    if (element == no_index) continue;
    found.kind = *kind;
    found.elements.push_back(element);
  }
  found.elements = sorted_unique(std::move(found.elements));
  return found;
}

}  // namespace croquis::app
