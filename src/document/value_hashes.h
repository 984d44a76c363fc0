// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>

#include "croquis/document/content_hash.h"

namespace croquis {

/// Content hashes of values, each computed once for as long as the value lives. Thread safe.
class ValueHashes {
 public:
  ContentHash of(const Value& value);

 private:
  /// A value's owner and its place with that owner. The weak pointer keeps the owner's own name from being given to
  /// another one, which a bare address would not.
  struct Key {
    std::weak_ptr<const void> owner;
    const void* place = nullptr;

    bool operator<(const Key& other) const {
      if (owner.owner_before(other.owner)) return true;
      if (other.owner.owner_before(owner)) return false;
      return std::less<const void*>()(place, other.place);
    }
  };

  void drop_expired();

  std::mutex mutex_;
  std::map<Key, ContentHash> hashes_;
  std::size_t size_to_clean_at_ = 64;
};

}  // namespace croquis
