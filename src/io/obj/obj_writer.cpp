// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

#include "io/channel_values.h"
#include "io/mesh_formats.h"
#include "io/mesh_writing.h"
#include "io/text.h"

namespace croquis {
namespace {

// A `vt` or `vn` table: its distinct entries, and the entry of each corner.
struct CornerTable {
  std::size_t width = 0;
  std::vector<double> values;
  std::vector<Index> entries;  // per corner, no_index for none; empty when there is no table
};

using Entry = std::array<double, 3>;
using Bits = std::array<std::uint64_t, 3>;

// NaN anywhere means that there is none.
bool read_entry(const AttributeChannel& channel, std::size_t element, Entry& entry) {
  const auto width = static_cast<std::size_t>(channel.width);
  for (std::size_t k = 0; k < width; ++k) {
    entry[k] = value_of(channel, element * width + k);
    if (!std::isfinite(entry[k])) return false;
  }
  return true;
}

// Values that are bitwise the same share an entry, so that seams stay seams and nothing else is split.
CornerTable shared_entries(const PolyMesh& mesh, const AttributeChannel& channel) {
  CornerTable table{static_cast<std::size_t>(channel.width), {}, std::vector<Index>(mesh.corners.size(), no_index)};
  std::map<Bits, Index> known;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    Entry entry{};
    if (!read_entry(channel, channel.domain == Domain::Vertex ? mesh.corners[c] : c, entry)) continue;
    const auto [position, is_new] = known.try_emplace(std::bit_cast<Bits>(entry), static_cast<Index>(known.size()));
    if (is_new) table.values.insert(table.values.end(), entry.begin(), entry.begin() + channel.width);
    table.entries[c] = position->second;
  }
  return table;
}

CornerTable corner_table(const PolyMesh& mesh, const AttributeChannel* channel) {
  if (channel == nullptr) return {};
  if (channel->domain == Domain::Corner || !all_finite(*channel)) return shared_entries(mesh, *channel);
  CornerTable table{static_cast<std::size_t>(channel->width), {}, mesh.corners};
  table.values.reserve(channel->size());
  for (std::size_t i = 0; i < channel->size(); ++i) table.values.push_back(value_of(*channel, i));
  return table;
}

// A name has to stay on its line, and an element without one can't go back to having none.
std::string statement_name(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 0x20) c = '_';
  }
  name = trimmed(name);
  if (!name.empty() && name.back() == '\\') name.back() = '_';
  return name.empty() ? "default" : name;
}

/// The statements that read back as these tags; sets are left out.
/// @param settled the channel "settled_corner" of vertices, or null
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

class ObjWriter {
 public:
  ObjWriter(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress)
      : mesh_(mesh), precision_(options.precision), tick_(progress) {}

  MeshWriteResult write() {
    choose_channels();
    text_.reserve(64 * mesh_.vertex_count() + 8 * mesh_.corners.size());
    write_vertices();
    write_table("vt", uvs_);
    write_table("vn", normals_);
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) write_face(f);
    for (std::size_t l = 0; l < mesh_.line_count(); ++l) write_line(l);
    append_obj_tags(mesh_.tags, settled_, precision_, text_);
    loss_.note_sets(mesh_.tags);
    loss_.note_others(mesh_, written_);
    return {std::move(text_), loss_.warnings()};
  }

 private:
  // One of the states that hold for the elements after it.
  struct State {
    const char* keyword;
    const char* name;
    const AttributeChannel* faces = nullptr;
    const AttributeChannel* lines = nullptr;
    const AttributeChannel* last_channel = nullptr;  // of the last element looked at, and its value there
    double last_value = -1;
    std::string current = {};  // the name in force, empty before the first
  };

  void choose_channels() {
    colours_ = use("color", Domain::Vertex, 3, 4);
    settled_ = use(settled_corner_channel, Domain::Vertex, 1, 1);
    smoothing_ = use("smoothing_group", Domain::Face, 1, 1);
    const AttributeChannel* uv = use("uv", Domain::Corner, 2, 3);
    if (uv == nullptr) uv = use("uv", Domain::Vertex, 2, 3);
    const AttributeChannel* normal = use("normal", Domain::Corner, 3, 3);
    if (normal == nullptr) normal = use("normal", Domain::Vertex, 3, 3);
    uvs_ = corner_table(mesh_, uv);
    normals_ = corner_table(mesh_, normal);
    for (State& state : states_) {
      state.faces = use(state.name, Domain::Face, 1, 1);
      state.lines = use(state.name, Domain::Line, 1, 1);
    }
  }

  const AttributeChannel* use(const char* name, Domain domain, int width, int or_width) {
    const AttributeChannel* channel = usable_channel(mesh_, name, domain, width, or_width);
    if (channel != nullptr) written_.push_back(channel);
    return channel;
  }

  void write_vertices() {
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      tick_();
      text_ += 'v';
      for (int k = 0; k < 3; ++k) append_number(text_ += ' ', mesh_.positions[v][k], precision_);
      if (colours_ != nullptr) write_colour(v);
      text_ += '\n';
    }
  }

  void write_colour(std::size_t vertex) {
    const auto width = static_cast<std::size_t>(colours_->width);
    std::array<double, 4> colour = {0, 0, 0, 1};
    for (std::size_t k = 0; k < width; ++k) {
      colour[k] = colour_of(*colours_, vertex * width + k);
      if (!std::isfinite(colour[k])) return;
    }
    // An alpha of 1 is what a reader assumes; few programs read the seventh number.
    for (std::size_t k = 0; k < (colour[3] == 1 ? 3U : 4U); ++k) append_number(text_ += ' ', colour[k], precision_);
  }

  void write_table(const char* keyword, const CornerTable& table) {
    for (std::size_t i = 0; i < table.values.size(); ++i) {
      if (i % table.width == 0) text_ += keyword;
      append_number(text_ += ' ', table.values[i], precision_);
      if ((i + 1) % table.width == 0) text_ += '\n';
    }
  }

  void write_states(std::size_t element, const AttributeChannel* State::*channel) {
    for (State& state : states_) {
      const AttributeChannel* values = state.*channel;
      const double value = values == nullptr ? -1 : value_of(*values, element);
      if (values == state.last_channel && value == state.last_value) continue;
      state.last_channel = values;
      state.last_value = value;
      const std::string name = value < 0 ? std::string() : statement_name(label_of(*values, element));
      if (name == state.current) continue;
      text_.append(state.keyword).append(1, ' ').append(name.empty() ? "default" : name).append(1, '\n');
      state.current = name;
    }
  }

  void write_smoothing(std::size_t face) {
    if (smoothing_ == nullptr) return;
    const double group = value_of(*smoothing_, face);
    if (smoothing_written_ && group == smoothing_group_) return;
    smoothing_written_ = true;
    smoothing_group_ = group;
    text_ += "s ";
    if (group > 0) {
      append_number(text_, static_cast<std::int64_t>(std::min(group, 2147483647.0)));
    } else {
      text_ += "off";
    }
    text_ += '\n';
  }

  void write_face(std::size_t face) {
    tick_();
    write_states(face, &State::faces);
    write_smoothing(face);
    text_ += 'f';
    for (std::size_t c = mesh_.face_offsets[face]; c < mesh_.face_offsets[face + 1]; ++c) {
      const Index uv = uvs_.entries.empty() ? no_index : uvs_.entries[c];
      const Index normal = normals_.entries.empty() ? no_index : normals_.entries[c];
      append_number(text_ += ' ', std::uint64_t{mesh_.corners[c]} + 1);
      if (uv != no_index) append_number(text_ += '/', std::uint64_t{uv} + 1);
      if (normal != no_index) append_number(text_ += uv == no_index ? "//" : "/", std::uint64_t{normal} + 1);
    }
    text_ += '\n';
  }

  void write_line(std::size_t line) {
    tick_();
    write_states(line, &State::lines);
    text_ += 'l';
    for (const Index vertex : mesh_.line(line)) append_number(text_ += ' ', std::uint64_t{vertex} + 1);
    text_ += '\n';
  }

  const PolyMesh& mesh_;
  int precision_;
  WriteTick tick_;
  std::string text_;
  FormatLoss loss_{"OBJ"};
  std::vector<const AttributeChannel*> written_;
  const AttributeChannel* colours_ = nullptr;
  const AttributeChannel* smoothing_ = nullptr;
  const AttributeChannel* settled_ = nullptr;
  double smoothing_group_ = 0;
  bool smoothing_written_ = false;
  CornerTable uvs_, normals_;
  std::array<State, 3> states_ = {State{"o", "object"}, State{"g", "group"}, State{"usemtl", "material"}};
};

}  // namespace

MeshWriteResult write_obj(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress) {
  return ObjWriter(mesh, options, progress).write();
}

}  // namespace croquis
