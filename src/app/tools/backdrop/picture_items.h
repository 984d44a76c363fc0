// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <map>
#include <memory>

#include "croquis/geometry/picture_file.h"
#include "croquis/render/picture_item.h"

namespace croquis::app {

/// Pictures made ready for the renderer, beside the window's thread, for as long as somebody holds them.
class PictureItems : public QObject {
  Q_OBJECT

 public:
  PictureItems() { thread_.setMaxThreadCount(1); }
  ~PictureItems() override { thread_.waitForDone(); }

  /// Null while it is being made, and for a picture that can't be read.
  render::PictureItemPtr item(const std::shared_ptr<const PictureFile>& picture);

  bool busy() const { return making_ > 0; }

 signals:
  void ready();

 private:
  using Key = std::weak_ptr<const PictureFile>;

  std::map<Key, render::PictureItemPtr, std::owner_less<>> items_;
  int making_ = 0;
  QThreadPool thread_;
};

}  // namespace croquis::app
