// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "app/files/file_reader.h"
#include "app/studio/studio.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/joined_meshes.h"
#include "croquis/geometry/mesh_report.h"
#include "step/step_file.h"

namespace croquis::app {

/// Which meshes go into a file.
struct MeshExport {
  enum class Objects { Picked, Visible, All };  ///< Picked: the active one where none is

  Objects objects = Objects::Picked;
  std::string unit = {};  ///< "mm", "cm", "m" or "in" that lengths of the file have; empty: those of the document
};

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

/// Writes a solid as a STEP file, one at a time.
class StepExport : public FileThread {
  Q_OBJECT

 public:
  /// Nothing while one is being written.
  void start(std::shared_ptr<const Brep> solid, const StepOptions& options, const QString& path);

 signals:
  void finished(const QString& path);
  void failed(const croquis::Findings& findings);  ///< none: it was cancelled, and nothing is written
};

/// The surfaces of these objects as they are shown, where they stand, by their names.
/// @throws Error (E_EMPTY) where one isn't finished, or there is none
std::vector<NamedMesh> meshes_of(const Studio& studio, const MeshExport& wanted);

/// These surfaces as one mesh; a single one that stays as it is is that mesh itself.
std::shared_ptr<const PolyMesh> exported_mesh(const Studio& studio, const MeshExport& wanted);

/// By how much coordinates are multiplied on the way out, for the unit.
double export_scale(const Studio& studio, const MeshExport& wanted);

/// These surfaces as one file, in the format of the name's extension.
/// @return what the format can't hold
Findings export_solid(const Studio& studio, const QString& path, const MeshExport& wanted = {});

/// The operations whose results are files of their own and stand in no view.
std::vector<const OperationDescription*> result_exports(const Studio& studio);

/// What one of these makes of a value of the active object's chain: its attribute network, say.
/// @return what the operation warns of
Findings export_result(const Studio& studio, const OperationDescription& operation, const QString& path);

/// Whether there is such a value, computed to the end.
bool can_export(const Studio& studio, const OperationDescription& operation);

/// The active object's faces as they are, of solids made from a drawing in perspective; null while it isn't finished,
/// and of other objects.
std::shared_ptr<const Brep> exact_solid(const Studio& studio);

/// Begins to write it as STEP, in the drawing's unit; the writer reports the end.
/// @throws Error (E_EMPTY) without one
void export_step(const Studio& studio, const QString& path, StepExport& writer);

/// The drawing as SVG.
void export_drawing(const Studio& studio, const QString& path);

}  // namespace croquis::app
