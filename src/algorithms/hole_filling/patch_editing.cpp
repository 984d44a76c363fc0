// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patch_editing.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace croquis::hole_filling {
namespace {

struct MeshTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexTraits { double size = 1; };
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;
using Vertex = OpenMesh::VertexHandle;
using Halfedge = OpenMesh::HalfedgeHandle;
using Edge = OpenMesh::EdgeHandle;

constexpr double too_long = 4.0 / 3;
constexpr double too_short = 4.0 / 5;
constexpr int flip_rounds = 5;

/// Cosine: triangles that a step makes may not turn further from those they come from.
constexpr double least_agreement = 0.5;

class PatchEditing {
 public:
  explicit PatchEditing(const LoosePatch& patch) : rim_points_(static_cast<int>(patch.rim_points)) {
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
      const Vec3& p = patch.points[i];
      mesh_.data(mesh_.add_vertex({p.x(), p.y(), p.z()})).size = patch.sizes[i];
    }
    for (const auto& [a, b, c] : patch.triangles)
      is_manifold_ &= mesh_.add_face(vertex(a), vertex(b), vertex(c)).is_valid();
  }

  bool is_manifold() const { return is_manifold_; }

  void run() {
    split_long();
    collapse_short();
    mesh_.garbage_collection();
    for (int round = 0; round < flip_rounds && flip_once(); ++round) {
    }
  }

  LoosePatch result() const {
    LoosePatch patch;
    patch.rim_points = static_cast<std::size_t>(rim_points_);
    for (const auto v : mesh_.vertices()) {
      patch.points.push_back(at(v));
      patch.sizes.push_back(mesh_.data(v).size);
    }
    for (const auto face : mesh_.faces()) {
      std::array<Index, 3> t{};
      std::size_t i = 0;
      for (const auto v : mesh_.fv_range(face)) t[i++] = static_cast<Index>(v.idx());
      patch.triangles.push_back(t);
    }
    return patch;
  }

 private:
  static Vertex vertex(Index i) { return Vertex(static_cast<int>(i)); }
  Vec3 at(Vertex v) const {
    const auto& p = mesh_.point(v);
    return {p[0], p[1], p[2]};
  }
  bool on_rim(Vertex v) const { return v.idx() < rim_points_; }

  Halfedge half(Edge e) const { return mesh_.halfedge_handle(e, 0); }
  Vertex from(Halfedge h) const { return mesh_.from_vertex_handle(h); }
  Vertex to(Halfedge h) const { return mesh_.to_vertex_handle(h); }

  /// Length as a share of what is wanted.
  double relative_length(Vertex a, Vertex b) const {
    return 2 * (at(a) - at(b)).norm() / (mesh_.data(a).size + mesh_.data(b).size);
  }

  Vec3 normal(Vertex a, Vertex b, Vertex c) const { return (at(b) - at(a)).cross(at(c) - at(a)); }
  static bool agree(const Vec3& a, const Vec3& b) { return a.dot(b) > least_agreement * a.norm() * b.norm(); }

  /// The edges there are now, the longest first.
  void split_long() {
    std::vector<std::pair<double, int>> order;
    for (const auto e : mesh_.edges()) {
      const double length = relative_length(from(half(e)), to(half(e)));
      if (!mesh_.is_boundary(e) && length > too_long) order.emplace_back(-length, e.idx());
    }
    std::sort(order.begin(), order.end());
    for (const auto& [length, index] : order) {
      const Edge e(index);
      const Vertex a = from(half(e)), b = to(half(e));
      if (relative_length(a, b) <= too_long) continue;
      const auto middle = mesh_.add_vertex(0.5 * (mesh_.point(a) + mesh_.point(b)));
      mesh_.data(middle).size = 0.5 * (mesh_.data(a).size + mesh_.data(b).size);
      mesh_.split(e, middle);
    }
  }

  void collapse_short() {
    for (int index = 0; index < static_cast<int>(mesh_.n_edges()); ++index) {
      const Edge e(index);
      if (mesh_.status(e).deleted() || mesh_.is_boundary(e)) continue;
      Halfedge h = half(e);
      if (on_rim(from(h))) h = mesh_.opposite_halfedge_handle(h);
      if (on_rim(from(h)) || relative_length(from(h), to(h)) >= too_short) continue;
      if (mesh_.is_collapse_ok(h) && keeps_shape(h)) mesh_.collapse(h);
    }
  }

  /// Whether the triangles around stay of good size, on their side, and apart from other rim points.
  bool keeps_shape(Halfedge h) const {
    const Vertex gone = from(h), kept = to(h);
    for (const auto out : mesh_.voh_range(gone)) {
      const Vertex a = to(out);
      if (a == kept) continue;
      if (relative_length(a, kept) > too_long) return false;
      if (on_rim(a) && on_rim(kept) && !mesh_.find_halfedge(a, kept).is_valid()) return false;
      const Vertex b = to(mesh_.next_halfedge_handle(out));
      if (mesh_.is_boundary(out) || b == kept) continue;
      if (!agree(normal(gone, a, b), normal(kept, a, b))) return false;
    }
    return true;
  }

  bool flip_once() {
    bool any = false;
    for (const auto e : mesh_.edges()) {
      if (mesh_.is_boundary(e) || !mesh_.is_flip_ok(e) || !gains_by_flip(e)) continue;
      mesh_.flip(e);
      any = true;
    }
    return any;
  }

  double angle(Vertex apex, Vertex a, Vertex b) const {
    const Vec3 u = at(a) - at(apex), v = at(b) - at(apex);
    return std::atan2(u.cross(v).norm(), u.dot(v));
  }

  bool gains_by_flip(Edge e) const {
    const Halfedge h = half(e);
    const Vertex a = from(h), b = to(h);
    const Vertex c = to(mesh_.next_halfedge_handle(h));
    const Vertex d = to(mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h)));
    if (on_rim(c) && on_rim(d)) return false;
    constexpr double pi = 3.14159265358979323846;
    if (angle(c, a, b) + angle(d, a, b) <= pi + 1e-9) return false;  // rounding must not flip back and forth
    const Vec3 both = normal(a, b, c) + normal(b, a, d);
    return agree(both, normal(a, d, c)) && agree(both, normal(b, c, d));
  }

  Mesh mesh_;
  int rim_points_;
  bool is_manifold_ = true;
};

/// Whether some edge has two triangles that run the same way. Asked first, since OpenMesh prints what it refuses.
bool has_crowded_edge(const LoosePatch& patch) {
  std::vector<std::array<Index, 2>> edges;
  for (const auto& [a, b, c] : patch.triangles) edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
}

}  // namespace

bool bring_to_size(LoosePatch& patch) {
  if (has_crowded_edge(patch)) return false;
  PatchEditing editing(patch);
  if (!editing.is_manifold()) return false;
  editing.run();
  patch = editing.result();
  return true;
}

}  // namespace croquis::hole_filling
