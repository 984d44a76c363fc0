// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

/// The project's own sources as text: which file includes what, and what the architecture page allows.
namespace croquis::test {

struct SourceFile {
  std::string path;    ///< relative to the project's root, with '/'
  std::string module;  ///< "geometry", "silhouette", …
  bool is_public = false;
  std::vector<std::string> own_includes;     ///< project files, relative to the root
  std::vector<std::string> system_includes;  ///< what stands between < and >
  std::size_t line_count = 0;
  std::size_t type_count = 0;      ///< structs, classes and enumerations that are defined in it
  std::size_t constant_count = 0;  ///< named numbers and tables of the whole file
};

/// How large a module is, or may be.
struct ModuleSize {
  std::size_t lines = 0, files = 0, types = 0, constants = 0;
};

struct ModuleRule {
  std::set<std::string> uses;         ///< direct
  std::set<std::string> third_party;  ///< allowed in public headers, lower case
};

/// Every header and source below include/ and src/, sorted by path.
std::vector<SourceFile> read_sources(const std::filesystem::path& root);

/// The table of docs/architecture.md by module.
std::map<std::string, ModuleRule> read_rules(const std::filesystem::path& root);

/// The table of budgets of docs/architecture.md by module.
std::map<std::string, ModuleSize> read_budgets(const std::filesystem::path& root);

/// What the modules have, by module.
std::map<std::string, ModuleSize> sizes_of(const std::vector<SourceFile>& files);

/// Everything a module may use: `uses` followed downwards, itself and base.
std::set<std::string> reachable(const std::map<std::string, ModuleRule>& rules, const std::string& module);

/// The third-party library that an include belongs to ("cgal", "eigen", …), or "" for the standard library and system.
std::string library_of(const std::string& system_include);

/// Table rows of a Markdown file as trimmed cells, without header and rule rows.
std::vector<std::vector<std::string>> read_table_rows(const std::filesystem::path& markdown,
                                                      const std::string& first_heading);

}  // namespace croquis::test
