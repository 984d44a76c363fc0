// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/allocation_count.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

#include "support/sanitizers.h"

namespace {

std::atomic<std::ptrdiff_t> out = 0, most = 0;

[[maybe_unused]] void* counted(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  const std::ptrdiff_t now = out += static_cast<std::ptrdiff_t>(malloc_usable_size(block));
  for (std::ptrdiff_t seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
  }
  return block;
}

[[maybe_unused]] void release(void* block) {
  if (block == nullptr) return;
  out -= static_cast<std::ptrdiff_t>(malloc_usable_size(block));
  std::free(block);
}

}  // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
void* operator new(std::size_t size) { return counted(std::malloc(size > 0 ? size : 1)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }
#endif

namespace croquis::test {

AllocationPeak::AllocationPeak() : before_(out) { most = before_; }

std::optional<std::size_t> AllocationPeak::bytes() const {
  if (is_sanitized) return std::nullopt;
  return static_cast<std::size_t>(most - before_);
}

}  // namespace croquis::test
