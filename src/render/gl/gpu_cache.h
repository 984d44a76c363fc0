// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <utility>

namespace croquis::render {

/// What the graphics card holds of items: of every one drawn so far whose owner still holds it.
template <typename Item, typename GpuItem>
class GpuCache {
 public:
  /// Makes it when the item is new.
  /// @param more what its constructor takes behind the item
  template <typename... More>
  GpuItem& get(const std::shared_ptr<const Item>& item, More&&... more) {
    if (const auto found = items_.find(item); found != items_.end()) return found->second;
    return items_.emplace(item, GpuItem(*item, std::forward<More>(more)...)).first->second;
  }

  /// The one that is there, or null.
  GpuItem* find(const std::shared_ptr<const Item>& item) {
    const auto found = items_.find(item);
    return found != items_.end() ? &found->second : nullptr;
  }

  /// Frees what isn't used any more.
  void drop_expired() {
    std::erase_if(items_, [](const auto& entry) { return entry.first.expired(); });
  }

 private:
  std::map<std::weak_ptr<const Item>, GpuItem, std::owner_less<>> items_;
};

}  // namespace croquis::render
