// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/studio/studio.h"
#include "app/views/object_scenes.h"
#include "app/views/patch_surface.h"
#include "croquis/operators/fill_result.h"
#include "croquis/operators/hole_requests.h"

namespace croquis::app {

// The filling of the active object's holes: an operation at the end of its chain, of which everything is a parameter.
// Every change is one step of the history.

/// The operation's id.
inline const std::string filling_operation = "fill";

/// Of the active object, or null where its last operation isn't `fill`.
const Node* filling_node(const Studio& studio);

/// The active object has a mesh whose holes can be looked at.
bool can_fill(const Studio& studio);

/// Gives the active object the operation, with no hole chosen, unless it has it.
/// @throws Error (E_EMPTY) when there is no mesh
void start_filling(Studio& studio);

/// The value of a parameter of the node, else that of its preset, else the default.
ParameterValue filling_value(const Studio& studio, const Node& node, const std::string& parameter);

/// The document with other values of that node.
Document with_values(const Studio& studio, const Node& node, const ParameterValues& values);

// The holes that the result of `fill` has, as lists and views show them.

/// Of a result of `fill`; empty for any other, and for null.
std::vector<HoleRow> hole_rows(const Evaluation* result);

/// Ids of those that a selection for all holes names. @param max_diameter as FillOptions has it
std::vector<Index> named_rows(const std::vector<HoleRow>& rows, hole_filling::Selection selection,
                              double max_diameter = std::numeric_limits<double>::infinity());

/// These, and the islands in them or the holes around them: one without the other leaves the island cut off, or its
/// patch in the way. Ascending.
std::vector<Index> with_islands(const std::vector<HoleRow>& rows, const std::vector<Index>& holes);

/// "3", "3–5, 9" …: at most a few, then how many more.
QString numbers_of(const std::set<Index>& holes);

/// The parameters of a `fill` operation per hole, so that one hole can be changed without touching the others, and
/// joined again.
class HolePlan {
 public:
  HolePlan() = default;

  /// @throws Error (E_PARAMETER) when the requests can't be parsed
  HolePlan(const Studio& studio, const Node& node);

  /// Of one hole alone; empty when nothing is asked.
  HoleRequest request(Index hole) const;
  const std::vector<HoleRequest>& bridges() const { return bridges_; }
  bool is_bridged(Index hole) const;

  void fill(std::span<const Index> holes);

  /// Fills what a selection of all fills, whatever single holes were given; how they are made stays.
  /// @param open holes that stay open then: what is asked of their shape alone would fill them
  void fill_all(hole_filling::Selection select, std::span<const Index> open);

  /// What was asked of them goes away; those that would be filled with others are left.
  void reopen(std::span<const Index> holes);

  /// Those that hold one of the holes are no more; what else was asked of holes stays.
  void part_bridges(std::span<const Index> holes);

  /// One patch joins the rims.
  void bridge(std::span<const Index> holes);

  /// Changes how holes are made. Open ones stay open. @param filled ids of those that are filled now, sorted
  template <typename Change>
  void change(std::span<const Index> holes, std::span<const Index> filled, Change&& change_request) {
    for (const Index hole : holes) {
      HoleRequest& changed = entry(hole);
      change_request(changed);
      keep_as_is(changed, filled);
    }
    forget_empty();
  }

  /// The parameters that are to be set.
  ParameterValues values() const;

 private:
  HoleRequest& entry(Index hole);
  static void keep_as_is(HoleRequest& request, std::span<const Index> filled);
  void forget_empty();

  FillChoice choice_;  ///< without its requests, which follow
  std::map<Index, HoleRequest> single_;
  std::vector<HoleRequest> bridges_;
};

/// How open holes would be filled, kept computed beside the document: nothing of it is in there.
class PatchPreview : public QObject {
  Q_OBJECT

 public:
  PatchPreview(Studio& studio, QThreadPool& threads, QObject* parent);

  /// Shows the patches that these holes would get. @param node of the operation; 0 or no holes: nothing
  void show(NodeId node, std::vector<Index> holes);

  /// After the document has changed.
  void follow();

  const render::MeshItemPtr& item() const { return item_.item(); }
  const std::vector<Index>& holes() const { return holes_; }
  const PatchSurface& patches() const { return patches_; }    ///< that item() shows
  const std::vector<HoleRow>& rows() const { return rows_; }  ///< of the result with them
  bool busy() const { return (live_ && live_->busy()) || item_.busy(); }

  /// Milliseconds from the last request to the patches that answered it.
  double last_latency_ms() const { return latency_ms_; }

 signals:
  void changed();

 private:
  void take();
  void forget();

  Studio& studio_;
  LiveItem item_;
  NodeId node_ = 0;
  std::vector<Index> holes_;
  QElapsedTimer since_;
  double latency_ms_ = 0;
  std::shared_ptr<const Evaluation> shown_;
  PatchSurface patches_;
  std::vector<HoleRow> rows_;
  std::unique_ptr<LiveNode> live_;  ///< last: its jobs use all of the above
};

}  // namespace croquis::app
