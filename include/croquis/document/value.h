// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "croquis/document/value_list.h"
#include "croquis/geometry/affine3.h"
#include "croquis/geometry/bounds.h"

/// What can travel along a link between two operations: a pointer to immutable content, and the row of a table that
/// has all that a document, an evaluator and a project file do with it.
namespace croquis {

class ByteReader;
class ByteWriter;
class ContentHasher;

/// The row of one type. `content` is never null and of that type.
struct ValueTraits {
  const char* name;   ///< "mesh": in sentences, and in project files, so it never changes
  std::uint64_t tag;  ///< differs between types and never changes: part of content hashes

  /// All that a computation can see of it.
  void (*add_content)(const void* content, ContentHasher& hasher);

  /// About how much memory it takes.
  std::size_t (*byte_size)(const void* content);

  /// Where it lies; none for what has no place in space.
  BoundingBox (*bounds)(const void* content);

  /// The content after an invertible map; itself where it has no place in space.
  std::shared_ptr<const void> (*transformed)(const std::shared_ptr<const void>& content, const Affine3& map);

  /// The canonical form for project files: equal contents give equal bytes, and nothing is rounded. Begins with the
  /// number of its layout. @throws Error (E_LIMIT) for what is nested too deeply
  void (*store)(const void* content, ByteWriter& writer);

  /// Reads what `store` wrote, from anybody: what comes out is safe to compute with. @throws BadBytes
  std::shared_ptr<const void> (*load)(ByteReader& reader);

// NOLINTBEGIN(readability-identifier-naming): read like enumerators
#define CROQUIS_DECLARE_ROW(type, name) static const ValueTraits name;
  CROQUIS_VALUE_TYPES(CROQUIS_DECLARE_ROW)
#undef CROQUIS_DECLARE_ROW
  // NOLINTEND(readability-identifier-naming)
};

/// The row of a type. A type that isn't in the list can be a value as well where a function of this name is found
/// beside the type; project files are then read with a list of types that has it.
#define CROQUIS_DECLARE_TRAITS(type, name) \
  constexpr const ValueTraits& value_traits(std::type_identity<type>) { return ValueTraits::name; }
CROQUIS_VALUE_TYPES(CROQUIS_DECLARE_TRAITS)
#undef CROQUIS_DECLARE_TRAITS

/// Types that can be values.
template <class T>
concept ValueContent = requires {
  value_traits(std::type_identity<T>{});
};

/// A type of value: what ports describe. Compares by identity of the row.
class ValueType {
 public:
// NOLINTBEGIN(readability-identifier-naming): read like enumerators
#define CROQUIS_DECLARE_TYPE(type, name) static const ValueType name;
  CROQUIS_VALUE_TYPES(CROQUIS_DECLARE_TYPE)
#undef CROQUIS_DECLARE_TYPE
  // NOLINTEND(readability-identifier-naming)

  constexpr ValueType() = default;  ///< of no value

  template <ValueContent T>
  static constexpr ValueType of() {
    return ValueType(&value_traits(std::type_identity<T>{}));
  }

  /// @pre not the type of no value
  constexpr const ValueTraits& traits() const { return *traits_; }

  friend constexpr bool operator==(ValueType a, ValueType b) { return a.traits_ == b.traits_; }
  friend std::strong_ordering operator<=>(ValueType a, ValueType b) {
    return std::compare_three_way()(a.traits_, b.traits_);
  }
  friend const char* to_string(ValueType type) { return type.traits_ == nullptr ? "value" : type.traits_->name; }

 private:
  explicit constexpr ValueType(const ValueTraits* traits) : traits_(traits) {}

  const ValueTraits* traits_ = nullptr;
};

#define CROQUIS_DEFINE_TYPE(type, name) inline constexpr ValueType ValueType::name{&ValueTraits::name};
CROQUIS_VALUE_TYPES(CROQUIS_DEFINE_TYPE)
#undef CROQUIS_DEFINE_TYPE

/// All listed types, in the order of the list.
std::span<const ValueType> value_types();

/// One content of any of the types. Shared and immutable: passing one on copies a pointer. Equal and ordered by
/// identity of the content, not by what is in it (see content_hash for that).
class Value {
 public:
  Value() = default;  ///< no value: of no type, without content

  /// @param content may be null: a value of that type without content
  template <class T>
  requires ValueContent<std::remove_const_t<T>> Value(
      std::shared_ptr<T> content)  // NOLINT(google-explicit-constructor): contents are values
      : type_(ValueType::of<std::remove_const_t<T>>()), content_(std::move(content)) {}

  ValueType type() const { return type_; }
  bool has_content() const { return content_ != nullptr; }

  /// The content, or null where it is of another type.
  template <ValueContent T>
  std::shared_ptr<const T> as() const {
    return type_ == ValueType::of<T>() ? std::static_pointer_cast<const T>(content_) : nullptr;
  }

  /// The content, for as long as a value shares it.
  /// @throws Error (E_INTERNAL) where it is of another type or there is none
  template <ValueContent T>
  const T& get() const {
    require(ValueType::of<T>());
    return *static_cast<const T*>(content_.get());
  }

  /// For rows of the table; type() has its type.
  const std::shared_ptr<const void>& content() const { return content_; }

  /// The value after an invertible map: the same where it has no place in space.
  Value transformed(const Affine3& map) const;

  friend bool operator==(const Value& a, const Value& b) = default;
  friend std::strong_ordering operator<=>(const Value& a, const Value& b) = default;

 private:
  friend Value value_of(ValueType type, std::shared_ptr<const void> content);

  void require(ValueType type) const;

  ValueType type_;
  std::shared_ptr<const void> content_;
};

/// @param content of that type, as its row's functions give it
Value value_of(ValueType type, std::shared_ptr<const void> content);

/// Values by port name.
using Values = std::map<std::string, Value>;

/// Where a value lies; none of what has no place in space, and without content.
BoundingBox bounds_of(const Value& value);

}  // namespace croquis
