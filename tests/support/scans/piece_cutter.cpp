// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/piece_cutter.h"

#include <cmath>
#include <numbers>

namespace croquis::test {

RaggedRadius::RaggedRadius(Random& random, double radius, double raggedness)
    : radius_(radius), raggedness_(raggedness) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 direction(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    waves_[i] = direction.normalized() * (2 + 2 * static_cast<double>(i)) / radius;
    phases_[i] = random.between(0, 2 * std::numbers::pi);
  }
}

double RaggedRadius::at(const Vec3& offset) const {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += std::sin(waves_[i].dot(offset) + phases_[i]);
  return radius_ * (1 + raggedness_ * sum / 2);
}

PieceCutter::PieceCutter(const PolyMesh& mesh) : mesh_(mesh), topology_(mesh), taken_(mesh.vertex_count(), false) {
  for (const Index v : topology_.boundary_loops().values) taken_[v] = true;
}

bool PieceCutter::is_free(const std::vector<Index>& faces, std::ptrdiff_t rims) const {
  std::vector<std::array<Index, 2>> edges;
  std::set<Index> vertices;
  for (const Index f : faces) {
    const auto t = mesh_.face(f);
    for (std::size_t i = 0; i < 3; ++i) {
      if (taken_[t[i]]) return false;
      vertices.insert(t[i]);
      edges.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Index> rim_ends;
  std::ptrdiff_t edge_count = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    ++edge_count;
    if (i + 1 < edges.size() && edges[i] == edges[i + 1]) {
      ++i;
      continue;
    }
    rim_ends.insert(rim_ends.end(), edges[i].begin(), edges[i].end());
  }
  std::sort(rim_ends.begin(), rim_ends.end());
  for (std::size_t i = 2; i < rim_ends.size(); ++i) {
    if (rim_ends[i - 2] == rim_ends[i]) return false;
  }
  const auto count = static_cast<std::ptrdiff_t>(vertices.size()) + static_cast<std::ptrdiff_t>(faces.size());
  return !faces.empty() && count - edge_count == 2 - rims;
}

void PieceCutter::take(const std::vector<Index>& faces) {
  std::set<Index> used;
  for (const Index f : faces) used.insert(mesh_.face(f).begin(), mesh_.face(f).end());
  for (int ring = 0; ring < 2; ++ring) {
    const std::set<Index> inner = used;
    for (const Index v : inner) {
      for (const Index corner : topology_.vertex_corners(v)) {
        const auto face = mesh_.face(topology_.face(corner));
        used.insert(face.begin(), face.end());
      }
    }
  }
  for (const Index v : used) taken_[v] = true;
}

}  // namespace croquis::test
