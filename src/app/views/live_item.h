// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <memory>

#include "croquis/render/mesh_item.h"

class QThreadPool;

namespace croquis::app {

/// The renderer's item of a mesh that changes. Small meshes are made ready at once, large ones on another
/// thread; the newest wins, and meanwhile the item before it stays.
class LiveItem : public QObject {
  Q_OBJECT

 public:
  /// Given the mesh, what is to be drawn of it (other colours); runs on any thread.
  using Paint = std::function<std::shared_ptr<const PolyMesh>(const std::shared_ptr<const PolyMesh>&)>;

  /// @param threads outlives this
  explicit LiveItem(QThreadPool& threads) : threads_(threads) {}

  /// Null shows nothing.
  /// @param look number of the paint: the same mesh in another look is a new item
  void show(const std::shared_ptr<const PolyMesh>& mesh, const render::MeshItemOptions& options,
            const Paint& paint = nullptr, int look = 0);

  const render::MeshItemPtr& item() const { return item_; }
  const std::shared_ptr<const PolyMesh>& mesh() const { return made_of_; }  ///< what item() shows
  bool busy() const { return wanted_ != made_of_ || look_ != made_look_; }

 signals:
  void ready();  ///< a large mesh's item has come

 private:
  void begin();
  void take(const std::shared_ptr<const PolyMesh>& mesh, const render::MeshItemOptions& options, int look,
            const render::MeshItemPtr& item);

  QThreadPool& threads_;
  std::shared_ptr<const PolyMesh> wanted_;
  std::shared_ptr<const PolyMesh> made_of_;
  render::MeshItemOptions options_;
  Paint paint_;
  int look_ = 0;
  int made_look_ = 0;  ///< what item() shows it in
  render::MeshItemPtr item_;
  bool making_ = false;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< expires with this: later results are ignored
};

}  // namespace croquis::app
