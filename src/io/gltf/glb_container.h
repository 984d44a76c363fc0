// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "io/read_context.h"

namespace croquis {

/// The two parts of a GLB file (Khronos glTF 2.0, section 4.4), as views into it.
struct GlbContainer {
  std::string_view json;
  std::string_view binary;  ///< empty when there is none
};

/// @throws Error E_SYNTAX when the bytes are no GLB of version 2, E_TRUNCATED when they end before its chunks do
GlbContainer open_glb(std::string_view bytes, ReadContext& context);

}  // namespace croquis
