// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace croquis::render {

/// The text of a file of shaders/, or null when none has that name. Defined in a generated file.
const char* shader_source(std::string_view name);

}  // namespace croquis::render
