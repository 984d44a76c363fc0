// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/random_tags.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "support/meshes/cages.h"

namespace croquis::test {

void add_random_tags(PolyMesh& mesh, Random& random, bool all_infinite) {
  constexpr std::array shares = {0.0, 0.1, 0.3, 0.5, 0.8, 1.0};
  const double share = shares[random.below(shares.size())];
  for (const VertexPair& edge : all_edges(mesh)) {
    if (random.unit() >= share) continue;
    double sharpness = infinite_sharpness;
    if (!all_infinite) {
      const std::uint32_t kind = random.below(4);
      if (kind == 1) sharpness = 1 + random.below(3);
      if (kind == 2) sharpness = random.between(0.05, 3);
      if (kind == 3) sharpness = random.between(0.05, 0.95);
    }
    mesh.tags.creases.push_back({edge, sharpness});
  }
  const double pin_share = random.below(2) == 0 ? 0 : 0.3;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (random.unit() < pin_share) mesh.tags.pins.push_back(v);
  }
}

subdivision::Rules random_rules(Random& random) {
  using namespace subdivision;
  if (random.below(3) == 0) return Rules::of(random.below(2) == 0 ? Preset::Refined : Preset::Paper);
  return {random.below(2) == 0 ? Weights::Classical : Weights::Average,
          random.below(2) == 0 ? Profile::Clamped : Profile::Plain, static_cast<ChainEnds>(random.below(3)),
          random.below(2) == 0 ? BoundaryCorners::Corner : BoundaryCorners::Smooth};
}

PolyMesh with_faces_shuffled(const PolyMesh& mesh, Random& random) {
  std::vector<std::size_t> order(mesh.face_count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  }
  PolyMesh result = mesh;
  result.face_offsets = {0};
  result.corners.clear();
  for (const std::size_t f : order) {
    std::vector<Index> face(mesh.face(f).begin(), mesh.face(f).end());
    std::rotate(face.begin(), face.begin() + random.below(static_cast<std::uint32_t>(face.size())), face.end());
    result.add_face(face);
  }
  return result;
}

}  // namespace croquis::test
