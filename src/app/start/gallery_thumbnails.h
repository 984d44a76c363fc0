// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <thread>

#include "croquis/document/registry.h"

namespace croquis::app {

class OffscreenPictures;

/// Makes the samples solid or smooth, one after the other on another thread, and pictures of them. The window's thread
/// only shows these.
class GalleryThumbnails : public QObject {
  Q_OBJECT

 public:
  GalleryThumbnails(const Registry& registry, OffscreenPictures& pictures, QObject* parent);
  ~GalleryThumbnails() override;

  /// Goes on with those that have no picture yet.
  void start();

  /// Some samples have no picture yet, and it is being made.
  bool busy() const { return busy_; }

  /// Stops soon: files that are opened go first.
  void stop();

 signals:
  void finished(const QString& sample, const QImage& picture);

 private:
  void make_pictures(std::size_t first);
  QImage picture_of(const QString& sample);

  const Registry& registry_;
  OffscreenPictures& pictures_;
  std::size_t done_ = 0;
  bool busy_ = false;
  std::atomic<bool> stopped_{false};
  std::thread worker_;
};

}  // namespace croquis::app
