// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/export_check.h"

#include <QObject>
#include <QStringList>
#include <set>
#include <string>

#include "croquis/base/text.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/self_intersection.h"

namespace croquis::app {
namespace {

void look_at_boundary(const PolyMesh& mesh, ExportCheck& check) {
  const MeshTopology topology(mesh);
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    if (topology.edge_corners(edge).size() != 1) continue;
    check.doubt->subjects.push_back(numbered_subject(SubjectKind::Edge, edge));
    for (const Index vertex : topology.edge_vertices(edge)) check.where.extend(mesh.positions[vertex]);
  }
}

void look_at_crossings(const PolyMesh& mesh, const SelfIntersections& crossings, ExportCheck& check) {
  std::set<Index> faces;
  for (const auto& [a, b] : crossings.pairs) faces.insert({a, b});
  for (const Index face : faces) {
    check.doubt->subjects.push_back(numbered_subject(SubjectKind::Face, face));
    for (const Index vertex : mesh.face(face)) check.where.extend(mesh.positions[vertex]);
  }
}

}  // namespace

ExportCheck check_export(const PolyMesh& mesh, Progress& progress) {
  ExportCheck check;
  Progress counting = progress.step("count elements", 0.3);
  check.figures = inspect(mesh, false, counting);
  Progress searching = progress.step("find self-intersections", 0.7);
  const SelfIntersections crossings = find_self_intersections(mesh, searching);
  check.figures.self_intersections = crossings.count;
  std::string faults;
  if (!check.figures.closed)
    faults = "isn't closed: " + counted(check.figures.boundary_edges, "edge is", "edges are") + " open";
  if (crossings.count > 0)
    faults +=
        (faults.empty() ? "" : ", and it ") + ("crosses itself in " + counted(crossings.count, "place", "places"));
  if (faults.empty()) return check;
  const bool crosses = crossings.count > 0;
  check.doubt =
      make_warning(Category::Geometry, crosses ? "W_SELF_INTERSECTION" : "W_OPEN", "The mesh " + faults + ".", {});
  crosses ? look_at_crossings(mesh, crossings, check) : look_at_boundary(mesh, check);
  return check;
}

QString summary_of(const MeshReport& figures, const QString& unit) {
  QStringList parts = {figures.closed ? QObject::tr("closed") : QObject::tr("open"),
                       QString::fromStdString(counted(figures.faces, "face", "faces"))};
  if (figures.bounds) {
    const Vec3 size = (*figures.bounds)[1] - (*figures.bounds)[0];
    QStringList lengths;
    for (const double length : size) lengths << QString::number(length, 'g', 4);
    parts << lengths.join(QStringLiteral(" × ")) + (unit.isEmpty() ? "" : " " + unit);
  }
  return parts.join(QStringLiteral(", "));
}

}  // namespace croquis::app
