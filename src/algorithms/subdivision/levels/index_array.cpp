// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/index_array.h"

#include <cstdlib>
#include <new>

#include "algorithms/subdivision/levels/large_pages.h"

namespace croquis::subdivision {

void* allocate_block(std::size_t bytes) {
  void* block = nullptr;
  if (bytes < large_page) {
    block = std::malloc(bytes);
  } else if (posix_memalign(&block, large_page, bytes) == 0) {
    wish_large_pages(block, bytes);
  }
  if (block == nullptr && bytes > 0) throw std::bad_alloc();
  return block;
}

void free_block(void* block) { std::free(block); }

}  // namespace croquis::subdivision
