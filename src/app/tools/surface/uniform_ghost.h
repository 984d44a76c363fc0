// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <memory>
#include <vector>

#include "app/tools/surface/shown_surface.h"
#include "croquis/attribute_surface/domain_comparison.h"
#include "croquis/attribute_surface/surface_measures.h"
#include "croquis/render/mesh_item.h"

namespace croquis::app {

/// The same network on uniform domains, beside the document: its surfaces as a ghost, and in numbers what the domains
/// make of points. Computed on another thread; the newest wins, and meanwhile what there is stays.
class UniformGhost : public QObject {
  Q_OBJECT

 public:
  UniformGhost();
  ~UniformGhost() override;

  bool on() const { return on_; }
  void set_on(bool on);

  /// After a result has come.
  void follow(const ShownSurface& shown);

  /// What was compared; null before the first time and while it is off.
  struct Compared {
    ShownSurface shown;  ///< with which
    DomainComparison comparison;
    SurfaceMeasures measures;  ///< of the uniform one
    render::MeshItemPtr item;  ///< in the world; null where there is no surface
  };
  const Compared* compared() const { return compared_.get(); }
  bool busy() const { return running_ != nullptr; }

 signals:
  void changed();

 private:
  void begin();
  void take(const std::shared_ptr<const Compared>& made);

  bool on_ = false;
  ShownSurface wanted_;
  std::shared_ptr<const Compared> compared_;
  std::shared_ptr<std::atomic<bool>> running_;  ///< set: it is to stop. Null: nothing runs
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
  QThreadPool thread_;
};

}  // namespace croquis::app
