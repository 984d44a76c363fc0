// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/patch_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/render/mesh_item.h"
#include "croquis/render/value_color.h"

namespace croquis::app {
namespace {

constexpr double crease_cosine = 0.5;  // as render::MeshItemOptions has it
const render::Color preview_color(96, 160, 235, 255);
const render::Color labelled_color(198, 219, 214, 255);

/// Its length is twice the face's area.
Vec3 face_normal(const PolyMesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  Vec3 normal = Vec3::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const Vec3& first = mesh.positions[corners[0]];
    normal += (mesh.positions[corners[k - 1]] - first).cross(mesh.positions[corners[k]] - first);
  }
  return normal;
}

/// Puts a part of a mesh together.
class Part {
 public:
  explicit Part(const PolyMesh& whole) : whole_(whole), place_(whole.vertex_count(), no_index) {}

  void add_face(std::size_t face) {
    const auto corners = whole_.face(face);
    std::vector<Index> own;
    for (const Index vertex : corners) own.push_back(own_vertex(vertex));
    mesh_.add_face(own);
  }

  PolyMesh take(const std::vector<std::int32_t>& ids) {
    for (const AttributeChannel& channel : whole_.channels) {
      if (channel.domain == Domain::Vertex && (channel.name == "color" || channel.name == "confidence")) copy(channel);
    }
    add_normals(ids);
    return std::move(mesh_);
  }

 private:
  Index own_vertex(Index vertex) {
    Index& place = place_[vertex];
    if (place == no_index) {
      place = static_cast<Index>(mesh_.positions.size());
      mesh_.positions.push_back(whole_.positions[vertex]);
      from_.push_back(vertex);
    }
    return place;
  }

  void copy(const AttributeChannel& channel) {
    AttributeChannel part = channel;
    const auto width = static_cast<std::size_t>(channel.width);
    std::visit(
        [&](auto& values) {
          const auto all = std::move(values);
          values.clear();
          for (const Index vertex : from_) {
            for (std::size_t k = 0; k < width; ++k) values.push_back(all[vertex * width + k]);
          }
        },
        part.data);
    mesh_.channels.push_back(std::move(part));
  }

  void add_normals(const std::vector<std::int32_t>& ids) {
    std::vector<Vec3> own(from_.size(), Vec3::Zero());
    std::vector<Vec3> around(from_.size(), Vec3::Zero());
    for (std::size_t face = 0; face < mesh_.face_count(); ++face) {
      const Vec3 normal = face_normal(mesh_, face);
      for (const Index vertex : mesh_.face(face)) own[vertex] += normal;
    }
    for (std::size_t face = 0; face < whole_.face_count(); ++face) {
      if (ids[face] >= 0) continue;
      const auto corners = whole_.face(face);
      if (std::none_of(corners.begin(), corners.end(), [&](Index v) { return place_[v] != no_index; })) continue;
      const Vec3 normal = face_normal(whole_, face);
      for (const Index vertex : corners) {
        if (place_[vertex] != no_index) around[place_[vertex]] += normal;
      }
    }
    AttributeChannel channel{"normal", Domain::Vertex, 3, std::vector<float>(), {}};
    auto& values = std::get<std::vector<float>>(channel.data);
    for (std::size_t v = 0; v < own.size(); ++v) {
      // A cap that meets the rim at an angle keeps its own light.
      const bool smooth = around[v].dot(own[v]) > crease_cosine * around[v].norm() * own[v].norm();
      const Vec3 normal = (smooth ? around[v] : own[v]).normalized();
      for (const double value : {normal.x(), normal.y(), normal.z()}) values.push_back(static_cast<float>(value));
    }
    mesh_.channels.push_back(std::move(channel));
  }

  const PolyMesh& whole_;
  PolyMesh mesh_;
  std::vector<Index> place_;  ///< of the whole's vertices in the part
  std::vector<Index> from_;
};

/// None for faces that aren't of patches: they are drawn as without this channel.
AttributeChannel face_colors_by_id(const std::vector<std::int32_t>& ids) {
  AttributeChannel channel{"color", Domain::Face, 3, std::vector<float>(), {}};
  auto& values = std::get<std::vector<float>>(channel.data);
  values.reserve(3 * ids.size());
  for (const std::int32_t id : ids) {
    for (const std::uint8_t level : {labelled_color.r, labelled_color.g, labelled_color.b}) {
      values.push_back(id < 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(level) / 255.0F);
    }
  }
  return channel;
}

void paint(PolyMesh& mesh, PatchLook look) {
  if (look == PatchLook::Preview) std::erase_if(mesh.channels, [](const auto& c) { return c.name == "color"; });
  if (mesh.channel("color", Domain::Vertex) != nullptr) return;
  const render::Color color = look == PatchLook::Preview    ? preview_color
                              : look == PatchLook::Distinct ? labelled_color
                                                            : render::palette_color(0);
  AttributeChannel channel{"color", Domain::Vertex, 3, std::vector<std::uint8_t>(), {}};
  auto& values = std::get<std::vector<std::uint8_t>>(channel.data);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) values.insert(values.end(), {color.r, color.g, color.b});
  mesh.channels.push_back(std::move(channel));
}

}  // namespace

const std::vector<std::int32_t>* patch_ids(const PolyMesh& mesh) {
  const AttributeChannel* channel = mesh.channel("patch_id", Domain::Face);
  return channel == nullptr ? nullptr : std::get_if<std::vector<std::int32_t>>(&channel->data);
}

bool begins_with(const PolyMesh& filled, const PolyMesh& scan) {
  return filled.face_count() >= scan.face_count() && filled.vertex_count() >= scan.vertex_count() &&
         std::equal(scan.face_offsets.begin(), scan.face_offsets.end(), filled.face_offsets.begin()) &&
         std::equal(scan.corners.begin(), scan.corners.end(), filled.corners.begin()) &&
         std::equal(scan.positions.begin(), scan.positions.end(), filled.positions.begin());
}

PatchSurface patches_of(const PolyMesh& filled, const PolyMesh* scan, const std::set<Index>* wanted) {
  PatchSurface patches;
  const std::vector<std::int32_t>* ids = patch_ids(filled);
  if (ids == nullptr) return patches;
  Part part(filled);
  std::size_t patch_faces = 0;
  for (std::size_t face = 0; face < ids->size(); ++face) {
    const std::int32_t id = (*ids)[face];
    if (id < 0) continue;
    ++patch_faces;
    if (wanted != nullptr && !wanted->contains(static_cast<Index>(id))) continue;
    part.add_face(face);
    patches.patch.push_back(id);
  }
  patches.mesh = std::make_shared<const PolyMesh>(part.take(*ids));
  patches.completes = scan != nullptr && wanted == nullptr && filled.face_count() == scan->face_count() + patch_faces &&
                      begins_with(filled, *scan);
  return patches;
}

std::shared_ptr<const PolyMesh> colored(const PatchSurface& patches, PatchLook look) {
  if (!patches.mesh || patches.mesh->face_count() == 0) return nullptr;
  auto mesh = std::make_shared<PolyMesh>(*patches.mesh);
  paint(*mesh, look);
  if (look != PatchLook::Confidence) return mesh;
  return std::make_shared<const PolyMesh>(render::with_value_colors(*mesh));
}

std::shared_ptr<const PolyMesh> colored_whole(const std::shared_ptr<const PolyMesh>& filled, PatchLook look) {
  const std::vector<std::int32_t>* ids = patch_ids(*filled);
  if (ids == nullptr || look == PatchLook::Plain) return filled;
  if (look == PatchLook::Confidence) return std::make_shared<const PolyMesh>(render::with_value_colors(*filled));
  const bool has_own =
      std::ranges::any_of(filled->channels, [](const AttributeChannel& channel) { return channel.name == "color"; });
  if (has_own) return filled;
  auto mesh = std::make_shared<PolyMesh>(*filled);
  mesh->channels.push_back(face_colors_by_id(*ids));
  return mesh;
}

}  // namespace croquis::app
