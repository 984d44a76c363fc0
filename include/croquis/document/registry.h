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

  /// In the order they were added.
  const std::vector<std::unique_ptr<const Operation>>& operations() const { return operations_; }

 private:
  std::vector<std::unique_ptr<const Operation>> operations_;
};

}  // namespace croquis
