// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace croquis {

/// What the operation `edit` did; its report is made of this.
struct EditResult {
  std::vector<std::string> edits;  ///< as lines of text, in their order
  std::string connectivity;        ///< name for how the faces of the mesh given are joined
  std::size_t new_vertices = 0, new_faces = 0;
};

std::size_t byte_size(const EditResult& result);

}  // namespace croquis
