// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <string>

#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/picture_file.h"

/// Photos and scans: what Qt reads. For any thread.
namespace croquis::app {

/// ".png", ".jpg" …: of the formats that can be read on this machine.
const QStringList& picture_endings();
bool is_picture_name(const QString& path);

/// The file's picture, after a look at all of it.
/// @param file for sentences
/// @throws Error (E_PICTURE_FILE, malformed) for a broken, incomplete or empty one
PictureFile read_picture(std::string bytes, const std::string& file);

/// As people see it: turned as the file says, 8 bits a channel (RGBA), its longer side at most so many pixels.
/// @return a null image for bytes that can't be read
QImage decoded(const PictureFile& picture, int longest_side);

/// The lines of a file's picture, upright, as strokes.
/// @throws Error like read_picture and trace_picture
/// @throws Cancelled
Drawing traced_picture(std::string bytes, const std::string& file, Progress& progress);

}  // namespace croquis::app
