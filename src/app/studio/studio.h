// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "croquis/session/selection.h"
#include "croquis/tools/perspective/perspective_tool.h"
#include "croquis/tools/silhouette/sketch_tool.h"
#include "croquis/tools/surface/surface_tool.h"
#include "croquis/workspace/computed.h"
#include "croquis/workspace/object_commands.h"
#include "croquis/workspace/object_names.h"
#include "croquis/workspace/step_commands.h"
#include "croquis/workspace/work_object.h"

namespace croquis::app {

/// Faces of an object that have a name: all patches that closed its holes, and each of them.
struct FaceSet {
  std::string name;          ///< "patches", "patch of hole 3", "patch of holes 3, 7"; of a mesh by itself "patch 3"
  std::vector<Index> holes;  ///< that the patch closes, as far as that is known
  std::vector<Index> faces;  ///< of the object's mesh, ascending
};

/// The sets of objects, read from the channel "patch_id" of their meshes. They are there as long as the patches are: in
/// projects and files with them. Kept until a mesh changes. One thread.
class FaceSets {
 public:
  /// Which holes each patch of an object closes, by its number; as far as that is known.
  using HolesOfPatches = std::function<std::map<std::int32_t, std::vector<Index>>(const WorkObject&)>;
  void set_holes(HolesOfPatches holes) { holes_ = std::move(holes); }

  void clear() { known_.clear(); }

  /// All patches first, then each by its lowest hole or number; none without patches. O(faces) for a new mesh.
  const std::vector<FaceSet>& of(const WorkObject& object);

  /// Of the sets that are selected as parts of the object, ascending.
  std::vector<Index> selected(const WorkObject& object, const Selection& selection);

 private:
  struct Known {
    std::shared_ptr<const PolyMesh> mesh;
    std::shared_ptr<const Evaluation> result;
    std::vector<FaceSet> sets;
  };
  std::vector<FaceSet> sets_of(const WorkObject& object) const;

  HolesOfPatches holes_;
  std::map<NodeId, Known> known_;
};

/// The workspace of a window, as Qt's objects hear of it. Lives in the window's thread.
class Studio : public QObject, public Workspace {
  Q_OBJECT

 public:
  Studio();
  ~Studio() override;

  /// Named faces of an object. Selected as parts of its node by their names.
  FaceSets& face_sets() { return face_sets_; }

  // The sketch worked on: a drawing, and the first solid in the chain that begins with it.

  /// The drawing of the active object, else the one that was worked on last, else the first; empty when there is none.
  const Drawing& drawing() const;

  /// The perspective drawing of the active object; 0 when it doesn't begin with one. Then the sketch view is its sheet.
  NodeId sheet_node() const;
  /// The network of curves that the active object begins with; 0 when it doesn't.
  NodeId network_node() const;
  NodeId drawing_node() const;  ///< 0 when there is none
  /// What the sketch view shows: the sheet, else the sketch; 0 when there is neither.
  NodeId shown_drawing() const { return sheet_node() != 0 ? sheet_node() : drawing_node(); }
  NodeId solid_node() const;  ///< 0 when there is none
  const Node* solid_operation() const { return session().document().find(solid_node()); }

  /// Of the solid node: the newest result there is, stale while the next one is computed. Null before the first one.
  std::shared_ptr<const Evaluation> result() const;
  using Workspace::result;
  std::shared_ptr<const PolyMesh> solid() const;  ///< its mesh, or null

  /// What a sketch tool of this studio makes with its first stroke.
  SketchToolOptions tool_options() const;
  PerspectiveToolOptions sheet_options() const;  ///< the same for drawings in perspective
  SurfaceToolOptions network_options() const;    ///< the same for networks of curves

  /// The unit of lengths that the first drawing or network of the document names that names one: "mm"; else empty.
  std::string unit() const;

  /// The document with a network and its surfaces. Networks have z upwards; what is made of them stands upright.
  Document with_network(const Document& document, AttributeNetwork network, const SurfaceToolOptions& options) const;

  /// Some document was begun or opened.
  bool begun() const { return begun_; }

 signals:
  void loaded();          ///< another document
  void changed();         ///< the document or the selection
  void result_changed();  ///< objects(), result(), findings()
  void progress_changed(double fraction, const QString& step);
  void busy_changed(bool busy);

 private:
  static Listener listener_of(Studio* studio);
  void follow_sketch();

  FaceSets face_sets_;
  NodeId sketch_ = 0;  ///< that was worked on last
  bool begun_ = false;
};

}  // namespace croquis::app
