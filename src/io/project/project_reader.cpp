// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/project_reader.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/document/byte_stream.h"
#include "croquis/document/value_bytes.h"
#include "io/project/blob_store.h"
#include "io/project/damage_log.h"
#include "io/project/node_reader.h"
#include "io/project/project_writer.h"
#include "io/project/schema.h"

namespace croquis {
namespace {

/// Pictures of a few hundred pixels a side; more than this is no thumbnail.
constexpr std::size_t max_thumbnail_bytes = 16 * 1024 * 1024;
constexpr std::string_view png_magic = "\x89PNG\r\n\x1a\n";

template <typename Number>
Number parse_or(const std::string& text, Number otherwise) {
  Number value{};
  const auto end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  return parsed.ec == std::errc{} && parsed.ptr == end ? value : otherwise;
}

/// Empty where the column holds no picture.
std::vector<std::uint8_t> png_of(const Statement& row, int column) {
  if (!row.is_blob(column)) return {};
  const std::string_view bytes = row.blob(column);
  if (!bytes.starts_with(png_magic) || bytes.size() > max_thumbnail_bytes) return {};
  return {bytes.begin(), bytes.end()};
}

using KeptNodes = std::map<std::string, std::shared_ptr<const Node>>;  ///< by their hashes

/// Of a row whose columns 1 and 2 are next_id and nodes; nothing where some node isn't there.
std::optional<Document> document_of(const Statement& row, const KeptNodes& nodes) {
  const std::string_view hashes = row.blob(2);
  constexpr std::size_t size = 16;
  std::vector<std::shared_ptr<const Node>> own;
  std::set<NodeId> ids;
  for (std::size_t at = 0; at + size <= hashes.size(); at += size) {
    const auto node = nodes.find(std::string(hashes.substr(at, size)));
    if (node == nodes.end() || !node->second || node->second->id == 0) return std::nullopt;
    if (!ids.insert(node->second->id).second) return std::nullopt;
    own.push_back(node->second);
  }
  return Document::of(std::move(own), from_row_id(row.integer(1)));
}

class ProjectReader {
 public:
  ProjectReader(Database& database, const std::string& file_name, Progress& progress, std::span<const ValueType> types)
      : database_(database), progress_(progress), types_(types), damage_(file_name) {}

  ProjectFile read() {
    read_version();
    check_tables();
    check_version();
    check_pages();
    std::set<TableGroup> tables;
    try {
      tables = tables_in(database_);
    } catch (const DatabaseError&) {
      // check_tables has reported it
    }
    std::vector<NodeRow> rows = read_node_rows(database_, types_, tables, damage_);
    const auto next_id = parse_or<NodeId>(meta("next_id"), 0);
    check_sum(rows, next_id);
    read_sources(rows);
    read_pictures(rows);
    drop_dead_links(rows);
    ProjectFile project;
    if (rows.empty() && !damage_.empty()) damage_.refuse();
    std::vector<std::shared_ptr<const Node>> nodes;
    for (NodeRow& row : rows) nodes.push_back(std::make_shared<const Node>(std::move(row.node)));
    project.document = Document::of(std::move(nodes), next_id);
    if (tables.contains(TableGroup::Results)) read_results(project.kept.results);
    const bool has_versions = tables.contains(TableGroup::Versions);
    if (has_versions || tables.contains(TableGroup::Past)) read_past(project.kept, has_versions);
    try {
      project.thumbnail_png = read_thumbnail(database_);
    } catch (const DatabaseError&) {
      damage_.lose("its thumbnail can't be read");
    }
    progress_.report(1);
    project.warnings = std::move(warnings_);
    const Findings losses = damage_.warnings();
    project.warnings.insert(project.warnings.end(), losses.begin(), losses.end());
    return project;
  }

 private:
  std::string meta(const std::string& key) {
    try {
      return read_meta(database_, key);
    } catch (const DatabaseError&) {
      return "";  // check_pages and the nodes report it
    }
  }

  void read_version() {
    try {
      version_ = database_.integer("PRAGMA user_version");
    } catch (const DatabaseError&) {
      damage_.lose(changed_bytes);
      damage_.refuse();
    }
  }

  // A newer project names the oldest schema whose readers can read it.
  void check_version() {
    if (version_ <= project_schema_version) return;
    const auto since = parse_or<std::int64_t>(meta("readable_since"), version_);
    const std::string saved = "The project '" + damage_.file() + "' was saved by a newer Croquis (schema " +
                              std::to_string(version_) + ", this one knows " + std::to_string(project_schema_version) +
                              ")";
    const std::vector<Subject> subjects = {file_subject(damage_.file())};
    if (since > project_schema_version) {
      throw Error(
          make_error(Category::Malformed, "E_PROJECT_VERSION", saved + "; open it with that version.", subjects));
    }
    warnings_.push_back(make_warning(Category::Malformed, "W_PROJECT_NEWER",
                                     saved + "; what this version doesn't know is left out when you save it.",
                                     subjects));
  }

  // Virtual tables (those without pages) are refused before any statement touches them: they run code of their own.
  void check_tables() {
    std::set<std::string> unknown;
    const char* sql = "SELECT name, type, rootpage FROM sqlite_schema";
    each_row(database_, sql, "contents", damage_, [&](const Statement& row) {
      const std::string name(row.text(0));
      if (row.text(1) == "table" && row.integer(2) == 0) {
        damage_.lose("its table '" + printable(name) + "' is not a stored one");
        damage_.refuse();
      }
      const bool index = row.text(1) == "index" || name.starts_with("sqlite_");
      const bool known = std::find(project_tables.begin(), project_tables.end(), name) != project_tables.end();
      if (!index && !known) unknown.insert(printable(name));
    });
    if (unknown.empty()) return;
    std::string list;
    for (const std::string& name : unknown) list += (list.empty() ? "'" : ", '") + name + "'";
    warnings_.push_back(make_warning(Category::Malformed, "W_IGNORED",
                                     "The project '" + damage_.file() + "' has tables that mean nothing to this " +
                                         "version (" + list + "); they are left out when you save it.",
                                     {file_subject(damage_.file())}));
  }

  void check_pages() {
    each_row(database_, "PRAGMA quick_check(1)", "pages", damage_, [&](const Statement& row) {
      const std::string answer(row.text(0));
      if (answer != "ok") damage_.lose("some of " + std::string(changed_bytes));
    });
  }

  void check_sum(const std::vector<NodeRow>& rows, NodeId next_id) {
    const std::string wanted = meta("checksum");
    if (wanted.empty() || version_ > project_schema_version || !damage_.empty()) return;
    std::vector<const NodeRow*> all;
    for (const NodeRow& row : rows) all.push_back(&row);
    if (nodes_checksum(all, next_id) == wanted) return;
    damage_.lose("names, parameters or links are not those that were saved, so check them before you continue");
  }

  void read_sources(std::vector<NodeRow>& rows) {
    std::size_t done = 0;
    std::erase_if(rows, [&](NodeRow& row) {
      progress_.report(static_cast<double>(done++) / static_cast<double>(rows.size()));
      const Node& node = row.node;
      // Its row in the table of sources is among what can't be read.
      if (!row.kind) return node.operation.empty() && !damage_.empty();
      const auto& [value, reason] = value_of(*row.kind, row.hash);
      row.node.source = value;
      if (value) return false;
      damage_.lose(title_of(node) + " is left out since its contents can't be read: " + reason, {node_subject(node)});
      return true;
    });
  }

  // A drawing without the picture behind it is whole.
  void read_pictures(std::vector<NodeRow>& rows) {
    for (NodeRow& row : rows) {
      if (!row.backdrop) continue;
      const auto& [value, reason] = value_of(ValueType::PictureFile, row.picture_hash);
      if (value) row.backdrop->picture = value->as<PictureFile>();
      if (value && is_valid(*row.backdrop)) {
        row.node.backdrop = std::make_shared<const Backdrop>(*row.backdrop);
        continue;
      }
      damage_.lose(
          title_of(row.node) + " has lost the picture behind it: " + (value ? "its place or opacity can't be" : reason),
          {node_subject(row.node)});
    }
  }

  // Without one of them a step shows nothing until it is mended.
  void read_results(KeptResults& kept) {
    const char* sql = "SELECT node, role, kind, hash FROM kept_results";
    each_row(database_, sql, "kept_results", damage_, [&](const Statement& row) {
      const auto kind = std::ranges::find_if(types_, [&](ValueType type) { return row.text(2) == to_string(type); });
      if (kind == types_.end()) return damage_.lose("a kept result is of a kind that this version doesn't know");
      const auto& [value, reason] = value_of(*kind, std::string(row.blob(3)));
      if (!value) return damage_.lose("a kept result can't be read: " + reason);
      KeptResult& of = kept[from_row_id(row.integer(0))];
      (row.text(1) == "edited" ? of.edited : of.result) = *value;
    });
  }

  // All or nothing: undo can't leave out what is between two documents. Each version stands for itself.
  void read_past(KeptWork& kept, bool has_versions) {
    bool whole = true;
    KeptNodes nodes;
    each_row(database_, "SELECT hash, bytes FROM past_nodes", "past_nodes", damage_,
             [&](const Statement& row) { nodes[std::string(row.blob(0))] = past_node(row.blob(1)); });
    each_row(database_, "SELECT label, next_id, nodes FROM past ORDER BY number", "past", damage_,
             [&](const Statement& row) {
               const auto document = document_of(row, nodes);
               whole = whole && document;
               if (whole) kept.past.push_back({std::string(row.text(0)), *document});
             });
    if (!whole) {
      kept.past.clear();
      damage_.lose("the steps that could be undone can't be read");
    }
    if (!has_versions) return;
    const char* sql = "SELECT name, next_id, nodes, png FROM versions ORDER BY number";
    each_row(database_, sql, "versions", damage_, [&](const Statement& row) {
      const std::string name(row.text(0));
      const auto document = document_of(row, nodes);
      if (!document) return damage_.lose("its version '" + printable(name) + "' can't be read");
      kept.versions.push_back({name, *document, png_of(row, 3)});
    });
  }

  /// Null where it can't be read.
  std::shared_ptr<const Node> past_node(std::string_view bytes) {
    try {
      NodeRow row = past_row_of(bytes);
      if (row.kind) row.node.source = value_of(*row.kind, row.hash).first;
      if (row.kind && !row.node.source) return nullptr;
      if (row.backdrop) {
        const auto& picture = value_of(ValueType::PictureFile, row.picture_hash).first;
        row.backdrop->picture = picture ? picture->as<PictureFile>() : nullptr;
        if (!is_valid(*row.backdrop)) return nullptr;
        row.node.backdrop = std::make_shared<const Backdrop>(*row.backdrop);
      }
      return std::make_shared<const Node>(std::move(row.node));
    } catch (const BadBytes&) {
      return nullptr;
    }
  }

  using Loaded = std::pair<std::optional<Value>, std::string>;

  // Nodes that have the same contents share them again, and a broken blob is checked once.
  const Loaded& value_of(ValueType kind, const std::string& hash) {
    const auto [place, is_new] = values_.try_emplace({kind, hash});
    if (!is_new) return place->second;
    try {
      place->second.first = decode(kind, load_blob(database_, hash, progress_));
    } catch (const BadBytes& bad) {
      place->second.second = bad.what();
    } catch (const DatabaseError&) {
      place->second.second = changed_bytes;
    }
    return place->second;
  }

  // A whole file keeps all its links, even those that lead nowhere: the evaluator reports them.
  void drop_dead_links(std::vector<NodeRow>& rows) {
    if (damage_.empty()) return;
    std::set<NodeId> alive;
    for (const NodeRow& row : rows) alive.insert(row.node.id);
    for (NodeRow& row : rows) {
      std::erase_if(row.node.inputs, [&](const auto& input) {
        if (alive.contains(input.second.node)) return false;
        damage_.lose(title_of(row.node) + " has lost its input '" + printable(input.first) + "'",
                     {node_subject(row.node)});
        return true;
      });
    }
  }

  Database& database_;
  Progress& progress_;
  std::span<const ValueType> types_;
  DamageLog damage_;
  Findings warnings_;
  std::int64_t version_ = 0;
  std::map<std::pair<ValueType, std::string>, Loaded> values_;
};

}  // namespace

ProjectFile read_project_database(Database& database, const std::string& file_name, Progress& progress,
                                  std::span<const ValueType> types) {
  return ProjectReader(database, file_name, progress, types).read();
}

std::vector<std::uint8_t> read_thumbnail(const Database& database) {
  Statement statement(database, "SELECT png FROM thumbnail LIMIT 1");
  return statement.step() ? png_of(statement, 0) : std::vector<std::uint8_t>();
}

std::string read_meta(const Database& database, const std::string& key) {
  Statement statement(database, "SELECT value FROM meta WHERE key=?");
  return statement.bind_text(0, key).step() ? std::string(statement.text(0)) : "";
}

}  // namespace croquis
