// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace croquis {

/// What a mesh is made of, as people select it.
enum class ComponentKind { Vertex, Edge, Face };

inline constexpr std::array<ComponentKind, 3> component_kinds = {ComponentKind::Vertex, ComponentKind::Edge,
                                                                 ComponentKind::Face};

/// "vertex", "edge", "face".
constexpr const char* singular(ComponentKind kind) {
  if (kind == ComponentKind::Vertex) return "vertex";
  return kind == ComponentKind::Edge ? "edge" : "face";
}

/// "vertices", "edges", "faces".
constexpr const char* plural(ComponentKind kind) {
  if (kind == ComponentKind::Vertex) return "vertices";
  return kind == ComponentKind::Edge ? "edges" : "faces";
}

/// The kind with that singular, or none.
constexpr std::optional<ComponentKind> kind_of_singular(std::string_view word) {
  for (const ComponentKind kind : component_kinds) {
    if (word == singular(kind)) return kind;
  }
  return std::nullopt;
}

/// The kind with that plural, or none.
constexpr std::optional<ComponentKind> kind_of_plural(std::string_view word) {
  for (const ComponentKind kind : component_kinds) {
    if (word == plural(kind)) return kind;
  }
  return std::nullopt;
}

}  // namespace croquis
