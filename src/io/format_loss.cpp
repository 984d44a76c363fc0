// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/format_loss.h"

#include <algorithm>
#include <utility>

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

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

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
  note("tags (" + counted(tags.creases.size(), "sharp edge") + " and " + counted(tags.pins.size(), "pin") + ")");
}

void FormatLoss::note_sets(const MeshTags& tags) {
  if (tags.sets.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < tags.sets.size() && i < named_sets; ++i) {
    names += (i == 0 ? "" : ", ") + in_quotes(tags.sets[i].name);
  }
  note(counted(tags.sets.size(), "set") + " of tags (" + names + (tags.sets.size() > named_sets ? ", ..." : "") +
       "; the tags are kept)");
}

Findings FormatLoss::warnings() const {
  if (parts_.empty()) return {};
  std::string sentence = format_ + " can't hold ";
  for (std::size_t i = 0; i < parts_.size(); ++i)
    sentence += (i == 0 ? "" : i + 1 < parts_.size() ? ", " : " and ") + parts_[i];
  return {make_warning(Category::Io, "W_FORMAT_LOSS", sentence + ".")};
}

}  // namespace croquis
