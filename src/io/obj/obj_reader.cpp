// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/limits.h"
#include "croquis/geometry/poly_mesh.h"
#include "io/channel_values.h"
#include "io/mesh_formats.h"
#include "io/text.h"

namespace croquis {
namespace {

// Keywords of the format for what a mesh can't hold.
constexpr std::array passed_over = {
    "mtllib", "maplib", "usemap", "p",    "mg",   "bevel",  "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj",
    "ctech",  "stech",  "call",   "csh",  "vp",   "cstype", "deg",      "bmat",     "step", "curv",       "curv2",
    "surf",   "parm",   "trim",   "hole", "scrv", "sp",     "end",      "con",      "xref"};

const char* what_is_lost(std::string_view keyword) {
  if (keyword.starts_with("t ")) return "of tags only crease and corner are read";
  if (keyword == "mtllib") return "the material library is not read, material names are kept";
  if (keyword == "p") return "points as elements are not read";
  return "they say nothing that a mesh holds";
}

/// A table of OBJ's (`vt`, `vn`) and which of its entries each corner uses.
struct ObjCornerTable {
  const char* name;
  int width;
  std::vector<std::array<double, 3>> entries = {};
  std::vector<Index> of_corners = {};  // empty until one is used
};

/// @param entry place in the table, or no_index
void add_corner(ObjCornerTable& table, Index entry, std::size_t corners_before) {
  if (entry == no_index && table.of_corners.empty()) return;
  table.of_corners.resize(corners_before, no_index);
  table.of_corners.push_back(entry);
}

/// The channel: on vertices where every corner uses the entry of its vertex' own number, else on corners.
void add_channel(ObjCornerTable& table, PolyMesh& mesh) {
  const bool on_vertices = table.entries.size() == mesh.vertex_count() && table.of_corners == mesh.corners;
  if (table.entries.empty() || !(on_vertices || !table.of_corners.empty())) return;
  const auto width = static_cast<std::size_t>(table.width);
  const std::size_t count = on_vertices ? table.entries.size() : mesh.corners.size();
  table.of_corners.resize(mesh.corners.size(), no_index);
  std::vector<double> values(count * width, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t entry = on_vertices ? i : table.of_corners[i];
    if (entry == no_index) continue;
    std::copy_n(table.entries[entry].begin(), width, values.begin() + static_cast<std::ptrdiff_t>(i * width));
  }
  mesh.channels.push_back(
      make_channel(table.name, on_vertices ? Domain::Vertex : Domain::Corner, table.width, std::move(values)));
}

// Joins lines that end with a backslash; copies only those.
class StatementReader {
 public:
  explicit StatementReader(std::string_view bytes) : lines_(bytes) {}

  bool next(TextLine& statement) {
    if (!lines_.next(statement)) return false;
    if (!continues(statement.text)) return true;
    joined_.clear();
    TextLine line = statement;
    do {
      joined_.append(line.text.substr(0, line.text.size() - 1)).append(1, ' ');
    } while (lines_.next(line) && continues(line.text));
    if (!continues(line.text)) joined_.append(line.text);
    statement.text = joined_;
    return true;
  }

  std::size_t position() const { return lines_.position(); }

 private:
  static bool continues(std::string_view text) { return !text.empty() && text.back() == '\\'; }

  LineReader lines_;
  std::string joined_;
};

/// The values of a tag statement.
struct TagValues {
  std::vector<Index> vertices;
  std::vector<double> numbers;
};

/// "2/1/0"
bool parse_counts(std::string_view word, std::array<std::size_t, 3>& counts) {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    if (!parse_number(word.substr(0, slash), counts[i])) return false;
    if (slash == word.size()) return i + 1 == counts.size();
    word.remove_prefix(slash + 1);
  }
  return false;
}

/// Reads what a tag's counts announce. @return what is wrong; empty for nothing
std::string read_tag_values(WordReader& words, TagValues& values) {
  const std::string_view header = words.next();
  std::array<std::size_t, 3> counts{};
  if (!parse_counts(header, counts)) return in_quotes(header) + " is not the counts of a tag, such as 2/1/0";
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    for (std::size_t left = counts[kind]; left > 0; --left) {
      const std::string_view word = words.next();
      if (word.empty()) return "the tag has fewer values than it announces";
      if (kind == 0 && !parse_number(word, values.vertices.emplace_back()))
        return in_quotes(word) + " is not a vertex number";
      if (kind == 1 && !parse_number(word, values.numbers.emplace_back()))
        return in_quotes(word) + " is not a sharpness";
    }
  }
  return words.next().empty() ? "" : "the tag has more values than it announces";
}

/// The sharpness of the i-th of `count` elements; OpenSubdiv looks up that of an edge by its first vertex.
double sharpness_of(const TagValues& values, std::size_t i, std::size_t count) {
  if (values.numbers.size() == 1) return values.numbers[0];
  return values.numbers[values.numbers.size() == count ? i : 2 * i];
}

bool fits(const TagValues& values, std::size_t vertices_each) {
  const std::size_t count = values.vertices.size() / vertices_each;
  const std::size_t numbers = values.numbers.size();
  return count > 0 && values.vertices.size() % vertices_each == 0 &&
         (numbers == 1 || numbers == count || numbers == values.vertices.size());
}

void add_creases(const TagValues& values, MeshTags& tags) {
  const std::size_t count = values.vertices.size() / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const double sharpness = sharpness_of(values, i, count);
    tags.creases.push_back({{values.vertices[2 * i], values.vertices[2 * i + 1]},
                            sharpness >= greatest_sharpness ? infinite_sharpness : sharpness});
  }
}

/// A corner is a pin, whatever its sharpness.
void add_pins(const TagValues& values, Place place, MeshTags& tags, ReadContext& context) {
  for (std::size_t i = 0; i < values.vertices.size(); ++i) {
    const Index vertex = values.vertices[i];
    const double sharpness = sharpness_of(values, i, values.vertices.size());
    const bool is_pin = sharpness > 0;
    if (is_pin) tags.pins.push_back(vertex);
    if (sharpness >= greatest_sharpness) continue;
    std::string number;
    append_number(number, sharpness);
    context.warn("W_TAG_SHARPNESS",
                 "vertex " + std::to_string(vertex) + " has the sharpness " + number +
                     (is_pin ? ", but vertices are pinned or not: it is pinned" : " and is not pinned"),
                 place, vertex_subject(vertex));
  }
}

constexpr std::int64_t absent = std::numeric_limits<std::int64_t>::min();
constexpr std::size_t no_face = std::numeric_limits<std::size_t>::max();

struct Reference {
  std::int64_t vertex = absent, uv = absent, normal = absent;  // as written
};

// "v", "v/t", "v//n" or "v/t/n"; some exporters leave the slashes of what they don't have.
bool parse_reference(std::string_view word, Reference& reference) {
  const std::array parts = {&reference.vertex, &reference.uv, &reference.normal};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::string_view part = word.substr(0, slash);
    if (part.empty() ? i == 0 : !parse_number(part, *parts[i])) return false;
    if (slash == word.size()) return true;
    word.remove_prefix(slash + 1);
  }
  return false;
}

// The number of values read, or -1 after an error.
int read_numbers(WordReader& words, std::span<double> values, Place place, ReadContext& context) {
  int count = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (static_cast<std::size_t>(count) == values.size()) {
      context.error("E_SYNTAX", "there are more than " + std::to_string(count) + " numbers", place);
      return -1;
    }
    if (!parse_number(word, values[static_cast<std::size_t>(count)])) {
      context.error("E_SYNTAX", in_quotes(word) + " is not a number", place);
      return -1;
    }
    ++count;
  }
  return count;
}

// False after an error.
bool read_references(WordReader& words, Place place, ReadContext& context, std::vector<Reference>& references) {
  references.clear();
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (parse_reference(word, references.emplace_back())) continue;
    context.error("E_SYNTAX", in_quotes(word) + " is not a vertex reference like 3, 3/1 or 3/1/2", place);
    return false;
  }
  return true;
}

// Corners that an earlier refinement has made, with the lines that name them.
using SettledCorners = std::vector<std::pair<Index, std::int64_t>>;

void add_settled(const SettledCorners& settled, PolyMesh& mesh, ReadContext& context) {
  if (settled.empty()) return;
  std::vector<std::uint8_t> values(mesh.vertex_count(), 0);
  for (const auto& [vertex, line] : settled) {
    if (vertex < values.size()) {
      values[vertex] = 1;
    } else {
      context.error("E_INDEX", "there is no vertex " + std::to_string(vertex), at_line(line));
    }
  }
  mesh.channels.push_back(make_channel(settled_corner_channel, Domain::Vertex, 1, std::move(values)));
}

// @param colours four numbers per vertex, up to the last that has a colour
void add_colours(std::vector<double> colours, int width, PolyMesh& mesh) {
  if (colours.empty()) return;
  colours.resize(4 * mesh.vertex_count(), std::numeric_limits<double>::quiet_NaN());
  std::vector<double> values;
  values.reserve(mesh.vertex_count() * static_cast<std::size_t>(width));
  for (auto first = colours.begin(); first != colours.end(); first += 4)
    values.insert(values.end(), first, first + width);
  mesh.channels.push_back(make_channel("color", Domain::Vertex, width, std::move(values)));
}

class ObjReader {
 public:
  ObjReader(std::string_view bytes, ReadContext& context) : statements_(bytes), context_(context) {}

  PolyMesh read() {
    TextLine statement;
    while (statements_.next(statement)) {
      context_.tick(statements_.position());
      line_ = statement.number;
      WordReader words(statement.text);
      const std::string_view keyword = words.next();
      if (!keyword.empty()) handle(keyword, words);
    }
    finish();
    return std::move(mesh_);
  }

 private:
  // A reference to something further down the file, which can be judged only at its end.
  struct Forward {
    std::int64_t line, value;
    std::size_t face;
    int kind;
  };

  void handle(std::string_view keyword, WordReader& words) {
    if (keyword == "v") return read_vertex(words);
    if (keyword == "f" || keyword == "fo") return read_face(words);
    if (keyword == "vn") return read_table_entry(normals_, words, 3, "normal");
    if (keyword == "vt") return read_table_entry(uvs_, words, 1, "texture coordinate");
    if (keyword == "l") return read_line(words);
    if (keyword == "s") return read_smoothing(words);
    if (keyword == "t") return read_tag(words);
    if (keyword == "g" || keyword == "o" || keyword == "usemtl") {
      CategoryState& category = keyword == "g" ? groups_ : keyword == "o" ? objects_ : materials_;
      const std::string_view name = words.rest();
      return category.set(name.empty() ? "default" : name);
    }
    pass_over(keyword);
  }

  void read_vertex(WordReader& words) {
    std::array<double, 7> values{};
    const int count = read_numbers(words, values, at_line(line_), context_);
    mesh_.positions.emplace_back(values[0], values[1], values[2]);  // even after an error, to keep the numbering
    if (count < 0) return;
    const std::size_t vertex = mesh_.vertex_count() - 1;
    if (count < 3 || count == 5) {
      return context_.error("E_SYNTAX",
                            "a vertex has 3 coordinates (and 3 or 4 colour values), not " + std::to_string(count),
                            at_line(line_), vertex_subject(vertex));
    }
    if (!are_usable_numbers(mesh_.positions.back())) context_.not_finite(vertex, at_line(line_));
    if (count == 4 && values[3] != 1) ++weights_;
    if (count >= 6) add_colour(values.data() + 3, count - 3);
  }

  void read_table_entry(ObjCornerTable& table, WordReader& words, int least, const char* what) {
    std::array<double, 3> values{};
    const int count = read_numbers(words, values, at_line(line_), context_);
    table.entries.push_back(values);
    table.width = std::max(table.width, count);
    if (count >= 0 && count < least) {
      context_.error("E_SYNTAX", std::string("a ") + what + " has too few numbers", at_line(line_));
    }
  }

  void add_colour(const double* values, int width) {
    colours_.resize(4 * (mesh_.vertex_count() - 1), std::numeric_limits<double>::quiet_NaN());
    colours_.insert(colours_.end(), values, values + 3);
    colours_.push_back(width == 4 ? values[3] : 1);
    colour_width_ = std::max(colour_width_, width);
  }

  void read_face(WordReader& words) {
    face_ = faces_met_++;
    if (!read_references(words, at_line(line_), context_, references_)) return;
    const std::size_t corners_before = mesh_.corners.size();
    if (references_.size() < 3) context_.too_few_corners(face_, references_.size(), at_line(line_));
    vertices_.clear();
    for (std::size_t i = 0; i < references_.size(); ++i) {
      const Reference& r = references_[i];
      vertices_.push_back(resolve(r.vertex, mesh_.vertex_count(), 0));
      add_corner(uvs_, r.uv == absent ? no_index : resolve(r.uv, uvs_.entries.size(), 1), corners_before + i);
      add_corner(normals_, r.normal == absent ? no_index : resolve(r.normal, normals_.entries.size(), 2),
                 corners_before + i);
    }
    const std::size_t face = mesh_.face_count();
    for (CategoryState* category : {&groups_, &objects_, &materials_}) category->face_added(face);
    if (smoothing_named_) {
      smoothing_.resize(face, 0);
      smoothing_.push_back(smoothing_group_);
    }
    mesh_.add_face(vertices_);
  }

  void read_line(WordReader& words) {
    face_ = no_face;
    if (!read_references(words, at_line(line_), context_, references_)) return;
    if (references_.size() < 2) {
      return context_.error("E_SYNTAX", "a polyline needs at least 2 vertices", at_line(line_));
    }
    vertices_.clear();
    for (const Reference& r : references_) vertices_.push_back(resolve(r.vertex, mesh_.vertex_count(), 0));
    for (CategoryState* category : {&groups_, &objects_, &materials_}) category->line_added(mesh_.line_count());
    mesh_.add_line(vertices_);
  }

  Index resolve(std::int64_t value, std::size_t count, int kind) {
    const auto known = static_cast<std::int64_t>(count);
    if (value < 0 && value >= -known) return static_cast<Index>(known + value);
    if (value <= 0 || value >= no_index) {
      report_index(line_, face_, value, kind);
      return 0;
    }
    if (value > known) forward_.push_back({line_, value, face_, kind});
    return static_cast<Index>(value - 1);
  }

  void read_smoothing(WordReader& words) {
    const std::string_view word = words.next();
    smoothing_group_ = 0;
    if (word != "off" && !parse_number(word, smoothing_group_)) {
      context_.error("E_SYNTAX", in_quotes(word) + " is not the number of a smoothing group", at_line(line_));
    }
    smoothing_named_ = true;
  }

  /// `t crease` and `t corner` as OpenSubdiv's shape files have them: NAME, INTS/FLOATS/STRINGS, and so many values (`t
  /// crease 2/1/0 A B SHARPNESS`, `t corner 1/1/0 V SHARPNESS`). Vertices count from 0, 10 and more is infinite. One
  /// statement may tag several edges or vertices, with one sharpness for all or one for each. Whether such edges exist
  /// is not checked. `t settled 1/0/0 V` is our own: the channel "settled_corner", by which a refinement that goes on
  /// from a file knows corners that an earlier one has made; others pass over tags that they don't know.
  void read_tag(WordReader& words) {
    const auto refuse = [&](const std::string& what) { context_.error("E_SYNTAX", what, at_line(line_)); };
    const std::string_view name = words.next();
    const bool crease = name == "crease", corner = name == "corner";
    if (name.empty()) return refuse("a tag has no name");
    if (!crease && !corner && name != "settled") return note_passed_over("t " + std::string(name));
    TagValues values;
    if (const std::string wrong = read_tag_values(words, values); !wrong.empty()) return refuse(wrong);
    if (!crease && !corner) {
      for (const Index vertex : values.vertices) settled_.emplace_back(vertex, line_);
    } else if (!fits(values, crease ? 2 : 1)) {
      refuse(crease ? "a crease has two vertices for each edge, and one sharpness or one for each edge"
                    : "a corner has vertices, and one sharpness or one for each of them");
    } else if (crease) {
      add_creases(values, mesh_.tags);
    } else {
      add_pins(values, at_line(line_), mesh_.tags, context_);
    }
  }

  void pass_over(std::string_view keyword) {
    if (std::find(passed_over.begin(), passed_over.end(), keyword) == passed_over.end()) {
      return context_.error("E_SYNTAX", "the statement " + in_quotes(keyword) + " does not exist in OBJ",
                            at_line(line_));
    }
    note_passed_over(keyword);
  }

  void note_passed_over(std::string_view keyword) {
    auto entry = passed_.find(keyword);
    if (entry == passed_.end()) entry = passed_.emplace(keyword, std::pair{std::size_t{0}, line_}).first;
    ++entry->second.first;
  }

  void report_index(std::int64_t line, std::size_t face, std::int64_t value, int kind) {
    static constexpr std::array names = {"vertex", "texture coordinate", "normal"};
    const std::array counts = {mesh_.vertex_count(), uvs_.entries.size(), normals_.entries.size()};
    const auto k = static_cast<std::size_t>(kind);
    const std::string why = value == 0  ? "but OBJ counts from 1"
                            : value < 0 ? "but only " + std::to_string(counts[k]) + " stand before it"
                                        : "but the file has " + std::to_string(counts[k]);
    context_.error("E_INDEX",
                   "the element uses " + std::string(names[k]) + " number " + std::to_string(value) + ", " + why,
                   at_line(line), face == no_face ? std::vector<Subject>{} : face_subject(face));
  }

  void finish() {
    const std::array counts = {mesh_.vertex_count(), uvs_.entries.size(), normals_.entries.size()};
    for (const Forward& f : forward_) {
      if (f.value > static_cast<std::int64_t>(counts[static_cast<std::size_t>(f.kind)])) {
        report_index(f.line, f.face, f.value, f.kind);
      }
    }
    add_settled(settled_, mesh_, context_);
    if (context_.has_errors()) return;
    add_colours(std::move(colours_), colour_width_, mesh_);
    add_channel(uvs_, mesh_);
    add_channel(normals_, mesh_);
    for (CategoryState* category : {&objects_, &groups_, &materials_}) category->finish(mesh_);
    if (!smoothing_.empty()) {
      mesh_.channels.push_back(make_channel("smoothing_group", Domain::Face, 1, std::move(smoothing_)));
    }
    for (const auto& [keyword, met] : passed_) {
      context_.warn("W_IGNORED",
                    std::to_string(met.first) + " " + in_quotes(keyword) +
                        " statements were passed over: " + what_is_lost(keyword),
                    at_line(met.second));
    }
    if (weights_ > 0) {
      context_.warn("W_IGNORED", "the weights of " + std::to_string(weights_) + " vertices were passed over", {});
    }
  }

  StatementReader statements_;
  ReadContext& context_;
  PolyMesh mesh_;
  std::int64_t line_ = 0;
  std::size_t faces_met_ = 0;
  std::size_t face_ = no_face;  // the one being read
  std::vector<Reference> references_;
  std::vector<Index> vertices_;
  std::vector<Forward> forward_;
  CategoryState groups_{"group"}, objects_{"object"}, materials_{"material"};
  ObjCornerTable uvs_{"uv", 2}, normals_{"normal", 3};
  std::vector<double> colours_;  // four per vertex, empty until one has a colour
  int colour_width_ = 3;
  std::vector<std::int32_t> smoothing_;
  std::int32_t smoothing_group_ = 0;
  bool smoothing_named_ = false;
  SettledCorners settled_;
  std::size_t weights_ = 0;
  std::map<std::string, std::pair<std::size_t, std::int64_t>, std::less<>> passed_;  // count and first line
};

}  // namespace

PolyMesh read_obj(std::string_view bytes, ReadContext& context) { return ObjReader(bytes, context).read(); }

}  // namespace croquis
