// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <memory>

#include "croquis/tools/holes/hole_pins.h"
#include "croquis/tools/mesh/mesh_pick.h"

namespace croquis::app {

/// Finds which holes a scan itself hides in a view. What that needs is made on another thread.
class HoleSightMaker : public QObject {
  Q_OBJECT

 public:
  explicit HoleSightMaker(QObject* parent);
  ~HoleSightMaker() override;

  /// Null: nothing hides anything.
  void follow(const std::shared_ptr<const PolyMesh>& scan);

  /// Empty before it is ready.
  HoleSight sight() const;

 signals:
  void changed();

 private:
  std::shared_ptr<const PolyMesh> scan_;
  std::shared_ptr<MeshPicker> picker_;
  QThreadPool thread_;
};

}  // namespace croquis::app
