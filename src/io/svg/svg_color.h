// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace croquis {

using SvgColor = std::array<double, 3>;  ///< red, green, blue, 0..255

/// "#08f", "#0088ff", "rgb(0, 136, 255)", "rgb(0%, 53%, 100%)" or a name; nothing for what is no colour, such as
/// "none".
std::optional<SvgColor> svg_color(std::string_view text);

/// "#0088ff"
std::string hexadecimal_text(const SvgColor& color);

}  // namespace croquis
