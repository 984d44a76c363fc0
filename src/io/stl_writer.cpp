// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/stl_writer.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "croquis/base/error.h"
#include "croquis/geometry/polygon_cut.h"
#include "io/channel_values.h"
#include "io/float_positions.h"
#include "io/format_loss.h"
#include "io/position_joiner.h"
#include "io/text.h"
#include "io/tick.h"
#include "io/value_sink.h"

namespace croquis {
namespace {

constexpr std::size_t title_size = 80;

class StlWriter {
 public:
  StlWriter(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress)
      : mesh_(mesh),
        options_(options),
        tick_(progress),
        positions_(options.ascii ? as_written(mesh, MeshFormat::Stl, options).positions
                                 : positions_as_floats(mesh, MeshFormat::Stl)),
        cut_(mesh_triangles(positions_, mesh)) {}

  MeshWriteResult write() {
    names_ = usable_channel(mesh_, "object", Domain::Face, 1, 1);
    attributes_ = usable_channel(mesh_, "attribute", Domain::Face, 1, 1);
    if (attributes_ != nullptr && !std::holds_alternative<std::vector<std::uint16_t>>(attributes_->data)) {
      attributes_ = nullptr;
    }
    options_.ascii ? write_text() : write_binary();
    note_losses();
    return {std::move(text_), loss_.warnings()};
  }

 private:
  const Vec3& place(Index corner) const { return positions_[mesh_.corners[corner]]; }
  Vec3 normal(const std::array<Index, 3>& corners) const;
  void write_binary();
  void write_text();
  void write_facet(const std::array<Index, 3>& corners);
  std::string solid_name(std::size_t face) const;
  bool reads_back_in_order() const;
  void note_losses();

  const PolyMesh& mesh_;
  const MeshWriteOptions& options_;
  WriteTick tick_;
  std::vector<Vec3> positions_;
  MeshTriangles cut_;
  const AttributeChannel* names_ = nullptr;
  const AttributeChannel* attributes_ = nullptr;
  FormatLoss loss_{"STL"};
  std::string text_;
};

Vec3 StlWriter::normal(const std::array<Index, 3>& corners) const {
  const Vec3& a = place(corners[0]);
  const Vec3 normal = (place(corners[1]) - a).cross(place(corners[2]) - a).normalized();
  return normal.allFinite() ? normal : Vec3::Zero();
}

void StlWriter::write_binary() {
  ValueSink sink(false, 0);
  sink.text().reserve(title_size + 4 + 50 * cut_.corners.size());
  sink.text().assign("Binary STL, written by Croquis").resize(title_size, ' ');
  sink.put(static_cast<std::uint32_t>(cut_.corners.size()));
  const auto put_point = [&](const Vec3& point) {
    for (const double x : point) sink.put(static_cast<float>(x));
  };
  for (std::size_t t = 0; t < cut_.corners.size(); ++t) {
    tick_();
    put_point(normal(cut_.corners[t]));
    for (const Index corner : cut_.corners[t]) put_point(place(corner));
    const double attribute = attributes_ == nullptr ? 0 : value_of(*attributes_, cut_.faces[t]);
    sink.put(static_cast<std::uint16_t>(attribute));
  }
  text_ = std::move(sink.text());
}

std::string StlWriter::solid_name(std::size_t face) const {
  if (names_ == nullptr) return "solid";
  std::string name = label_of(*names_, face);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '_');
  name = trimmed(name);
  return name.empty() ? "solid" : "solid " + name;
}

void StlWriter::write_text() {
  std::string open;
  for (std::size_t t = 0; t < cut_.corners.size(); ++t) {
    tick_();
    const std::string name = solid_name(cut_.faces[t]);
    if (name != open) {
      if (!open.empty()) text_ += "end" + open + "\n";
      text_ += name + "\n";
      open = name;
    }
    write_facet(cut_.corners[t]);
  }
  text_ += open.empty() ? "solid\nendsolid\n" : "end" + open + "\n";
}

void StlWriter::write_facet(const std::array<Index, 3>& corners) {
  const Vec3 direction = normal(corners);
  text_ += "facet normal";
  for (const double x : direction) append_number(text_ += ' ', static_cast<float>(x), options_.precision);
  text_ += "\n outer loop\n";
  for (const Index corner : corners) {
    text_ += "  vertex";
    for (const double x : place(corner)) append_number(text_ += ' ', x, options_.precision);
    text_ += '\n';
  }
  text_ += " endloop\nendfacet\n";
}

// A reader numbers vertices by their first use and joins those at one place.
bool StlWriter::reads_back_in_order() const {
  PositionJoiner joiner;
  std::vector<Vec3> read;
  for (const auto& triangle : cut_.corners) {
    for (const Index corner : triangle) {
      if (joiner.add(place(corner), read) != mesh_.corners[corner]) return false;
    }
  }
  return read.size() == mesh_.vertex_count();
}

void StlWriter::note_losses() {
  loss_.note_polygons(mesh_);
  if (mesh_.line_count() > 0) loss_.note("polylines");
  if (!reads_back_in_order()) loss_.note("the order of vertices");
  loss_.note_tags(mesh_.tags);
  loss_.note_others(mesh_, {options_.ascii ? names_ : attributes_});
}

}  // namespace

MeshWriteResult write_stl(const PolyMesh& mesh, const MeshWriteOptions& options, Progress& progress) {
  if (mesh.face_count() == 0) {
    throw Error(make_error(Category::Geometry, "E_NO_FACES",
                           "The mesh has no faces, and STL holds nothing else: write it as PLY or OBJ"));
  }
  return StlWriter(mesh, options, progress).write();
}

}  // namespace croquis
