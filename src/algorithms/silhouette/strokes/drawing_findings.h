// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"

/// Subjects and phrases of findings about a drawing. Places are in the input's own frame: y down.
namespace croquis::silhouette {

Subject stroke_subject(const Drawing& drawing, Index stroke, const std::optional<Vec2>& at = std::nullopt);
Subject crossing_subject(const Drawing& drawing, const Vec2& at);

/// The stroke's id in quotes.
std::string in_quotes(const Drawing& drawing, Index stroke);

/// E_NO_LABELLING.
/// @param why no solid looks like the drawing
Finding no_solid(const std::string& why, std::vector<Subject> subjects);

/// W_TINY.
Finding too_short(const Drawing& drawing, Index stroke);

}  // namespace croquis::silhouette
