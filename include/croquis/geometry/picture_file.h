// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace croquis {

/// A photo or a scan, as its file holds it: nothing here decodes it, and every byte is kept.
struct PictureFile {
  std::string bytes;  ///< of the file (PNG, JPEG …), not empty
  int width = 1;      ///< px as people see it, after the file's own rotation; > 0
  int height = 1;     ///< px, > 0
  std::string file;   ///< where it came from, for people
};

}  // namespace croquis
