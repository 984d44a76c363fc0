// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <variant>

#include "croquis/base/report.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// What can travel along a link between two operations. Shared and immutable: passing one on copies a pointer.
using Value =
    std::variant<std::shared_ptr<const PolyMesh>, std::shared_ptr<const Drawing>, std::shared_ptr<const Report>>;

/// The alternatives of Value, in its order.
enum class ValueType { Mesh, Drawing, Report };

/// Values by port name.
using Values = std::map<std::string, Value>;

/// "mesh", "drawing", "report".
const char* to_string(ValueType type);

inline ValueType type_of(const Value& value) { return static_cast<ValueType>(value.index()); }

}  // namespace croquis
