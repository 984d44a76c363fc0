// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/mesh_text.h"
#include "cli/solid_faults.h"
#include "croquis/base/described.h"
#include "croquis/base/error.h"
#include "croquis/document/evaluator.h"
#include "croquis/io/project_file.h"

namespace croquis::cli {
namespace {

// ---- Values for one run

struct Setting {
  std::string node;
  std::string parameter;
  std::string value;
};

Error refused(const char* code, std::string message, const std::string& subject, SubjectKind kind) {
  return Error(make_error(Category::Usage, code, std::move(message), {{kind, subject, {}, {}, {}}}));
}

/// Names may hold dots, parameters don't.
bool parse(const std::string& text, Setting& setting) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) return false;
  const auto dot = text.rfind('.', equals);
  if (dot == std::string::npos || dot == 0 || dot + 1 == equals) return false;
  setting = {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1)};
  return true;
}

std::vector<Setting> split(const std::string& settings) {
  std::vector<Setting> list;
  std::istringstream stream(settings);
  for (std::string piece; std::getline(stream, piece, ';');) {
    Setting setting;
    if (parse(piece, setting)) {
      list.push_back(std::move(setting));
    } else if (list.empty()) {
      throw refused("E_USAGE", "'" + piece + "' is no setting: write NODE.PARAMETER=VALUE.", "set",
                    SubjectKind::Parameter);
    } else {
      list.back().value += ";" + piece;
    }
  }
  return list;
}

const Node& find_node(const Document& document, const std::string& wanted) {
  const Node* found = nullptr;
  for (const auto& node : document.nodes()) {
    if (std::to_string(node->id) == wanted) return *node;
    if (node->name != wanted) continue;
    if (found != nullptr) {
      throw refused("E_USAGE", "Several nodes are called '" + wanted + "'; name the one you mean by its id.", wanted,
                    SubjectKind::Node);
    }
    found = node.get();
  }
  if (found != nullptr) return *found;
  std::string names;
  for (const auto& node : document.nodes()) {
    names += (names.empty() ? "" : ", ") + std::to_string(node->id) + " ('" + node->name + "')";
  }
  throw refused("E_USAGE",
                "There is no node '" + wanted + "' in the project; there are " + (names.empty() ? "none" : names) + ".",
                wanted, SubjectKind::Node);
}

Document with_setting(const Document& document, const Setting& setting, const Registry& registry) {
  Node node = find_node(document, setting.node);
  const Operation* operation = registry.find(node.operation);
  const auto parameters = operation == nullptr ? std::vector<ParameterDescription>() : operation->describe().parameters;
  const ParameterDescription* found = find_parameter(parameters, setting.parameter);
  if (found == nullptr) {
    throw refused("E_PARAMETER",
                  "Node '" + setting.node + "' has no parameter '" + setting.parameter +
                      "'; croquis-cli operations lists them all.",
                  setting.parameter, SubjectKind::Parameter);
  }
  node.parameters[setting.parameter] = parse_parameter(*found, setting.value);
  return document.with(std::move(node));
}

/// The document with other parameters.
/// @param settings NODE.PARAMETER=VALUE, several separated by ';'. NODE is a node's id or its name. A piece that isn't
///        of that form belongs to the value before it, which may be a list of its own.
/// @throws Error (E_USAGE, E_PARAMETER; Category::Usage) with a finding for each setting that can't be
Document with_settings(const Document& document, const std::string& settings, const Registry& registry) {
  Document edited = document;
  Findings findings;
  for (const Setting& setting : split(settings)) {
    try {
      edited = with_setting(edited, setting, registry);
    } catch (const Error& error) {
      findings.insert(findings.end(), error.findings().begin(), error.findings().end());
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return edited;
}

// ---- Several meshes in one file

/// A mesh among others in one file.
struct NamedMesh {
  std::string name;
  std::shared_ptr<const PolyMesh> mesh;
};

struct MeshUnion {
  PolyMesh mesh;      ///< the parts one after the other; "object" on faces and lines distinguishes them; tags are kept
  Findings warnings;  ///< at most one W_CHANNELS: attributes that not all parts have, left out
};

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

/// One mesh of several, which stay as they are beside each other. A single one stays itself.
MeshUnion unite(const std::vector<NamedMesh>& parts) {
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

/// What people see as results: visible meshes that no other visible mesh is made of.
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

class ProjectRun {
 public:
  ProjectRun(const Registry& registry, const Document& document, CommandResult& result)
      : registry_(registry), document_(document), evaluator_(registry), result_(result) {}

  void evaluate(const Node& node, Progress& progress) {
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
    meshes_.push_back({title_of(node), evaluation->outputs.at(port->name).as<PolyMesh>()});
    is_solid_ = port->is_solid;
  }

  /// @throws Error when no mesh came out: all findings
  MeshUnion finish() {
    result_.details = Report().set("nodes", std::move(nodes_));
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
      result_.warnings.push_back(std::move(finding));
    }
    return unite(meshes_);
  }

  /// Whether the one mesh that came out should be a solid. Of several, each may be one and all together none.
  bool promises_solid() const { return meshes_.size() == 1 && is_solid_; }

 private:
  /// The findings of everything that the node is made from, once. These evaluations are available already.
  void collect_findings(NodeId id) {
    for (const auto& node : document_.upstream(id)) {
      if (!reported_.insert(node->id).second) continue;
      Progress silent;
      const Findings more = evaluator_.evaluate(document_, node->id, Quality::Final, silent)->findings;
      findings_.insert(findings_.end(), more.begin(), more.end());
    }
  }

  const Registry& registry_;
  const Document& document_;
  Evaluator evaluator_;
  CommandResult& result_;
  Report nodes_ = Report::array();
  Findings findings_;
  std::set<NodeId> reported_;
  std::vector<NamedMesh> meshes_;
  bool is_solid_ = false;
};

ProjectFile read_input_project(const Invocation& invocation, Progress& progress) {
  if (invocation.input == "-") return read_project(read_input(invocation), "standard input", progress);
  return load_project(invocation.input, progress);
}

void run_project(const Registry& registry, const Invocation& invocation, CommandResult& result, Progress& progress) {
  const MeshFormat format = output_mesh_format(invocation.output, invocation.output_format);
  Progress reading = progress.step("read", 0.05);
  ProjectFile project = read_input_project(invocation, reading);
  result.warnings = std::move(project.warnings);
  const std::string settings = text_of(invocation.parameters, "set");
  const Document document = with_settings(project.document, settings, registry);

  Progress evaluating = progress.step("evaluate", 0.85);
  const std::vector<const Node*> wanted = results_of(document, registry);
  ProjectRun project_run(registry, document, result);
  for (const Node* node : wanted) {
    Progress step = evaluating.step(title_of(*node), 1.0 / static_cast<double>(wanted.size()));
    project_run.evaluate(*node, step);
  }
  MeshUnion united = project_run.finish();
  result.warnings.insert(result.warnings.end(), united.warnings.begin(), united.warnings.end());

  Progress writing = progress.step("write", 0.1);
  stage_mesh(invocation.output, united.mesh, {}, format, result, writing);
  const PolyMesh written = as_written(united.mesh, format, {});
  if (project_run.promises_solid()) {
    judge_solid(invocation.output, written, result, writing);
  } else {
    result.mesh = inspect(written, true, writing);
    warn_of_faults(invocation.output, format == MeshFormat::Stl, result);
  }
  result.text = mesh_text(*result.mesh);
  progress.report(1);
}

}  // namespace

Command run_command(const Registry& registry) {
  return {{.name = "run",
           .sentence = "Evaluates a project and writes its visible meshes that no other visible mesh is made of.",
           .input_word = "FILE.croq",
           .output = OutputNeed::Required,
           .parameters = {list_parameter(
               "set", "NODE.PARAMETER=VALUE: another value, for this run; NODE is a name or an id.")},
           .examples = {"croquis-cli run project.croq -o solid.obj",
                        "croquis-cli run project.croq -o solid.obj --set inflate.min-gap=0.5"}},
          [&registry](const Invocation& invocation, CommandResult& result, Progress& progress) {
            run_project(registry, invocation, result, progress);
          }};
}

}  // namespace croquis::cli
