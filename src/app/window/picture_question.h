// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>

#include "app/files/file_reader.h"

namespace croquis::app {

/// Asks what becomes of the pictures among the files; nothing: they aren't wanted. Without pictures it doesn't ask.
std::optional<PictureUse> ask_picture_use(const QStringList& paths, QWidget& parent);

}  // namespace croquis::app
