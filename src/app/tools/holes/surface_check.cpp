// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/surface_check.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "app/views/patch_surface.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/hole_filling/surface_view.h"

namespace croquis::app {
namespace {

constexpr int pause_ms = 400;  // checks take longer than patches: not while values are being tried

/// Of patches, by their places among those given.
/// @param faces faces of the mesh, ascending
std::vector<Index> patch_faces(const PolyMesh& mesh, std::span<const Index> faces) {
  std::vector<Index> patches;
  const std::vector<std::int32_t>* ids = patch_ids(mesh);
  for (std::size_t i = 0; ids != nullptr && i < faces.size(); ++i) {
    if ((*ids)[faces[i]] >= 0) patches.push_back(static_cast<Index>(i));
  }
  return patches;
}

/// Whether all faces that are of no patch are the scan's, in its order, though some are missing: trimming takes faces
/// and vertices away, so that only places can be compared.
bool keeps_what_trimming_left(const PolyMesh& filled, const PolyMesh& scan, const std::vector<Index>& patches) {
  const auto same_place = [&](Index ours, Index theirs) { return filled.positions[ours] == scan.positions[theirs]; };
  const std::size_t kept = filled.face_count() - patches.size();
  std::size_t theirs = 0;
  for (std::size_t face = 0; face < kept; ++face) {
    const auto ours = filled.face(face);
    while (theirs < scan.face_count() && !std::ranges::equal(ours, scan.face(theirs), same_place)) ++theirs;
    if (theirs++ == scan.face_count()) return false;
  }
  return kept < scan.face_count();
}

QString counted(std::size_t count, const QString& one, const QString& many) {
  return (count == 1 ? one : many).arg(count);
}

/// Edges that nothing explains. A remeshed model has other edges along the same border.
std::size_t surprising_edges(const CheckedSurface& checked, const LeftOpen& left) {
  const std::size_t known = left.border_edges + left.hole_edges;
  if (!checked.has_patches) return left.borders + left.holes == 0 ? checked.open_edges : 0;
  return checked.open_edges - std::min(checked.open_edges, known);
}

QString opening(const CheckedSurface& checked, const LeftOpen& left) {
  const auto tr = [](const char* text) { return SurfaceCheck::tr(text); };
  const auto edges = [&](std::size_t count) { return counted(count, tr("%1 edge"), tr("%1 edges")); };
  if (checked.open_edges == 0) {
    if (checked.seam_edges == 0) return tr("closed");
    return tr("closed but for seams (%1): merge the vertices of the scan").arg(edges(checked.seam_edges));
  }
  const std::size_t surprising = surprising_edges(checked, left);
  if (surprising == checked.open_edges) return counted(surprising, tr("%1 open edge"), tr("%1 open edges"));
  // Of a remeshed model only the sum is known.
  const bool apart = checked.has_patches && left.borders > 0 && left.holes > 0;
  const QString all = apart ? QString() : " (" + edges(checked.open_edges - surprising) + ")";
  QStringList places;
  if (left.borders > 0) {
    places << (left.borders == 1 ? tr("its outer border") : tr("its %1 borders").arg(left.borders)) +
                  (apart ? " (" + edges(left.border_edges) + ")" : QString());
  }
  if (left.holes > 0) {
    places << counted(left.holes, tr("%1 hole"), tr("%1 holes")) +
                  (apart ? " (" + edges(left.hole_edges) + ")" : QString());
  }
  const QString text = tr("open at %1").arg(places.join(tr(" and "))) + all;
  return surprising == 0 ? text : text + tr(" and along %1 more").arg(edges(surprising));
}

}  // namespace

CheckedSurface check_surface(const PolyMesh& filled, const PolyMesh* scan, Progress& progress) {
  CheckedSurface checked;
  Progress counting = progress.step("count", 0.5);
  const hole_filling::SurfaceView view = hole_filling::view_surface(filled, counting);
  checked.open_edges = view.rim_corners.size();
  checked.seam_edges = hole_filling::count_seam_edges(filled, view);
  checked.nonmanifold_edges = view.nonmanifold_edges;
  const hole_filling::JoinedMesh surface = hole_filling::joined(filled, view);
  const std::vector<Index> patches = patch_faces(filled, surface.face);
  checked.has_patches = scan != nullptr && !patches.empty();
  Progress meeting = progress.step("intersections", 0.5);
  checked.intersections = checked.has_patches ? find_intersections_of(surface.mesh, patches, meeting, {}).count
                                              : find_self_intersections(surface.mesh, meeting, {}).count;
  if (scan == nullptr) return checked;
  checked.outside_unchanged = begins_with(filled, *scan);
  checked.trimmed =
      !checked.outside_unchanged && checked.has_patches && keeps_what_trimming_left(filled, *scan, patches);
  return checked;
}

bool is_as_wanted(const CheckedSurface& checked, const LeftOpen& left) {
  return checked.is_sound() && left.failed == 0 && surprising_edges(checked, left) == 0;
}

QString sentence_of(const CheckedSurface& checked, const LeftOpen& left) {
  const auto tr = [](const char* text) { return SurfaceCheck::tr(text); };
  QStringList parts;
  parts << (checked.nonmanifold_edges == 0
                ? tr("manifold")
                : counted(checked.nonmanifold_edges, tr("%1 non-manifold edge"), tr("%1 non-manifold edges")));
  parts << (checked.has_patches ? counted(checked.intersections, tr("%1 new intersection"), tr("%1 new intersections"))
                                : counted(checked.intersections, tr("%1 intersection"), tr("%1 intersections")));
  if (!checked.has_patches)
    parts << tr("remeshed");
  else if (checked.outside_unchanged)
    parts << tr("outside unchanged");
  else
    parts << (checked.trimmed ? tr("rims trimmed, else unchanged") : tr("outside CHANGED"));
  const bool otherwise_sound = checked.open_edges > 0 && is_as_wanted(checked, left);
  return opening(checked, left) + (otherwise_sound ? tr(", otherwise sound: ") : QStringLiteral(", ")) +
         parts.join(", ");
}

SurfaceCheck::SurfaceCheck(QObject* parent) : QObject(parent) {
  pause_.setSingleShot(true);
  connect(&pause_, &QTimer::timeout, this, &SurfaceCheck::begin);
}

void SurfaceCheck::follow(std::shared_ptr<const PolyMesh> filled, std::shared_ptr<const PolyMesh> scan) {
  if (filled == filled_ && scan == scan_) return;
  job_.cancel();
  pause_.stop();
  filled_ = std::move(filled);
  scan_ = std::move(scan);
  found_.reset();
  if (filled_) pause_.start(pause_ms);
  emit changed();
}

void SurfaceCheck::begin() {
  job_.start(
      [filled = filled_, scan = scan_](Progress& progress) { return check_surface(*filled, scan.get(), progress); },
      [this](const std::optional<CheckedSurface>& found) {
        found_ = found;
        if (found) emit changed();
      });
}

}  // namespace croquis::app
