// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_writing.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "io/text.h"

namespace croquis {
namespace {

const char* name_of(Domain domain) {
  switch (domain) {
    case Domain::Vertex: return "vertices";
    case Domain::Face: return "faces";
    case Domain::Corner: return "corners";
    case Domain::Line: return "polylines";
    case Domain::Edge: return "edges";
  }
  return "";
}

constexpr std::size_t named_sets = 10;

}  // namespace

void FormatLoss::note_channel(const AttributeChannel& channel) {
  for (const auto& [name, words] : {std::pair{"normal", "normals"},
                                    {"color", "colours"},
                                    {"uv", "places in textures"},
                                    {"object", "names of objects"},
                                    {"group", "groups"},
                                    {"material", "materials"}}) {
    if (channel.name == name && channel.domain != Domain::Edge) return note(words);
  }
  note("the attribute " + in_quotes(channel.name) + " of " + name_of(channel.domain));
}

void FormatLoss::note_others(const PolyMesh& mesh, const std::vector<const AttributeChannel*>& written) {
  for (const AttributeChannel& channel : mesh.channels) {
    if (std::find(written.begin(), written.end(), &channel) == written.end()) note_channel(channel);
  }
}

void FormatLoss::note_polygons(const PolyMesh& mesh) {
  if (mesh.corners.size() > 3 * mesh.face_count()) note("polygons (they are cut into triangles)");
}

void FormatLoss::note_tags(const MeshTags& tags) {
  if (tags.empty()) return;
  note("tags (" + counted(tags.creases.size(), "sharp edge", "sharp edges") + " and " +
       counted(tags.pins.size(), "pin", "pins") + ")");
}

void FormatLoss::note_sets(const MeshTags& tags) {
  if (tags.sets.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < tags.sets.size() && i < named_sets; ++i) {
    names += (i == 0 ? "" : ", ") + in_quotes(tags.sets[i].name);
  }
  note(counted(tags.sets.size(), "set", "sets") + " of tags (" + names +
       (tags.sets.size() > named_sets ? ", ..." : "") + "; the tags are kept)");
}

Findings FormatLoss::warnings() const {
  if (parts_.empty()) return {};
  std::string sentence = format_ + " can't hold ";
  for (std::size_t i = 0; i < parts_.size(); ++i)
    sentence += (i == 0 ? "" : i + 1 < parts_.size() ? ", " : " and ") + parts_[i];
  return {make_warning(Category::Io, "W_FORMAT_LOSS", sentence + ".")};
}

// One by one: Eigen 3.4 leaves doubles unrounded in cast<float>().cast<double>() where it works on packets.
Vec3 as_floats(const Vec3& point) {
  Vec3 rounded;
  for (int k = 0; k < 3; ++k) rounded[k] = static_cast<double>(static_cast<float>(point[k]));
  return rounded;
}

bool positions_are_floats(const PolyMesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3& p) { return as_floats(p) == p; });
}

std::vector<Vec3> positions_as_floats(const PolyMesh& mesh, MeshFormat format) {
  std::vector<Vec3> positions = mesh.positions;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    positions[v] = as_floats(positions[v]);
    if (positions[v].allFinite()) continue;
    throw Error(make_error(Category::Geometry, "E_OUT_OF_RANGE",
                           "Vertex " + std::to_string(v) + " is too far out for the 32-bit numbers of " +
                               to_string(format) + "; scale the model down or write another format.",
                           {numbered_subject(SubjectKind::Vertex, v)}));
  }
  return positions;
}

}  // namespace croquis
