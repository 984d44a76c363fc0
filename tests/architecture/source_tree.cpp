// SPDX-License-Identifier: GPL-3.0-or-later
#include "architecture/source_tree.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>
#include <utility>

namespace croquis::test {
namespace {

namespace fs = std::filesystem;

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(trimmed(part));
  return parts;
}

std::string module_of(const std::string& path) {
  std::vector<std::string> parts = split(path, '/');
  if (parts[0] == "include" || parts[1] == "algorithms") return parts[2];
  return parts[1];
}

/// Quoted includes name either a public header or a private one relative to src/.
std::string resolve(const fs::path& root, const std::string& quoted) {
  const std::string folder = quoted.starts_with("croquis/") ? "include/" : "src/";
  return fs::exists(root / (folder + quoted)) ? folder + quoted : "missing: " + quoted;
}

SourceFile read_source(const fs::path& root, const fs::path& path) {
  SourceFile file;
  file.path = fs::relative(path, root).generic_string();
  file.module = module_of(file.path);
  file.is_public = file.path.starts_with("include/");
  std::ifstream stream(path);
  static const std::regex type(R"(^\s*(struct|class|enum|enum class) \w+.*\{.*)");
  static const std::regex constant(R"(^(inline |static )?constexpr [^(]*[={].*)");
  for (std::string line; std::getline(stream, line); ++file.line_count) {
    file.type_count += std::regex_match(line, type);
    file.constant_count += std::regex_match(line, constant);
    if (!line.starts_with("#include")) continue;
    const auto open = line.find_first_of("\"<");
    const auto close = line.find_first_of("\">", open + 1);
    if (open == std::string::npos || close == std::string::npos) continue;
    const std::string name = line.substr(open + 1, close - open - 1);
    if (line[open] == '<') {
      file.system_includes.push_back(name);
    } else {
      file.own_includes.push_back(resolve(root, name));
    }
  }
  return file;
}

}  // namespace

std::vector<SourceFile> read_sources(const fs::path& root) {
  std::vector<SourceFile> files;
  for (const char* folder : {"include", "src"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".h" || extension == ".cpp") files.push_back(read_source(root, entry.path()));
    }
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return files;
}

std::vector<std::vector<std::string>> read_table_rows(const fs::path& markdown, const std::string& first_heading) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream stream(markdown);
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("|")) {
      inside = false;
      continue;
    }
    const std::vector<std::string> cells = split(line.substr(1), '|');
    if (cells[0] == first_heading) {
      inside = true;
    } else if (inside && !cells[0].starts_with("---")) {
      rows.push_back(cells);
    }
  }
  return rows;
}

std::map<std::string, ModuleRule> read_rules(const fs::path& root) {
  std::map<std::string, ModuleRule> rules;
  for (const auto& row : read_table_rows(root / "docs/architecture.md", "Module")) {
    ModuleRule rule;
    for (const std::string& used : split(row[1], ',')) {
      if (used != "–") rule.uses.insert(used);
    }
    for (std::string library : split(row[2], ',')) {
      std::transform(library.begin(), library.end(), library.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      if (library != "–") rule.third_party.insert(library);
    }
    rules[row[0]] = std::move(rule);
  }
  return rules;
}

std::map<std::string, ModuleSize> read_budgets(const fs::path& root) {
  std::map<std::string, ModuleSize> budgets;
  for (const auto& row : read_table_rows(root / "docs/architecture.md", "Budget of")) {
    budgets[row[0]] = {std::stoul(row[1]), std::stoul(row[2]), std::stoul(row[3]), std::stoul(row[4])};
  }
  return budgets;
}

std::map<std::string, ModuleSize> sizes_of(const std::vector<SourceFile>& files) {
  std::map<std::string, ModuleSize> sizes;
  for (const SourceFile& file : files) {
    ModuleSize& size = sizes[file.module];
    size.lines += file.line_count;
    size.files += 1;
    size.types += file.type_count;
    size.constants += file.constant_count;
  }
  return sizes;
}

std::set<std::string> reachable(const std::map<std::string, ModuleRule>& rules, const std::string& module) {
  std::set<std::string> seen = {"base", module};
  std::vector<std::string> pending = {module};
  while (!pending.empty()) {
    const auto rule = rules.find(pending.back());
    pending.pop_back();
    if (rule == rules.end()) continue;
    for (const std::string& used : rule->second.uses) {
      if (seen.insert(used).second) pending.push_back(used);
    }
  }
  return seen;
}

std::string library_of(const std::string& system_include) {
  static constexpr std::array<std::pair<const char*, const char*>, 15> prefixes = {{{"Eigen/", "eigen"},
                                                                                    {"CGAL/", "cgal"},
                                                                                    {"OpenMesh/", "openmesh"},
                                                                                    {"opensubdiv/", "opensubdiv"},
                                                                                    {"glpk.h", "glpk"},
                                                                                    {"glm/", "glm"},
                                                                                    {"epoxy/", "epoxy"},
                                                                                    {"nlohmann/", "nlohmann-json"},
                                                                                    {"CLI/", "cli11"},
                                                                                    {"pugixml", "pugixml"},
                                                                                    {"tiny_gltf", "tinygltf"},
                                                                                    {"png.h", "libpng"},
                                                                                    {"xxhash", "xxhash"},
                                                                                    {"sqlite3", "sqlite"},
                                                                                    {"Q", "qt"}}};
  for (const auto& [prefix, library] : prefixes) {
    if (system_include.starts_with(prefix)) return library;
  }
  return system_include.ends_with(".hxx") ? "opencascade" : "";
}

}  // namespace croquis::test
