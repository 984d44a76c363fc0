// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <string>
#include <vector>

#include "app/studio/studio.h"

namespace croquis::app {

// What objects are called in lists, sentences and proposed file names. Documents, recordings and reports keep their
// own names beside it.

/// An object's name for people.
QString shown_name(const WorkObject& object);

/// Of an object, a group or a stroke: names that nobody typed ("Sketch 2") are in the language in use.
QString shown_name(const std::string& name);

/// What a chain begins with: "Sketch", "Curves", "Mesh".
QString source_words(const Node* source);

/// A file's stem for what is worked on: the active object's name.
std::string document_name(const Studio& studio);

/// Something of an object that the list shows below it, or below one of its steps: a body, a stroke, faces by a name.
struct ObjectRow {
  QString name;
  QString info;  ///< in the second column
  QString tip;
  std::vector<std::string> parts;  ///< what is selected with it
  bool made = true;                ///< false: shown grey
  bool opened = true;              ///< the rows below it are seen at first
  std::vector<ObjectRow> rows = {};
  std::function<void(const std::string& name)> rename = {};  ///< of what people can rename; an empty name takes it back
};

}  // namespace croquis::app
