// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <set>
#include <vector>

#include "cli/command.h"
#include "croquis/document/evaluator.h"
#include "croquis/geometry/joined_meshes.h"

namespace croquis::cli {

/// What people see as results: visible meshes that no other visible mesh is made of.
std::vector<const Node*> results_of(const Document& document, const Registry& registry);

/// Its name, or what stands for one.
std::string title_of(const Node& node);

struct MeshUnion {
  PolyMesh mesh;      ///< the parts one after the other; "object" on faces and lines distinguishes them; tags are kept
  Findings warnings;  ///< at most one W_CHANNELS: attributes that not all parts have, left out
};

/// Evaluates nodes of one document and collects meshes, reports and findings.
class ProjectRun {
 public:
  /// @param evaluator of the registry; what it keeps serves later runs
  ProjectRun(const Registry& registry, const Document& document, Evaluator& evaluator)
      : registry_(registry), document_(document), evaluator_(evaluator) {}

  void evaluate(const Node& node, Progress& progress);

  /// What failed becomes a warning where something came out; details go to the result as well.
  /// @throws Error when no mesh came out: all findings
  void finish(CommandResult& result);

  /// Where they stand.
  const std::vector<NamedMesh>& meshes() const { return meshes_; }

  /// One mesh of several, each in its own space. A single one stays itself.
  MeshUnion united() const;

  /// Whether the one mesh that came out should be a solid. Of several, each may be one and all together none.
  bool promises_solid() const { return meshes_.size() == 1 && is_solid_; }

 private:
  void collect_findings(NodeId id);

  const Registry& registry_;
  const Document& document_;
  Evaluator& evaluator_;
  Report nodes_ = Report::array();
  Findings findings_;
  std::set<NodeId> reported_;
  std::vector<NamedMesh> meshes_;
  bool is_solid_ = false;
};

}  // namespace croquis::cli
