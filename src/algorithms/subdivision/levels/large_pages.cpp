// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/levels/large_pages.h"

#include <memory>

#include <sys/mman.h>

namespace croquis::subdivision {
namespace {

constexpr std::size_t small_page = 4096;

}  // namespace

void wish_large_pages(void* block, std::size_t bytes) {
  if (bytes < large_page || std::align(small_page, large_page, block, bytes) == nullptr) return;
  madvise(block, bytes, MADV_HUGEPAGE);
}

}  // namespace croquis::subdivision
