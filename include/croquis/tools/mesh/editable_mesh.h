// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/edits/edit_line.h"
#include "croquis/session/session.h"
#include "croquis/tools/mesh/mesh_pick.h"
#include "croquis/tools/recording/step.h"
#include "croquis/workspace/workspace.h"

namespace croquis {

/// What the parts of a mesh tool exchange about commands.
struct CommandLog {
  std::function<void()> begin;         ///< called before each command: a gesture under way is given up
  std::optional<recorded::Step> done;  ///< what the last Commit did
  Findings notes;                      ///< what the last edit lost or refused (warnings)
};

/// A mesh with its neighbourhoods and its picking tree.
struct PreparedMesh {
  std::shared_ptr<const PolyMesh> mesh;
  std::shared_ptr<const MeshTopology> topology;
  MeshPicker picker;

  explicit PreparedMesh(std::shared_ptr<const PolyMesh> now)
      : mesh(std::move(now)), topology(std::make_shared<const MeshTopology>(*mesh)), picker(mesh, topology) {}
};

/// The mesh of a node of a session, and what is derived of it, kept as long as it is valid: one that a source holds, or
/// one that is computed, as of a sketch's solid.
///
/// Neighbourhoods are only made again when the connectivity changed, the picking tree is refitted when the next pick
/// asks. Those of big meshes are made beside. The session outlives this. One thread.
class EditableMesh {
 public:
  /// @param workspace computes meshes; null: only those of sources are there
  explicit EditableMesh(Session& session, Workspace* workspace = nullptr) : session_(session), workspace_(workspace) {}

  Session& session() const { return session_; }
  void set_node(NodeId node);
  void go_on_with(NodeId node);  ///< that gives the same mesh edited
  NodeId node() const { return node_; }
  std::string node_name() const;                 ///< empty when there is no such node
  std::shared_ptr<const PolyMesh> mesh() const;  ///< null when the node holds none, or none is computed yet
  bool is_computed() const;                      ///< nothing but edits can change it

  PreparedMesh* prepared();           ///< of mesh(), or null; waits until it is made
  PreparedMesh* prepared_if_ready();  ///< also null while it is being made
  bool ready() { return prepared_if_ready() != nullptr; }

  std::shared_ptr<const MeshTopology> topology();  ///< of mesh(), or null; waits
  const std::vector<double>& edge_sharpness();     ///< #E, of mesh()'s tags; waits

  /// Grows when the numbers of elements no longer mean what they did: another node, or another connectivity.
  std::uint64_t connectivity() const { return connectivity_; }

  /// The session's document with this mesh in the node, a source.
  Document with_mesh(PolyMesh mesh) const;

  /// A document with lines of edits after the node, which is computed, and the node that gives the edited mesh. The
  /// mesh is computed.
  /// @param document of the session, now or before a drag
  /// @throws Error what is wrong with the lines
  AddedNode with_lines(const Document& document, const std::vector<EditLine>& lines) const;

 private:
  Session& session_;
  Workspace* workspace_;
  NodeId node_ = 0;
  mutable std::shared_ptr<const PolyMesh> computed_;  ///< the mesh of a computed node …
  mutable NodeId computed_node_ = 0;                  ///< … which was this one …
  mutable std::uint64_t computed_revision_ = 0;       ///< … of the session as it was then
  std::unique_ptr<PreparedMesh> prepared_;
  std::future<std::unique_ptr<PreparedMesh>> coming_;  ///< of a big mesh
  std::uint64_t connectivity_ = 0;

  std::optional<MeshTags> sharpness_of_;      ///< tags that `sharpness_` was made of …
  std::uint64_t sharpness_connectivity_ = 0;  ///< … and connectivity
  std::vector<double> sharpness_;             ///< #E
};

}  // namespace croquis
