// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "io/channel_values.h"
#include "io/gltf/glb_reading.h"

namespace croquis {
namespace {

constexpr std::size_t most_components = 4;

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Per vertex of the mesh the value of the first that was joined; nothing when another one differs.
std::vector<double> common_values(const std::vector<double>& values, std::size_t width, const GlbVertices& vertices,
                                  std::size_t count) {
  std::vector<double> common(count * width, std::numeric_limits<double>::quiet_NaN());
  std::vector<std::uint8_t> known(count, 0);
  for (std::size_t r = 0; r < vertices.joined.size(); ++r) {
    const Index v = vertices.joined[r];
    for (std::size_t c = 0; c < width; ++c) {
      double& value = common[v * width + c];
      if (known[v] != 0 && !same_number(value, values[r * width + c])) return {};
      value = values[r * width + c];
    }
    known[v] = 1;
  }
  return common;
}

AttributeChannel channel_of(const char* name, Domain domain, std::size_t width, std::vector<double> values,
                            bool bytes) {
  const auto columns = static_cast<int>(width);
  if (std::string_view(name) == "color") return colour_channel(domain, columns, std::move(values), bytes);
  return make_channel(name, domain, columns, std::vector<float>(values.begin(), values.end()));
}

}  // namespace

void GlbAttribute::add(std::size_t first, const GltfNumbers& numbers) {
  const std::size_t end = most_components * (first + numbers.count());
  if (values_.size() < end) values_.resize(end, std::numeric_limits<double>::quiet_NaN());
  width_ = std::max(width_, numbers.components);
  all_bytes_ = all_bytes_ && numbers.parts_of_255;
  for (std::size_t i = 0; i < numbers.count(); ++i) {
    for (std::size_t c = 0; c < numbers.components; ++c) {
      values_[most_components * (first + i) + c] = numbers.values[i * numbers.components + c];
    }
    // A colour among others that have a fourth component is opaque.
    for (std::size_t c = numbers.components; c < most_components; ++c) values_[most_components * (first + i) + c] = 1;
  }
}

std::vector<double> GlbAttribute::values(std::size_t repeated) const {
  std::vector<double> result(repeated * width_, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < std::min(repeated, values_.size() / most_components); ++i) {
    for (std::size_t c = 0; c < width_; ++c) result[i * width_ + c] = values_[most_components * i + c];
  }
  return result;
}

void add_glb_channel(const char* name, const GlbAttribute& attribute, const GlbVertices& vertices, PolyMesh& mesh) {
  if (attribute.empty()) return;
  const std::size_t width = attribute.width();
  const std::vector<double> values = attribute.values(vertices.joined.size());
  std::vector<double> common = common_values(values, width, vertices, mesh.vertex_count());
  if (!common.empty()) {
    mesh.channels.push_back(channel_of(name, Domain::Vertex, width, std::move(common), attribute.all_bytes()));
    return;
  }
  std::vector<double> of_corners;
  of_corners.reserve(vertices.corners.size() * width);
  for (const std::uint32_t r : vertices.corners) {
    for (std::size_t c = 0; c < width; ++c) of_corners.push_back(values[r * width + c]);
  }
  mesh.channels.push_back(channel_of(name, Domain::Corner, width, std::move(of_corners), attribute.all_bytes()));
}

}  // namespace croquis
