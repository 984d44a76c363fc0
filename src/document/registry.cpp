// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/registry.h"

#include <utility>

#include "croquis/base/error.h"

namespace croquis {

void Registry::add(std::unique_ptr<const Operation> operation) {
  const std::string id = operation->describe().id;
  if (find(id) != nullptr) {
    throw Error(make_error(Category::Internal, "E_INTERNAL", "Two operations are called '" + id + "'."));
  }
  operations_.push_back(std::move(operation));
}

const Operation* Registry::find(std::string_view id) const {
  for (const auto& operation : operations_) {
    if (operation->describe().id == id) return operation.get();
  }
  return nullptr;
}

}  // namespace croquis
