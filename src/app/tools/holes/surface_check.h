// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstddef>
#include <memory>
#include <optional>

#include "app/tools/background_job.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::app {

/// What a check of a filled mesh finds, in the view in which holes are found and filled: vertices at one place are one.
struct CheckedSurface {
  std::size_t open_edges = 0;         ///< of one face …
  std::size_t seam_edges = 0;         ///< … and those that only vertices at equal places close
  std::size_t nonmanifold_edges = 0;  ///< of more than two
  std::size_t intersections = 0;      ///< pairs in which patches take part; of a remeshed model, all
  bool has_patches = true;            ///< else it was remeshed
  bool outside_unchanged = true;      ///< the scan's vertices and faces come first, digit by digit
  bool trimmed = false;               ///< all but the faces that were taken off along rims

  bool is_sound() const {
    return nonmanifold_edges == 0 && intersections == 0 && (outside_unchanged || trimmed || !has_patches);
  }
};

/// What was left open by choice: its edges are expected.
struct LeftOpen {
  std::size_t borders = 0;
  std::size_t holes = 0;         ///< that aren't borders …
  std::size_t failed = 0;        ///< … of which these were to be filled
  std::size_t border_edges = 0;  ///< of the scan
  std::size_t hole_edges = 0;
};

/// @param scan that was filled by patches; null: the model was remeshed
/// @throws Error, Cancelled
CheckedSurface check_surface(const PolyMesh& filled, const PolyMesh* scan, Progress& progress);

/// "closed, manifold, 0 new intersections, outside unchanged", or what is wrong; a scan's own intersections aren't new.
/// Where something was left open on purpose: "open at its outer border (204 edges), otherwise sound: manifold, …".
/// Where vertices lie on others: "closed but for seams (72 edges): merge the vertices of the scan, manifold, …".
QString sentence_of(const CheckedSurface& checked, const LeftOpen& left);

/// No worse than was asked for: sound, and no edge is open but those left so.
bool is_as_wanted(const CheckedSurface& checked, const LeftOpen& left);

/// Checks the newest filled mesh on another thread, once nothing has changed for a moment.
class SurfaceCheck : public QObject {
  Q_OBJECT

 public:
  explicit SurfaceCheck(QObject* parent);

  /// Null meshes: there is nothing to be checked. The same ones as before: what was found stays.
  void follow(std::shared_ptr<const PolyMesh> filled, std::shared_ptr<const PolyMesh> scan);

  const std::optional<CheckedSurface>& found() const { return found_; }
  bool busy() const { return filled_ != nullptr && !found_; }

 signals:
  void changed();

 private:
  void begin();

  std::shared_ptr<const PolyMesh> filled_;
  std::shared_ptr<const PolyMesh> scan_;
  std::optional<CheckedSurface> found_;
  QTimer pause_;
  BackgroundJob job_;
};

}  // namespace croquis::app
