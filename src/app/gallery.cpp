// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gallery.h"

#include <QDir>
#include <QFile>

#include "croquis/base/error.h"
#include "croquis/io/svg_drawing.h"

namespace croquis::app {
namespace {

const QString folder = QStringLiteral(":/sketches");

}  // namespace

std::vector<GallerySketch> gallery_sketches() {
  std::vector<GallerySketch> sketches;
  for (const QString& file : QDir(folder).entryList({"*.svg"}, QDir::Files, QDir::Name)) {
    const QString name = file.chopped(4);
    QString title = name;
    title.replace('_', ' ');
    title[0] = title[0].toUpper();
    sketches.push_back({name, title});
  }
  return sketches;
}

Drawing load_gallery_sketch(const QString& name) {
  QFile file(folder + "/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly)) {
    throw Error(make_error(Category::Malformed, "E_FILE_OPEN",
                           "There is no shipped sketch named \"" + name.toStdString() + "\""));
  }
  const QByteArray bytes = file.readAll();
  Progress progress;
  return read_svg_drawing({bytes.constData(), static_cast<std::size_t>(bytes.size())}, name.toStdString() + ".svg",
                          progress)
      .drawing;
}

}  // namespace croquis::app
