// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "croquis/base/limits.h"
#include "io/mesh_formats.h"
#include "io/ply/ply_tables.h"
#include "io/text.h"

namespace croquis {
namespace {

// The scalar columns not yet turned into a channel.
using Pool = std::vector<PlyColumn*>;

PlyColumn* find(const Pool& pool, std::string_view name) {
  const auto found =
      std::find_if(pool.begin(), pool.end(), [&](const PlyColumn* column) { return column->property.name == name; });
  return found == pool.end() ? nullptr : *found;
}

void add_channel(const std::string& name, Domain domain, const Pool& parts, Pool& pool, PolyMesh& mesh) {
  AttributeChannel channel{name, domain, static_cast<int>(parts.size()), {}, {}};
  std::visit(
      [&]<typename T>(std::vector<T>& first) {
        std::vector<T> values = parts.size() == 1 ? std::move(first) : std::vector<T>(first.size() * parts.size());
        for (std::size_t k = 0; parts.size() > 1 && k < parts.size(); ++k) {
          const auto& part = std::get<std::vector<T>>(parts[k]->values);
          for (std::size_t i = 0; i < part.size(); ++i) values[i * parts.size() + k] = part[i];
        }
        channel.data = std::move(values);
      },
      parts.front()->values);
  std::erase_if(pool, [&](const PlyColumn* c) { return std::find(parts.begin(), parts.end(), c) != parts.end(); });
  mesh.channels.push_back(std::move(channel));
}

bool same_types(const Pool& parts) {
  return std::all_of(parts.begin(), parts.end(), [&](const PlyColumn* part) {
    return part != nullptr && part->property.type == parts.front()->property.type;
  });
}

void add_named(Domain domain, Pool& pool, PolyMesh& mesh) {
  for (const PlyPartNames& row : ply_part_names) {
    Pool parts;
    for (int k = 0; k < row.width; ++k) parts.push_back(find(pool, row.parts[static_cast<std::size_t>(k)]));
    const std::string name(row.channel);
    if (mesh.channel(name, domain) == nullptr && parts.front() != nullptr && same_types(parts)) {
      add_channel(name, domain, parts, pool, mesh);
    }
  }
}

// name_0 name_1 …, one after the other in the file.
Pool numbered_run(const Pool& pool, std::size_t begin) {
  const std::string& first = pool[begin]->property.name;
  Pool parts;
  if (!first.ends_with("_0")) return parts;
  const std::string stem = first.substr(0, first.size() - 1);
  for (std::size_t i = begin; i < pool.size(); ++i) {
    const PlyProperty& property = pool[i]->property;
    if (property.name != stem + std::to_string(i - begin) || property.type != pool[begin]->property.type) break;
    parts.push_back(pool[i]);
  }
  return parts;
}

std::size_t element_size(const PlyTable& faces, const PolyMesh& mesh, const PlyColumn& column) {
  // The number of values per corner, when it is the same for every face that has any.
  std::size_t width = 0;
  for (std::size_t f = 0; f < faces.element.count; ++f) {
    const std::size_t corners = mesh.face(f).size();
    const std::size_t size = column.list_size(f);
    if (size == 0) continue;
    if (size % corners != 0 || (width != 0 && size != width * corners)) return 0;
    width = size / corners;
  }
  return width;
}

template <typename T>
std::vector<T> corner_values(const PolyMesh& mesh, const PlyColumn& column, const std::vector<T>& values,
                             std::size_t width) {
  std::vector<T> result;
  result.reserve(mesh.corners.size() * width);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(column.list_begin(f));
    result.insert(result.end(), begin, begin + static_cast<std::ptrdiff_t>(column.list_size(f)));
    result.resize(mesh.face_offsets[f + 1] * width, std::numeric_limits<T>::quiet_NaN());
  }
  return result;
}

bool has_empty_list(const PlyTable& faces, const PlyColumn& column) {
  for (std::size_t f = 0; f < faces.element.count; ++f) {
    if (column.list_size(f) == 0) return true;
  }
  return false;
}

/// Turns the scalar columns that are left in the table (those with values) into channels of the mesh, joining the parts
/// of normals, colours, texture coordinates and name_0 name_1 …
void add_scalar_channels(PlyTable& table, Domain domain, PolyMesh& mesh) {
  Pool pool;
  for (PlyColumn& column : table.columns) {
    const bool full = std::visit([&](const auto& v) { return v.size() == table.element.count; }, column.values);
    if (!column.property.is_list && full) pool.push_back(&column);
  }
  add_named(domain, pool, mesh);
  while (!pool.empty()) {
    const Pool run = numbered_run(pool, 0);
    if (run.size() > 1) {
      const std::string& first = run.front()->property.name;
      add_channel(first.substr(0, first.size() - 2), domain, run, pool, mesh);
    } else {
      add_channel(pool.front()->property.name, domain, {pool.front()}, pool, mesh);
    }
  }
}

/// Turns face lists with the same number of values for each corner into corner channels; an empty list means "none" for
/// floating types. Other lists are passed over with a warning.
void add_corner_channels(PlyTable& faces, PolyMesh& mesh, ReadContext& context) {
  for (PlyColumn& column : faces.columns) {
    if (!column.property.is_list || column.list_ends.empty()) continue;
    const std::size_t width = element_size(faces, mesh, column);
    if (width == 0 || (is_integer(column.property.type) && has_empty_list(faces, column))) {
      context.warn("W_IGNORED", "the list " + in_quotes(column.property.name) + " of faces was passed over", {});
      continue;
    }
    const bool is_uv = column.property.name == "texcoord" && width == 2;
    AttributeChannel channel{is_uv ? "uv" : column.property.name, Domain::Corner, static_cast<int>(width), {}, {}};
    std::visit([&](const auto& values) { channel.data = corner_values(mesh, column, values, width); }, column.values);
    mesh.channels.push_back(std::move(channel));
  }
}

// Takes the column's values out, so that no channel is made of them.
template <typename Target>
std::vector<Target> take_values(PlyColumn& column) {
  std::vector<Target> result;
  std::visit(
      [&](auto& values) {
        result.assign(values.begin(), values.end());
        values = {};
      },
      column.values);
  return result;
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, ReadContext& context) : bytes_(bytes), context_(context) {}

  PolyMesh read() {
    header_ = read_ply_header(bytes_, context_);
    cursor_ = {header_.body, header_.body_line};
    for (const PlyElement& element : header_.elements) read_table(element);
    check_end();
    if (context_.has_errors()) return {};
    if (!vertices_) context_.fail("E_SYNTAX", "the file has no element 'vertex'", {});
    make_positions();
    if (faces_) make_faces();
    if (strips_) make_strips();
    if (grid_) make_grid();
    if (edges_) make_lines();
    return std::move(mesh_);
  }

 private:
  void read_table(const PlyElement& element) {
    const std::array kept = {std::pair{"vertex", &vertices_}, std::pair{"face", &faces_},
                             std::pair{"tristrips", &strips_}, std::pair{"range_grid", &grid_},
                             std::pair{"edge", &edges_}};
    const auto target =
        std::find_if(kept.begin(), kept.end(), [&](const auto& entry) { return element.name == entry.first; });
    const bool keep = target != kept.end();
    PlyTable table = header_.encoding == PlyEncoding::Ascii
                         ? read_ply_text(bytes_, element, keep, cursor_, context_)
                         : read_ply_binary(bytes_, element, header_.encoding, keep, cursor_, context_);
    if (keep) {
      target->second->emplace(std::move(table));
    } else if (element.count > 0) {
      context_.warn("W_IGNORED",
                    std::to_string(element.count) + " elements " + in_quotes(element.name) + " were passed over", {});
    }
  }

  // Blank space at the end is harmless; anything else means that the header's counts are wrong.
  void check_end() {
    static constexpr std::string_view harmless(" \t\r\n\0", 5);
    const std::size_t rest = bytes_.find_first_not_of(harmless, cursor_.byte);
    if (rest == std::string_view::npos) return;
    const bool text = header_.encoding == PlyEncoding::Ascii;
    const auto skipped = std::count(bytes_.begin() + static_cast<std::ptrdiff_t>(cursor_.byte),
                                    bytes_.begin() + static_cast<std::ptrdiff_t>(rest), '\n');
    context_.error("E_COUNT", "the file holds more data than its header announces",
                   text ? at_line(cursor_.line + skipped) : at_byte(cursor_.byte));
  }

  PlyColumn* column(PlyTable& table, std::initializer_list<const char*> names, bool is_list) {
    for (PlyColumn& candidate : table.columns) {
      const bool named =
          std::any_of(names.begin(), names.end(), [&](const char* name) { return candidate.property.name == name; });
      if (named && candidate.property.is_list == is_list) return &candidate;
    }
    return nullptr;
  }

  PlyColumn& index_list(PlyTable& table) {
    PlyColumn* const list = column(table, {"vertex_indices", "vertex_index"}, true);
    if (list == nullptr || !is_integer(list->property.type)) {
      context_.fail("E_SYNTAX", in_quotes(table.element.name) + " has no list vertex_indices of integers", {});
    }
    return *list;
  }

  void make_positions() {
    static constexpr std::array axes = {"x", "y", "z"};
    mesh_.positions.resize(vertices_->element.count);
    for (int k = 0; k < 3; ++k) {
      PlyColumn* const axis = column(*vertices_, {axes[static_cast<std::size_t>(k)]}, false);
      if (axis == nullptr) context_.fail("E_SYNTAX", "the vertices lack x, y or z", {});
      std::visit(
          [&](auto& values) {
            for (std::size_t v = 0; v < values.size(); ++v) mesh_.positions[v][k] = static_cast<double>(values[v]);
            values = {};
          },
          axis->values);
      axis->property.name.clear();
    }
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (!are_usable_numbers(mesh_.positions[v])) context_.not_finite(v, vertices_->place(v));
    }
    if (vertices_->element.count > 0) add_scalar_channels(*vertices_, Domain::Vertex, mesh_);
    for (const PlyColumn& list : vertices_->columns) {
      if (!list.property.is_list) continue;
      context_.warn("W_IGNORED", "the list " + in_quotes(list.property.name) + " of vertices was passed over", {});
    }
  }

  void make_faces() {
    PlyColumn& list = index_list(*faces_);
    const std::size_t count = mesh_.vertex_count();
    std::visit(
        [&](auto& values) {
          mesh_.corners.reserve(values.size());
          mesh_.face_offsets.reserve(faces_->element.count + 1);
          for (std::size_t f = 0; f < faces_->element.count; ++f) {
            context_.tick(bytes_.size());
            if (list.list_size(f) < 3) context_.too_few_corners(f, list.list_size(f), faces_->place(f));
            for (std::size_t i = list.list_begin(f); i < list.list_ends[f]; ++i) {
              const auto index = static_cast<std::int64_t>(values[i]);
              const bool good = index >= 0 && static_cast<std::size_t>(index) < count;
              if (!good) context_.bad_index(f, index, count, faces_->place(f));
              mesh_.corners.push_back(good ? static_cast<Index>(index) : 0);
            }
            mesh_.face_offsets.push_back(static_cast<Index>(mesh_.corners.size()));
          }
          values = {};
        },
        list.values);
    list.list_ends.clear();
    if (context_.has_errors() || faces_->element.count == 0) return;
    add_scalar_channels(*faces_, Domain::Face, mesh_);
    add_corner_channels(*faces_, mesh_, context_);
  }

  void make_strips() {
    if (faces_ && faces_->element.count > 0) {
      return context_.error("E_SYNTAX", "the file has both faces and triangle strips", {});
    }
    PlyColumn& list = index_list(*strips_);
    const std::vector<Index> ends = list.list_ends;
    const auto values = take_values<std::int64_t>(list);
    for (std::size_t row = 0; row < ends.size(); ++row) {
      const std::size_t begin = row == 0 ? 0 : ends[row - 1];
      expand_strip(std::span(values).subspan(begin, ends[row] - begin), row);
    }
  }

  // Every other triangle turns round; -1 begins a new strip; triangles with a repeated vertex only steer the strip.
  void expand_strip(std::span<const std::int64_t> strip, std::size_t row) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < strip.size(); ++i) {
      context_.tick(bytes_.size());
      if (strip[i] == -1) {
        begin = i + 1;
        continue;
      }
      if (!check_index(strip[i], *strips_, row) || i < begin + 2) continue;
      const auto a = static_cast<Index>(strip[i - 2]), b = static_cast<Index>(strip[i - 1]);
      const auto c = static_cast<Index>(strip[i]);
      if (a == b || b == c || c == a) continue;
      (i - begin) % 2 == 0 ? mesh_.add_triangle(a, b, c) : mesh_.add_triangle(b, a, c);
    }
  }

  void make_grid() {
    if (mesh_.face_count() > 0) {
      return context_.warn("W_IGNORED", "the range grid was passed over: the file has faces of its own", {});
    }
    triangulate_range_grid(header_.grid, *grid_, index_list(*grid_), mesh_, context_);
  }

  void make_lines() {
    PlyColumn* const first = column(*edges_, {"vertex1"}, false);
    PlyColumn* const second = column(*edges_, {"vertex2"}, false);
    if (first == nullptr || second == nullptr || !is_integer(first->property.type) ||
        !is_integer(second->property.type)) {
      return context_.fail("E_SYNTAX", "the edges lack vertex1 or vertex2 as integers", {});
    }
    const auto a = take_values<std::int64_t>(*first), b = take_values<std::int64_t>(*second);
    for (std::size_t e = 0; e < a.size(); ++e) {
      if (!check_index(a[e], *edges_, e) || !check_index(b[e], *edges_, e)) continue;
      mesh_.add_line(std::array{static_cast<Index>(a[e]), static_cast<Index>(b[e])});
    }
    if (!context_.has_errors() && !a.empty()) add_scalar_channels(*edges_, Domain::Line, mesh_);
  }

  bool check_index(std::int64_t index, const PlyTable& table, std::size_t row) {
    if (index >= 0 && static_cast<std::size_t>(index) < mesh_.vertex_count()) return true;
    context_.error("E_INDEX",
                   "element " + std::to_string(row) + " of " + in_quotes(table.element.name) + " uses vertex " +
                       std::to_string(index) + ", but the file has " + std::to_string(mesh_.vertex_count()) +
                       " vertices",
                   table.place(row));
    return false;
  }

  std::string_view bytes_;
  ReadContext& context_;
  PlyHeader header_;
  PlyCursor cursor_;
  std::optional<PlyTable> vertices_, faces_, strips_, grid_, edges_;
  PolyMesh mesh_;
};

}  // namespace

PolyMesh read_ply(std::string_view bytes, ReadContext& context) { return PlyReader(bytes, context).read(); }

}  // namespace croquis
