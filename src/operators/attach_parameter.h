// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/silhouette/options.h"

namespace croquis {

/// Reads "A,B=0.4;C,D": pairs of objects with how deep they sink, 0.55 by default. What follows the last '=' is the
/// depth; names hold no comma and no semicolon.
/// @throws Error with one E_PARAMETER for every entry that is no pair
std::vector<silhouette::AttachedPair> parse_attached_pairs(const std::string& text);

}  // namespace croquis
