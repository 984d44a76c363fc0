// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace croquis::app {

/// Something of an object that the list shows below it, or below one of its steps: a body, a stroke, faces by a name.
struct ObjectRow {
  QString name;
  QString info;  ///< in the second column
  QString tip;
  std::vector<std::string> parts;  ///< what is selected with it
  bool made = true;                ///< false: shown grey
  bool opened = true;              ///< the rows below it are seen at first
  std::vector<ObjectRow> rows;
};

}  // namespace croquis::app
