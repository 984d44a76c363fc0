// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/value_hashes.h"

#include <algorithm>

namespace croquis {

ContentHash ValueHashes::of(const Value& value) {
  const std::shared_ptr<const void>& owner = value.content();
  // Without an owner it isn't known how long the address holds this value.
  if (owner.use_count() == 0) return content_hash(value);
  const Key key{owner, owner.get()};
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = hashes_.find(key); found != hashes_.end()) return found->second;
  }
  const ContentHash hash = content_hash(value);
  const std::lock_guard lock(mutex_);
  hashes_.emplace(key, hash);
  if (hashes_.size() >= size_to_clean_at_) drop_expired();
  return hash;
}

void ValueHashes::drop_expired() {
  std::erase_if(hashes_, [](const auto& entry) { return entry.first.owner.expired(); });
  size_to_clean_at_ = std::max<std::size_t>(64, 2 * hashes_.size());
}

}  // namespace croquis
