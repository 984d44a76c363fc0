// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

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

}  // namespace

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

}  // namespace croquis
