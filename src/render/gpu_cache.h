// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>

namespace croquis::render {

/// What the graphics card holds of items: of every one drawn so far whose owner still holds it.
template <typename Item, typename GpuItem>
class GpuCache {
 public:
  /// Uploads the item when it is new.
  GpuItem& get(const std::shared_ptr<const Item>& item) {
    if (const auto found = items_.find(item); found != items_.end()) return found->second;
    return items_.emplace(item, GpuItem(*item)).first->second;
  }

  /// Frees what nobody holds any more.
  void drop_expired() {
    std::erase_if(items_, [](const auto& entry) { return entry.first.expired(); });
  }

 private:
  std::map<std::weak_ptr<const Item>, GpuItem, std::owner_less<>> items_;
};

}  // namespace croquis::render
