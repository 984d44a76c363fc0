// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "croquis/document/byte_stream.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/value.h"

namespace croquis {

/// The row of the table that a definition makes. A definition is a struct with
///
///     using Content = PolyMesh;                                    // the type
///     static constexpr const char* name = "mesh";
///     static constexpr std::uint64_t tag = 0;
///     static void add_content(const PolyMesh&, ContentHasher&);
///     static std::size_t byte_size(const PolyMesh&);
///     static void store(const PolyMesh&, ByteWriter&);
///     static PolyMesh load(ByteReader&);
///
/// and, for what has a place in space, bounds_of(const PolyMesh&) and transformed(const PolyMesh&, const Affine3&)
/// beside the type.
template <class Definition>
constexpr ValueTraits value_row() {
  using Content = typename Definition::Content;
  ValueTraits row{};
  row.name = Definition::name;
  row.tag = Definition::tag;
  row.add_content = [](const void* content, ContentHasher& hasher) {
    Definition::add_content(*static_cast<const Content*>(content), hasher);
  };
  row.byte_size = [](const void* content) { return Definition::byte_size(*static_cast<const Content*>(content)); };
  row.bounds = [](const void* content) -> BoundingBox {
    if constexpr (requires(const Content& c) { bounds_of(c); }) {
      return bounds_of(*static_cast<const Content*>(content));
    } else {
      return {};
    }
  };
  row.transformed = [](const std::shared_ptr<const void>& content, const Affine3& map) -> std::shared_ptr<const void> {
    if constexpr (requires(const Content& c) { transformed(c, map); }) {
      return std::make_shared<const Content>(transformed(*static_cast<const Content*>(content.get()), map));
    } else {
      return content;
    }
  };
  row.store = [](const void* content, ByteWriter& writer) {
    Definition::store(*static_cast<const Content*>(content), writer);
  };
  row.load = [](ByteReader& reader) -> std::shared_ptr<const void> {
    return std::make_shared<const Content>(Definition::load(reader));
  };
  return row;
}

/// The number that a value's bytes begin with, from 1 to the newest layout. @throws BadBytes
inline std::uint32_t read_layout(ByteReader& reader, std::uint32_t newest) {
  const auto layout = reader.number<std::uint32_t>();
  if (layout < 1 || layout > newest) throw BadBytes("its layout is not known");
  return layout;
}

}  // namespace croquis
