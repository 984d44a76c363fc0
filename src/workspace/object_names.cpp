// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/object_names.h"

#include <set>

namespace croquis {

std::string readable_name(const std::string& name) {
  if (name.find('_') == std::string::npos) return name;
  std::string readable;
  for (const char c : name) {
    const bool gap = c == '_' || c == ' ';
    if (gap && (readable.empty() || readable.back() == ' ')) continue;
    readable += gap ? ' ' : c;
  }
  if (readable.ends_with(' ')) readable.pop_back();
  if (readable.empty()) return name;
  if (readable.front() >= 'a' && readable.front() <= 'z')
    readable.front() = static_cast<char>(readable.front() - 'a' + 'A');
  return readable;
}

std::string free_name(const Document& document, const std::string& wanted) {
  std::set<std::string> taken;
  for (const auto& node : document.nodes()) taken.insert(node->name);
  std::string name = wanted;
  for (int number = 2; taken.contains(name); ++number) name = wanted + " " + std::to_string(number);
  return name;
}

}  // namespace croquis
