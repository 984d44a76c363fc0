// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "croquis/document/evaluator.h"
#include "croquis/document/kept_work.h"
#include "croquis/document/registry.h"
#include "croquis/geometry/bounds.h"
#include "croquis/session/session.h"
#include "croquis/workspace/chain_edit.h"
#include "croquis/workspace/live_results.h"
#include "croquis/workspace/work_object.h"

namespace croquis {

/// What people work on: a session, and the objects that its document makes, each kept evaluated beside the thread that
/// owns the workspace. Knows no operation by its name. What people do to objects and to steps of chains are functions:
/// see object_commands.h and step_commands.h; what is known of results is in computed.h. For one thread.
class Workspace {
 public:
  /// Bytes that undo and kept results take together, and of these undo at most: results can be
  /// computed again, steps can't.
  static constexpr std::size_t memory_cap = std::size_t{1} << 30;
  static constexpr std::size_t history_cap = memory_cap / 4 * 3;

  /// What is reported to the owner. Each may be empty.
  struct Listener {
    std::function<void()> loaded;          ///< another document
    std::function<void()> changed;         ///< the document or the selection
    std::function<void()> result_changed;  ///< objects(), findings
    std::function<void(double fraction, const std::string& step)> progress;
    std::function<void(bool busy)> busy_changed;
  };

  /// @param post runs something later on the owner's thread; can be called until the destructor has returned
  Workspace(Registry registry, LiveEvaluation::Post post, Listener listener);
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  Session& session() { return session_; }
  const Session& session() const { return session_; }
  const Registry& registry() const { return registry_; }
  /// Null for none of that id.
  const OperationDescription* description(const std::string& operation) const {
    return registry_.description(operation);
  }

  /// What is computed and kept, of documents beside the session's, too.
  Evaluator& evaluator() { return evaluator_; }
  const Evaluator& evaluator() const { return evaluator_; }

  /// In the document's order, hidden ones too.
  const std::vector<WorkObject>& objects() const { return objects_; }

  /// The one that ends in this node, or has it as its cage, or has it in its chain; or null.
  const WorkObject* object(NodeId node) const;

  /// The object that panels and keys are about: the selected one, else the last that was, else the first.
  const WorkObject* active() const;
  void set_active(NodeId node) { active_ = node; }

  /// Of the shown mesh, in its own space; none without one. Kept until the mesh is another one.
  BoundingBox own_bounds(const WorkObject& object) const;

  /// Only these objects are seen, until it is called again with none. No step of the history.
  void isolate(const std::vector<NodeId>& objects);
  /// The first nodes of the only chains that are seen; empty: all are.
  const std::set<NodeId>& isolated() const { return isolated_; }

  void set_view(NodeId object, ChainView view);

  /// Whether elements are being picked (vertices, edges, faces). A chain that begins with a mesh, or has steps of
  /// edits, always has a cage; any other one, as of a sketch's solid, while this is on and it is the active one.
  void set_edits_elements(bool on);

  /// The newest result of a node that is kept evaluated: stale while the next one is computed, null before the first
  /// one. Nodes in chains are found, too, once they are computed.
  std::shared_ptr<const Evaluation> result(NodeId node) const;

  /// Some newest result isn't final, or doesn't belong to the document as it is now.
  bool busy() const { return live_.busy(); }

  /// A node evaluated beside the document, as for a preview.
  /// @param id       in the documents that it is given to follow; greater than all ids of the session's document
  /// @param changed  its result is another one
  std::unique_ptr<LiveNode> live_beside(NodeId id, std::function<void()> changed) {
    return live_.beside(id, std::move(changed));
  }

  /// The mesh that a step of edits fitted last, or null.
  std::shared_ptr<const PolyMesh> edited_input(NodeId step) const;

  void load(Document document, bool modified = false, KeptWork kept = {});

  /// One step of the history.
  /// @param dragging more values follow: they become one step of the history
  /// @param label    of that step; empty: the parameter's title, with the value where none follow
  void set_parameter(NodeId node, const std::string& name, const ParameterValue& value, bool dragging,
                     const std::string& label = {});

  /// While held, results and the progress towards them are kept back; released, they are reported at once.
  void hold_results(bool held) { live_.hold(held); }

  /// Stops what is being computed; what is there stays.
  void cancel() { live_.cancel(); }

 private:
  void follow_session();
  void list_objects();
  void list_again();

  Registry registry_;
  Evaluator evaluator_;
  Listener listener_;
  Session session_;
  std::vector<WorkObject> objects_;
  std::map<NodeId, ChainView> views_;
  std::set<NodeId> isolated_;
  mutable std::map<NodeId, std::pair<std::weak_ptr<const PolyMesh>, BoundingBox>> measured_;  ///< by the object's node
  NodeId active_ = 0;
  bool edits_elements_ = false;
  std::map<NodeId, std::shared_ptr<const PolyMesh>> edited_inputs_;  ///< see edited_input
  bool dragging_parameter_ = false;
  LiveResults live_;  ///< last: its jobs use all of the above
};

}  // namespace croquis
