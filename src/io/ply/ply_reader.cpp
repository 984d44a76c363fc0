// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>

#include "croquis/base/limits.h"
#include "io/mesh_formats.h"
#include "io/ply/ply_tables.h"
#include "io/text.h"

namespace croquis {
namespace {

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
