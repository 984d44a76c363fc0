// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/studio/face_sets.h"
#include "app/studio/live_node.h"
#include "app/studio/studio_object.h"
#include "croquis/document/evaluator.h"
#include "croquis/document/registry.h"
#include "croquis/session/session.h"
#include "croquis/tools/silhouette/sketch_tool.h"

namespace croquis::app {

/// A finding and the node that it is about.
struct NodeFinding {
  NodeId node = 0;
  Finding finding;
};

/// What the window shows and edits: the session, and the objects that follow it, each evaluated by itself. Lives in
/// the window's thread.
class Studio : public QObject {
  Q_OBJECT

 public:
  /// Bytes that undo and kept results take together, and of these undo at most: results can be
  /// computed again, steps can't.
  static constexpr std::size_t memory_cap = std::size_t{1} << 30;
  static constexpr std::size_t history_cap = memory_cap / 4 * 3;

  Studio();
  ~Studio() override;

  Session& session() { return session_; }
  const Session& session() const { return session_; }
  const Registry& registry() const { return registry_; }
  Evaluator& evaluator() { return evaluator_; }

  /// In the document's order, hidden ones too.
  const std::vector<StudioObject>& objects() const { return objects_; }
  const StudioObject* object(NodeId node) const;  ///< the one that ends in this node or has it as its cage; or null

  /// The object that panels and keys are about: the selected one, else the last that was, else the first.
  const StudioObject* active() const;
  void set_active(NodeId node);

  /// Of the active object, when it is an operation.
  const Node* active_operation() const;
  const OperationDescription* description(const std::string& operation) const;  ///< null for none of that id

  /// Named faces of an object. Selected as parts of its node by their names.
  FaceSets& face_sets() { return face_sets_; }

  void set_view(NodeId object, SmoothView view);

  // The sketch: one drawing, and the solid made of it.

  /// The first drawing of the document; an empty one when there is none.
  const Drawing& drawing() const;
  NodeId drawing_node() const;  ///< 0 when there is none
  NodeId solid_node() const;    ///< 0 when there is none
  const Node* solid_operation() const { return session_.document().find(solid_node()); }
  const OperationDescription* solid_description() const;

  /// Of the solid node: the newest result there is, stale while the next one is computed. Null before the first one.
  std::shared_ptr<const Evaluation> result() const;
  std::shared_ptr<const PolyMesh> solid() const;  ///< its mesh, or null

  /// What a sketch tool of this studio makes with its first stroke.
  SketchToolOptions tool_options() const;

  /// The findings of the newest results, errors first.
  std::vector<NodeFinding> findings() const;

  /// Some newest result isn't final, or doesn't belong to the document as it is now.
  bool busy() const;
  bool settled() const { return !busy(); }

  /// Replaces the document by one drawing and the solid made of it; forgets the history.
  void start_with(Drawing drawing);
  void start_empty();
  void load(Document document, bool modified = false);

  /// Adds a mesh as an object, and selects it. @return its node
  NodeId add_mesh(const std::string& name, std::shared_ptr<const PolyMesh> mesh);

  /// @param dragging more values follow: they become one step of the history
  void set_parameter(NodeId node, const std::string& name, const ParameterValue& value, bool dragging);

  /// Takes an object away with everything that it alone is made of.
  void remove_object(NodeId node);
  void rename_object(NodeId node, const std::string& name);
  void show_object(NodeId node, bool visible);

  /// While held, results and the progress towards them are kept back; released, they are signalled at once.
  void hold_results(bool held);

  /// Stops what is being computed; the views keep what they show.
  void cancel();

 signals:
  void loaded();          ///< another document
  void changed();         ///< the document or the selection
  void result_changed();  ///< objects(), result(), findings()
  void progress_changed(double fraction, const QString& step);
  void busy_changed(bool busy);

 private:
  void follow_session();
  void list_objects();
  bool wants_evaluation(const StudioObject& object) const;
  LiveNode& live_node(NodeId node);
  void take_results();

  Registry registry_;
  Evaluator evaluator_;
  Session session_;
  std::vector<StudioObject> objects_;
  std::map<NodeId, SmoothView> views_;
  FaceSets face_sets_;
  NodeId active_ = 0;
  std::map<std::string, OperationDescription> descriptions_;
  bool dragging_parameter_ = false;
  bool held_ = false;
  bool results_wait_ = false;                         ///< for the end of holding
  std::map<NodeId, std::unique_ptr<LiveNode>> live_;  ///< last: their jobs use all of the above
};

}  // namespace croquis::app
