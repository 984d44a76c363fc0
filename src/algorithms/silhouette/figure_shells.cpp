// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "algorithms/silhouette/figure_solid.h"
#include "algorithms/silhouette/joining/joining.h"
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

/// By numbers of shells.
using FacesOfShells = std::map<std::size_t, std::set<Index>>;

using SeamShares = std::map<ObjectPair, double>;

/// Whether a surface without a region of its own is closed and shows so much of what was drawn of its objects.
bool is_sound(const LabelledFigure& figure, const Shell& shell, double least_silhouette, Progress& progress) {
  if (!topology_fault(shell.mesh, std::nullopt, progress).empty()) return false;
  std::vector<SidedOutline> outlines;
  for (const Index object : shell.objects) {
    for (const Index c : figure.objects[drawn_object(figure, object)].contours) {
      outlines.push_back({contour_points(figure, c), figure.contours[c].side});
    }
  }
  const PolyMesh* mesh = &shell.mesh;
  return silhouette_overlap({&mesh, 1}, outlines).ratio() >= least_silhouette;
}

/// Faces that meet others, on the numbers as they are and as files may round them: nothing is proven about joined
/// surfaces.
FacesOfShells meeting_by_shell(const std::vector<Shell>& shells, double unit, Progress& progress,
                               const std::optional<MeshFaces>& among = std::nullopt) {
  std::vector<const PolyMesh*> meshes;
  for (const Shell& shell : shells) meshes.push_back(&shell.mesh);
  FacesOfShells meeting;
  for (const Rounding rounding : {Rounding::None, Rounding::Grid}) {
    for (const auto& pair : meeting_faces(meshes, rounding, unit, progress, among)) {
      for (const MeshFace& place : pair) meeting[place.mesh].insert(place.face);
    }
  }
  return meeting;
}

/// The attachments whose seams are nearest to faces of a shell, among those of the faces' objects; none in a shell of
/// one object.
std::set<ObjectPair> nearest_seams(const Shell& shell, const Attachments& attachments, const std::set<Index>& faces) {
  if (shell.face_objects.empty()) return {};
  const PolyMesh& mesh = shell.mesh;
  std::vector<std::set<Index>> objects(mesh.vertex_count());
  for (Index f = 0; f < shell.face_objects.size(); ++f) {
    for (const Index v : mesh.face(f)) objects[v].insert(shell.face_objects[f]);
  }
  std::vector<Index> on_seams;
  for (Index v = 0; v < objects.size(); ++v) {
    if (objects[v].size() > 1) on_seams.push_back(v);
  }
  std::set<ObjectPair> seams;
  for (const Index face : faces) {
    const Index own = shell.face_objects[face];
    const auto corners = mesh.face(face);
    const Vec3 centre = (mesh.positions[corners[0]] + mesh.positions[corners[1]] + mesh.positions[corners[2]]) / 3;
    std::optional<ObjectPair> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const Index v : on_seams) {
      const double distance = (mesh.positions[v] - centre).squaredNorm();
      if (distance >= least || !objects[v].contains(own)) continue;
      for (const Index other : objects[v]) {
        const ObjectPair pair = std::minmax(own, other);
        if (!attachments.kappa(own, other)) continue;
        least = distance;
        nearest = pair;
        break;
      }
    }
    if (nearest) seams.insert(*nearest);
  }
  return seams;
}

void fail_pairs_of(Index object, const Attachments& attachments, FigureShells& made) {
  for (const ObjectPair& pair : attachments.pairs(Hold::Joined)) {
    if (pair.first == object || pair.second == object) made.failed.push_back({pair, JoinFault::Unsound});
  }
}

void join(const LabelledFigure& figure, const std::vector<Shell>& surfaces, const std::vector<std::string>& faults,
          const Attachments& attachments, FigureShells& made, Progress& progress) {
  std::vector<const Shell*> parts;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const Index object = surfaces[s].objects.front();
    if (!attachments.joins(object)) continue;
    if (faults[s].empty()) {
      parts.push_back(&surfaces[s]);
    } else {
      fail_pairs_of(object, attachments, made);
    }
  }
  if (!made.failed.empty()) return;
  const std::vector<ObjectPair> pairs = attachments.pairs(Hold::Joined);
  PartJoining joining = join_parts(parts, pairs, sliver * figure.unit, progress);
  made.failed = std::move(joining.failed);
  for (Shell& joined : joining.groups) {
    if (!is_sound(figure, joined, least_kept_silhouette, progress)) {
      fail_pairs_of(joined.objects.back(), attachments, made);  // it was spoilt by a part: the last one for all we know
      continue;
    }
    std::ranges::sort(joined.objects);
    made.shells.push_back(std::move(joined));
  }
}

void check_apart(double unit, const Attachments& attachments, FigureShells& made, Progress& progress) {
  const FacesOfShells meeting = meeting_by_shell(made.shells, unit, progress);
  std::set<ObjectPair> spoilt;
  for (const auto& [shell, faces] : meeting) spoilt.merge(nearest_seams(made.shells[shell], attachments, faces));
  for (const ObjectPair& pair : spoilt) made.failed.push_back({pair, JoinFault::Unsound});
  if (!spoilt.empty()) return;
  for (auto shell = meeting.rbegin(); shell != meeting.rend(); ++shell) {
    made.refused.emplace_back(made.shells[shell->first].objects.front(), "intersects another one");
    made.shells.erase(made.shells.begin() + static_cast<std::ptrdiff_t>(shell->first));
  }
}

/// Halves the radii of these seams, of all where there are none of them; below a quarter a seam stays sharp.
void lessen(const std::set<ObjectPair>& fault, SeamShares& shares) {
  const bool all = std::ranges::none_of(fault, [&](const ObjectPair& pair) { return shares.contains(pair); });
  for (auto& [pair, share] : shares) {
    if (all || fault.contains(pair)) share /= 2;
  }
  std::erase_if(shares, [](const auto& entry) { return entry.second < least_share; });
}

/// What is wrong with a shell whose seams were rounded, also beside all others: none for nothing, else the seams next
/// to the places where surfaces meet; empty where it isn't known which.
std::optional<std::set<ObjectPair>> blend_fault(const LabelledFigure& figure, const std::vector<Shell>& shells,
                                                std::size_t number, const Attachments& attachments,
                                                Progress& progress) {
  if (!is_sound(figure, shells[number], least_blended_silhouette, progress)) return std::set<ObjectPair>{};
  FacesOfShells meeting = meeting_by_shell(shells, figure.unit, progress);
  if (meeting.empty()) return std::nullopt;
  return nearest_seams(shells[number], attachments, meeting[number]);
}

/// @param radii of seams; those of other shells don't matter
void blend(const LabelledFigure& figure, std::size_t number, const Attachments& attachments, const SeamShares& radii,
           std::vector<Shell>& shells, Progress& progress) {
  Shell& shell = shells[number];
  SeamShares shares;
  for (const auto& [pair, radius] : radii) {
    if (std::ranges::binary_search(shell.objects, pair.first)) shares[pair] = 1;
  }
  if (shares.empty() || shell.face_objects.empty()) return;
  Shell sharp = std::move(shell);
  for (int k = 0; k < max_blends && !shares.empty(); ++k) {
    progress.check();
    SeamShares tried;
    for (const auto& [pair, share] : shares) tried[pair] = share * radii.at(pair);
    std::optional<Shell> blended = blend_seams(sharp, tried, finest_share * figure.step);
    std::set<ObjectPair> fault;
    if (blended) {
      shell = std::move(*blended);
      const std::optional<std::set<ObjectPair>> found = blend_fault(figure, shells, number, attachments, progress);
      if (!found) {
        shell.blends = std::move(shares);
        return;
      }
      fault = *found;
    }
    lessen(fault, shares);
  }
  shell = std::move(sharp);
}

/// Wider triangles where shells are joined. Where surfaces would meet their triangles stay as they were, or else all.
void improve(std::size_t number, double unit, std::vector<Shell>& shells, Progress& progress) {
  Shell& shell = shells[number];
  if (shell.face_objects.empty()) return;
  Shell joined = std::move(shell);
  std::vector<std::uint8_t> kept(joined.mesh.vertex_count(), 0);
  for (int k = 0; k < max_improvements; ++k) {
    ImprovedUnion improved = improve_union(joined, kept, progress);
    shell = std::move(improved.surface);
    FacesOfShells meeting = meeting_by_shell(shells, unit, progress, MeshFaces{number, improved.changed});
    if (meeting[number].empty()) return;
    for (const Index face : meeting[number]) {
      for (const Index v : shell.mesh.face(face)) kept[improved.vertices[v]] = 1;
    }
  }
  shell = std::move(joined);
}

/// A copy that rests on what it belongs to may meet it, whose far side needn't be as its near one: it is moved away
/// from its object, in all by up to 63 contour steps, and left out where that doesn't help.
void part_copies(const LabelledFigure& figure, FigureShells& made, Progress& progress) {
  const auto is_lone_copy = [&](const Shell& shell) { return is_copy(figure, shell.objects.front()); };
  if (std::ranges::none_of(made.shells, is_lone_copy)) return;
  const auto mean_depth = [&](Index object) {
    const auto shell = std::ranges::find(made.shells, object, [](const Shell& each) { return each.objects.front(); });
    return shell == made.shells.end() ? 0 : middle_depth(shell->mesh);
  };
  constexpr int most_moves = 6;
  bool any_meets = true;
  for (int k = 0; any_meets && k <= most_moves; ++k) {
    any_meets = false;
    const FacesOfShells meeting = meeting_by_shell(made.shells, figure.unit, progress);
    for (auto shell = meeting.rbegin(); shell != meeting.rend(); ++shell) {
      const auto place = made.shells.begin() + static_cast<std::ptrdiff_t>(shell->first);
      if (!is_lone_copy(*place)) continue;
      any_meets = true;
      const Index object = drawn_object(figure, place->objects.front());
      if (k == most_moves) {
        made.lost.push_back(object);
        made.shells.erase(place);
        continue;
      }
      const double away = std::copysign(std::ldexp(figure.step, k), middle_depth(place->mesh) - mean_depth(object));
      for (Vec3& position : place->mesh.positions) position.z() += away;
    }
  }
}

/// Copies take the numbers of what was drawn.
void number_as_drawn(const LabelledFigure& figure, FigureShells& made) {
  for (Shell& shell : made.shells) {
    for (std::vector<Index>* objects : {&shell.objects, &shell.face_objects})
      for (Index& object : *objects) object = drawn_object(figure, object);
    std::ranges::sort(shell.objects);
    shell.objects.erase(std::unique(shell.objects.begin(), shell.objects.end()), shell.objects.end());
    std::erase_if(shell.blends, [&](const auto& entry) { return is_copy(figure, entry.first.second); });
  }
  std::erase_if(made.refused, [&](const auto& refused) { return is_copy(figure, refused.first); });
  // Where only a copy can't be joined its object stays as it is.
  std::map<ObjectPair, FailedJoin> failed;
  for (const FailedJoin& join : made.failed) {
    const auto& [a, b] = join.pair;
    const ObjectPair drawn = std::minmax(drawn_object(figure, a), drawn_object(figure, b));
    const bool is_plain = drawn == join.pair;
    if (is_plain) failed[drawn] = join;
    if (!is_plain) failed.try_emplace(drawn, FailedJoin{drawn, join.fault, drawn_object(figure, std::max(a, b))});
  }
  made.failed.clear();
  for (const auto& [pair, join] : failed) made.failed.push_back(join);
}

FigureShells make_all_shells(const LabelledFigure& figure, HeldSurfaces held, Progress& progress) {
  FigureShells made;
  const Attachments& attachments = held.attachments;
  const bool joins = attachments.any(Hold::Joined);
  if (joins) join(figure, held.surfaces, held.faults, attachments, made, progress);
  if (!made.failed.empty()) return made;
  for (std::size_t s = 0; s < held.surfaces.size(); ++s) {
    const Index object = held.surfaces[s].objects.front();
    if (attachments.joins(object)) continue;
    if (held.faults[s].empty()) {
      made.shells.push_back(std::move(held.surfaces[s]));
    } else {
      made.refused.emplace_back(object, held.faults[s]);
    }
  }
  std::ranges::sort(made.shells, {}, [](const Shell& shell) { return shell.objects.front(); });
  if (!attachments.held.empty()) part_copies(figure, made, progress);
  if (joins) check_apart(figure.unit, attachments, made, progress);
  for (std::size_t shell = 0; made.failed.empty() && !held.seams.empty() && shell < made.shells.size(); ++shell) {
    blend(figure, shell, attachments, held.seams, made.shells, progress);
  }
  for (std::size_t shell = 0; shell < made.shells.size(); ++shell) {
    improve(shell, figure.unit, made.shells, progress);
  }
  return made;
}

}  // namespace

FigureShells make_shells(const LabelledFigure& figure, HeldSurfaces held, Progress& progress) {
  FigureShells made = make_all_shells(figure, std::move(held), progress);
  number_as_drawn(figure, made);
  return made;
}

}  // namespace croquis::silhouette
