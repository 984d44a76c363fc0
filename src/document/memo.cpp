// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/memo.h"

namespace croquis {

std::shared_ptr<const void> Memo::find_entry(const Key& key) {
  const std::lock_guard lock(mutex_);
  const auto found = by_key_.find(key);
  if (found == by_key_.end()) return nullptr;
  by_use_.splice(by_use_.begin(), by_use_, found->second);
  return found->second->result;
}

std::shared_ptr<const void> Memo::keep_entry(Key key, std::shared_ptr<const void> result, std::size_t bytes) {
  std::list<Entry> dropped;  // destroyed after the lock is released: results may be large
  const std::lock_guard lock(mutex_);
  if (const auto found = by_key_.find(key); found != by_key_.end()) {
    by_use_.splice(by_use_.begin(), by_use_, found->second);
    return found->second->result;
  }
  if (entry_bytes > byte_cap_ || bytes > byte_cap_ - entry_bytes) return result;
  bytes += entry_bytes;
  drop_beyond(byte_cap_ - bytes, dropped);
  by_use_.push_front({key, result, bytes});
  by_key_.emplace(std::move(key), by_use_.begin());
  bytes_ += bytes;
  return result;
}

/// The mutex is held.
void Memo::drop_beyond(std::size_t bytes, std::list<Entry>& dropped) {
  while (bytes_ > bytes) {
    bytes_ -= by_use_.back().bytes;
    by_key_.erase(by_use_.back().key);
    dropped.splice(dropped.end(), by_use_, std::prev(by_use_.end()));
  }
}

void Memo::set_byte_cap(std::size_t byte_cap) {
  std::list<Entry> dropped;
  const std::lock_guard lock(mutex_);
  byte_cap_ = byte_cap;
  drop_beyond(byte_cap_, dropped);
}

std::size_t Memo::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

void Memo::clear() {
  std::list<Entry> dropped;
  const std::lock_guard lock(mutex_);
  dropped.swap(by_use_);
  by_key_.clear();
  bytes_ = 0;
}

}  // namespace croquis
