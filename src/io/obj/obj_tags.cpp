// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj/obj_tags.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/channel_values.h"

namespace croquis {
namespace {

/// The values of a tag statement.
struct Values {
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

/// Reads what the counts announce; false after an error.
class ValueReader {
 public:
  ValueReader(WordReader& words, std::int64_t line, ReadContext& context)
      : words_(words), line_(line), context_(context) {}

  bool read(Values& values) {
    const std::string_view header = words_.next();
    std::array<std::size_t, 3> counts{};
    if (!parse_counts(header, counts)) return refuse(in_quotes(header) + " is not the counts of a tag, such as 2/1/0");
    return read_list(counts[0], values.vertices, "a vertex number") &&
           read_list(counts[1], values.numbers, "a sharpness") && pass_strings(counts[2]) && at_end();
  }

  bool refuse(const std::string& message) {
    context_.error("E_SYNTAX", message, at_line(line_));
    return false;
  }

 private:
  template <typename T>
  bool read_list(std::size_t count, std::vector<T>& list, const char* what) {
    for (; count > 0; --count) {
      const std::string_view word = words_.next();
      if (word.empty()) return refuse("the tag has fewer values than it announces");
      if (!parse_number(word, list.emplace_back())) return refuse(in_quotes(word) + " is not " + what);
    }
    return true;
  }

  bool pass_strings(std::size_t count) {
    for (; count > 0; --count) {
      if (words_.next().empty()) return refuse("the tag has fewer values than it announces");
    }
    return true;
  }

  bool at_end() { return words_.next().empty() || refuse("the tag has more values than it announces"); }

  WordReader& words_;
  std::int64_t line_;
  ReadContext& context_;
};

/// The sharpness of the i-th of `count` elements; OpenSubdiv looks up that of an edge by its first vertex.
double sharpness_of(const Values& values, std::size_t i, std::size_t count) {
  if (values.numbers.size() == 1) return values.numbers[0];
  return values.numbers[values.numbers.size() == count ? i : 2 * i];
}

void add_creases(const Values& values, MeshTags& tags) {
  const std::size_t count = values.vertices.size() / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const double sharpness = sharpness_of(values, i, count);
    tags.creases.push_back({{values.vertices[2 * i], values.vertices[2 * i + 1]},
                            sharpness >= greatest_sharpness ? infinite_sharpness : sharpness});
  }
}

void add_pins(const Values& values, std::int64_t line, MeshTags& tags, ReadContext& context) {
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
                 at_line(line), vertex_subject(vertex));
  }
}

bool fits(const Values& values, std::size_t vertices_each) {
  const std::size_t count = values.vertices.size() / vertices_each;
  const std::size_t numbers = values.numbers.size();
  return count > 0 && values.vertices.size() % vertices_each == 0 &&
         (numbers == 1 || numbers == count || numbers == values.vertices.size());
}

}  // namespace

std::string_view ObjTagReader::read(WordReader& words, std::int64_t line, ReadContext& context) {
  ValueReader reader(words, line, context);
  const std::string_view name = words.next();
  const bool crease = name == "crease", corner = name == "corner";
  if (!crease && !corner && name != "settled") {
    if (name.empty()) reader.refuse("a tag has no name");
    return name;
  }
  Values values;
  if (!reader.read(values)) return {};
  if (!crease && !corner) {
    for (const Index vertex : values.vertices) settled_.push_back({vertex, line});
  } else if (!fits(values, crease ? 2 : 1)) {
    reader.refuse(crease ? "a crease has two vertices for each edge, and one sharpness or one for each edge"
                         : "a corner has vertices, and one sharpness or one for each of them");
  } else if (crease) {
    add_creases(values, tags_);
  } else {
    add_pins(values, line, tags_, context);
  }
  return {};
}

void ObjTagReader::finish(PolyMesh& mesh, ReadContext& context) {
  mesh.tags = std::move(tags_);
  if (settled_.empty()) return;
  std::vector<std::uint8_t> values(mesh.vertex_count(), 0);
  for (const Settled& settled : settled_) {
    if (settled.vertex < values.size()) {
      values[settled.vertex] = 1;
    } else {
      context.error("E_INDEX", "there is no vertex " + std::to_string(settled.vertex), at_line(settled.line));
    }
  }
  mesh.channels.push_back(make_channel(settled_channel_name, Domain::Vertex, 1, std::move(values)));
}

void append_obj_tags(const MeshTags& tags, const AttributeChannel* settled, int precision, std::string& text) {
  for (const Crease& crease : tags.creases) {
    text += "t crease 2/1/0";
    for (const Index vertex : crease.vertices) append_number(text += ' ', vertex);
    const bool infinite = crease.sharpness >= greatest_sharpness;
    append_number(text += ' ', infinite ? greatest_sharpness : crease.sharpness, precision);
    text += '\n';
  }
  for (const Index vertex : tags.pins) {
    append_number(text += "t corner 1/1/0 ", vertex);
    append_number(text += ' ', greatest_sharpness);
    text += '\n';
  }
  for (std::size_t v = 0; settled != nullptr && v < settled->size(); ++v) {
    if (value_of(*settled, v) == 0) continue;
    append_number(text += "t settled 1/0/0 ", v);
    text += '\n';
  }
}

}  // namespace croquis
