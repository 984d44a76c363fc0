// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "app/studio/studio.h"

/// What objects are called in lists, sentences and proposed file names. Documents, recordings and reports keep their
/// own names beside it.
namespace croquis::app {

/// A part of the sketch's solid.
struct Body {
  QString name;                      ///< "Body 1"; the name that the drawing gives it, where it does
  std::vector<std::string> strokes;  ///< that it is made of
};

/// Of the newest solid, in its order; empty without one.
std::vector<Body> bodies_of(const Studio& studio);

/// A mesh's name for people.
QString shown_name(const StudioObject& object);

/// The object that a finding is about, where there are several; else empty.
QString owner_of(const Studio& studio, const NodeFinding& found);

/// A file's stem for what is worked on: the active mesh's name, "Sketch" for a drawing and its solid.
std::string document_name(const Studio& studio);

}  // namespace croquis::app
