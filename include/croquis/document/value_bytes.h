// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/document/byte_stream.h"
#include "croquis/document/value.h"

namespace croquis {

/// The whole value in the canonical form, in the oldest layout that holds it: equal values give equal bytes, and
/// nothing is rounded (docs/project-file.md has the layouts).
/// @param value has content
/// @throws Error (E_LIMIT) for a report nested too deeply
std::string encode(const Value& value);

/// The value of those bytes. What comes out is safe to compute with: indices and offsets are in range, channels have
/// their lengths.
/// @throws BadBytes
Value decode(ValueType type, std::string_view bytes);

}  // namespace croquis
