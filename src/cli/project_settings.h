// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/document/document.h"
#include "croquis/document/registry.h"

namespace croquis::cli {

/// The document with other parameters.
/// @param settings NODE.PARAMETER=VALUE, several separated by ';'. NODE is a node's id or its name. A piece that isn't
///        of that form belongs to the value before it, which may be a list of its own.
/// @throws Error (E_USAGE, E_PARAMETER; Category::Usage) with a finding for each setting that can't be
Document with_settings(const Document& document, const std::string& settings, const Registry& registry);

}  // namespace croquis::cli
