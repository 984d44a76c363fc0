// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace croquis {

/// What a mesh is made of, as people select it.
enum class ComponentKind { Vertex, Edge, Face };

}  // namespace croquis
