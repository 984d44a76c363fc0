// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/backdrop/picture_items.h"

#include <QMetaObject>
#include <span>

#include "app/files/picture_reader.h"

namespace croquis::app {
namespace {

render::PictureItemPtr made_of(const PictureFile& picture) {
  const QImage image = decoded(picture, render::max_picture_item_side);
  if (image.isNull()) return nullptr;
  // RGBA8888 has 4 bytes a pixel, so its rows have no padding.
  return render::make_picture_item(std::span(image.constBits(), static_cast<std::size_t>(image.sizeInBytes())),
                                   image.width(), image.height());
}

}  // namespace

render::PictureItemPtr PictureItems::item(const std::shared_ptr<const PictureFile>& picture) {
  std::erase_if(items_, [](const auto& entry) { return entry.first.expired(); });
  const auto [place, is_new] = items_.try_emplace(picture);
  if (!is_new) return place->second;
  ++making_;
  thread_.start([this, picture] {
    render::PictureItemPtr item = made_of(*picture);
    QMetaObject::invokeMethod(
        this,
        [this, picture, item] {
          --making_;
          items_[picture] = item;
          emit ready();
        },
        Qt::QueuedConnection);
  });
  return nullptr;
}

}  // namespace croquis::app
