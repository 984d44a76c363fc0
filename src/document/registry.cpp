// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/registry.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {

void Registry::add(std::unique_ptr<const Operation> operation) {
  OperationDescription description = operation->describe();
  if (find(description.id) != nullptr) {
    throw Error(make_error(Category::Internal, "E_INTERNAL", "Two operations are called '" + description.id + "'."));
  }
  operations_.push_back(std::move(operation));
  descriptions_.push_back(std::move(description));
}

const OperationDescription* Registry::description(std::string_view id) const {
  const auto found = std::ranges::find(descriptions_, id, &OperationDescription::id);
  return found == descriptions_.end() ? nullptr : &*found;
}

const Operation* Registry::find(std::string_view id) const {
  const OperationDescription* known = description(id);
  return known == nullptr ? nullptr : operations_[static_cast<std::size_t>(known - descriptions_.data())].get();
}

}  // namespace croquis
