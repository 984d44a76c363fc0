// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "croquis/document/backdrop.h"
#include "croquis/document/document.h"

namespace croquis {

/// A rectangle on the plane that is drawn on, x right, y UP.
struct BackdropArea {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
};

/// What a picture behind that drawing is fitted into: the sheet of one in perspective, the strokes of a sketch, or the
/// place where a first stroke would be drawn.
BackdropArea backdrop_area(const Node& drawing);

/// The picture in the middle of the area, as large as fits.
Backdrop fitted(std::shared_ptr<const PictureFile> picture, const BackdropArea& area);

/// The area that it covers.
BackdropArea area_of(const Backdrop& backdrop);

/// The size of a sheet for that picture, px: its own, made smaller where its longer side has more than `longest`.
Vec2 sheet_for(const PictureFile& picture, double longest = 4096);

/// The document with that picture behind a drawing, or without one. @pre the node is there
Document with_backdrop(const Document& document, NodeId drawing, std::optional<Backdrop> backdrop);

}  // namespace croquis
