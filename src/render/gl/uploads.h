// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "croquis/render/renderer.h"
#include "render/gl/gl_handle.h"

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

/// Where shaders of surfaces and of lines alike read a vertex's position and colour.
inline constexpr GLuint position_place = 0;
inline constexpr GLuint color_place = 2;

/// Items of at most so many bytes are never sent in slices.
inline constexpr std::size_t small_item = std::size_t{1} << 20;

/// Meters what goes to the graphics card: how much a drawing may still send, and how much was sent.
class Uploads {
 public:
  /// @param budget bytes of one drawing; 0: no limit
  void begin_drawing(std::size_t budget);

  /// How many of these bytes may go now.
  /// @param at_once all, whatever is left
  std::size_t grant(std::size_t wanted, bool at_once);

  /// Books bytes that are sent in any case.
  void count(std::size_t bytes);

  bool pending() const { return pending_; }
  const UploadCount& total() const { return total_; }

 private:
  std::size_t left_ = std::numeric_limits<std::size_t>::max();
  bool pending_ = false;
  UploadCount total_;
};

/// A buffer on the graphics card that fills over several drawings.
class SlicedBuffer {
 public:
  explicit SlicedBuffer(std::size_t size);
  template <typename Value>
  explicit SlicedBuffer(const std::vector<Value>& values) : SlicedBuffer(values.size() * sizeof(Value)) {}

  /// Sends more of it.
  /// @param bytes all that is to be in the buffer in the end
  void send(std::span<const std::byte> bytes, bool at_once, Uploads& uploads);

  std::size_t size() const { return size_; }
  std::size_t sent() const { return sent_; }
  bool complete() const { return sent_ == size_; }
  unsigned name() const { return buffer_.name(); }

 private:
  GlHandle buffer_;
  std::size_t size_ = 0, sent_ = 0;
};

}  // namespace croquis::render
