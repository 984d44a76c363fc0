// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_text.h"

namespace croquis {

std::string svg_escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      default: safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return safe;
}

void append_svg_attribute(std::string& text, std::string_view name, std::string_view value) {
  text.append(" ").append(name).append("=\"").append(svg_escaped(value)).append("\"");
}

}  // namespace croquis
