// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/mesh_export.h"

#include <QFileInfo>
#include <QStringList>
#include <set>
#include <string>
#include <utility>

#include "app/window/language.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/io/svg_writer.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/workspace/chain.h"

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

void write_to(const QString& path, std::string bytes) {
  OutputTransaction files;
  files.add(local_name(path), std::move(bytes));
  files.commit();
}

std::string writable_endings() {
  std::vector<std::string> endings;
  for (const MeshFormat format : mesh_formats()) endings.push_back(extension_of(format));
  return either_of(endings);
}

/// The camera that the object was drawn for.
std::optional<Camera> camera_of(const Studio& studio, const WorkObject& object) {
  const auto camera = value_along(studio, object, ValueType::Camera).as<Camera>();
  if (camera == nullptr) return std::nullopt;
  return *camera;
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
                       localized(counted(figures.faces, "face", "faces"))};
  if (figures.bounds) {
    const Vec3 size = (*figures.bounds)[1] - (*figures.bounds)[0];
    QStringList lengths;
    for (const double length : size) lengths << QString::number(length, 'g', 4);
    parts << lengths.join(QStringLiteral(" × ")) + (unit.isEmpty() ? "" : " " + unit);
  }
  return parts.join(QStringLiteral(", "));
}

double export_scale(const Studio& studio, const MeshExport& wanted) {
  const double unit = metres_of_unit(wanted.unit), own = metres_of_unit(studio.unit().empty() ? "mm" : studio.unit());
  return unit > 0 && own > 0 ? own / unit : 1;
}

std::vector<NamedMesh> meshes_of(const Studio& studio, const MeshExport& wanted) {
  std::vector<NodeId> nodes;
  if (wanted.objects == MeshExport::Objects::Picked) nodes = picked_or_active(studio);
  for (const WorkObject& object : studio.objects()) {
    const bool all = wanted.objects == MeshExport::Objects::All;
    if (all || (wanted.objects == MeshExport::Objects::Visible && object.visible)) nodes.push_back(object.node);
  }
  if (nodes.empty()) throw Error(make_error(Category::Geometry, "E_EMPTY", "There is no mesh to export"));
  const Affine3 scaling{export_scale(studio, wanted) * Eigen::Matrix3d::Identity(), Vec3::Zero()};
  std::vector<NamedMesh> meshes;
  for (const NodeId node : nodes) {
    const WorkObject& object = *studio.object(node);
    const auto& mesh = object.shown();
    const bool computed = mesh && object.result && mesh == object.mesh;
    if (!mesh || (computed && (object.result->failed || object.quality != Quality::Final))) {
      const std::string name = nodes.size() == 1 ? std::string() : " of \"" + readable_name(object.name) + '"';
      const char* cure = object.visible ? ": wait until it is computed" : ": show it first, so that it is computed";
      throw Error(
          make_error(Category::Geometry, "E_EMPTY", "There is no finished mesh" + name + " to export yet" + cure));
    }
    meshes.push_back({readable_name(object.name), mesh, composed(scaling, object.placement.map())});
  }
  return meshes;
}

std::shared_ptr<const PolyMesh> exported_mesh(const Studio& studio, const MeshExport& wanted) {
  const std::vector<NamedMesh> meshes = meshes_of(studio, wanted);
  const Affine3& map = meshes.front().map;
  const bool unmoved = map == Affine3{};
  if (meshes.size() == 1 && unmoved) return meshes.front().mesh;
  return std::make_shared<const PolyMesh>(joined(meshes));
}

Findings export_solid(const Studio& studio, const QString& path, const MeshExport& wanted) {
  const auto format = mesh_format_of(local_name(path));
  if (!format) {
    throw Error(make_error(Category::Usage, "E_FORMAT",
                           "\"" + local_name(path) + "\" names no mesh format: use " + writable_endings()));
  }
  const std::vector<NamedMesh> meshes = meshes_of(studio, wanted);
  Progress progress;
  MeshWriteOptions options;
  const WorkObject* object = studio.active();
  if (meshes.size() == 1 && object->shown() == meshes.front().mesh) options.camera = camera_of(studio, *object);
  if (meshes.size() == 1) options.name = meshes.front().name;
  MeshWriteResult written = write_mesh(joined(meshes), *format, options, progress);
  write_to(path, std::move(written.bytes));
  return written.warnings;
}

std::vector<const OperationDescription*> result_exports(const Studio& studio) {
  std::vector<const OperationDescription*> found;
  for (const OperationDescription& operation : studio.registry().descriptions()) {
    const PortDescription* output = main_output(operation);
    if (output != nullptr && output->type == ValueType::AttributeNetwork) found.push_back(&operation);
  }
  return found;
}

bool can_export(const Studio& studio, const OperationDescription& operation) {
  const WorkObject* object = studio.active();
  const PortDescription* input = main_input(operation);
  return object != nullptr && input != nullptr && has_value_along(studio, *object, input->type);
}

Findings export_result(const Studio& studio, const OperationDescription& operation, const QString& path) {
  const WorkObject* object = studio.active();
  const PortDescription& input = *main_input(operation);
  const Value value = object == nullptr ? Value() : value_along(studio, *object, input.type);
  if (!value.has_content()) {
    throw Error(make_error(Category::Geometry, "E_EMPTY",
                           "There is no finished " + std::string(to_string(input.type)) + " to export yet"));
  }
  Progress progress;
  Context context{progress};
  const OperationResult made = run(*studio.registry().find(operation.id), {{input.name, value}}, {}, context);
  write_to(path, write_attribute_network(made.outputs.at(main_output(operation)->name).get<AttributeNetwork>()));
  return made.warnings;
}

std::shared_ptr<const Brep> exact_solid(const Studio& studio) {
  const WorkObject* object = studio.active();
  if (object == nullptr || !object->result || object->result->failed || object->result->stale) return nullptr;
  if (object->result->quality != Quality::Final) return nullptr;
  for (const auto& [name, value] : object->result->outputs) {
    const auto solid = value.as<Brep>();
    if (!solid || solid->faces.empty()) continue;
    return value.transformed(object->placement.map()).as<Brep>();
  }
  return nullptr;
}

void export_step(const Studio& studio, const QString& path, StepExport& writer) {
  const std::shared_ptr<const Brep> solid = exact_solid(studio);
  if (!solid) {
    throw Error(make_error(Category::Geometry, "E_EMPTY",
                           "There is no finished solid of a drawing in perspective to export yet"));
  }
  StepOptions options;
  options.name = QFileInfo(path).completeBaseName().toStdString();
  const NodeId first = studio.active()->chain.front();
  const auto sheet = source_of<PerspectiveDrawing>(studio.session().document().find(first));
  if (sheet) options.unit = length_unit_named(sheet->unit).value_or(LengthUnit::Millimetre);
  writer.start(solid, options, path);
}

void export_drawing(const Studio& studio, const QString& path) {
  const Document& document = studio.session().document();
  const auto sheet = source_of<PerspectiveDrawing>(document.find(studio.sheet_node()));
  const auto network = source_of<AttributeNetwork>(document.find(studio.network_node()));
  write_to(path, network ? write_attribute_network(*network)
                 : sheet ? write_perspective_svg(*sheet)
                         : write_svg_drawing(studio.drawing()));
}

void StepExport::start(std::shared_ptr<const Brep> solid, const StepOptions& options, const QString& path) {
  if (busy()) return;
  const auto work = [solid = std::move(solid), options, path](Progress& progress) {
    write_to(path, write_step(*solid, options, progress).bytes);
  };
  const auto take = [this, path](bool done, const Findings& findings) {
    if (done)
      emit finished(path);
    else
      emit failed(findings);
  };
  begin(work, take, "The solid doesn't fit into this machine's memory.");
}

}  // namespace croquis::app
