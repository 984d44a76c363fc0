// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/content_hash.h"

#include <array>
#include <bit>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <xxhash.h>

#include "croquis/document/document.h"
#include "document/node_content.h"

namespace croquis {

struct ContentHasher::State {
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> xxh{XXH3_createState()};
};

ContentHasher::ContentHasher() : state_(std::make_unique<State>()) {
  if (!state_->xxh) throw std::bad_alloc();
  XXH3_128bits_reset(state_->xxh.get());
}

ContentHasher::~ContentHasher() = default;

void ContentHasher::add_integer(std::uint64_t number) {
  std::array<unsigned char, 8> bytes;
  for (unsigned char& byte : bytes) {
    byte = static_cast<unsigned char>(number & 0xff);
    number >>= 8;
  }
  XXH3_128bits_update(state_->xxh.get(), bytes.data(), bytes.size());
}

void ContentHasher::add(double number) { add_integer(std::bit_cast<std::uint64_t>(number)); }

void ContentHasher::add(std::span<const std::byte> bytes) {
  add_integer(bytes.size());
  XXH3_128bits_update(state_->xxh.get(), bytes.data(), bytes.size());
}

void ContentHasher::add(std::string_view text) { add(std::as_bytes(std::span(text))); }

void ContentHasher::add(std::span<const double> numbers) {
  static_assert(std::endian::native == std::endian::little, "arrays are hashed as they lie in memory");
  add(std::as_bytes(numbers));
}

void ContentHasher::add(std::span<const std::uint32_t> numbers) { add(std::as_bytes(numbers)); }

void ContentHasher::add(const ContentHash& hash) {
  add_integer(hash.high);
  add_integer(hash.low);
}

ContentHash ContentHasher::digest() const {
  const XXH128_hash_t digest = XXH3_128bits_digest(state_->xxh.get());
  return {digest.high64, digest.low64};
}

namespace {

void add_content(ContentHasher& hasher, const std::map<std::string, std::string>& texts) {
  hasher.add(texts.size());
  for (const auto& [key, text] : texts) {
    hasher.add(key);
    hasher.add(text);
  }
}

void add_content(ContentHasher& hasher, const AttributeChannel& channel) {
  hasher.add(channel.name);
  hasher.add(static_cast<int>(channel.domain));
  hasher.add(channel.width);
  hasher.add(channel.data.index());
  std::visit([&](const auto& values) { hasher.add(std::as_bytes(std::span(values))); }, channel.data);
  hasher.add(channel.labels.size());
  for (const std::string& label : channel.labels) hasher.add(label);
}

void add_content(ContentHasher& hasher, const std::array<Index, 2>& edge) {
  hasher.add(edge[0]);
  hasher.add(edge[1]);
}

void add_content(ContentHasher& hasher, const CreaseSet& set) {
  hasher.add(set.name);
  hasher.add(set.sharpness);
  hasher.add(set.edges.size());
  for (const auto& edge : set.edges) add_content(hasher, edge);
  hasher.add(std::span<const Index>(set.pins));
}

void add_content(ContentHasher& hasher, const MeshTags& tags) {
  hasher.add(tags.creases.size());
  for (const Crease& crease : tags.creases) {
    add_content(hasher, crease.vertices);
    hasher.add(crease.sharpness);
  }
  hasher.add(std::span<const Index>(tags.pins));
  hasher.add(tags.sets.size());
  for (const CreaseSet& set : tags.sets) add_content(hasher, set);
}

void add_content(ContentHasher& hasher, const PolyMesh& mesh) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  hasher.add(std::as_bytes(std::span(mesh.positions)));
  hasher.add(std::span<const Index>(mesh.face_offsets));
  hasher.add(std::span<const Index>(mesh.corners));
  hasher.add(std::span<const Index>(mesh.line_offsets));
  hasher.add(std::span<const Index>(mesh.line_vertices));
  hasher.add(mesh.channels.size());
  for (const AttributeChannel& channel : mesh.channels) add_content(hasher, channel);
  if (!mesh.tags.empty()) add_content(hasher, mesh.tags);  // last, so that nothing can be mistaken for them
}

void add_content(ContentHasher& hasher, const Stroke& stroke) {
  hasher.add(stroke.id);
  hasher.add(stroke.samples.size());
  for (const StrokeSample& sample : stroke.samples) {
    const std::array<double, 6> figures = {sample.position.x(), sample.position.y(), sample.pressure,
                                           sample.tilt.x(),     sample.tilt.y(),     sample.time};
    hasher.add(std::span<const double>(figures));
  }
  hasher.add(stroke.closed);
  hasher.add(stroke.object);
  add_content(hasher, stroke.data);
  hasher.add(stroke.line.has_value());
  hasher.add(stroke.line.value_or(0));
}

void add_content(ContentHasher& hasher, const Drawing& drawing) {
  hasher.add(drawing.strokes.size());
  for (const Stroke& stroke : drawing.strokes) add_content(hasher, stroke);
  hasher.add(drawing.object_data.size());
  for (const auto& [object, data] : drawing.object_data) {
    hasher.add(object);
    add_content(hasher, data);
  }
  hasher.add(drawing.file);
}

/// A text is the same whether it was parsed or not.
void add_content(ContentHasher& hasher, const ParameterValue& value) {
  if (const auto* parsed = std::get_if<ParsedText>(&value)) return add_content(hasher, ParameterValue(parsed->text()));
  hasher.add(value.index());
  std::visit(
      [&](const auto& content) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(content)>, ParsedText>) hasher.add(content);
      },
      value);
}

void add_content(ContentHasher& hasher, const Report& report) {
  hasher.add(report.value().index());
  std::visit(
      [&](const auto& value) {
        using Content = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Content, Report::Array>) {
          hasher.add(value.size());
          for (const Report& element : value) add_content(hasher, element);
        } else if constexpr (std::is_same_v<Content, Report::Object>) {
          hasher.add(value.size());
          for (const auto& [key, member] : value) {
            hasher.add(key);
            add_content(hasher, member);
          }
        } else if constexpr (!std::is_same_v<Content, std::monostate>) {
          hasher.add(value);
        }
      },
      report.value());
}

}  // namespace

void add_content(ContentHasher& hasher, const ParameterValues& parameters) {
  hasher.add(parameters.size());
  for (const auto& [name, value] : parameters) {
    hasher.add(name);
    add_content(hasher, value);
  }
}

ContentHash content_hash(const Value& value) {
  ContentHasher hasher;
  hasher.add(value.index());
  std::visit(
      [&](const auto& content) {
        hasher.add(content != nullptr);
        if (content) add_content(hasher, *content);
      },
      value);
  return hasher.digest();
}

ContentHash content_hash(const Document& document) {
  ContentHasher hasher;
  hasher.add(document.nodes().size());
  for (const auto& node : document.nodes()) {
    hasher.add(node->id);
    hasher.add(node->name);
    hasher.add(node->operation);
    hasher.add(node->version);
    add_content(hasher, node->parameters);
    hasher.add(node->inputs.size());
    for (const auto& [port, link] : node->inputs) {
      hasher.add(port);
      hasher.add(link.node);
      hasher.add(link.output);
    }
    hasher.add(node->source.has_value());
    if (node->source) hasher.add(content_hash(*node->source));
    hasher.add(node->visible);
  }
  return hasher.digest();
}

}  // namespace croquis
