// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_compare.h"

#include <bit>
#include <cmath>

#include <catch2/catch.hpp>

#include "support/random.h"

namespace croquis::test {
namespace {

template <typename T>
bool same_bits(T a, T b) {
  if constexpr (std::is_floating_point_v<T>) {
    if (std::isnan(a) && std::isnan(b)) return true;
    return a == b && std::signbit(a) == std::signbit(b);
  } else {
    return a == b;
  }
}

bool same_data(const AttributeChannel& a, const AttributeChannel& b) {
  if (a.data.index() != b.data.index()) return false;
  return std::visit(
      [&]<typename T>(const std::vector<T>& values) {
        const auto& others = std::get<std::vector<T>>(b.data);
        return std::equal(values.begin(), values.end(), others.begin(), others.end(), same_bits<T>);
      },
      a.data);
}

std::string name_of(const AttributeChannel& channel) {
  return channel.name + "/" + std::to_string(static_cast<int>(channel.domain));
}

template <typename T>
AttributeChannel random_channel(std::string name, Domain domain, int width, std::size_t elements, Random& random) {
  std::vector<T> values(elements * static_cast<std::size_t>(width));
  for (T& value : values) value = static_cast<T>(std::is_integral_v<T> ? random.below(120) : random.unit());
  return {std::move(name), domain, width, std::move(values), {}};
}

}  // namespace

std::string difference(const PolyMesh& a, const PolyMesh& b) {
  if (!same_connectivity(a, b)) return "connectivity";
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    for (int k = 0; k < 3; ++k) {
      if (!same_bits(a.positions[v][k], b.positions[v][k])) return "position " + std::to_string(v);
    }
  }
  for (const AttributeChannel& channel : a.channels) {
    const AttributeChannel* other = b.channel(channel.name, channel.domain);
    if (other == nullptr) return name_of(channel) + " is missing";
    if (other->width != channel.width || !same_data(channel, *other)) return name_of(channel) + " differs";
    if (other->labels != channel.labels) return name_of(channel) + " has other labels";
  }
  if (!same_tags(a.tags, b.tags)) return "tags";
  return a.channels.size() == b.channels.size() ? "" : "number of channels";
}

MeshReadResult read(const std::string& bytes, MeshFormat format) {
  Progress progress;
  return read_mesh(bytes, format, "file", progress);
}

MeshWriteResult write(const PolyMesh& mesh, MeshFormat format, MeshWriteOptions options) {
  Progress progress;
  return write_mesh(mesh, format, options, progress);
}

Findings refusal(const std::string& bytes, MeshFormat format) {
  try {
    read(bytes, format);
  } catch (const Error& error) {
    return error.findings();
  }
  FAIL("the file was read: " << bytes.substr(0, 200));
  return {};
}

PolyMesh with_attributes(PolyMesh mesh) {
  Random random(7);
  const std::size_t v = mesh.vertex_count(), f = mesh.face_count(), c = mesh.corners.size();
  mesh.channels = {random_channel<float>("normal", Domain::Vertex, 3, v, random),
                   random_channel<std::uint8_t>("color", Domain::Vertex, 4, v, random),
                   random_channel<double>("confidence", Domain::Vertex, 1, v, random),
                   random_channel<std::int16_t>("sensor", Domain::Vertex, 3, v, random),
                   random_channel<std::uint32_t>("patch", Domain::Face, 1, f, random),
                   random_channel<std::int8_t>("flag", Domain::Face, 1, f, random),
                   random_channel<std::uint8_t>("color", Domain::Face, 3, f, random),
                   random_channel<float>("uv", Domain::Corner, 2, c, random),
                   random_channel<std::uint16_t>("tag", Domain::Corner, 1, c, random)};
  return mesh;
}

}  // namespace croquis::test
