// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/format_loss.h"

#include <algorithm>

#include "io/text.h"

namespace croquis {
namespace {

const char* name_of(Domain domain) {
  switch (domain) {
    case Domain::Vertex: return "vertices";
    case Domain::Face: return "faces";
    case Domain::Corner: return "corners";
    case Domain::Line: return "polylines";
  }
  return "";
}

}  // namespace

void FormatLoss::note_channel(const AttributeChannel& channel) {
  note("the attribute " + quoted(channel.name) + " of " + name_of(channel.domain));
}

void FormatLoss::note_others(const PolyMesh& mesh, const std::vector<const AttributeChannel*>& written) {
  for (const AttributeChannel& channel : mesh.channels) {
    if (std::find(written.begin(), written.end(), &channel) == written.end()) note_channel(channel);
  }
}

Findings FormatLoss::warnings() const {
  if (parts_.empty()) return {};
  std::string sentence = format_ + " can't hold all of this mesh: ";
  for (std::size_t i = 0; i < parts_.size(); ++i) sentence += (i == 0 ? "" : "; ") + parts_[i];
  return {make_warning(Category::Io, "W_FORMAT_LOSS", sentence + ".")};
}

}  // namespace croquis
