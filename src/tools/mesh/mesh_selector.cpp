// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_selector.h"

#include <algorithm>
#include <set>
#include <utility>

#include "algorithms/mesh_editing/edge_walk.h"
#include "croquis/edits/edit_line.h"
#include "croquis/mesh_editing/tag_edit.h"

namespace croquis {
namespace {

using How = PickHow;

/// In the order of PickHow.
constexpr std::array how_names{"replace", "add",  "remove",    "toggle", "loop",
                               "ring",    "path", "connected", "chain",  "all"};

bool shares_row(std::span<const Index> row, Index element) {
  return std::find(row.begin(), row.end(), element) != row.end();
}

/// Rows through each of many edges; an edge that a row has already found needs no row of its own.
template <typename Row>
Elements rows_through(const Elements& edges, Row row) {
  std::set<Index> found;
  for (const Index edge : edges) {
    if (found.contains(edge)) continue;
    const Elements more = row(edge);
    found.insert(more.begin(), more.end());
  }
  return {found.begin(), found.end()};
}

}  // namespace

PickHow pick_how(const std::string& name) {
  const auto found = std::ranges::find(how_names, name);
  return found == how_names.end() ? How::Replace : static_cast<How>(found - how_names.begin());
}

MeshMode mode_of(ComponentKind kind) {
  if (kind == ComponentKind::Vertex) return MeshMode::Vertex;
  return kind == ComponentKind::Edge ? MeshMode::Edge : MeshMode::Face;
}

// ---- What is selected

ComponentKind MeshSelector::kind() const {
  if (mode_ == MeshMode::Vertex) return ComponentKind::Vertex;
  return mode_ == MeshMode::Face ? ComponentKind::Face : ComponentKind::Edge;
}

const Elements& MeshSelector::selected() const {
  static const Elements none;
  const ComponentSelection& selection = editable_.session().components();
  const bool own = mode_ != MeshMode::Object && selection.node == editable_.node() && selection.kind == kind();
  return own ? selection.elements : none;
}

const Elements& MeshSelector::selected_vertices() {
  static const Elements none;
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return none;
  const bool whole = mode_ == MeshMode::Object;
  const Selection& objects = editable_.session().selection();
  if (whole && !std::binary_search(objects.begin(), objects.end(), SelectedItem{editable_.node(), ""})) return none;
  const auto selection = editable_.session().shared_components();
  const bool known = vertices_connectivity_ == editable_.connectivity() && all_vertices_ == whole;
  if (known && (whole ? vertices_.size() == now->mesh->vertex_count() : vertices_of_ == selection)) return vertices_;
  vertices_connectivity_ = editable_.connectivity();
  all_vertices_ = whole;
  vertices_of_ = selection;
  vertices_ = whole ? all_elements(now->mesh->vertex_count())
                    : converted(*now->topology, kind(), ComponentKind::Vertex, selected());
  return vertices_;
}

Elements MeshSelector::selected_edges() {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr || mode_ == MeshMode::Object) return {};
  const ConvertRule rule = mode_ == MeshMode::Vertex ? ConvertRule::Contained : ConvertRule::Touching;
  return converted(*now->topology, kind(), ComponentKind::Edge, selected(), rule);
}

Vec3 MeshSelector::middle() {
  const PolyMesh& now = *editable_.prepared()->mesh;
  const Elements& vertices = selected_vertices();
  if (vertices.empty()) return Vec3::Zero();
  Vec3 low = now.positions[vertices.front()];
  Vec3 high = low;
  for (const Index vertex : vertices) {
    low = low.cwiseMin(now.positions[vertex]);
    high = high.cwiseMax(now.positions[vertex]);
  }
  return (low + high) / 2;
}

std::string MeshSelector::counted(const std::string& verb, ComponentKind wanted, std::size_t count) const {
  if (mode_ == MeshMode::Object) return verb + ' ' + editable_.node_name();
  return verb + ' ' + counted_elements(wanted, count);
}

// ---- Modes

void MeshSelector::set_mode(MeshMode mode) {
  log_.begin();
  mode_set_(mode != mode_);
  if (mode == mode_) return;
  forget_other_connectivity();
  Session& session = editable_.session();
  if (session.components().node == editable_.node() && mode_ != MeshMode::Object)
    kept_[static_cast<std::size_t>(kind())] = session.shared_components();
  mode_ = mode;
  const auto kept = mode == MeshMode::Object ? nullptr : kept_[static_cast<std::size_t>(kind())];
  session.select_components(kept ? *kept : ComponentSelection{});
}

void MeshSelector::forget_other_connectivity() {
  editable_.prepared();
  if (kept_connectivity_ == editable_.connectivity()) return;
  kept_ = {};
  kept_connectivity_ = editable_.connectivity();
}

Verdict MeshSelector::convert_to(MeshMode mode, ConvertRule rule) {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr || mode == MeshMode::Object || mode_ == MeshMode::Object) {
    set_mode(mode);
    return Verdict::Continue;
  }
  const Elements before = selected();
  const ComponentKind from = kind();
  set_mode(mode);
  return choose(kind(), converted(*now->topology, from, kind(), before, rule));
}

// ---- Choosing

Verdict MeshSelector::choose(ComponentKind wanted, Elements elements, std::optional<recorded::Step> step) {
  log_.begin();
  if (editable_.prepared() == nullptr) return Verdict::Continue;
  if (mode_ != mode_of(wanted)) set_mode(mode_of(wanted));
  if (!step) step = recorded::Pick{editable_.node_name(), singular(wanted), elements, "replace"};
  Session& session = editable_.session();
  const std::uint64_t before = session.revision();
  session.select_components({editable_.node(), wanted, std::move(elements)});
  if (session.revision() == before) return Verdict::Continue;
  log_.done = std::move(step);
  return Verdict::Commit;
}

Verdict MeshSelector::choose_if_any(ComponentKind wanted, Elements elements) {
  return elements.empty() ? Verdict::Continue : choose(wanted, std::move(elements));
}

Verdict MeshSelector::pick(ComponentKind wanted, Elements elements, How how) {
  if (editable_.prepared() == nullptr) return Verdict::Continue;
  if (mode_ != mode_of(wanted)) set_mode(mode_of(wanted));
  recorded::Pick step{editable_.node_name(), singular(wanted), elements, how_names[static_cast<std::size_t>(how)]};
  Elements found = found_by(wanted, std::move(elements), how);
  if (how == How::Remove) {
    found = subtracted(selected(), found);
  } else if (how == How::Toggle) {
    found = toggled(selected(), found);
  } else if (how != How::Replace) {
    found = united(selected(), found);
  }
  return choose(wanted, std::move(found), std::move(step));
}

/// What is taken, added or taken away, sorted.
Elements MeshSelector::found_by(ComponentKind wanted, Elements elements, How how) {
  if (how == How::All) return all_elements(element_count(*editable_.topology(), wanted));
  if (how == How::Path) {
    return elements.size() < 2 ? Elements{} : sorted_unique(path(wanted, elements.front(), elements.back()));
  }
  if (how != How::Loop && how != How::Ring && how != How::Connected && how != How::Chain)
    return sorted_unique(std::move(elements));
  Elements found;
  for (const Index element : elements) {
    const Elements more = expanded(wanted, element, how);
    found.insert(found.end(), more.begin(), more.end());
  }
  return sorted_unique(std::move(found));
}

Elements MeshSelector::expanded(ComponentKind wanted, Index element, How how) {
  const PreparedMesh& now = *editable_.prepared();
  if (how == How::Connected || wanted != ComponentKind::Edge)
    return connected(*now.topology, wanted, std::span(&element, 1));
  if (how == How::Ring) return edge_ring(*now.topology, element);
  if (how == How::Chain) return tagged_chain(*now.topology, now.mesh->tags, element);
  return edge_loop(*now.topology, element);
}

// ---- Paths

Elements MeshSelector::path(ComponentKind wanted, Index from, Index to) {
  const PreparedMesh& now = *editable_.prepared();
  const MeshTopology& topology = *now.topology;
  if (wanted == ComponentKind::Face) return face_path(from, to);
  if (wanted == ComponentKind::Vertex) {
    const Elements edges = shortest_path(topology, now.mesh->positions, from, to);
    return converted(topology, ComponentKind::Edge, ComponentKind::Vertex, edges);
  }
  const Elements loop = edge_loop(topology, from, true);
  if (shares_row(loop, to)) return part_between(loop, from, to, closes(topology, loop));
  const Elements ring = edge_ring(topology, from, true);
  if (shares_row(ring, to)) return part_between(ring, from, to, ring_closes(topology, ring));
  return shortest_edge_path(topology, now.mesh->positions, from, to);
}

Elements MeshSelector::face_path(Index from, Index to) {
  const PreparedMesh& now = *editable_.prepared();
  if (from >= now.mesh->face_count() || to >= now.mesh->face_count()) return {};
  Elements best;
  for (Index corner = now.mesh->face_offsets[from]; corner < now.mesh->face_offsets[from + 1]; ++corner) {
    if (now.topology->edge(corner) == no_index) continue;
    const EdgeRing ring = walk_ring(*now.topology, now.topology->edge(corner));
    if (!shares_row(ring.faces, from) || !shares_row(ring.faces, to)) continue;
    Elements part = part_between(ring.faces, from, to, ring.closed);
    if (best.empty() || part.size() < best.size()) best = std::move(part);
  }
  return best;
}

// ---- Commands

Verdict MeshSelector::select_all() {
  return mode_ == MeshMode::Object ? Verdict::Continue : pick(kind(), {}, How::All);
}

Verdict MeshSelector::select_none() {
  if (selected().empty()) return Verdict::Continue;
  return choose(kind(), {});
}

Verdict MeshSelector::reselect(Reselect how) {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Continue;
  const MeshTopology& topology = *now->topology;
  const ComponentKind own = kind();
  const auto rows = [&](auto row) {
    return mode_ == MeshMode::Edge ? choose_if_any(own, rows_through(selected(), row)) : Verdict::Continue;
  };
  const bool is_object = mode_ == MeshMode::Object, is_none = selected().empty();
  switch (how) {
    case Reselect::Invert:
      return is_object ? Verdict::Continue : choose(own, inverted(selected(), element_count(topology, own)));
    case Reselect::Grow: return is_none ? Verdict::Continue : choose(own, grown(topology, own, selected()));
    case Reselect::Shrink: return is_none ? Verdict::Continue : choose(own, shrunk(topology, own, selected()));
    case Reselect::Connected: return is_none ? Verdict::Continue : choose(own, connected(topology, own, selected()));
    case Reselect::Loop: return rows([&](Index edge) { return edge_loop(topology, edge); });
    case Reselect::Ring: return rows([&](Index edge) { return edge_ring(topology, edge); });
    case Reselect::Chain: return rows([&](Index edge) { return tagged_chain(topology, now->mesh->tags, edge); });
    case Reselect::Boundary: return choose_if_any(ComponentKind::Edge, boundary_edges(topology));
    case Reselect::Tagged: return choose_if_any(ComponentKind::Edge, tagged_edges(now->mesh->tags, topology));
    case Reselect::Between: return selected().size() == 2 ? pick(own, selected(), How::Path) : Verdict::Continue;
  }
  return Verdict::Continue;
}

}  // namespace croquis
