// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/described.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/remeshing/remesh.h"

/// What the operation `fill` found and did; its report is made of this.
namespace croquis {

using hole_filling::FillAction;

/// One hole of the scan. Lengths in model units, angles in radians.
struct HoleRow {
  Index id = 0;  ///< place in FillResult::holes; polyline of the output "rims"
  hole_filling::HoleClass kind = hole_filling::HoleClass::Simple;
  std::size_t edges = 0;  ///< of its rim
  double perimeter = 0;
  double diameter = 0;
  double area = 0;                       ///< of its minimal triangulation
  FillAction state = FillAction::Leave;  ///< Fill in a list that was made without filling: it would be filled
  std::string method;                    ///< of the patch taken, empty without one
  std::string reason;                    ///< why it was left, failed, or not filled by the first method
  std::optional<double> angle;           ///< greatest one between the faces on the two sides of a rim edge
  std::optional<double> confidence;      ///< 0..1, of its patch
  Vec3 at = Vec3::Zero();                ///< the middle of its rim
  Vec3 normal = Vec3::UnitZ();           ///< unit, on the side that the faces look to
  std::vector<Index> companions;         ///< holes that belong to it: islands, the hole around it, a tunnel's other rim
  std::optional<Index> patch;            ///< as in the mesh's channel "patch_id"; one patch may close several holes
  std::optional<double> expected_error;  ///< mean distance of its patch to the surface that was there

  bool is_border() const { return kind == hole_filling::HoleClass::Outer; }
};
/// Angles in degrees.
inline auto described(const HoleRow& hole) {
  const auto known = [](const std::string& text) { return text.empty() ? Report() : Report(text); };
  return fields(named("id", hole.id), named("class", hole.kind), named("boundary_edges", hole.edges),
                named("perimeter", hole.perimeter), named("diameter", hole.diameter), named("area", hole.area),
                named("action", hole.state), named("method", known(hole.method)), named("reason", known(hole.reason)),
                named("max_normal_jump", in_degrees(hole.angle)), named("confidence", hole.confidence),
                named("at", hole.at), named("normal", hole.normal), named("companions", hole.companions),
                named("patch", hole.patch), named("error_estimate", hole.expected_error));
}

/// What only a remeshed model has.
struct RemeshFigures {
  std::size_t predicted_bytes = 0, predicted_faces = 0;
  std::size_t full_faces = 0;  ///< before faces were merged where the surface is flat
  remeshing::RemeshChecks checks;
};

/// Edges of one face, with vertices that count as one taken as one (see hole_filling::view_surface).
struct OpenEdges {
  std::size_t before = 0;  ///< of the scan
  std::size_t after = 0;   ///< of the mesh made
  std::size_t loose = 0;   ///< of the scan, and of no hole: their rims end at edges of more than two faces
  std::size_t seams = 0;   ///< edges of the scan that are closed only since vertices at one place count as one
};
inline auto described(const OpenEdges& edges) {
  return fields(named("before", edges.before), named("after", edges.after), named("loose", edges.loose),
                named("seams", edges.seams));
}
static_assert(describes_every_member<OpenEdges>);

struct FillResult {
  std::shared_ptr<const PolyMesh> scan;  ///< the mesh given, whose holes these are
  std::vector<HoleRow> holes;            ///< by id
  bool listed = false;                   ///< nothing was filled, and the output is the scan
  OpenEdges open_edges;
  std::size_t new_vertices = 0, new_faces = 0;
  std::size_t domains = 0;  ///< functions that were fitted: of patches one or several each
  hole_filling::DomainPointCounts points_per_domain;
  std::size_t untouched_vertices = 0;     ///< of the scan's
  std::size_t removed_faces = 0;          ///< of the scan's, by trimming
  bool outside_unchanged = false;         ///< of a scan with patches: checked after filling
  std::optional<RemeshFigures> remeshed;  ///< of a remeshed model, and of nothing else
};

/// Without the scan, which the operation was given.
std::size_t byte_size(const FillResult& result);

}  // namespace croquis
