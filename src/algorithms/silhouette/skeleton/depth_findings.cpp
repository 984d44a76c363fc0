// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/depth_findings.h"

#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// The stroke of a node's object that has a sample nearest to a place.
Index nearest_stroke(const SkeletonNode& node, const LabelledFigure& figure, const Drawing& drawing, const Vec2& at) {
  Index nearest = no_index;
  double least = std::numeric_limits<double>::infinity();
  for (const Index stroke : figure.objects[node.object].strokes) {
    for (const StrokeSample& sample : drawing.strokes[stroke].samples) {
      const double distance = (sample.position - at).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = stroke;
    }
  }
  return nearest;
}

/// The strokes at both ends of a node's chord, at the node's place.
std::vector<Subject> chord_subjects(const SkeletonNode& node, const LabelledFigure& figure, const Drawing& drawing) {
  std::set<Index> strokes;
  for (const Vec2& end : node.chord) strokes.insert(nearest_stroke(node, figure, drawing, end));
  strokes.erase(no_index);
  std::vector<Subject> subjects;
  for (const Index stroke : strokes) subjects.push_back(stroke_subject(drawing, stroke, node.position));
  return subjects;
}

/// The worst pair of every place: pairs that share a node, or whose nodes are neighbours, are one place.
std::vector<DepthCollision> worst_by_place(const DepthResult& result, const Skeleton& skeleton) {
  std::vector<bool> involved(skeleton.nodes.size(), false);
  DisjointSets places(skeleton.nodes.size());
  for (const DepthCollision& collision : result.collisions) {
    involved[collision.upper] = involved[collision.lower] = true;
    places.unite(collision.upper, collision.lower);
  }
  for (const auto& [i, k] : skeleton.edges) {
    if (involved[i] && involved[k]) places.unite(i, k);
  }
  std::vector<DepthCollision> worst(skeleton.nodes.size());
  for (const DepthCollision& collision : result.collisions) {
    DepthCollision& place = worst[places.root(collision.upper)];
    if (collision.shortfall > place.shortfall) place = collision;
  }
  std::erase_if(worst, [](const DepthCollision& collision) { return collision.shortfall == 0; });
  return worst;
}

}  // namespace

Findings depth_findings(const DepthResult& result, const Skeleton& skeleton, const LabelledFigure& figure,
                        const Drawing& drawing) {
  Findings findings;
  for (const DepthCollision& collision : worst_by_place(result, skeleton)) {
    const SkeletonNode& upper = skeleton.nodes[collision.upper];
    const SkeletonNode& lower = skeleton.nodes[collision.lower];
    std::vector<Subject> subjects = chord_subjects(upper, figure, drawing);
    for (Subject& subject : chord_subjects(lower, figure, drawing)) subjects.push_back(std::move(subject));
    findings.push_back(make_warning(Category::Geometry, "W_COLLISION",
                                    "Two parts that lie over one another are nearer than the minimum gap: draw them "
                                    "thinner, further apart, or reduce the minimum gap",
                                    std::move(subjects)));
  }
  return findings;
}

}  // namespace croquis::silhouette
