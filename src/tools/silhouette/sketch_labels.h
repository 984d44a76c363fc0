// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/tools/silhouette/sketch_steps.h"

/// How the sketch tool's undo steps are called.
namespace croquis {

/// "Move stroke 3", "Move stroke outline", "Erase 2 strokes".
std::string strokes_label(const std::string& verb, const std::vector<std::string>& ids);

/// "Drag a point of stroke 2".
std::string point_label(const std::string& id);

/// "Make stroke 2 a hole", "Bring stroke 1 in front of stroke 2", "Set thickness of stroke 1".
std::string setting_label(const recorded::StrokeReading& setting);

}  // namespace croquis
