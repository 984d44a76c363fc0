// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_elements.h"

#include <algorithm>
#include <array>

#include "io/text.h"

namespace croquis {
namespace {

template <std::size_t N>
bool is_one_of(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::string_view svg_local_name(const pugi::xml_node& node) {
  std::string_view name = node.name();
  if (name.substr(0, 4) == "svg:") name.remove_prefix(4);
  return name;
}

bool is_svg_group(std::string_view name) {
  return is_one_of(name, std::array<std::string_view, 4>{"g", "a", "svg", "switch"});
}

bool is_svg_definition(std::string_view name) {
  constexpr std::array<std::string_view, 19> names{"defs",   "clipPath", "symbol", "marker",         "pattern",
                                                   "mask",   "title",    "desc",   "metadata",       "style",
                                                   "script", "filter",   "cursor", "linearGradient", "radialGradient",
                                                   "set",    "view",     "font",   "foreignObject"};
  return is_one_of(name, names) || name.substr(0, 7) == "animate" || name.find(':') != std::string_view::npos;
}

std::string_view svg_declared(std::string_view declarations, std::string_view property) {
  std::string_view value;
  while (!declarations.empty()) {
    const std::string_view declaration = declarations.substr(0, declarations.find(';'));
    declarations.remove_prefix(std::min(declarations.size(), declaration.size() + 1));
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos || trimmed(declaration.substr(0, colon)) != property) continue;
    value = trimmed(declaration.substr(colon + 1));
  }
  return value;
}

std::string svg_property(const pugi::xml_node& node, std::string_view name) {
  const std::string_view declared = svg_declared(node.attribute("style").value(), name);
  if (!declared.empty()) return std::string(declared);
  return std::string(trimmed(node.attribute(std::string(name).c_str()).value()));
}

}  // namespace croquis
