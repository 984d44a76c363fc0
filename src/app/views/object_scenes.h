// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "app/studio/studio.h"
#include "app/views/patch_surface.h"
#include "croquis/render/mesh_item.h"
#include "croquis/render/scene.h"

namespace croquis::app {

/// The renderer's item of a mesh that changes. Small meshes are made ready at once, large ones on another
/// thread; the newest wins, and meanwhile the item before it stays.
class LiveItem : public QObject {
  Q_OBJECT

 public:
  /// Given the mesh, what is to be drawn of it (other colours); runs on any thread.
  using Paint = std::function<std::shared_ptr<const PolyMesh>(const std::shared_ptr<const PolyMesh>&)>;

  /// @param threads outlives this
  explicit LiveItem(QThreadPool& threads) : threads_(threads) {}

  /// Null shows nothing.
  /// @param look number of the paint: the same mesh in another look is a new item
  void show(const std::shared_ptr<const PolyMesh>& mesh, const render::MeshItemOptions& options,
            const Paint& paint = nullptr, int look = 0);

  const render::MeshItemPtr& item() const { return item_; }
  const std::shared_ptr<const PolyMesh>& mesh() const { return made_of_; }  ///< what item() shows
  bool busy() const { return wanted_ != made_of_ || look_ != made_look_; }

 signals:
  void ready();  ///< a large mesh's item has come

 private:
  void begin();
  void take(const std::shared_ptr<const PolyMesh>& mesh, const render::MeshItemOptions& options, int look,
            const render::MeshItemPtr& item);

  QThreadPool& threads_;
  std::shared_ptr<const PolyMesh> wanted_;
  std::shared_ptr<const PolyMesh> made_of_;
  render::MeshItemOptions options_;
  Paint paint_;
  int look_ = 0;
  int made_look_ = 0;  ///< what item() shows it in
  render::MeshItemPtr item_;
  bool making_ = false;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< expires with this: later results are ignored
};

/// How surfaces are drawn (keys 4, 5, 6).
enum class MeshLook { Wire, Shaded, ShadedWire };

/// The surfaces of the studio's objects, and their cages, made ready for the renderer.
class ObjectScenes : public QObject {
  Q_OBJECT

 public:
  ObjectScenes(Studio& studio, QObject* parent);
  ~ObjectScenes() override;

  /// Every face by its own normal.
  void set_flat(bool flat);

  /// How patches of filled holes are coloured.
  void set_patch_look(PatchLook look);

  /// What colours a computed surface gets that its mesh doesn't have: a paint, or null for none.
  using Painter = std::function<LiveItem::Paint(const WorkObject&)>;
  void set_painter(Painter painter) { painter_ = std::move(painter); }

  /// Of an object whose last operation filled holes; null for any other, and before its first result.
  const PatchSurface* patches(NodeId object) const;

  /// After the studio's objects have changed.
  void follow();

  /// What one view shows.
  struct Wanted {
    MeshLook look = MeshLook::Shaded;
    bool stale = false;     ///< what is out of date is drawn faded
    bool outlines = false;  ///< around selected objects
    bool nothing = false;
    bool only_with_cage = false;  ///< without the solid of the sketch
    NodeId edited = 0;            ///< the cage whose elements are being worked on: its edges are shown …
    bool edited_cage = true;      ///< … unless the surface alone is wanted
    NodeId replaced = 0;          ///< an object in whose place …
    render::MeshItemPtr by;       ///< … this one is shown
    std::optional<render::MeshItemPtr> instead;  ///< of all objects, and of what tools add; may be null
  };
  render::Scene scene(const Wanted& wanted) const;

  /// The surfaces alone, as pictures and thumbnails show them.
  std::vector<render::Shown<render::MeshItem>> surfaces() const;

  /// Made ready, or null.
  render::MeshItemPtr surface_item(NodeId object) const;
  render::MeshItemPtr cage_item(NodeId cage) const;

  /// Some item is still being made.
  bool busy() const;

  QThreadPool& threads() { return threads_; }

 signals:
  void changed();

 private:
  struct Items {
    std::unique_ptr<LiveItem> surface;
    std::unique_ptr<LiveItem> cage;
    bool shows_cage = false;                       ///< the surface is the cage
    std::unique_ptr<LiveItem> filling;             ///< patches, where the surface is the scan as it was
    PatchSurface patches;                          ///< of …
    std::shared_ptr<const PolyMesh> filled;        ///< … this mesh
    std::shared_ptr<const PolyMesh> filling_mesh;  ///< they, in …
    PatchLook filling_look = PatchLook::Plain;     ///< … this look
    std::vector<Index> chosen;                     ///< faces of the shown mesh that are selected by name …
    render::FaceHighlightPtr highlight;            ///< … as this item of theirs shows them
  };
  Items& items_of(NodeId node);
  void follow_patches(const WorkObject& object, Items& items);
  void highlight_chosen(const WorkObject& object, Items& items) const;

  Studio& studio_;
  bool flat_ = false;
  PatchLook patch_look_ = PatchLook::Plain;
  Painter painter_;
  QThreadPool threads_;
  mutable std::map<NodeId, Items> items_;  ///< by the object's node
};

}  // namespace croquis::app
