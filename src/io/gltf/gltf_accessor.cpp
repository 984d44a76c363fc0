// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "io/gltf/glb_reading.h"
#include "io/little_endian.h"

namespace croquis {
namespace {

constexpr std::size_t no_view = static_cast<std::size_t>(-1);

constexpr std::array component_counts = {std::pair{"SCALAR", std::size_t{1}}, std::pair{"VEC2", std::size_t{2}},
                                         std::pair{"VEC3", std::size_t{3}}, std::pair{"VEC4", std::size_t{4}}};

std::size_t components_of(const std::string& type) {
  for (const auto& [name, count] : component_counts) {
    if (type == name) return count;
  }
  return 0;
}

}  // namespace

struct GltfAccessors::ComponentType {
  int code = 0;
  std::size_t size = 0;
  double largest = 1;  ///< of whole ones
  bool normalized = false;

  double load(const char* from) const {
    switch (code) {
      case 5120: return part(load_little_endian<std::int8_t>(from));
      case 5121: return part(load_little_endian<std::uint8_t>(from));
      case 5122: return part(load_little_endian<std::int16_t>(from));
      case 5123: return part(load_little_endian<std::uint16_t>(from));
      case 5125: return part(load_little_endian<std::uint32_t>(from));
      default: return static_cast<double>(load_little_endian<float>(from));
    }
  }

  template <typename Whole>
  double part(Whole value) const {
    const auto number = static_cast<double>(value);
    return normalized ? std::max(number / largest, -1.0) : number;
  }

  bool is_unsigned() const { return code == 5121 || code == 5123 || code == 5125; }
};

/// Where the elements of an accessor lie; without a first byte all of them are 0.
struct GltfAccessors::Layout {
  const char* first = nullptr;
  std::size_t stride = 0;
};

GltfAccessors::GltfAccessors(const GltfDocument& document, std::string_view binary)
    : document_(document), binary_(binary) {}

GltfAccessors::ComponentType GltfAccessors::component_type(const Report& owner, const std::string& name) const {
  struct Known {
    int code;
    std::size_t size;
    double largest;
  };
  constexpr std::array known = {Known{5120, 1, 127},   Known{5121, 1, 255},          Known{5122, 2, 32767},
                                Known{5123, 2, 65535}, Known{5125, 4, 4294967295.0}, Known{5126, 4, 1}};
  const std::size_t code = document_.index_or(owner, "componentType", 0, name);
  for (const Known& type : known) {
    if (code != static_cast<std::size_t>(type.code)) continue;
    const Report* normalized = owner.find("normalized");
    const bool* set = normalized == nullptr ? nullptr : std::get_if<bool>(&normalized->value());
    return {type.code, type.size, type.largest, set != nullptr && *set};
  }
  document_.fail("E_SYNTAX", "'componentType' of " + name + " is none of glTF's");
}

std::string_view GltfAccessors::buffer(std::size_t index, const std::string& user) const {
  const std::string name = gltf_element("buffer", index);
  const Report& entry = document_.element("buffers", index, user);
  const std::string place = GltfDocument::text(entry, "uri");
  if (!place.empty() || index > 0) {
    document_.fail("E_FORMAT", name + " lies outside of the file's binary part: export the model as one GLB file");
  }
  const std::size_t length = document_.index_or(entry, "byteLength", 0, name);
  if (length > binary_.size()) {
    document_.fail("E_TRUNCATED", name + " claims " + std::to_string(length) + " bytes, but the file holds " +
                                      std::to_string(binary_.size()));
  }
  return binary_.substr(0, length);
}

/// The bytes of a view from `offset` on.
std::string_view GltfAccessors::view_bytes(std::size_t view, std::size_t offset, const std::string& user,
                                           std::size_t& stride) const {
  const std::string name = gltf_element("buffer view", view);
  const Report& entry = document_.element("bufferViews", view, user);
  const std::optional<std::size_t> index = document_.index(entry, "buffer", name);
  if (!index) document_.fail("E_SYNTAX", name + " names no buffer");
  const std::string_view bytes = buffer(*index, name);
  const std::size_t begin = document_.index_or(entry, "byteOffset", 0, name);
  const std::size_t length = document_.index_or(entry, "byteLength", 0, name);
  if (begin > bytes.size() || length > bytes.size() - begin) {
    document_.fail("E_COUNT", name + " reaches beyond its buffer of " + std::to_string(bytes.size()) + " bytes");
  }
  if (offset > length) document_.fail("E_COUNT", user + " begins beyond its buffer view");
  stride = document_.index_or(entry, "byteStride", 0, name);
  return bytes.substr(begin + offset, length - offset);
}

GltfAccessors::Layout GltfAccessors::layout_of(const Report& owner, std::size_t view, std::size_t count,
                                               const ComponentType& type, std::size_t components,
                                               const std::string& name) const {
  const std::size_t size = type.size * components;
  Layout layout;
  const std::string_view bytes =
      view_bytes(view, document_.index_or(owner, "byteOffset", 0, name), name, layout.stride);
  if (layout.stride == 0) layout.stride = size;
  if (layout.stride < size) document_.fail("E_SYNTAX", "the elements of " + name + " overlap each other");
  // All of these are below 2^32, so that products fit 64 bits.
  if (count > 0 && (bytes.size() < size || (count - 1) * layout.stride > bytes.size() - size)) {
    document_.fail("E_COUNT", name + " claims " + std::to_string(count) + " elements, more than its buffer view holds");
  }
  layout.first = bytes.data();
  return layout;
}

std::size_t GltfAccessors::count(std::size_t accessor, const std::string& user) const {
  const std::string name = gltf_element("accessor", accessor);
  const std::size_t claimed = document_.index_or(document_.element("accessors", accessor, user), "count", 0, name);
  // Also of accessors without a buffer view, which are 0 throughout: their memory isn't backed by bytes of the file.
  if (claimed > document_.context().file_size()) {
    document_.fail("E_COUNT", name + " claims " + std::to_string(claimed) + " elements, more than the file has bytes");
  }
  return claimed;
}

GltfNumbers GltfAccessors::read(std::size_t accessor, std::size_t least_components, std::size_t most_components,
                                const std::string& user) const {
  const std::string name = gltf_element("accessor", accessor);
  const Report& entry = document_.element("accessors", accessor, user);
  const ComponentType type = component_type(entry, name);
  GltfNumbers numbers;
  numbers.components = components_of(GltfDocument::text(entry, "type"));
  if (numbers.components < least_components || numbers.components > most_components) {
    document_.fail("E_SYNTAX", "the type of " + name + " doesn't fit its use by " + user);
  }
  numbers.parts_of_255 = type.code == 5121 && type.normalized;
  const std::size_t elements = count(accessor, user);
  const std::size_t view = document_.index_or(entry, "bufferView", no_view, name);
  if (view == no_view) {
    // All 0, but for a sparse accessor's exceptions.
    numbers.values.assign(elements * numbers.components, 0);
  } else {
    const Layout layout = layout_of(entry, view, elements, type, numbers.components, name);
    numbers.values.reserve(elements * numbers.components);
    for (std::size_t i = 0; i < elements; ++i) {
      const char* from = layout.first + i * layout.stride;
      for (std::size_t c = 0; c < numbers.components; ++c) numbers.values.push_back(type.load(from + c * type.size));
    }
  }
  if (const Report* sparse = entry.find("sparse")) add_sparse(*sparse, type, name, numbers);
  return numbers;
}

void GltfAccessors::add_sparse(const Report& sparse, const ComponentType& type, const std::string& name,
                               GltfNumbers& numbers) const {
  const auto part = [&](const char* member, std::size_t& view) -> const Report& {
    const Report* found = std::holds_alternative<Report::Object>(sparse.value()) ? sparse.find(member) : nullptr;
    if (found != nullptr && !std::holds_alternative<Report::Object>(found->value())) found = nullptr;
    view = found == nullptr ? no_view : document_.index_or(*found, "bufferView", no_view, name);
    if (view == no_view) document_.fail("E_SYNTAX", "the sparse part of " + name + " has no '" + member + "'");
    return *found;
  };
  std::size_t index_view = 0, value_view = 0;
  const Report& indices = part("indices", index_view);
  const Report& values = part("values", value_view);
  const std::size_t exceptions = document_.index_or(sparse, "count", 0, name);
  const ComponentType index_type = component_type(indices, name);
  if (!index_type.is_unsigned()) document_.fail("E_SYNTAX", "the sparse indices of " + name + " aren't whole numbers");
  const Layout from = layout_of(indices, index_view, exceptions, index_type, 1, name);
  const Layout what = layout_of(values, value_view, exceptions, type, numbers.components, name);
  for (std::size_t i = 0; i < exceptions; ++i) {
    const auto element = static_cast<std::size_t>(index_type.load(from.first + i * from.stride));
    if (element >= numbers.count()) {
      document_.fail("E_INDEX", "the sparse part of " + name + " names element " + std::to_string(element) + " of " +
                                    std::to_string(numbers.count()));
    }
    for (std::size_t c = 0; c < numbers.components; ++c) {
      numbers.values[element * numbers.components + c] = type.load(what.first + i * what.stride + c * type.size);
    }
  }
}

std::vector<std::size_t> GltfAccessors::read_indices(std::size_t accessor, const std::string& user) const {
  const std::string name = gltf_element("accessor", accessor);
  const ComponentType type = component_type(document_.element("accessors", accessor, user), name);
  if (!type.is_unsigned() || type.normalized) {
    document_.fail("E_SYNTAX", name + " is used as indices, but holds no whole numbers from 0");
  }
  const GltfNumbers numbers = read(accessor, 1, 1, user);
  return {numbers.values.begin(), numbers.values.end()};
}

}  // namespace croquis
