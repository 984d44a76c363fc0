// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "croquis/document/evaluator.h"
#include "croquis/document/kept_work.h"
#include "croquis/document/registry.h"
#include "croquis/geometry/bounds.h"
#include "croquis/session/session.h"
#include "croquis/workspace/chain_edit.h"
#include "croquis/workspace/live_node.h"
#include "croquis/workspace/work_object.h"

namespace croquis {

/// A finding and the node that it is about; an error with the step that has to be mended.
struct NodeFinding {
  NodeId node = 0;
  Finding finding;
};

/// An object and where it stands or is to stand.
struct PlacedObject {
  NodeId node = 0;
  Placement placement;
};

/// What people work on: a session, and the objects that its document makes, each kept evaluated beside the thread that
/// owns the workspace. Knows no operation by its name. For one thread.
class Workspace {
 public:
  /// Bytes that undo and kept results take together, and of these undo at most: results can be
  /// computed again, steps can't.
  static constexpr std::size_t memory_cap = std::size_t{1} << 30;
  static constexpr std::size_t history_cap = memory_cap / 4 * 3;

  /// What the owner is told. Each may be empty.
  struct Listener {
    std::function<void()> loaded;          ///< another document
    std::function<void()> changed;         ///< the document or the selection
    std::function<void()> result_changed;  ///< objects(), findings()
    std::function<void(double fraction, const std::string& step)> progress;
    std::function<void(bool busy)> busy_changed;
  };

  /// @param post runs something later on the owner's thread; can be called until the destructor has returned
  Workspace(Registry registry, LiveEvaluation::Post post, Listener listener);
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  Session& session() { return session_; }
  const Session& session() const { return session_; }
  const Registry& registry() const { return registry_; }
  /// Null for none of that id.
  const OperationDescription* description(const std::string& operation) const {
    return registry_.description(operation);
  }

  /// The first operation whose chain goes on from that type of value; null for none.
  const OperationDescription* first_operation_on(ValueType type) const;

  /// All that can be the next step after a node and gives a mesh, in the registry's order.
  std::vector<const OperationDescription*> operations_on(NodeId node) const;

  // ---- Objects

  /// In the document's order, hidden ones too.
  const std::vector<WorkObject>& objects() const { return objects_; }

  /// The one that ends in this node, or has it as its cage, or has it in its chain; or null.
  const WorkObject* object(NodeId node) const;

  /// Some object has elements that can be edited.
  bool has_cage() const;

  /// The object that panels and keys are about: the selected one, else the last that was, else the first.
  const WorkObject* active() const;
  void set_active(NodeId node);

  /// The step that panels are about: the selected one of the active object, else its last one. 0 without an object.
  NodeId active_step() const;

  /// That step, when it is an operation; or null.
  const Node* active_operation() const;

  /// The last step of the object that has this operation, or null.
  const Node* step_with(const WorkObject& object, const std::string& operation) const;

  /// A node of a chain with what is known of it; it is in the document.
  ChainStep step(NodeId node) const;

  /// The steps of an object, its first node first.
  std::vector<ChainStep> steps_of(const WorkObject& object) const;

  /// A value of a type that the object's chain gives on its way, nearest to its end, moved with the steps after it and
  /// placed as the object is:
  /// the camera of a drawing in perspective, say. Without content where there is none, or where what gives it isn't
  /// computed to the end.
  Value value_along(const WorkObject& object, ValueType type) const;

  /// The objects that are selected as wholes, or some step of theirs, in the document's order: their nodes.
  std::vector<NodeId> picked() const;
  std::vector<NodeId> picked_or_active() const;  ///< where none is selected, the active one

  /// These objects and all that share a group with one of them, in the document's order.
  std::vector<NodeId> with_groups(const std::vector<NodeId>& objects) const;

  /// Of the shown mesh, in its own space; none without one. Kept until the mesh is another one.
  BoundingBox own_bounds(const WorkObject& object) const;
  /// The box around that box where the object stands.
  BoundingBox bounds(const WorkObject& object) const;

  /// The document with these objects placed so; those that share their first node go together.
  Document with_objects_placed(Document document, const std::vector<PlacedObject>& objects) const;

  /// Only these objects are seen, until it is called again with none. No step of the history.
  void isolate(const std::vector<NodeId>& objects);
  bool is_isolating() const { return !isolated_.empty(); }

  void set_view(NodeId object, ChainView view);

  /// Whether elements are being picked (vertices, edges, faces). A chain that begins with a mesh, or has steps of
  /// edits, always has a cage; any other one, as of a sketch's solid, while this is on and it is the active one.
  void set_edits_elements(bool on);

  /// The newest result of a node that is kept evaluated: stale while the next one is computed, null before the first
  /// one. Nodes in chains are found, too, once they are computed.
  std::shared_ptr<const Evaluation> result(NodeId node) const;

  /// The mesh that a node gives to the next one, as far as it is there: computed already, or a source's. Or null.
  std::shared_ptr<const PolyMesh> mesh_at(NodeId node) const;

  /// The mesh that a node of some document holds or gives, when it is computed to the end; never an older one. Or null.
  std::shared_ptr<const PolyMesh> final_mesh(const Document& document, NodeId node) const;

  /// The same, computed now if needed: for a step that is about to be added after what is computed already, as one more
  /// edit, so that everybody finds it.
  /// @throws Error what is wrong with the step
  std::shared_ptr<const PolyMesh> compute_mesh(const Document& document, NodeId node);

  /// The findings of the newest results, errors first. Of steps that wait for another one, that one's reasons.
  std::vector<NodeFinding> findings() const;

  /// Some newest result isn't final, or doesn't belong to the document as it is now.
  bool busy() const;
  bool settled() const { return !busy(); }

  /// What all kept results take.
  std::size_t result_bytes() const { return evaluator_.bytes(); }

  /// A node evaluated beside the document, as for a preview.
  /// @param id       in the documents that it is given to follow; greater than all ids of the session's document
  /// @param changed  its result is another one
  std::unique_ptr<LiveNode> live_beside(NodeId id, std::function<void()> changed);

  // ---- What people do; each is one step of the history

  void load(Document document, bool modified = false, KeptWork kept = {});

  /// Of steps of edits that don't fit their input now, and of all after them: for files.
  KeptResults kept_results() const;

  /// Adds a value as an object, and selects it. @return its node
  NodeId add_source(const std::string& name, Value value);

  /// @param dragging more values follow: they become one step of the history
  /// @param label    of that step; empty: the parameter's title, with the value where none follow
  void set_parameter(NodeId node, const std::string& name, const ParameterValue& value, bool dragging,
                     const std::string& label = {});

  void remove_objects(const std::vector<NodeId>& objects);  ///< with everything that they alone are made of
  /// The copies stand beside them along x, as far as all of them reach and a tenth more, and are selected.
  void copy_objects(const std::vector<NodeId>& objects);
  void rename_object(NodeId node, const std::string& name);
  void show_objects(const std::vector<NodeId>& objects, bool visible);
  void place_objects(const std::vector<PlacedObject>& objects);  ///< @throws Error (E_PARAMETER) for no valid place
  void group_objects(const std::vector<NodeId>& objects);        ///< they leave the groups they were in
  void ungroup_objects(const std::vector<NodeId>& objects);
  void rename_group(const std::string& group, const std::string& name);

  /// On top of an object, or after the step of it that is selected. Selects it. @return its node
  /// @throws Error (E_STEP)
  NodeId add_step(NodeId after, const std::string& operation, const ParameterValues& parameters = {});
  void remove_step(NodeId step);  ///< @throws Error (E_STEP), as do the following
  void enable_step(NodeId step, bool enabled);
  void move_step(NodeId step, int by);  ///< 1 later, -1 earlier
  void copy_step(NodeId step);
  void freeze_step(NodeId step);  ///< what it gave, or gave last, becomes a source

  /// Makes a step of edits fit the mesh that it is given now. By number: its lines stay as they are.
  /// @throws Error (E_STEP) when the mesh isn't computed yet, and (E_EDIT, E_INPUT …) when it lacks an element
  void reapply_step(NodeId step);
  /// By position: each line's elements become those nearest to where its elements were.
  /// @throws Error (E_STEP) as well when the mesh that the edits were made for isn't kept any more
  void reapply_step_by_position(NodeId step);

  // ---- Computing

  /// While held, results and the progress towards them are kept back; released, they are reported at once.
  void hold_results(bool held);

  /// Stops what is being computed; what is there stays.
  void cancel();

 private:
  void follow_session();
  void list_objects();
  void list_again();
  std::vector<NodeId> first_nodes(const std::vector<NodeId>& objects) const;
  void choose_cages();
  void fill_cages();
  void note_edited_inputs();
  NodeId chosen_step(const WorkObject& object) const;
  NodeId failing_step(NodeId step) const;
  std::shared_ptr<const PolyMesh> input_of_edits(NodeId step) const;
  void apply_edits_again(NodeId step, const std::string& lines);
  void follow_nodes(const Document& document);
  void take_live_results();
  NodeId evaluated_node(const WorkObject& object) const;
  bool begins_empty(const WorkObject& object) const;
  LiveNode& live_node(NodeId node);
  void take_results();
  const Node& step_node(NodeId step) const;
  std::string title_of(const Node& node) const;
  void edit_chain(const std::string& label, Document document, NodeId selected);
  void edit_objects(const std::string& verb, const std::vector<NodeId>& objects, Document document);

  Registry registry_;
  Evaluator evaluator_;
  LiveEvaluation::Post post_;
  Listener listener_;
  Session session_;
  std::vector<WorkObject> objects_;
  std::map<NodeId, ChainView> views_;
  std::set<NodeId> isolated_;  ///< the first nodes of the only chains that are seen; empty: all are
  struct Measured {
    std::weak_ptr<const PolyMesh> mesh;
    BoundingBox box;
  };
  mutable std::map<NodeId, Measured> measured_;  ///< by the object's node
  NodeId active_ = 0;
  bool edits_elements_ = false;
  std::map<NodeId, std::shared_ptr<const PolyMesh>> edited_inputs_;  ///< that the edits of each such step fitted last
  bool dragging_parameter_ = false;
  bool held_ = false;
  bool results_wait_ = false;                         ///< for the end of holding
  std::map<NodeId, std::unique_ptr<LiveNode>> live_;  ///< last: their jobs use all of the above
};

}  // namespace croquis
