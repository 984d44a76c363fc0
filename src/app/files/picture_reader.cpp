// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/picture_reader.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImageReader>
#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/io/picture_trace.h"
#include "croquis/render/picture_item.h"

namespace croquis::app {
namespace {

constexpr int most_megabytes = 2048;  // of a decoded picture; Qt's own bound is less than a large scan takes
constexpr std::string_view jpeg_scan = "\xFF\xDA", jpeg_end = "\xFF\xD9";

/// Qt's reader fills what is missing of a JPEG file with grey, without an error.
bool is_cut_off(const std::string& bytes) {
  if (!bytes.starts_with("\xFF\xD8")) return false;
  const auto scan = bytes.rfind(jpeg_scan);  // the picture's own, not its thumbnail's
  return scan == std::string::npos || bytes.find(jpeg_end, scan) == std::string::npos;
}

[[noreturn]] void refuse_picture(const std::string& file, const std::string& reason) {
  throw Error(make_error(Category::Malformed, "E_PICTURE_FILE",
                         "The picture \"" + file + "\" can't be read: " + reason + "; save it again as PNG or JPEG",
                         {{SubjectKind::File, file, std::nullopt, std::nullopt, {}}}));
}

/// A picture of so many pixels, as large as allowed.
QSize shown_size(const QSize& size, int longest_side) {
  return std::max(size.width(), size.height()) <= longest_side
             ? size
             : size.scaled(longest_side, longest_side, Qt::KeepAspectRatio).expandedTo(QSize(1, 1));
}

/// @param reason what was wrong, where the image is null
QImage read_image(const std::string& bytes, int longest_side, QSize& own_size, QString& reason) {
  QBuffer buffer;
  buffer.setData(QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())));
  buffer.open(QIODevice::ReadOnly);
  QImageReader::setAllocationLimit(most_megabytes);
  QImageReader reader(&buffer);
  reader.setDecideFormatFromContent(true);
  reader.setAutoTransform(true);
  const QSize stored = reader.size();
  if (stored.isValid()) reader.setScaledSize(shown_size(stored, longest_side));
  QImage image = reader.read();
  if (image.isNull()) {
    reason = reader.errorString();
    return image;
  }
  // Files that don't say how large they are are known only now.
  own_size = stored.isValid() ? stored : image.size();
  if (reader.transformation() & QImageIOHandler::TransformationRotate90) own_size.transpose();
  const QSize size = shown_size(image.size(), longest_side);
  if (size != image.size()) image = image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  return image.convertToFormat(QImage::Format_RGBA8888);
}

}  // namespace

const QStringList& picture_endings() {
  static const QStringList endings = [] {
    QStringList readable;
    const QList<QByteArray> formats = QImageReader::supportedImageFormats();
    for (const char* format : {"png", "jpg", "jpeg", "webp", "tif", "tiff", "bmp", "gif"}) {
      if (formats.contains(format)) readable << QString(".") + format;
    }
    return readable;
  }();
  return endings;
}

bool is_picture_name(const QString& path) {
  return picture_endings().contains("." + QFileInfo(path).suffix(), Qt::CaseInsensitive);
}

PictureFile read_picture(std::string bytes, const std::string& file) {
  if (bytes.empty()) refuse_picture(file, "it is empty");
  if (is_cut_off(bytes)) refuse_picture(file, "its end is missing");
  QSize size;
  QString reason;
  const QImage image = read_image(bytes, render::max_picture_item_side, size, reason);
  if (image.isNull()) refuse_picture(file, reason.isEmpty() ? "it is damaged" : reason.toLower().toStdString());
  PictureFile picture;
  picture.bytes = std::move(bytes);
  picture.width = size.width();
  picture.height = size.height();
  picture.file = file;
  return picture;
}

QImage decoded(const PictureFile& picture, int longest_side) {
  QSize size;
  QString reason;
  return read_image(picture.bytes, longest_side, size, reason);
}

Drawing traced_picture(std::string bytes, const std::string& file, Progress& progress) {
  // As on the command line.
  if (bytes.starts_with("\x89PNG")) return read_picture_drawing(bytes, file, progress);
  const QImage image = decoded(read_picture(std::move(bytes), file), TraceOptions().longest_side);
  Picture picture{image.width(), image.height(), {}};
  for (int y = 0; y < image.height(); ++y) {
    const uchar* row = image.constScanLine(y);
    picture.rgba.insert(picture.rgba.end(), row, row + 4 * static_cast<std::ptrdiff_t>(image.width()));
  }
  return trace_picture(picture, file, progress);
}

}  // namespace croquis::app
