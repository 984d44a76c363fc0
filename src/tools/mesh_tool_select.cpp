// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <utility>

#include "algorithms/mesh_editing/edge_walk.h"
#include "tools/mesh_tool_cache.h"

namespace croquis {
namespace {

using How = MeshTool::How;

const char* name_of(How how) {
  switch (how) {
    case How::Replace: return "replace";
    case How::Add: return "add";
    case How::Remove: return "remove";
    case How::Toggle: return "toggle";
    case How::Loop: return "loop";
    case How::Ring: return "ring";
    case How::Path: return "path";
    case How::Connected: return "connected";
    case How::Chain: return "chain";
    case How::All: return "all";
  }
  return "replace";
}

MeshMode mode_of(ComponentKind kind) {
  if (kind == ComponentKind::Vertex) return MeshMode::Vertex;
  return kind == ComponentKind::Edge ? MeshMode::Edge : MeshMode::Face;
}

bool shares_row(std::span<const Index> row, Index element) {
  return std::find(row.begin(), row.end(), element) != row.end();
}

}  // namespace

// ---- What is selected

ComponentKind MeshTool::kind() const {
  if (mode_ == MeshMode::Vertex) return ComponentKind::Vertex;
  return mode_ == MeshMode::Face ? ComponentKind::Face : ComponentKind::Edge;
}

const Elements& MeshTool::selected() const {
  static const Elements none;
  const ComponentSelection& selection = session_.components();
  const bool own = mode_ != MeshMode::Object && selection.node == node_ && selection.kind == kind();
  return own ? selection.elements : none;
}

const Elements& MeshTool::selected_vertices() {
  static const Elements none;
  Cache* cache = fresh();
  if (cache == nullptr) return none;
  const bool whole = mode_ == MeshMode::Object;
  const Selection& objects = session_.selection();
  if (whole && !std::binary_search(objects.begin(), objects.end(), SelectedItem{node_, ""})) return none;
  const auto now = session_.shared_components();
  if (whole ? cache->all_vertices && cache->vertices.size() == cache->mesh->vertex_count()
            : !cache->all_vertices && cache->vertices_of == now)
    return cache->vertices;
  cache->all_vertices = whole;
  cache->vertices_of = now;
  cache->vertices = whole ? all_elements(cache->mesh->vertex_count())
                          : converted(*cache->topology, kind(), ComponentKind::Vertex, selected());
  return cache->vertices;
}

Elements MeshTool::selected_edges() {
  const Cache* cache = fresh();
  if (cache == nullptr || mode_ == MeshMode::Object) return {};
  const ConvertRule rule = mode_ == MeshMode::Vertex ? ConvertRule::Contained : ConvertRule::Touching;
  return converted(*cache->topology, kind(), ComponentKind::Edge, selected(), rule);
}

// ---- Modes

void MeshTool::set_mode(MeshMode mode) {
  give_up();
  arm_loop_cut(false);
  if (mode == mode_) return;
  fresh();  // what was kept for another connectivity is forgotten
  if (session_.components().node == node_ && mode_ != MeshMode::Object)
    kept_[static_cast<std::size_t>(kind())] = session_.shared_components();
  mode_ = mode;
  preview_ = {};
  anchor_ = anchor_before_ = no_index;
  last_click_.reset();
  const auto kept = mode == MeshMode::Object ? nullptr : kept_[static_cast<std::size_t>(kind())];
  session_.select_components(kept ? *kept : ComponentSelection{});
}

Verdict MeshTool::convert_to(MeshMode mode, ConvertRule rule) {
  const Cache* cache = fresh();
  if (cache == nullptr || mode == MeshMode::Object || mode_ == MeshMode::Object) {
    set_mode(mode);
    return Verdict::Continue;
  }
  const Elements before = selected();
  const ComponentKind from = kind();
  set_mode(mode);
  return choose(kind(), converted(*cache->topology, from, kind(), before, rule));
}

// ---- Choosing

Verdict MeshTool::choose(ComponentKind wanted, Elements elements, std::optional<recorded::Step> step) {
  give_up();
  if (fresh() == nullptr) return Verdict::Continue;
  if (mode_ != mode_of(wanted)) set_mode(mode_of(wanted));
  if (!step) step = recorded::Pick{node_name(), singular(wanted), elements, "replace"};
  const std::uint64_t before = session_.revision();
  session_.select_components({node_, wanted, std::move(elements)});
  if (session_.revision() == before) return Verdict::Continue;
  done_ = std::move(step);
  return Verdict::Commit;
}

Verdict MeshTool::choose_if_any(ComponentKind wanted, Elements elements) {
  return elements.empty() ? Verdict::Continue : choose(wanted, std::move(elements));
}

Verdict MeshTool::pick(ComponentKind wanted, Elements elements, How how) {
  if (fresh() == nullptr) return Verdict::Continue;
  if (mode_ != mode_of(wanted)) set_mode(mode_of(wanted));
  recorded::Pick step{node_name(), singular(wanted), elements, name_of(how)};
  Elements found;
  if (how == How::All) {
    found = all_elements(element_count(*cache_->topology, wanted));
  } else if (how == How::Path) {
    if (elements.size() >= 2) found = path(wanted, elements.front(), elements.back());
  } else if (how == How::Loop || how == How::Ring || how == How::Connected || how == How::Chain) {
    for (const Index element : elements) {
      const Elements more = expanded(wanted, element, how);
      found.insert(found.end(), more.begin(), more.end());
    }
  } else {
    found = std::move(elements);
  }
  found = sorted_unique(std::move(found));
  if (how == How::Remove) {
    found = subtracted(selected(), found);
  } else if (how == How::Toggle) {
    found = toggled(selected(), found);
  } else if (how != How::Replace) {
    found = united(selected(), found);
  }
  return choose(wanted, std::move(found), std::move(step));
}

Elements MeshTool::expanded(ComponentKind wanted, Index element, How how) {
  const Cache& cache = *fresh();
  if (how == How::Connected || wanted != ComponentKind::Edge)
    return connected(*cache.topology, wanted, std::span(&element, 1));
  if (how == How::Ring) return edge_ring(*cache.topology, element);
  if (how == How::Chain) return tagged_chain(*cache.topology, cache.mesh->tags, element);
  return edge_loop(*cache.topology, element);
}

// ---- Paths

Elements MeshTool::path(ComponentKind wanted, Index from, Index to) {
  const Cache& cache = *fresh();
  const MeshTopology& topology = *cache.topology;
  if (wanted == ComponentKind::Face) return face_path(from, to);
  if (wanted == ComponentKind::Vertex) {
    const Elements edges = shortest_path(topology, cache.mesh->positions, from, to);
    return converted(topology, ComponentKind::Edge, ComponentKind::Vertex, edges);
  }
  const Elements loop = edge_loop(topology, from, true);
  if (shares_row(loop, to)) return part_between(loop, from, to, closes(topology, loop));
  const Elements ring = edge_ring(topology, from, true);
  if (shares_row(ring, to)) return part_between(ring, from, to, ring_closes(topology, ring));
  return shortest_edge_path(topology, cache.mesh->positions, from, to);
}

Elements MeshTool::face_path(Index from, Index to) {
  const Cache& cache = *fresh();
  if (from >= cache.mesh->face_count() || to >= cache.mesh->face_count()) return {};
  Elements best;
  for (Index corner = cache.mesh->face_offsets[from]; corner < cache.mesh->face_offsets[from + 1]; ++corner) {
    if (cache.topology->edge(corner) == no_index) continue;
    const EdgeRing ring = walk_ring(*cache.topology, cache.topology->edge(corner));
    if (!shares_row(ring.faces, from) || !shares_row(ring.faces, to)) continue;
    Elements part = part_between(ring.faces, from, to, ring.closed);
    if (best.empty() || part.size() < best.size()) best = std::move(part);
  }
  return best;
}

// ---- Commands

Verdict MeshTool::select_all() { return mode_ == MeshMode::Object ? Verdict::Continue : pick(kind(), {}, How::All); }

Verdict MeshTool::select_none() {
  if (selected().empty()) return Verdict::Continue;
  return choose(kind(), {});
}

Verdict MeshTool::invert_selection() {
  const Cache* cache = fresh();
  if (cache == nullptr || mode_ == MeshMode::Object) return Verdict::Continue;
  return choose(kind(), inverted(selected(), element_count(*cache->topology, kind())));
}

Verdict MeshTool::grow_selection() {
  const Cache* cache = fresh();
  if (cache == nullptr || selected().empty()) return Verdict::Continue;
  return choose(kind(), grown(*cache->topology, kind(), selected()));
}

Verdict MeshTool::shrink_selection() {
  const Cache* cache = fresh();
  if (cache == nullptr || selected().empty()) return Verdict::Continue;
  return choose(kind(), shrunk(*cache->topology, kind(), selected()));
}

namespace {

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

Verdict MeshTool::select_loop() {
  const Cache* cache = fresh();
  if (cache == nullptr || mode_ != MeshMode::Edge) return Verdict::Continue;
  return choose_if_any(kind(), rows_through(selected(), [&](Index e) { return edge_loop(*cache->topology, e); }));
}

Verdict MeshTool::select_ring() {
  const Cache* cache = fresh();
  if (cache == nullptr || mode_ != MeshMode::Edge) return Verdict::Continue;
  return choose_if_any(kind(), rows_through(selected(), [&](Index e) { return edge_ring(*cache->topology, e); }));
}

Verdict MeshTool::select_connected() {
  const Cache* cache = fresh();
  if (cache == nullptr || selected().empty()) return Verdict::Continue;
  return choose(kind(), connected(*cache->topology, kind(), selected()));
}

Verdict MeshTool::select_chain() {
  const Cache* cache = fresh();
  if (cache == nullptr || mode_ != MeshMode::Edge) return Verdict::Continue;
  const auto chain = [&](Index edge) { return tagged_chain(*cache->topology, cache->mesh->tags, edge); };
  return choose_if_any(kind(), rows_through(selected(), chain));
}

Verdict MeshTool::select_boundary() {
  const Cache* cache = fresh();
  return cache == nullptr ? Verdict::Continue : choose_if_any(ComponentKind::Edge, boundary_edges(*cache->topology));
}

Verdict MeshTool::select_tagged() {
  const Cache* cache = fresh();
  if (cache == nullptr) return Verdict::Continue;
  return choose_if_any(ComponentKind::Edge, tagged_edges(cache->mesh->tags, *cache->topology));
}

Verdict MeshTool::select_between() {
  if (fresh() == nullptr || selected().size() != 2) return Verdict::Continue;
  return pick(kind(), selected(), How::Path);
}

Verdict MeshTool::select_sharper_than(double degrees) {
  const Cache* cache = fresh();
  if (cache == nullptr) return Verdict::Continue;
  return choose_if_any(ComponentKind::Edge, edges_sharper_than(*cache->topology, *cache->mesh, degrees));
}

}  // namespace croquis
