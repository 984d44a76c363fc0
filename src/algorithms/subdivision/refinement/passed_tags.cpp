// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/passed_tags.h"

#include <algorithm>

namespace croquis::subdivision {
namespace {

class TagPasser {
 public:
  TagPasser(const Neighbourhood& near, const EdgeMatching& matching, Level& next)
      : near_(near), matching_(matching), next_(next) {}

  void run() {
    for (Index line = 0; line < near_.classes.lines.size(); ++line) pass_line(line);
    for (const Sector& sector : near_.sectors.list) pass_chord(sector);
    std::sort(next_.sharp.begin(), next_.sharp.end(),
              [](const SharpEdge& a, const SharpEdge& b) { return a.edge < b.edge; });
    for (const Index vertex : near_.classes.special) pass_vertex(vertex);
    std::sort(next_.pins.begin(), next_.pins.end());
    std::sort(next_.settled.begin(), next_.settled.end());
    std::sort(next_.valence_two.begin(), next_.valence_two.end());
  }

 private:
  void tag(Index a, Index b, double sharpness) {
    if (sharpness > 0) next_.sharp.push_back({matching_.edge_between(a, b), sharpness});
  }

  void pass_line(Index line) {
    const SharpLine& sharp = near_.classes.lines[line];
    if (sharp.on_boundary()) return;
    tag(near_.points.chain(line, 0), near_.points.chain(line, 1), sharp.sharpness - 1);
    for (std::size_t end = 0; end < 2; ++end) {
      const Index kept = near_.points.kept(sharp.vertices[end]), point = near_.points.chain(line, end);
      if (kept != no_index && kept != point) tag(kept, point, sharp.sharpness - 1);
    }
  }

  /// Where a chain passes a vertex, its two sectors have the same chord: taken from the first.
  void pass_chord(const Sector& sector) {
    if (near_.classes.class_of[sector.vertex] != VertexClass::Crease || sector.first_line > sector.last_line) return;
    const SharpLine &first = near_.classes.lines[sector.first_line], &last = near_.classes.lines[sector.last_line];
    if (first.on_boundary() || last.on_boundary()) return;
    tag(near_.points.chain_at(near_.classes, sector.first_line, sector.vertex),
        near_.points.chain_at(near_.classes, sector.last_line, sector.vertex),
        std::min(first.sharpness, last.sharpness) - 1);
  }

  void pass_vertex(Index vertex) {
    const bool pinned = near_.classes.pinned[vertex] != 0;
    if (near_.classes.class_of[vertex] == VertexClass::Corner) {
      const Index kept = near_.points.kept(vertex);
      if (pinned) next_.pins.push_back(kept);
      next_.settled.push_back(kept);
      if (has_two_faces(vertex)) next_.valence_two.push_back(kept);
    } else if (pinned && near_.classes.class_of[vertex] == VertexClass::Dart) {
      next_.pins.push_back(chain_end(vertex));
    }
  }

  /// An inner corner with two faces has two sectors, and keeps two faces; once its edges are smooth that matters.
  bool has_two_faces(Index vertex) const {
    return std::binary_search(near_.level.valence_two.begin(), near_.level.valence_two.end(), vertex);
  }

  Index chain_end(Index vertex) const {
    const auto sector = std::lower_bound(near_.sectors.list.begin(), near_.sectors.list.end(), vertex,
                                         [](const Sector& s, Index value) { return s.vertex < value; });
    return near_.points.chain_at(near_.classes, sector->first_line, vertex);
  }

  const Neighbourhood& near_;
  const EdgeMatching& matching_;
  Level& next_;
};

}  // namespace

void pass_tags(const Neighbourhood& near, const EdgeMatching& matching, Level& next) {
  TagPasser(near, matching, next).run();
}

}  // namespace croquis::subdivision
