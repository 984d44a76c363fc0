// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure_shells.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "algorithms/silhouette/joining/seam_blending.h"
#include "algorithms/silhouette/joining/union_improvement.h"
#include "algorithms/silhouette/surface/certificate.h"
#include "algorithms/silhouette/surface/silhouette_overlap.h"

namespace croquis::silhouette {
namespace {

/// Joined surfaces show what their parts show, but for rounding; a union that lost a part of them is no union.
constexpr double least_kept_silhouette = 0.99;

/// Rounded seams may fill the corners of the outline a little.
constexpr double least_blended_silhouette = 0.97;
constexpr double finest_share = 0.6;  // of a contour step: edges of rounded seams
constexpr int max_blends = 6;         // each with smaller radii than the last
constexpr double least_share = 0.25;  // of the radius asked for; a smaller seam looks sharp

/// How often triangles are made even, each time with fewer of them.
constexpr int max_improvements = 4;

/// u: seams' edges shorter than that may go.
constexpr double sliver = 0.25;

Vec3 centre_of(const PolyMesh& mesh, Index face) {
  const auto corners = mesh.face(face);
  return (mesh.positions[corners[0]] + mesh.positions[corners[1]] + mesh.positions[corners[2]]) / 3;
}

std::vector<SidedOutline> outlines_of(const LabelledFigure& figure, const std::vector<Index>& objects) {
  std::vector<SidedOutline> outlines;
  for (const Index object : objects) {
    for (const Index c : figure.objects[object].contours) {
      SidedOutline outline{{}, figure.contours[c].side};
      for (const Index v : figure.contours[c].vertices) outline.points.push_back(figure.points[v]);
      outlines.push_back(std::move(outline));
    }
  }
  return outlines;
}

/// Tells which seams are next to places of a shell.
class NearestSeams {
 public:
  NearestSeams(const FigureShell& shell, const Attachments& attachments) : shell_(shell) {
    std::vector<std::set<Index>> objects(shell.mesh.vertex_count());
    for (Index f = 0; f < shell.face_objects.size(); ++f) {
      for (const Index v : shell.mesh.face(f)) objects[v].insert(shell.face_objects[f]);
    }
    for (Index v = 0; v < objects.size(); ++v) {
      for (const Index a : objects[v]) {
        for (const Index b : objects[v]) {
          if (a < b && attachments.pairs().contains({a, b})) seams_.push_back({{a, b}, v});
        }
      }
    }
  }

  /// The attachment of the face's object whose seam is nearest; none in a shell of one object.
  std::optional<ObjectPair> of(Index face) const {
    if (shell_.face_objects.empty()) return std::nullopt;
    const Index own = shell_.face_objects[face];
    const Vec3 centre = centre_of(shell_.mesh, face);
    std::optional<ObjectPair> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [pair, v] : seams_) {
      const double distance = (shell_.mesh.positions[v] - centre).squaredNorm();
      if ((pair.first != own && pair.second != own) || distance >= least) continue;
      least = distance;
      nearest = pair;
    }
    return nearest;
  }

 private:
  const FigureShell& shell_;
  std::vector<std::pair<ObjectPair, Index>> seams_;  ///< vertices of seams
};

class ShellMaker {
 public:
  ShellMaker(const LabelledFigure& figure, const std::vector<CheckedSurface>& surfaces, const Attachments& attachments)
      : figure_(figure), surfaces_(surfaces), attachments_(attachments) {}

  FigureShells make(const std::map<ObjectPair, double>& seams, Progress& progress) {
    if (!attachments_.empty()) join(progress);
    if (!result_.failed.empty()) return std::move(result_);
    for (const CheckedSurface& surface : surfaces_) {
      if (!attachments_.involves(surface.surface->object)) add_single(surface);
    }
    std::sort(result_.shells.begin(), result_.shells.end(),
              [](const FigureShell& a, const FigureShell& b) { return a.objects.front() < b.objects.front(); });
    if (!attachments_.empty()) check_apart(progress);
    if (result_.failed.empty() && !seams.empty()) blend(seams, progress);
    for (std::size_t shell = 0; shell < result_.shells.size(); ++shell) improve(shell, progress);
    return std::move(result_);
  }

 private:
  void join(Progress& progress) {
    std::vector<UnionPart> parts;
    for (const CheckedSurface& surface : surfaces_) {
      const Index object = surface.surface->object;
      if (!attachments_.involves(object)) continue;
      if (surface.fault.empty()) {
        parts.push_back({&surface.surface->mesh, object});
      } else {
        fail_pairs_of(object);
      }
    }
    if (!result_.failed.empty()) return;
    std::vector<ObjectPair> pairs;
    for (const auto& [pair, kappa] : attachments_.pairs()) pairs.push_back(pair);
    PartJoining joining = join_parts(parts, pairs, sliver * figure_.unit, progress);
    result_.failed = std::move(joining.failed);
    for (JoinedParts& joined : joining.groups) add_joined(std::move(joined), progress);
  }

  /// A surface that shows less than was drawn, or isn't closed, was spoilt by a part: by the last one for all we know.
  void add_joined(JoinedParts joined, Progress& progress) {
    const PolyMesh& mesh = joined.surface.mesh;
    const CertificateInput input{&mesh, std::nullopt};
    if (!certify_topology({&input, 1}, progress).front().empty() ||
        silhouette_overlap(mesh, outlines_of(figure_, joined.objects)).ratio() < least_kept_silhouette) {
      fail_pairs_of(joined.objects.back());
      return;
    }
    // A closed surface of triangles has three edges for every two faces.
    const int euler = static_cast<int>(mesh.vertex_count()) - static_cast<int>(mesh.face_count() / 2);
    std::sort(joined.objects.begin(), joined.objects.end());
    result_.shells.push_back(
        {std::move(joined.surface.mesh), std::move(joined.objects), std::move(joined.surface.face_objects), euler, {}});
  }

  void add_single(const CheckedSurface& checked) {
    const Index object = checked.surface->object;
    if (checked.fault.empty()) {
      // certify_topology has counted the mesh's Euler number and found it to be this.
      result_.shells.push_back({checked.surface->mesh, {object}, {}, 2 * figure_.objects[object].euler_region, {}});
    } else {
      result_.refused.emplace_back(object, checked.fault);
    }
  }

  void fail_pairs_of(Index object) {
    for (const auto& [pair, kappa] : attachments_.pairs()) {
      if (pair.first == object || pair.second == object) result_.failed.push_back({pair, JoinFault::Unsound});
    }
  }

  /// Nothing is proven about joined surfaces: they are tested on the numbers as they are and as files may round them.
  void check_apart(Progress& progress) {
    std::vector<CertificateInput> inputs;
    for (const FigureShell& shell : result_.shells) inputs.push_back({&shell.mesh, std::nullopt});
    std::set<ObjectPair> spoilt;
    std::set<std::size_t> refused;
    for (const auto& [shell, faces] : meeting_by_shell(inputs, progress)) {
      const NearestSeams seams(result_.shells[shell], attachments_);
      for (const Index face : faces) {
        if (const std::optional<ObjectPair> pair = seams.of(face)) {
          spoilt.insert(*pair);
        } else {
          refused.insert(shell);
        }
      }
    }
    for (const ObjectPair& pair : spoilt) result_.failed.push_back({pair, JoinFault::Unsound});
    if (!spoilt.empty()) return;
    for (auto mesh = refused.rbegin(); mesh != refused.rend(); ++mesh) {
      result_.refused.emplace_back(result_.shells[*mesh].objects.front(), "intersects another one");
      result_.shells.erase(result_.shells.begin() + static_cast<std::ptrdiff_t>(*mesh));
    }
  }

  void blend(const std::map<ObjectPair, double>& seams, Progress& progress) {
    for (FigureShell& shell : result_.shells) {
      if (shell.face_objects.empty()) continue;
      std::map<ObjectPair, double> own;
      for (const auto& seam : seams) {
        if (std::binary_search(shell.objects.begin(), shell.objects.end(), seam.first.first)) own.insert(seam);
      }
      if (!own.empty()) blend(shell, std::move(own), progress);
    }
  }

  /// @param radii of the shell's own seams
  void blend(FigureShell& shell, std::map<ObjectPair, double> radii, Progress& progress) {
    SurfaceUnion sharp{std::move(shell.mesh), std::move(shell.face_objects)};
    std::map<ObjectPair, double> shares;
    for (const auto& [pair, radius] : radii) shares[pair] = 1;
    for (int k = 0; k < max_blends && !shares.empty(); ++k) {
      progress.check();
      std::map<ObjectPair, double> tried;
      for (const auto& [pair, share] : shares) tried[pair] = share * radii[pair];
      std::optional<SurfaceUnion> blended = blend_seams(sharp, tried, finest_share * figure_.step);
      if (blended) {
        shell.mesh = std::move(blended->mesh);
        shell.face_objects = std::move(blended->face_objects);
        const std::optional<std::set<ObjectPair>> fault = blend_fault(shell, progress);
        if (!fault) {
          shell.blends = std::move(shares);
          return;
        }
        lessen(*fault, shares);
      } else {
        lessen({}, shares);
      }
    }
    shell.mesh = std::move(sharp.mesh);
    shell.face_objects = std::move(sharp.face_objects);
  }

  /// Halves the radii of these seams, of all where there are none of them; below a quarter a seam stays sharp.
  static void lessen(const std::set<ObjectPair>& fault, std::map<ObjectPair, double>& shares) {
    const bool all = std::none_of(fault.begin(), fault.end(), [&](const auto& pair) { return shares.contains(pair); });
    for (auto& [pair, share] : shares) {
      if (all || fault.contains(pair)) share /= 2;
    }
    std::erase_if(shares, [](const auto& entry) { return entry.second < least_share; });
  }

  /// What is wrong with a shell whose seams were rounded, also beside all others: none for nothing, else the seams next
  /// to the places where surfaces meet; empty where it isn't known which.
  std::optional<std::set<ObjectPair>> blend_fault(const FigureShell& shell, Progress& progress) const {
    const CertificateInput own{&shell.mesh, std::nullopt};
    if (!certify_topology({&own, 1}, progress).front().empty()) return std::set<ObjectPair>{};
    if (silhouette_overlap(shell.mesh, outlines_of(figure_, shell.objects)).ratio() < least_blended_silhouette) {
      return std::set<ObjectPair>{};
    }
    std::vector<CertificateInput> inputs;
    for (const FigureShell& other : result_.shells) inputs.push_back({&other.mesh, std::nullopt});
    const std::map<std::size_t, std::set<Index>> meeting = meeting_by_shell(inputs, progress);
    if (meeting.empty()) return std::nullopt;
    std::set<ObjectPair> fault;
    const auto own_faces = meeting.find(static_cast<std::size_t>(&shell - result_.shells.data()));
    if (own_faces == meeting.end()) return fault;
    const NearestSeams nearest(shell, attachments_);
    for (const Index face : own_faces->second) {
      if (const std::optional<ObjectPair> pair = nearest.of(face)) fault.insert(*pair);
    }
    return fault;
  }

  /// Faces that meet others, as they are or rounded, by their shells.
  std::map<std::size_t, std::set<Index>> meeting_by_shell(const std::vector<CertificateInput>& inputs,
                                                          Progress& progress) const {
    std::map<std::size_t, std::set<Index>> meeting;
    for (const Rounding rounding : {Rounding::None, Rounding::Grid}) {
      for (const auto& pair : meeting_faces(inputs, rounding, figure_.unit, progress)) {
        for (const MeshFace& place : pair) meeting[place.mesh].insert(place.face);
      }
    }
    return meeting;
  }

  /// Wider triangles where shells are joined. Where surfaces would meet their triangles stay as they were, or else all.
  void improve(std::size_t number, Progress& progress) {
    FigureShell& shell = result_.shells[number];
    if (shell.face_objects.empty()) return;
    const SurfaceUnion joined{std::move(shell.mesh), std::move(shell.face_objects)};
    std::vector<std::uint8_t> kept(joined.mesh.vertex_count(), 0);
    for (int k = 0; k < max_improvements; ++k) {
      ImprovedUnion improved = improve_union(joined, kept, progress);
      shell.mesh = std::move(improved.surface.mesh);
      shell.face_objects = std::move(improved.surface.face_objects);
      const std::vector<Index> meeting = meeting_vertices(number, improved.changed, progress);
      if (meeting.empty()) return;
      for (const Index v : meeting) kept[improved.vertices[v]] = 1;
    }
    shell.mesh = joined.mesh;
    shell.face_objects = joined.face_objects;
  }

  /// Of the shell's faces that meet others, one of them among those given.
  std::vector<Index> meeting_vertices(std::size_t shell, const std::vector<Index>& faces, Progress& progress) const {
    std::vector<CertificateInput> inputs;
    for (const FigureShell& other : result_.shells) inputs.push_back({&other.mesh, std::nullopt});
    std::vector<Index> vertices;
    for (const Rounding rounding : {Rounding::None, Rounding::Grid}) {
      for (const auto& meeting : meeting_faces_of(inputs, shell, faces, rounding, figure_.unit, progress)) {
        for (const MeshFace& place : meeting) {
          if (place.mesh != shell) continue;
          const auto corners = result_.shells[shell].mesh.face(place.face);
          vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
      }
    }
    return vertices;
  }

  const LabelledFigure& figure_;
  const std::vector<CheckedSurface>& surfaces_;
  const Attachments& attachments_;
  FigureShells result_;
};

}  // namespace

FigureShells make_shells(const LabelledFigure& figure, const std::vector<CheckedSurface>& surfaces,
                         const Attachments& attachments, const std::map<ObjectPair, double>& seams,
                         Progress& progress) {
  return ShellMaker(figure, surfaces, attachments).make(seams, progress);
}

}  // namespace croquis::silhouette
