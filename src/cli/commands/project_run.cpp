// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/project_run.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "croquis/base/described.h"
#include "croquis/base/error.h"

namespace croquis::cli {
namespace {

// ---- Several meshes in one file

constexpr const char* object_channel = "object";

/// Channels can be joined when every part has one of that name, width and type without labels of its own.
bool everywhere(const std::vector<NamedMesh>& parts, const AttributeChannel& channel) {
  return std::all_of(parts.begin(), parts.end(), [&](const NamedMesh& part) {
    const AttributeChannel* other = part.mesh->channel(channel.name, channel.domain);
    return other != nullptr && other->width == channel.width && other->data.index() == channel.data.index() &&
           other->labels.empty();
  });
}

void append_values(AttributeChannel& all, const AttributeChannel& more) {
  const auto append = [&](auto& values) {
    const auto& others = std::get<std::decay_t<decltype(values)>>(more.data);
    values.insert(values.end(), others.begin(), others.end());
  };
  std::visit(append, all.data);
}

void append_lists(std::vector<Index>& offsets, std::vector<Index>& vertices, const std::vector<Index>& more_offsets,
                  const std::vector<Index>& more_vertices, Index first_vertex) {
  const Index first = offsets.back();
  for (std::size_t i = 1; i < more_offsets.size(); ++i) offsets.push_back(first + more_offsets[i]);
  for (const Index vertex : more_vertices) vertices.push_back(first_vertex + vertex);
}

/// Tags of vertices that the part doesn't have would mean those of the next one, so they go.
void append_tags(const NamedMesh& part, Index first, MeshTags& all) {
  using Edge = std::array<Index, 2>;
  const auto is_there = [&](Index vertex) { return vertex < part.mesh->vertex_count(); };
  const auto are_there = [&](const Edge& edge) { return is_there(edge[0]) && is_there(edge[1]); };
  const auto shifted = [&](const Edge& edge) { return Edge{first + edge[0], first + edge[1]}; };
  const auto append_pins = [&](const std::vector<Index>& pins, std::vector<Index>& to) {
    for (const Index pin : pins) {
      if (is_there(pin)) to.push_back(first + pin);
    }
  };
  const MeshTags& tags = part.mesh->tags;
  for (const Crease& crease : tags.creases) {
    if (are_there(crease.vertices)) all.creases.push_back({shifted(crease.vertices), crease.sharpness});
  }
  append_pins(tags.pins, all.pins);
  for (const CreaseSet& set : tags.sets) {
    CreaseSet copy{part.name + ": " + set.name, set.sharpness, {}, {}};
    for (const Edge& edge : set.edges) {
      if (are_there(edge)) copy.edges.push_back(shifted(edge));
    }
    append_pins(set.pins, copy.pins);
    all.sets.push_back(std::move(copy));
  }
}

void append_part(PolyMesh& all, const NamedMesh& named) {
  const PolyMesh& part = *named.mesh;
  const auto first_vertex = static_cast<Index>(all.positions.size());
  append_tags(named, first_vertex, all.tags);
  all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
  append_lists(all.face_offsets, all.corners, part.face_offsets, part.corners, first_vertex);
  append_lists(all.line_offsets, all.line_vertices, part.line_offsets, part.line_vertices, first_vertex);
  for (AttributeChannel& channel : all.channels) append_values(channel, *part.channel(channel.name, channel.domain));
}

AttributeChannel objects(const std::vector<NamedMesh>& parts, Domain domain) {
  AttributeChannel channel{object_channel, domain, 1, std::vector<std::int32_t>(), {}};
  auto& values = std::get<std::vector<std::int32_t>>(channel.data);
  for (const NamedMesh& part : parts) {
    values.insert(values.end(), part.mesh->element_count(domain), static_cast<std::int32_t>(channel.labels.size()));
    channel.labels.push_back(part.name);
  }
  return channel;
}

/// Empty channels to be filled, and the names of those that can't be.
std::set<std::string> prepare_channels(const std::vector<NamedMesh>& parts, PolyMesh& all) {
  std::set<std::string> dropped;
  for (const NamedMesh& part : parts) {
    for (const AttributeChannel& channel : part.mesh->channels) {
      if (channel.name == object_channel) continue;
      if (!everywhere(parts, channel)) {
        dropped.insert(channel.name);
      } else if (all.channel(channel.name, channel.domain) == nullptr) {
        AttributeChannel empty = channel;
        std::visit([](auto& values) { values.clear(); }, empty.data);
        all.channels.push_back(std::move(empty));
      }
    }
  }
  return dropped;
}

void require_room(const std::vector<NamedMesh>& parts) {
  std::size_t vertices = 0, corners = 0, line_vertices = 0;
  for (const NamedMesh& part : parts) {
    vertices += part.mesh->vertex_count();
    corners += part.mesh->corners.size();
    line_vertices += part.mesh->line_vertices.size();
  }
  if (std::max({vertices, corners, line_vertices}) < std::numeric_limits<Index>::max()) return;
  throw Error(make_error(Category::Limit, "E_LIMIT",
                         "The project's meshes have too many vertices for one file; hide some of them."));
}

// ---- What is evaluated

/// The output that is a node's mesh.
struct MeshPort {
  std::string name;
  bool is_solid = false;
};

std::optional<MeshPort> mesh_port(const Node& node, const Registry& registry) {
  if (node.source) {
    const bool is_mesh = node.source->type() == ValueType::Mesh;
    return is_mesh ? std::optional<MeshPort>({"value", false}) : std::nullopt;
  }
  const Operation* operation = registry.find(node.operation);
  if (operation == nullptr) return std::nullopt;
  for (const PortDescription& port : operation->describe().outputs) {
    if (port.type == ValueType::Mesh) return MeshPort{port.name, port.is_solid};
  }
  return std::nullopt;
}

/// An unknown operation might have made the missing mesh: an error is better than leaving it out.
bool is_wanted(const Node& node, const Registry& registry) {
  const bool unknown = !node.operation.empty() && registry.find(node.operation) == nullptr;
  return node.visible && (unknown || mesh_port(node, registry));
}

}  // namespace

std::vector<const Node*> results_of(const Document& document, const Registry& registry) {
  std::set<NodeId> used;
  for (const auto& node : document.nodes()) {
    if (!is_wanted(*node, registry)) continue;
    for (const auto& [port, link] : node->inputs) used.insert(link.node);
  }
  std::vector<const Node*> results;
  for (const auto& node : document.nodes()) {
    if (is_wanted(*node, registry) && !used.contains(node->id)) results.push_back(node.get());
  }
  return results;
}

std::string title_of(const Node& node) { return node.name.empty() ? "node-" + std::to_string(node.id) : node.name; }

void ProjectRun::evaluate(const Node& node, Progress& progress) {
  const auto evaluation = evaluator_.evaluate(document_, node.id, Quality::Final, progress);
  Report entry = to_report(fields(named("id", std::to_string(node.id)), named("name", node.name),
                                  named("operation", node.operation), named("failed", evaluation->failed)));
  const auto details = evaluation->outputs.find("details");
  if (details != evaluation->outputs.end()) {
    if (const auto report = details->second.as<Report>()) {
      entry.set("details", *report);
    }
  }
  nodes_.push(std::move(entry));
  collect_findings(node.id);
  const auto port = mesh_port(node, registry_);
  if (evaluation->failed || !port) return;
  NamedMesh made{title_of(node), evaluation->outputs.at(port->name).as<PolyMesh>(), {}};
  for (const auto& step : document_.upstream(node.id)) made.map = composed(made.map, step->placement.map());
  meshes_.push_back(std::move(made));
  is_solid_ = port->is_solid;
}

void ProjectRun::finish(CommandResult& result) {
  result.details = Report().set("nodes", std::move(nodes_));
  if (meshes_.empty()) {
    if (!has_errors(findings_)) {
      findings_.push_back(make_error(Category::Geometry, "E_NO_MESH",
                                     "The project shows no mesh; make a node that gives one visible."));
    }
    throw Error(std::move(findings_));
  }
  // Something came out, so what failed is a warning.
  for (Finding& finding : findings_) {
    finding.severity = Severity::Warning;
    result.warnings.push_back(std::move(finding));
  }
}

/// The findings of everything that the node is made from, once. These evaluations are available already.
void ProjectRun::collect_findings(NodeId id) {
  for (const auto& node : document_.upstream(id)) {
    if (!reported_.insert(node->id).second) continue;
    Progress silent;
    const Findings more = evaluator_.evaluate(document_, node->id, Quality::Final, silent)->findings;
    findings_.insert(findings_.end(), more.begin(), more.end());
  }
}

MeshUnion ProjectRun::united() const {
  const std::vector<NamedMesh>& parts = meshes_;
  if (parts.size() == 1) return {*parts.front().mesh, {}};
  require_room(parts);
  MeshUnion result;
  const std::set<std::string> dropped = prepare_channels(parts, result.mesh);
  for (const NamedMesh& part : parts) append_part(result.mesh, part);
  for (const Domain domain : {Domain::Face, Domain::Line}) result.mesh.channels.push_back(objects(parts, domain));
  if (dropped.empty()) return result;
  std::string names;
  for (const std::string& name : dropped) names += (names.empty() ? "'" : ", '") + name + "'";
  result.warnings.push_back(make_warning(Category::Geometry, "W_CHANNELS",
                                         "Attributes that not all meshes of the project have alike were left out: " +
                                             names + "; show one mesh at a time to keep them."));
  return result;
}

}  // namespace croquis::cli
