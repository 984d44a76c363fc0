// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/poly_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>

#include "croquis/base/limits.h"

namespace croquis {
namespace {

/// Findings of one code listed one by one; more would hide the others.
constexpr std::size_t max_listed = 100;

/// Collects findings; of each code the first `max_listed` are kept, and the last of these gives the number of
/// the others.
class Collector {
 public:
  /// @param sentence makes the sentence without its full stop; called for the listed ones only
  void add(const char* code, SubjectKind kind, std::size_t id, const std::function<std::string()>& sentence) {
    std::size_t& count = counts_[code];
    if (++count > max_listed) return;
    findings_.push_back(make_error(Category::Malformed, code, sentence(), {numbered_subject(kind, id)}));
    if (count == max_listed) last_listed_[code] = findings_.size() - 1;
  }

  Findings take() {
    for (const auto& [code, last] : last_listed_) {
      const std::size_t more = counts_[code] - max_listed;
      if (more > 0) findings_[last].message += "; " + std::to_string(more) + " more are like it";
    }
    for (Finding& finding : findings_) finding.message += ".";
    return std::move(findings_);
  }

 private:
  std::map<std::string, std::size_t> counts_;
  std::map<std::string, std::size_t> last_listed_;
  Findings findings_;
};

/// What `face_offsets` with `corners` and `line_offsets` with `line_vertices` have in common.
struct IndexLists {
  const char* element;  ///< "Face"
  SubjectKind kind;
  const std::vector<Index>& offsets;
  const std::vector<Index>& vertices;
};

/// @return whether the offsets cut the vertices into lists
bool check_offsets(const IndexLists& lists, Collector& collector) {
  const std::string name = std::string(lists.element) + " offsets";
  if (lists.offsets.empty() || lists.offsets.front() != 0) {
    collector.add("E_INDEX", lists.kind, 0, [&] { return name + " don't begin with 0"; });
    return false;
  }
  for (std::size_t i = 1; i < lists.offsets.size(); ++i) {
    if (lists.offsets[i] >= lists.offsets[i - 1]) continue;
    collector.add("E_INDEX", lists.kind, i - 1, [&] { return name + " descend at number " + std::to_string(i); });
    return false;
  }
  if (lists.offsets.back() == lists.vertices.size()) return true;
  collector.add("E_INDEX", lists.kind, lists.offsets.size() - 1, [&] {
    return name + " end at " + std::to_string(lists.offsets.back()) + " but " + std::to_string(lists.vertices.size()) +
           " vertex indices are given";
  });
  return false;
}

void check_indices(const IndexLists& lists, std::size_t vertex_count, Collector& collector) {
  for (std::size_t i = 0; i + 1 < lists.offsets.size(); ++i) {
    for (std::size_t k = lists.offsets[i]; k < lists.offsets[i + 1]; ++k) {
      if (lists.vertices[k] < vertex_count) continue;
      collector.add("E_INDEX", lists.kind, i, [&] {
        return std::string(lists.element) + " " + std::to_string(i) + " uses vertex " +
               std::to_string(lists.vertices[k]) + " of a mesh with " + std::to_string(vertex_count) + " vertices";
      });
    }
  }
}

void check_positions(const PolyMesh& mesh, Collector& collector) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (are_usable_numbers(mesh.positions[v])) continue;
    collector.add("E_NOT_FINITE", SubjectKind::Vertex, v,
                  [&] { return "Vertex " + std::to_string(v) + " has a coordinate that " + unusable_words; });
  }
}

void check_faces(const PolyMesh& mesh, Collector& collector) {
  std::vector<Index> sorted;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() == 3 && face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) continue;
    sorted.assign(face.begin(), face.end());
    std::sort(sorted.begin(), sorted.end());
    const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
    if (face.size() < 3) {
      collector.add("E_FACE_DEGENERATE", SubjectKind::Face, f,
                    [&] { return "Face " + std::to_string(f) + " has fewer than 3 corners"; });
    } else if (repeated != sorted.end()) {
      collector.add("E_FACE_DEGENERATE", SubjectKind::Face, f, [&] {
        return "Face " + std::to_string(f) + " uses vertex " + std::to_string(*repeated) + " more than once";
      });
    }
  }
}

void check_channels(const PolyMesh& mesh, Collector& collector) {
  for (std::size_t i = 0; i < mesh.channels.size(); ++i) {
    const AttributeChannel& channel = mesh.channels[i];
    const std::size_t width = static_cast<std::size_t>(std::max(channel.width, 0));
    const std::size_t expected = mesh.element_count(channel.domain) * width;
    if (width > 0 && channel.size() == expected) continue;
    collector.add("E_COUNT", SubjectKind::Parameter, i, [&] {
      return "Attribute '" + channel.name + "' has " + std::to_string(channel.size()) + " values of width " +
             std::to_string(channel.width) + " instead of " + std::to_string(expected);
    });
  }
}

/// Distinct pairs of different vertices that follow one another in a face. Also of a mesh that isn't usable: offsets
/// beyond the corners are cut off there.
std::size_t count_edges(const PolyMesh& mesh) {
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(mesh.corners.size());
  for (std::size_t f = 0; f + 1 < mesh.face_offsets.size(); ++f) {
    const std::size_t end = std::min<std::size_t>(mesh.face_offsets[f + 1], mesh.corners.size());
    for (std::size_t c = mesh.face_offsets[f]; c < end; ++c) {
      const Index a = mesh.corners[c];
      const Index b = mesh.corners[c + 1 == end ? mesh.face_offsets[f] : c + 1];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  return static_cast<std::size_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

}  // namespace

std::size_t AttributeChannel::size() const {
  return std::visit([](const auto& values) { return values.size(); }, data);
}

void PolyMesh::add_face(std::span<const Index> vertices) {
  corners.insert(corners.end(), vertices.begin(), vertices.end());
  face_offsets.push_back(static_cast<Index>(corners.size()));
}

void PolyMesh::add_triangle(Index a, Index b, Index c) { add_face(std::array{a, b, c}); }

void PolyMesh::add_line(std::span<const Index> vertices) {
  line_vertices.insert(line_vertices.end(), vertices.begin(), vertices.end());
  line_offsets.push_back(static_cast<Index>(line_vertices.size()));
}

std::size_t PolyMesh::element_count(Domain domain) const {
  switch (domain) {
    case Domain::Vertex: return vertex_count();
    case Domain::Face: return face_count();
    case Domain::Corner: return corners.size();
    case Domain::Line: return line_count();
    case Domain::Edge: return count_edges(*this);
  }
  return 0;
}

bool PolyMesh::has_edge_channels() const {
  return std::any_of(channels.begin(), channels.end(),
                     [](const AttributeChannel& channel) { return channel.domain == Domain::Edge; });
}

const AttributeChannel* PolyMesh::channel(std::string_view name, Domain domain) const {
  for (const AttributeChannel& candidate : channels) {
    if (candidate.name == name && candidate.domain == domain) return &candidate;
  }
  return nullptr;
}

AttributeChannel* PolyMesh::channel(std::string_view name, Domain domain) {
  return const_cast<AttributeChannel*>(static_cast<const PolyMesh*>(this)->channel(name, domain));
}

Findings validate(const PolyMesh& mesh) {
  Collector collector;
  const IndexLists faces{"Face", SubjectKind::Face, mesh.face_offsets, mesh.corners};
  const IndexLists lines{"Line", SubjectKind::Line, mesh.line_offsets, mesh.line_vertices};
  check_positions(mesh, collector);
  if (check_offsets(faces, collector)) {
    check_indices(faces, mesh.vertex_count(), collector);
    check_faces(mesh, collector);
  }
  if (check_offsets(lines, collector)) check_indices(lines, mesh.vertex_count(), collector);
  // Without offsets there is no number of elements to compare with.
  if (!mesh.face_offsets.empty() && !mesh.line_offsets.empty()) check_channels(mesh, collector);
  return collector.take();
}

}  // namespace croquis
