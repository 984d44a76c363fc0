// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf/glb_container.h"

#include <cstdint>
#include <string>

#include "io/little_endian.h"

namespace croquis {
namespace {

constexpr std::size_t glb_header_size = 12;  // magic, version, length
constexpr std::size_t chunk_header_size = 8;
constexpr std::uint32_t json_chunk = 0x4e4f534a;
constexpr std::uint32_t binary_chunk = 0x004e4942;

/// The chunk that begins at `at`, which moves to its end.
std::string_view next_chunk(std::string_view bytes, std::size_t& at, std::uint32_t& type, ReadContext& context) {
  if (bytes.size() - at < chunk_header_size) {
    context.fail("E_TRUNCATED", "the file ends within the header of a chunk", at_byte(at));
  }
  const std::size_t length = load_little_endian<std::uint32_t>(bytes.data() + at);
  type = load_little_endian<std::uint32_t>(bytes.data() + at + 4);
  const std::size_t begin = at + chunk_header_size;
  if (length > bytes.size() - begin) {
    context.fail("E_TRUNCATED",
                 "a chunk claims " + std::to_string(length) + " bytes, but only " +
                     std::to_string(bytes.size() - begin) + " follow",
                 at_byte(at));
  }
  at = begin + length;
  return bytes.substr(begin, length);
}

}  // namespace

GlbContainer open_glb(std::string_view bytes, ReadContext& context) {
  if (!bytes.starts_with("glTF")) context.fail("E_SYNTAX", "the file doesn't begin with 'glTF'", at_byte(0));
  if (bytes.size() < glb_header_size) context.fail("E_TRUNCATED", "the file ends within its header", at_byte(0));
  const auto version = load_little_endian<std::uint32_t>(bytes.data() + 4);
  if (version != 2) {
    context.fail("E_SYNTAX", "this is glTF version " + std::to_string(version) + ", and only version 2 is read",
                 at_byte(4));
  }
  const std::size_t length = load_little_endian<std::uint32_t>(bytes.data() + 8);
  if (length > bytes.size()) {
    context.fail(
        "E_TRUNCATED",
        "the header claims " + std::to_string(length) + " bytes, but the file has " + std::to_string(bytes.size()),
        at_byte(8));
  }
  if (length < bytes.size()) {
    context.warn("W_TRAILING", std::to_string(bytes.size() - length) + " bytes after the model were passed over",
                 at_byte(length));
  }
  bytes = bytes.substr(0, length);
  if (length < glb_header_size) context.fail("E_TRUNCATED", "the header claims less than itself", at_byte(8));

  GlbContainer container;
  std::size_t at = glb_header_size;
  std::uint32_t type = 0;
  container.json = next_chunk(bytes, at, type, context);
  if (type != json_chunk) context.fail("E_SYNTAX", "the first chunk isn't JSON", at_byte(glb_header_size));
  while (at < bytes.size() && container.binary.empty()) {
    const std::string_view chunk = next_chunk(bytes, at, type, context);
    if (type == binary_chunk) container.binary = chunk;  // others are extensions, to be passed over
  }
  return container;
}

}  // namespace croquis
