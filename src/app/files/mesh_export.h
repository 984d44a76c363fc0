// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <atomic>
#include <memory>
#include <optional>

#include <Eigen/Geometry>

#include "croquis/base/finding.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/mesh_report.h"
#include "step/step_file.h"

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

/// Writes a solid as a STEP file on another thread, one at a time.
class StepExport : public QObject {
  Q_OBJECT

 public:
  StepExport();
  ~StepExport() override;

  /// Nothing while one is being written.
  void start(std::shared_ptr<const Brep> solid, StepOptions options, const QString& path);

  /// Nothing is written then.
  void cancel() { *cancelled_ = true; }

  bool busy() const { return busy_; }

 signals:
  void finished(const QString& path);
  void failed(const croquis::Findings& findings);  ///< none: it was cancelled
  void progress_changed(double fraction, const QString& step);
  void busy_changed(bool busy);

 private:
  void take(const QString& path, bool written, const Findings& findings);

  bool busy_ = false;
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  QThreadPool thread_;
};

}  // namespace croquis::app
