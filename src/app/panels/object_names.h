// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

#include "app/studio/studio.h"

/// What objects are called in lists, sentences and proposed file names. Documents, recordings and reports keep their
/// own names beside it.
namespace croquis::app {

/// An object's name for people.
QString shown_name(const WorkObject& object);

/// A file's stem for what is worked on: the active object's name.
std::string document_name(const Studio& studio);

}  // namespace croquis::app
