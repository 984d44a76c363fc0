// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/require_usable.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"

namespace croquis {
namespace {

bool are_usable(const std::vector<Index>& offsets, const std::vector<Index>& vertices, std::size_t vertex_count) {
  return !offsets.empty() && offsets.front() == 0 && offsets.back() == vertices.size() &&
         std::is_sorted(offsets.begin(), offsets.end()) &&
         (vertices.empty() || *std::max_element(vertices.begin(), vertices.end()) < vertex_count);
}

/// Whether nothing at all is wrong, without the effort of making findings.
bool is_usable(const PolyMesh& mesh) {
  return are_usable(mesh.face_offsets, mesh.corners, mesh.vertex_count()) &&
         are_usable(mesh.line_offsets, mesh.line_vertices, mesh.vertex_count()) &&
         std::ranges::all_of(mesh.positions, are_usable_numbers<Vec3>);
}

}  // namespace

void require_usable(const PolyMesh& mesh) {
  if (is_usable(mesh)) return;
  Findings findings = validate(mesh);
  std::erase_if(findings,
                [](const Finding& finding) { return finding.code != "E_INDEX" && finding.code != "E_NOT_FINITE"; });
  if (!findings.empty()) throw Error(std::move(findings));
}

}  // namespace croquis
