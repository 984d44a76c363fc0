// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <functional>
#include <sstream>

#include <catch2/catch.hpp>

#include "architecture/source_tree.h"

namespace croquis::test {
namespace {

const std::filesystem::path root = CROQUIS_SOURCE_DIR;

std::map<std::string, const SourceFile*> by_path(const std::vector<SourceFile>& files) {
  std::map<std::string, const SourceFile*> map;
  for (const SourceFile& file : files) map[file.path] = &file;
  return map;
}

TEST_CASE("every arrow between modules stands in the table of the architecture page") {
  const auto rules = read_rules(root);
  const auto files = read_sources(root);
  const auto index = by_path(files);
  REQUIRE(rules.size() > 5);
  std::set<std::string> used_modules;
  for (const SourceFile& file : files) {
    used_modules.insert(file.module);
    const auto allowed = reachable(rules, file.module);
    for (const std::string& include : file.own_includes) {
      INFO(file.path << " includes " << include);
      REQUIRE(index.contains(include));
      CHECK(allowed.contains(index.at(include)->module));
    }
  }
  for (const std::string& module : used_modules) {
    INFO("module " << module << " is missing in the table");
    CHECK(rules.contains(module));
  }
  for (const auto& [module, rule] : rules) {
    INFO("module " << module << " of the table has no source");
    CHECK(used_modules.contains(module));
  }
}

TEST_CASE("the table itself has no cycle") {
  const auto rules = read_rules(root);
  for (const auto& [module, rule] : rules) {
    for (const std::string& used : rule.uses) {
      INFO(module << " and " << used);
      if (used != module) CHECK_FALSE(reachable(rules, used).contains(module));
    }
  }
}

TEST_CASE("public headers show only the libraries that the table allows") {
  const auto rules = read_rules(root);
  for (const SourceFile& file : read_sources(root)) {
    if (!file.is_public || !rules.contains(file.module)) continue;
    std::set<std::string> allowed;
    for (const std::string& module : reachable(rules, file.module)) {
      if (rules.contains(module))
        allowed.insert(rules.at(module).third_party.begin(), rules.at(module).third_party.end());
    }
    for (const std::string& include : file.system_includes) {
      const std::string library = library_of(include);
      INFO(file.path << " includes <" << include << ">");
      CHECK((library.empty() || allowed.contains(library)));
    }
  }
}

TEST_CASE("public headers never include private ones") {
  for (const SourceFile& file : read_sources(root)) {
    for (const std::string& include : file.own_includes) {
      INFO(file.path << " includes " << include);
      if (file.is_public) CHECK(include.starts_with("include/"));
    }
  }
}

TEST_CASE("files include one another without a cycle") {
  const auto files = read_sources(root);
  const auto index = by_path(files);
  std::map<std::string, int> state;
  const std::function<void(const std::string&)> visit = [&](const std::string& path) {
    state[path] = 1;
    for (const std::string& include : index.at(path)->own_includes) {
      if (!index.contains(include)) continue;
      INFO(path << " includes " << include);
      CHECK(state[include] != 1);
      if (state[include] == 0) visit(include);
    }
    state[path] = 2;
  };
  for (const SourceFile& file : files) {
    if (state[file.path] == 0) visit(file.path);
  }
}

TEST_CASE("the window reads results by their types, no reports by their keys") {
  for (const SourceFile& file : read_sources(root)) {
    if (file.module != "app") continue;
    INFO(file.path);
    CHECK(std::ranges::count(file.own_includes, "include/croquis/base/report.h") == 0);
  }
}

/// The folder of `tools` that a file lies in, "" for others.
std::string tool_folder(const std::string& path) {
  for (const std::string prefix : {"include/croquis/tools/", "src/tools/"}) {
    if (!path.starts_with(prefix)) continue;
    const std::size_t end = path.find('/', prefix.size());
    return end == std::string::npos ? "" : path.substr(prefix.size(), end - prefix.size());
  }
  return "";
}

TEST_CASE("a tool's folder includes only itself and the shared ones, and those no tool's") {
  std::set<std::string> shared;
  std::set<std::string> listed;
  for (const auto& row : read_table_rows(root / "docs/architecture.md", "Folder of tools")) {
    const std::string name = row[0].substr(1, row[0].size() - 2);
    listed.insert(name);
    if (row[1] == "all tools") shared.insert(name);
  }
  REQUIRE(shared.size() >= 2);
  for (const SourceFile& file : read_sources(root)) {
    const std::string folder = tool_folder(file.path);
    if (folder.empty()) continue;
    INFO(file.path);
    CHECK(listed.contains(folder));
    for (const std::string& include : file.own_includes) {
      const std::string other = tool_folder(include);
      INFO("includes " << include);
      CHECK((other.empty() || other == folder || shared.contains(other)));
    }
  }
}

TEST_CASE("no module is larger than its budget, and no budget much larger than its module") {
  const auto budgets = read_budgets(root);
  for (const auto& [module, size] : sizes_of(read_sources(root))) {
    INFO("module " << module << ": | " << size.lines << " | " << size.files << " | " << size.types << " | "
                   << size.constants << " |");
    REQUIRE(budgets.contains(module));
    const ModuleSize& budget = budgets.at(module);
    CHECK(size.lines <= budget.lines);
    CHECK(size.files <= budget.files);
    CHECK(size.types <= budget.types);
    CHECK(size.constants <= budget.constants);
    CHECK(budget.lines <= size.lines + size.lines / 20 + 50);  // what has shrunk stays so
  }
}

TEST_CASE("no file is longer than 500 lines") {
  for (const SourceFile& file : read_sources(root)) {
    INFO(file.path);
    CHECK(file.line_count <= 500);
  }
}

TEST_CASE("a library is used only in the files that the third-party page names") {
  std::map<std::string, std::set<std::string>> listed;
  for (const auto& row : read_table_rows(root / "docs/third-party.md", "Library")) {
    std::string name = row[0];
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::istringstream files(row.back());
    for (std::string file; std::getline(files, file, ',');) {
      const auto open = file.find('`');
      const auto close = file.rfind('`');
      if (open != std::string::npos) listed[name].insert(file.substr(open + 1, close - open - 1));
    }
  }
  REQUIRE(listed.size() > 5);
  const auto is_listed = [&](const std::string& library, const std::string& path) {
    for (const std::string& prefix : listed[library]) {
      if (path == prefix || (prefix.ends_with("/") && path.starts_with(prefix))) return true;
    }
    return false;
  };
  for (const SourceFile& file : read_sources(root)) {
    for (const std::string& include : file.system_includes) {
      const std::string library = library_of(include);
      INFO(file.path << " includes <" << include << ">");
      if (!library.empty() && library != "eigen") CHECK(is_listed(library, file.path));
    }
  }
}

}  // namespace
}  // namespace croquis::test
