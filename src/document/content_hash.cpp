// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/content_hash.h"

#include <array>
#include <bit>
#include <variant>

#include <xxhash.h>

#include "croquis/document/backdrop.h"
#include "croquis/document/document.h"
#include "document/evaluation_steps.h"

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

}  // namespace

void add_content(ContentHasher& hasher, const ParameterValues& parameters) {
  hasher.add(parameters.size());
  for (const auto& [name, value] : parameters) {
    hasher.add(name);
    add_content(hasher, value);
  }
}

void add_content(ContentHasher& hasher, const Affine3& transform) {
  for (const double number : transform.linear.reshaped()) hasher.add(number);
  for (const double number : transform.offset) hasher.add(number);
}

ContentHash content_hash(const Value& value) {
  ContentHasher hasher;
  if (value.type() == ValueType()) return hasher.digest();
  hasher.add(value.type().traits().tag);
  hasher.add(value.has_content());
  if (value.has_content()) value.type().traits().add_content(value.content().get(), hasher);
  return hasher.digest();
}

namespace {

void add_content(ContentHasher& hasher, const Backdrop& backdrop) {
  for (const double number : {backdrop.centre.x(), backdrop.centre.y(), backdrop.scale, backdrop.opacity})
    hasher.add(number);
  hasher.add(backdrop.visible);
  const ContentHash picture = content_hash(Value(backdrop.picture));
  hasher.add(picture.high);
  hasher.add(picture.low);
}

}  // namespace

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
    // One number for what nodes seldom have, so that the hashes of all others stay as they are.
    const bool is_placed = !node->transform.is_identity();
    const bool stands = !(node->placement == Placement()) || !node->group.empty();
    hasher.add((node->visible ? 1 : 0) + (node->enabled ? 0 : 2) + (is_placed ? 4 : 0) + (node->backdrop ? 8 : 0) +
               (stands ? 16 : 0));
    if (is_placed) add_content(hasher, node->transform);
    if (node->backdrop) add_content(hasher, *node->backdrop);
    if (!stands) continue;
    for (const Vec3& numbers : {node->placement.position, node->placement.rotation, node->placement.scale}) {
      for (const double number : numbers) hasher.add(number);
    }
    hasher.add(node->group);
  }
  return hasher.digest();
}

}  // namespace croquis
