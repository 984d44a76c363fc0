// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <Eigen/Geometry>

#include "croquis/base/error.h"
#include "croquis/geometry/polygon_cut.h"
#include "io/channel_values.h"
#include "io/mesh_formats.h"
#include "io/mesh_writing.h"
#include "io/position_joiner.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr std::size_t title_size = 80;

/// The triangles of the file.
struct StlFacets {
  const PolyMesh& mesh;
  std::vector<Vec3> positions;
  MeshTriangles cut;

  std::size_t size() const { return cut.corners.size(); }
  const Vec3& place(std::size_t facet, std::size_t corner) const {
    return positions[mesh.corners[cut.corners[facet][corner]]];
  }

  /// By the right-hand rule; zero where there is none.
  Vec3 normal(std::size_t facet) const {
    const Vec3& a = place(facet, 0);
    const Vec3 normal = (place(facet, 1) - a).cross(place(facet, 2) - a).normalized();
    return normal.allFinite() ? normal : Vec3::Zero();
  }
};

std::string binary_stl(const StlFacets& facets, const AttributeChannel* attributes, WriteTick& tick) {
  ValueSink sink(false, 0);
  sink.text().reserve(title_size + 4 + 50 * facets.size());
  sink.text().assign("Binary STL, written by Croquis").resize(title_size, ' ');
  sink.put(static_cast<std::uint32_t>(facets.size()));
  const auto put_point = [&](const Vec3& point) {
    for (const double x : point) sink.put(static_cast<float>(x));
  };
  for (std::size_t t = 0; t < facets.size(); ++t) {
    tick();
    put_point(facets.normal(t));
    for (std::size_t k = 0; k < 3; ++k) put_point(facets.place(t, k));
    sink.put(static_cast<std::uint16_t>(attributes == nullptr ? 0 : value_of(*attributes, facets.cut.faces[t])));
  }
  return std::move(sink.text());
}

std::string solid_name(const AttributeChannel* names, std::size_t face) {
  if (names == nullptr) return "solid";
  std::string name = label_of(*names, face);
  std::ranges::replace_if(
      name, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '_');
  name = trimmed(name);
  return name.empty() ? "solid" : "solid " + name;
}

std::string text_stl(const StlFacets& facets, const AttributeChannel* names, int precision, WriteTick& tick) {
  std::string text, open;
  for (std::size_t t = 0; t < facets.size(); ++t) {
    tick();
    const std::string name = solid_name(names, facets.cut.faces[t]);
    if (name != open) {
      if (!open.empty()) text += "end" + open + "\n";
      text += name + "\n";
      open = name;
    }
    text += "facet normal";
    for (const double x : facets.normal(t)) append_number(text += ' ', static_cast<float>(x), precision);
    text += "\n outer loop\n";
    for (std::size_t k = 0; k < 3; ++k) {
      text += "  vertex";
      for (const double x : facets.place(t, k)) append_number(text += ' ', x, precision);
      text += '\n';
    }
    text += " endloop\nendfacet\n";
  }
  return text + (open.empty() ? "solid\nendsolid\n" : "end" + open + "\n");
}

// A reader numbers vertices by their first use and joins those at one place.
bool reads_back_in_order(const StlFacets& facets) {
  PositionJoiner joiner;
  std::vector<Vec3> read;
  for (std::size_t t = 0; t < facets.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (joiner.add(facets.place(t, k), read) != facets.mesh.corners[facets.cut.corners[t][k]]) return false;
    }
  }
  return read.size() == facets.mesh.vertex_count();
}

}  // namespace

MeshWriteResult write_stl(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress) {
  if (mesh.face_count() == 0) {
    throw Error(make_error(Category::Geometry, "E_NO_FACES",
                           "The mesh has no faces, and STL holds nothing else: write it as PLY or OBJ"));
  }
  StlFacets facets{mesh, {}, {}};
  facets.positions =
      options.ascii ? as_written(mesh, MeshFormat::Stl, options).positions : positions_as_floats(mesh, MeshFormat::Stl);
  facets.cut = mesh_triangles(facets.positions, mesh);
  const AttributeChannel* names = usable_channel(mesh, "object", Domain::Face, 1, 1);
  const AttributeChannel* attributes = usable_channel(mesh, "attribute", Domain::Face, 1, 1);
  if (attributes != nullptr && !std::holds_alternative<std::vector<std::uint16_t>>(attributes->data))
    attributes = nullptr;
  WriteTick tick(progress);
  std::string bytes =
      options.ascii ? text_stl(facets, names, options.precision, tick) : binary_stl(facets, attributes, tick);
  FormatLoss loss("STL");
  loss.note_polygons(mesh);
  if (mesh.line_count() > 0) loss.note("polylines");
  if (!reads_back_in_order(facets)) loss.note("the order of vertices");
  loss.note_tags(mesh.tags);
  loss.note_others(mesh, {options.ascii ? names : attributes});
  return {std::move(bytes), loss.warnings()};
}

}  // namespace croquis
