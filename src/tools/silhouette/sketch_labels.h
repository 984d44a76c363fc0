// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

/// How the sketch tool's undo steps are called.
namespace croquis {

/// "Move stroke 3", "Move stroke outline", "Erase 2 strokes".
std::string strokes_label(const std::string& verb, const std::vector<std::string>& ids);

/// "Drag a point of stroke 2".
std::string point_label(const std::string& id);

}  // namespace croquis
