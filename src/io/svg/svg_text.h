// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace croquis {

/// Text as an attribute's value; characters that XML can't hold become spaces.
std::string svg_escaped(std::string_view text);

/// Appends ` name="value"`.
void append_svg_attribute(std::string& text, std::string_view name, std::string_view value);

}  // namespace croquis
