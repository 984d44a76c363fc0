// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/value.h"

#include <array>

#include "croquis/base/error.h"
#include "croquis/document/value_bytes.h"

namespace croquis {

std::span<const ValueType> value_types() {
#define CROQUIS_LIST_TYPE(type, name) ValueType::name,
  static constexpr std::array types = {CROQUIS_VALUE_TYPES(CROQUIS_LIST_TYPE)};
#undef CROQUIS_LIST_TYPE
  return types;
}

void Value::require(ValueType type) const {
  if (type_ == type && content_ != nullptr) return;
  throw Error(make_error(Category::Internal, "E_INTERNAL",
                         std::string("Internal error (a ") + to_string(type) + " was expected and " +
                             (content_ == nullptr ? "nothing" : std::string("a ") + to_string(type_)) +
                             " came); please report it."));
}

Value value_of(ValueType type, std::shared_ptr<const void> content) {
  Value value;
  value.type_ = type;
  value.content_ = std::move(content);
  return value;
}

Value Value::transformed(const Affine3& map) const {
  return has_content() ? value_of(type_, type_.traits().transformed(content_, map)) : *this;
}

BoundingBox bounds_of(const Value& value) {
  return value.has_content() ? value.type().traits().bounds(value.content().get()) : std::nullopt;
}

std::string encode(const Value& value) {
  ByteWriter writer;
  value.type().traits().store(value.content().get(), writer);
  return writer.take();
}

Value decode(ValueType type, std::string_view bytes) {
  ByteReader reader(bytes);
  Value value = value_of(type, type.traits().load(reader));
  reader.finish();
  return value;
}

}  // namespace croquis
