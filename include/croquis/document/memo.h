// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <typeindex>
#include <utility>

#include "croquis/document/content_hash.h"

namespace croquis {

/// Results of stages by the content that they were made from, so that a change recomputes only what depends on it.
///
/// A key must be the hash of everything that its result depends on: begin it with the operation's id and version and
/// the stage's name. Then it never matters whether the memo is empty, but for time. Above the cap the least recently
/// used results are thrown away; those still held elsewhere live on there. Results of different types never meet,
/// even under one key. Thread safe.
class Memo {
 public:
  /// What an entry costs beside the bytes given for it.
  static constexpr std::size_t entry_bytes = 256;

  explicit Memo(std::size_t byte_cap = std::size_t{1} << 30) : byte_cap_(byte_cap) {}

  /// The result of that key, or null.
  template <class T>
  std::shared_ptr<const T> find(const ContentHash& key) {
    return std::static_pointer_cast<const T>(find_entry({key, typeid(T)}));
  }

  /// Keeps a result for that key; when another thread was first, that thread's is kept.
  /// @param bytes what the result takes; one that takes more than the cap isn't kept
  /// @return the result that counts from now on
  template <class T>
  std::shared_ptr<const T> keep(const ContentHash& key, std::shared_ptr<const T> result, std::size_t bytes) {
    return std::static_pointer_cast<const T>(keep_entry({key, typeid(T)}, std::move(result), bytes));
  }

  /// The result of that key, made when it isn't there.
  /// @param make  returns a T. Runs without a lock: it may use the memo, and two threads may make the same at once.
  ///              What it throws is passed on, and nothing is kept
  /// @param bytes gives the size of a const T&
  template <class T, class Make, class Bytes>
  std::shared_ptr<const T> get(const ContentHash& key, Make&& make, Bytes&& bytes) {
    if (auto found = find<T>(key)) return found;
    auto made = std::make_shared<const T>(std::forward<Make>(make)());
    const std::size_t size = std::invoke(std::forward<Bytes>(bytes), *made);
    return keep<T>(key, std::move(made), size);
  }

  /// What all entries take, entry_bytes for each of them included: never more than the cap.
  std::size_t bytes() const;

  /// Another cap from now on: what is beyond it goes at once, the least recently used first.
  void set_byte_cap(std::size_t byte_cap);

  void clear();

 private:
  using Key = std::pair<ContentHash, std::type_index>;
  struct Entry {
    Key key;
    std::shared_ptr<const void> result;
    std::size_t bytes = 0;
  };

  std::shared_ptr<const void> find_entry(const Key& key);
  void drop_beyond(std::size_t bytes, std::list<Entry>& dropped);
  std::shared_ptr<const void> keep_entry(Key key, std::shared_ptr<const void> result, std::size_t bytes);

  mutable std::mutex mutex_;
  std::size_t byte_cap_;
  std::size_t bytes_ = 0;
  std::list<Entry> by_use_;  ///< most recently used first
  std::map<Key, std::list<Entry>::iterator> by_key_;
};

/// As Memo::get, or just made when there is no memo (Context::memo may be null).
template <class T, class Make, class Bytes>
std::shared_ptr<const T> memoized(Memo* memo, const ContentHash& key, Make&& make, Bytes&& bytes) {
  if (memo == nullptr) return std::make_shared<const T>(std::forward<Make>(make)());
  return memo->get<T>(key, std::forward<Make>(make), std::forward<Bytes>(bytes));
}

}  // namespace croquis
