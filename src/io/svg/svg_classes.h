// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace croquis {

/// Declarations of a file's style sheets: rules whose selector is a class, an id or an element's name alone
/// (".a, #b, path { stroke: red }").
class SvgClasses {
 public:
  /// All `style` elements below the root that stand among definitions or in few groups.
  void read(const pugi::xml_node& root);

  /// A property of an element: its style attribute, then what sheets say of its id, its classes and its name, then its
  /// own attribute; empty when it has none.
  std::string property(const pugi::xml_node& node, std::string_view name) const;

  /// The same of the element or of the nearest element around it that has one.
  std::string inherited(pugi::xml_node node, std::string_view name) const;

 private:
  void read(const pugi::xml_node& root, int level);
  void read_sheet(std::string_view text);

  std::string_view of_rule(std::string_view selector, std::string_view name) const;

  std::map<std::string, std::string, std::less<>> declarations_;  ///< by selector
};

}  // namespace croquis
