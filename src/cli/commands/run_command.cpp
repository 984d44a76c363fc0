// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/run_command.h"

#include <set>
#include <utility>

#include "cli/files.h"
#include "cli/mesh_text.h"
#include "cli/mesh_union.h"
#include "cli/project_settings.h"
#include "cli/solid_faults.h"
#include "croquis/base/error.h"
#include "croquis/document/evaluator.h"
#include "croquis/io/project_file.h"

namespace croquis::cli {
namespace {

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

/// The node and all that it is made from, in the document's order.
std::vector<const Node*> sources_of(const Document& document, NodeId id) {
  std::set<NodeId> reached;
  std::vector<NodeId> pending = {id};
  while (!pending.empty()) {
    const NodeId next = pending.back();
    pending.pop_back();
    const Node* node = document.find(next);
    if (node == nullptr || !reached.insert(next).second) continue;
    for (const auto& [port, link] : node->inputs) pending.push_back(link.node);
  }
  std::vector<const Node*> nodes;
  for (const auto& node : document.nodes()) {
    if (reached.contains(node->id)) nodes.push_back(node.get());
  }
  return nodes;
}

class ProjectRun {
 public:
  ProjectRun(const Registry& registry, const Document& document, CommandResult& result)
      : registry_(registry), document_(document), evaluator_(registry), result_(result) {}

  void evaluate(const Node& node, Progress& progress) {
    const auto evaluation = evaluator_.evaluate(document_, node.id, Quality::Final, progress);
    Report entry;
    entry.set("id", std::to_string(node.id)).set("name", node.name).set("operation", node.operation);
    entry.set("failed", evaluation->failed);
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
    for (const Node* node : sources_of(document_, id)) {
      if (!told_.insert(node->id).second) continue;
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
  std::set<NodeId> told_;
  std::vector<NamedMesh> meshes_;
  bool is_solid_ = false;
};

ProjectFile read_input_project(const Invocation& invocation, Progress& progress) {
  if (invocation.input == "-") return read_project(read_input(invocation), "standard input", progress);
  return load_project(invocation.input, progress);
}

}  // namespace

CommandDescription RunCommand::describe() const {
  CommandDescription description;
  description.name = "run";
  description.sentence = "Evaluates a project and writes its visible meshes that no other visible mesh is made of.";
  description.input_word = "FILE.croq";
  description.output = OutputNeed::Required;
  description.parameters = {{"set",
                             ParameterType::Text,
                             std::string(),
                             0,
                             0,
                             {},
                             "",
                             "NODE.PARAMETER=VALUE: another value, for this run; NODE is a name or an id.",
                             true}};
  description.examples = {"croquis-cli run project.croq -o solid.obj",
                          "croquis-cli run project.croq -o solid.obj --set inflate.min-gap=0.5"};
  return description;
}

void RunCommand::run(const Invocation& invocation, CommandResult& result, Progress& progress) const {
  const MeshFormat format = output_mesh_format(invocation.output, invocation.output_format);
  Progress reading = progress.step("read", 0.05);
  ProjectFile project = read_input_project(invocation, reading);
  result.warnings = std::move(project.warnings);
  const std::string settings = text_of(invocation.parameters, "set");
  const Document document = with_settings(project.document, settings, registry_);

  Progress evaluating = progress.step("evaluate", 0.85);
  const std::vector<const Node*> wanted = results_of(document, registry_);
  ProjectRun project_run(registry_, document, result);
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

}  // namespace croquis::cli
