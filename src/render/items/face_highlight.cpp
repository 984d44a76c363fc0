// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/face_highlight.h"

#include <string>
#include <utility>
#include <vector>

#include "croquis/base/error.h"
#include "render/items/item_frame.h"
#include "render/items/mesh_plan.h"

namespace croquis::render {
namespace {

void require_faces(std::span<const Index> faces, std::size_t count) {
  Findings findings;
  for (const Index face : faces) {
    if (face >= count) findings.push_back(not_there(SubjectKind::Face, "face", face, count));
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

}  // namespace

FaceHighlightPtr make_face_highlight(const MeshItemPtr& mesh, std::span<const Index> faces, const Color& color) {
  if (!mesh || !mesh->plan) return nullptr;
  require_faces(faces, mesh->plan->face_count());
  const auto of_faces = [&](std::span<const std::uint32_t> all) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve(6 * faces.size());
    for (const Index face : faces) {
      const auto [first, last] = mesh->plan->triangle_indices(face);
      triangles.insert(triangles.end(), all.begin() + first, all.begin() + last);
    }
    return triangles;
  };
  FaceHighlightPtr reduced;
  if (mesh->reduced) {
    // The reduced surface keeps the cut of faces that it was made with.
    reduced = std::make_shared<FaceHighlight>(
        FaceHighlight{mesh->reduced, mesh->plan->reduced()->reduced(of_faces(mesh->plan->triangles())), color});
  }
  return std::make_shared<FaceHighlight>(FaceHighlight{mesh, of_faces(mesh->triangles), color, std::move(reduced)});
}

}  // namespace croquis::render
