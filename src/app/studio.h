// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <memory>
#include <string>

#include "croquis/document/evaluator.h"
#include "croquis/document/registry.h"
#include "croquis/session/live_evaluation.h"
#include "croquis/session/session.h"
#include "croquis/tools/sketch_tool.h"

namespace croquis::app {

/// What the window shows and edits: the session, and the solid that follows it. Lives in the window's thread.
class Studio : public QObject {
  Q_OBJECT

 public:
  Studio();
  ~Studio() override;

  Session& session() { return session_; }
  const Session& session() const { return session_; }
  const Registry& registry() const { return registry_; }

  /// The first drawing of the document; an empty one when there is none.
  const Drawing& drawing() const;
  NodeId drawing_node() const;  ///< 0 when there is none

  /// The operation whose result the views show, 0 when there is none.
  NodeId solid_node() const;
  const Node* solid_operation() const { return session_.document().find(solid_node()); }
  const OperationDescription* solid_description() const;

  /// Of the solid node: the newest result there is, stale while the next one is computed. Null before the first one.
  std::shared_ptr<const Evaluation> result() const { return result_; }
  Quality result_quality() const { return quality_; }

  /// The result's mesh, or null.
  std::shared_ptr<const PolyMesh> solid() const;

  /// What the newest result says, errors first; none before the first result.
  Findings findings() const;

  /// The newest result isn't final, or doesn't belong to the document as it is now.
  bool busy() const { return waiting_ || live_->busy(); }
  bool settled() const { return !busy(); }

  /// What a sketch tool of this studio makes with its first stroke.
  SketchToolOptions tool_options() const;

  /// Replaces the document by one drawing and the solid made of it; forgets the history.
  void start_with(Drawing drawing);
  void start_empty();
  void load(Document document, bool modified = false);

  /// @param dragging more values follow: they become one step of the history
  void set_parameter(NodeId node, const std::string& name, const ParameterValue& value, bool dragging);

  /// Stops what is being computed; the views keep what they show.
  void cancel();

 signals:
  void loaded();          ///< another document
  void changed();         ///< the document or the selection
  void result_changed();  ///< result(), findings()
  void progress_changed(double fraction, const QString& step);
  void busy_changed(bool busy);

 private:
  void follow_session();
  void evaluate();
  void take_result(std::shared_ptr<const Evaluation> result, Quality quality);

  Registry registry_;
  Evaluator evaluator_;
  Session session_;
  Document evaluated_;  ///< what the newest request was about
  std::shared_ptr<const Evaluation> result_;
  Quality quality_ = Quality::Final;
  bool drafting_ = false;  ///< the draft of the newest request hasn't come yet
  bool waiting_ = false;   ///< the document has changed since
  QElapsedTimer since_request_;
  bool dragging_parameter_ = false;
  std::unique_ptr<LiveEvaluation> live_;  ///< last: its jobs use all of the above
};

}  // namespace croquis::app
