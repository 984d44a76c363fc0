// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/document/kept_work.h"
#include "croquis/session/selection.h"

namespace croquis {

/// Documents that people keep under names.
class Versions {
 public:
  const std::vector<Version>& list() const { return list_; }

  /// @param pictures_alone only these differ from before: what was saved stays so
  void set(std::vector<Version> list, bool pictures_alone = false);

  std::uint64_t state() const { return state_; }  ///< grows with each change
  bool modified() const { return state_ != saved_; }
  void mark_saved() { saved_ = state_; }

  std::function<void()> changed = [] {};  ///< called after each change

 private:
  std::vector<Version> list_;
  std::uint64_t state_ = 0;
  std::uint64_t saved_ = 0;
};

/// What somebody works on: the current document with its history, and what is selected.
///
/// Undo is keeping the old documents. They share what didn't change, so a step costs only what it replaced; above the
/// byte cap the oldest steps are forgotten, but never the newest. For one thread.
class Session {
 public:
  /// @param byte_cap of what the history keeps beside the current document
  /// @param find     meshes of operations, so that their elements can be selected, too
  explicit Session(Document initial = {}, std::size_t byte_cap = std::size_t{1} << 30, MeshFinder find = {});

  const Document& document() const { return now_.document; }

  /// Each document of the history has its own number, which undo and redo bring back.
  std::uint64_t state() const { return now_.state; }

  /// Grows with every change of document or selection.
  std::uint64_t revision() const { return revision_; }

  /// Makes it the document, with one undo step. The document stays when its content is that of the current one.
  /// @param components of a mesh in the edited document, that are selected with the same step; none: as before
  void edit(std::string label, Document edited, std::optional<ComponentSelection> components = std::nullopt);

  /// Between begin_drag and end_drag, many changes are one step; cancel_drag goes back to the beginning. Whatever else
  /// edits, undoes or redoes ends a drag first. A drag that changed nothing is no step.
  void begin_drag(std::string label);
  void drag(Document edited);  ///< @throws Error (E_INTERNAL) when no drag was begun
  void end_drag();
  void cancel_drag();

  bool can_undo() const { return !undo_.empty(); }
  bool can_redo() const { return !redo_.empty(); }
  void undo();  ///< also brings back what was selected then; nothing to undo is no error
  void redo();

  /// Undoes or redoes until that many steps are done, or as near to that as there are; one change for listeners.
  void go_to(std::size_t steps);

  /// A document of the history.
  struct State {
    std::uint64_t state = 0;  ///< as state() gives it while this is the current one
    Document document;
  };
  /// All of them, the oldest first: can be given to go_to by their places.
  std::vector<State> history() const;

  std::vector<std::string> undo_labels() const;  ///< oldest first: the last one is undone next
  std::vector<std::string> redo_labels() const;  ///< the first one is redone next

  const Selection& selection() const { return now_.selection; }
  void select(Selection selection);  ///< what isn't there falls out, now and with later changes

  /// Selected vertices, edges or faces of one mesh; part of undo steps like the selection of nodes. What the mesh
  /// doesn't have falls out, now and with later changes.
  const ComponentSelection& components() const { return *now_.components.selection; }
  std::shared_ptr<const ComponentSelection> shared_components() const { return now_.components.selection; }
  void select_components(ComponentSelection components);

  /// Computed meshes are there now that may be others than before: what they don't have falls out.
  void check_components();

  Versions versions;  ///< no part of the history; its changes are reported as those of the document

  /// Whether the document isn't the one last saved or loaded, right across undo and redo, or the versions aren't.
  bool modified() const { return now_.state != saved_state_ || versions.modified(); }
  void mark_saved();

  /// Another document, without selection.
  /// @param modified for recovered work, which no file holds yet
  /// @param past     that undo leads back to
  void load(Document document, bool modified = false, std::vector<PastDocument> past = {},
            std::vector<Version> kept = {});

  /// Called after every change, on the same thread; several are called in the order they came. They may use the
  /// session.
  void on_change(std::function<void()> listener);

  /// What the history keeps beside the current document. See croquis::byte_size.
  std::size_t history_bytes() const;

 private:
  /// A document to come back to.
  struct Step {
    std::string label;
    Document document;
    Selection selection;
    KeptComponents components{std::make_shared<const ComponentSelection>(), 0, 0};
    std::uint64_t state = 0;
    std::size_t bytes = 0;  ///< what it keeps alive beside its neighbour towards the current document
  };

  void show(Step step);
  void report_change();

  Step now_;               ///< its label has no meaning
  std::deque<Step> undo_;  ///< next one last
  std::deque<Step> redo_;  ///< next one last
  std::optional<Step> drag_;
  MeshFinder find_mesh_;
  std::size_t byte_cap_;
  std::uint64_t revision_ = 0;
  std::uint64_t saved_state_ = 0;
  std::uint64_t last_state_ = 0;
  std::vector<std::function<void()>> listeners_;
};

/// What undo leads back to in that many steps, at most; the oldest first.
std::vector<PastDocument> past_of(const Session& session, std::size_t most);

}  // namespace croquis
