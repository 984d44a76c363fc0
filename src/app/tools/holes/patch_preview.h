// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/holes/hole_rows.h"
#include "app/views/live_item.h"
#include "app/views/patch_surface.h"

namespace croquis::app {

/// How open holes would be filled, kept computed beside the document: nothing of it is in there.
class PatchPreview : public QObject {
  Q_OBJECT

 public:
  PatchPreview(Studio& studio, QThreadPool& threads, QObject* parent);

  /// Shows the patches that these holes would get. @param node of the operation; 0 or no holes: nothing
  void show(NodeId node, std::vector<Index> holes);

  /// After the document has changed.
  void follow();

  const render::MeshItemPtr& item() const { return item_.item(); }
  const std::vector<Index>& holes() const { return holes_; }
  const PatchSurface& patches() const { return patches_; }    ///< that item() shows
  const std::vector<HoleRow>& rows() const { return rows_; }  ///< of the result with them
  bool busy() const { return (live_ && live_->busy()) || item_.busy(); }

  /// Milliseconds from the last request to the patches that answered it.
  double last_latency_ms() const { return latency_ms_; }

 signals:
  void changed();

 private:
  void take();
  void forget();

  Studio& studio_;
  LiveItem item_;
  NodeId node_ = 0;
  std::vector<Index> holes_;
  QElapsedTimer since_;
  double latency_ms_ = 0;
  std::shared_ptr<const Evaluation> shown_;
  PatchSurface patches_;
  std::vector<HoleRow> rows_;
  std::unique_ptr<LiveNode> live_;  ///< last: its jobs use all of the above
};

}  // namespace croquis::app
