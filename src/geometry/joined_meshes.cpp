// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/joined_meshes.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace croquis {
namespace {

/// The identity rounds nothing.
PolyMesh mapped(const NamedMesh& named) {
  return named.map.is_identity() ? *named.mesh : transformed(*named.mesh, named.map);
}

/// The mesh where it belongs, its own objects as groups.
PolyMesh part_of_joined(const NamedMesh& named) {
  PolyMesh part = mapped(named);
  for (const Domain domain : {Domain::Face, Domain::Line}) {
    AttributeChannel* objects = part.channel("object", domain);
    if (objects == nullptr) continue;
    if (part.channel("group", domain) == nullptr) {
      objects->name = "group";
    } else {
      std::erase_if(part.channels, [&](const auto& channel) { return &channel == objects; });
    }
  }
  return part;
}

/// Values that say "none here"; nothing where the channel's type has none.
std::optional<AttributeChannel::Data> none_of(const AttributeChannel& like, std::size_t count) {
  return std::visit(
      [&](const auto& values) -> std::optional<AttributeChannel::Data> {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_floating_point_v<Value>) {
          return std::vector<Value>(count, std::numeric_limits<Value>::quiet_NaN());
        } else if constexpr (std::is_signed_v<Value>) {
          if (!like.labels.empty()) return std::vector<Value>(count, Value{-1});
        }
        return std::nullopt;
      },
      like.data);
}

/// Adds the values of the next mesh; labels are counted on. @return false: they don't fit
bool append(AttributeChannel& all, const AttributeChannel& next) {
  if (all.width != next.width || all.data.index() != next.data.index()) return false;
  const double first_label = static_cast<double>(all.labels.size());
  const double label_end = first_label + static_cast<double>(next.labels.size());
  const bool fits = std::visit(
      [&](auto& values) {
        using Values = std::decay_t<decltype(values)>;
        using Value = typename Values::value_type;
        const bool labelled = !next.labels.empty();
        if (labelled && label_end > static_cast<double>(std::numeric_limits<Value>::max())) return false;
        for (const Value value : std::get<Values>(next.data)) {
          const double number = static_cast<double>(value);
          values.push_back(labelled && number >= 0 ? static_cast<Value>(number + first_label) : value);
        }
        return true;
      },
      all.data);
  if (fits) all.labels.insert(all.labels.end(), next.labels.begin(), next.labels.end());
  return fits;
}

using ChannelKey = std::pair<std::string, Domain>;

/// One channel of all meshes; nothing where that can't be.
std::optional<AttributeChannel> joined_channel(const std::vector<PolyMesh>& parts, const ChannelKey& key) {
  const AttributeChannel* like = nullptr;
  for (const PolyMesh& part : parts) {
    if (like == nullptr) like = part.channel(key.first, key.second);
  }
  AttributeChannel all = *like;
  all.labels.clear();
  std::visit([](auto& values) { values.clear(); }, all.data);
  for (const PolyMesh& part : parts) {
    const AttributeChannel* own = part.channel(key.first, key.second);
    if (own == nullptr) {
      auto none = none_of(*like, part.element_count(key.second) * static_cast<std::size_t>(like->width));
      if (!none) return std::nullopt;
      if (!append(all, {key.first, key.second, like->width, *std::move(none), {}})) return std::nullopt;
    } else if (!append(all, *own)) {
      return std::nullopt;
    }
  }
  return all;
}

AttributeChannel names_of(const std::vector<NamedMesh>& meshes, const std::vector<PolyMesh>& parts, Domain domain) {
  std::vector<std::int32_t> numbers;
  AttributeChannel names{"object", domain, 1, {}, {}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    numbers.insert(numbers.end(), parts[i].element_count(domain), static_cast<std::int32_t>(i));
    names.labels.push_back(meshes[i].name);
  }
  names.data = std::move(numbers);
  return names;
}

void append_tags(MeshTags& all, const MeshTags& next, Index first, const std::string& name) {
  for (Crease crease : next.creases) {
    for (Index& vertex : crease.vertices) vertex += first;
    all.creases.push_back(crease);
  }
  for (const Index pin : next.pins) all.pins.push_back(pin + first);
  for (CreaseSet set : next.sets) {
    const bool taken = std::ranges::find(all.sets, set.name, &CreaseSet::name) != all.sets.end();
    if (taken) set.name += " (" + name + ')';
    for (auto& edge : set.edges) {
      for (Index& vertex : edge) vertex += first;
    }
    for (Index& pin : set.pins) pin += first;
    all.sets.push_back(std::move(set));
  }
}

}  // namespace

PolyMesh joined(const std::vector<NamedMesh>& meshes) {
  if (meshes.size() == 1) return mapped(meshes.front());
  std::vector<PolyMesh> parts;
  for (const NamedMesh& named : meshes) parts.push_back(part_of_joined(named));
  PolyMesh all;
  std::vector<ChannelKey> keys;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PolyMesh& part = parts[i];
    const auto first = static_cast<Index>(all.positions.size());
    const auto first_corner = static_cast<Index>(all.corners.size());
    const auto first_line = static_cast<Index>(all.line_vertices.size());
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
    for (const Index corner : part.corners) all.corners.push_back(corner + first);
    for (const Index vertex : part.line_vertices) all.line_vertices.push_back(vertex + first);
    for (std::size_t f = 1; f < part.face_offsets.size(); ++f)
      all.face_offsets.push_back(part.face_offsets[f] + first_corner);
    for (std::size_t l = 1; l < part.line_offsets.size(); ++l)
      all.line_offsets.push_back(part.line_offsets[l] + first_line);
    append_tags(all.tags, part.tags, first, meshes[i].name);
    for (const AttributeChannel& channel : part.channels) {
      const ChannelKey key{channel.name, channel.domain};
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
    }
  }
  for (const ChannelKey& key : keys) {
    if (auto channel = joined_channel(parts, key)) all.channels.push_back(*std::move(channel));
  }
  if (all.face_count() > 0) all.channels.push_back(names_of(meshes, parts, Domain::Face));
  if (all.line_count() > 0) all.channels.push_back(names_of(meshes, parts, Domain::Line));
  return all;
}

}  // namespace croquis
