// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "io/svg/svg_walk.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr int deepest_sheet = 4;  // levels of groups around a style sheet

/// Cuts off the text before the next separator, and the separator.
std::string_view cut(std::string_view& text, char separator) {
  const std::string_view part = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(text.size(), part.size() + 1));
  return part;
}

/// On one line.
std::string without_comments(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find("/*"), text.size());
    result.append(text.substr(0, begin));
    text.remove_prefix(begin);
    const std::size_t end = text.find("*/", std::min<std::size_t>(2, text.size()));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
  }
  for (char& c : result) c = c == '\n' ? ' ' : c;
  return result;
}

}  // namespace

void SvgClasses::read(const pugi::xml_node& root) { read(root, 0); }

void SvgClasses::read(const pugi::xml_node& root, int level) {
  for (const pugi::xml_node& child : root.children()) {
    const std::string_view name = svg_local_name(child);
    if (name == "style") read_sheet(without_comments(child.text().get()));
    // Where drawing programs put style sheets; deeper there are too many elements to search.
    if (level < deepest_sheet && (name == "defs" || name == "switch" || name == "g")) read(child, level + 1);
  }
}

void SvgClasses::read_sheet(std::string_view text) {
  while (!text.empty()) {
    std::string_view selectors = cut(text, '{');
    const std::string_view declarations = cut(text, '}');
    while (!selectors.empty()) {
      const std::string_view selector = trimmed(cut(selectors, ','));
      const bool simple = selector.find_first_of(" .#>+~:[*@", 1) == std::string_view::npos;
      if (selector.empty() || !simple || selector.front() == '@') continue;
      declarations_[std::string(selector)].append(declarations).append(";");
    }
  }
}

std::string SvgClasses::property(const pugi::xml_node& node, std::string_view name) const {
  const std::string_view declared = svg_declared(node.attribute("style").value(), name);
  if (!declared.empty()) return std::string(declared);
  if (declarations_.empty()) return svg_property(node, name);
  const std::string_view by_id = of_rule("#" + std::string(node.attribute("id").value()), name);
  if (!by_id.empty()) return std::string(by_id);
  std::string_view classes = node.attribute("class").value();
  while (!classes.empty()) {
    const std::string_view value = of_rule("." + std::string(trimmed(cut(classes, ' '))), name);
    if (!value.empty()) return std::string(value);
  }
  const std::string_view by_name = of_rule(svg_local_name(node), name);
  return by_name.empty() ? svg_property(node, name) : std::string(by_name);
}

std::string_view SvgClasses::of_rule(std::string_view selector, std::string_view name) const {
  const auto found = declarations_.find(selector);
  return found == declarations_.end() ? std::string_view() : svg_declared(found->second, name);
}

std::string SvgClasses::inherited(pugi::xml_node node, std::string_view name) const {
  for (; node; node = node.parent()) {
    std::string value = property(node, name);
    if (!value.empty() && value != "inherit") return value;
  }
  return {};
}

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
