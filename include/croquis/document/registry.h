// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "croquis/document/operation.h"

namespace croquis {

/// The operations a host offers. Filled above the document (croquis/operators) and handed to the hosts.
class Registry {
 public:
  /// @throws Error (Category::Internal) when the id is taken
  void add(std::unique_ptr<const Operation> operation);

  /// The operation of that id, or null.
  const Operation* find(std::string_view id) const;

  /// What that operation says of itself, or null. Valid until another one is added.
  const OperationDescription* description(std::string_view id) const;

  /// Of all, in the order they were added.
  const std::vector<OperationDescription>& descriptions() const { return descriptions_; }

  /// In the order they were added.
  const std::vector<std::unique_ptr<const Operation>>& operations() const { return operations_; }

 private:
  std::vector<std::unique_ptr<const Operation>> operations_;
  std::vector<OperationDescription> descriptions_;  ///< of each: asked for far more often than made
};

}  // namespace croquis
