// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "app/studio/studio.h"
#include "app/views/live_item.h"

/// The parts of a sketch's solid. Documents, recordings and reports call them by their first strokes.
namespace croquis::app {

struct Body {
  QString name;                      ///< "Body 1"; the name that the drawing gives it, where it does
  std::vector<std::string> strokes;  ///< that it is made of
};

/// Of a solid's newest result, in its order; empty without one.
std::vector<Body> bodies_of(const Drawing& drawing, const Evaluation* solid);

/// What people call a kind of stroke.
QString word_of(silhouette::StrokeKind kind);

/// The body that some of these strokes belong to, or null.
const Body* body_with(const std::vector<Body>& bodies, const std::vector<std::string>& strokes);

/// Bodies that were joined get one colour, without lines where they meet. Null for what is no solid of a sketch.
LiveItem::Paint paint_of_bodies(const WorkObject& object);

}  // namespace croquis::app
