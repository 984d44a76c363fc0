// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <pugixml.hpp>

/// What kinds of elements an SVG file has, and their properties.
namespace croquis {

/// "svg:path" and "path" are the same; other prefixes stay, so that they match nothing.
std::string_view svg_local_name(const pugi::xml_node& node);

bool is_svg_group(std::string_view name);

/// Elements that draw nothing by themselves.
bool is_svg_definition(std::string_view name);

/// The value of a property in a list of declarations ("a: b; c: d"), the last one; empty when it is not there.
std::string_view svg_declared(std::string_view declarations, std::string_view property);

/// A property as an attribute or, stronger, in the style attribute.
std::string svg_property(const pugi::xml_node& node, std::string_view name);

}  // namespace croquis
