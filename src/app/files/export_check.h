// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include <Eigen/Geometry>

#include "croquis/geometry/mesh_report.h"

namespace croquis::app {

/// A mesh looked at before it is written.
struct ExportCheck {
  MeshReport figures;            ///< with self-intersections
  std::optional<Finding> doubt;  ///< that it isn't closed or crosses itself, and the faces or edges to look at …
  Eigen::AlignedBox3d where;     ///< … and their bounds
};

/// @throws Error, Cancelled
ExportCheck check_export(const PolyMesh& mesh, Progress& progress);

/// "closed, 812 faces, 62 × 40 × 31 mm".
QString summary_of(const MeshReport& figures, const QString& unit);

}  // namespace croquis::app
