// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "croquis/geometry/drawing.h"

namespace croquis::app {

/// A sketch that ships inside the program.
struct GallerySketch {
  QString name;   ///< "linked_rings": how command lines and replays call it
  QString title;  ///< "Linked rings"
};

/// In the order of their names.
std::vector<GallerySketch> gallery_sketches();

/// @throws Error (E_FILE_OPEN) when there is none of that name
Drawing load_gallery_sketch(const QString& name);

}  // namespace croquis::app
