// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/document/document.h"
#include "croquis/document/registry.h"

/// What people do to the steps of chains, as functions from a document to the edited one. They name steps and objects
/// in their errors as the document does.
namespace croquis {

/// A document with a node that was added to it.
struct AddedNode {
  Document document;
  NodeId node = 0;
};

/// A step of that operation after a node. What used the node's main output uses the step, where its type allows that;
/// so a step after the end of a chain is the new end.
/// @param id of a node that gives a value
/// @throws Error (E_STEP) when the operation isn't known or doesn't take what the node gives
AddedNode with_step(const Document& document, const Registry& registry, NodeId id, const std::string& operation,
                    const ParameterValues& parameters = {});

/// Without the step: what used it uses what it was made from.
/// @throws Error (E_STEP) for a source, and when a later step can't work on what is before this one
Document without_step(const Document& document, const Registry& registry, NodeId id);

/// Without the object that ends in this node: its whole chain, and all else that nothing but this chain uses.
Document without_object(const Document& document, NodeId end);

/// Whether there is such a step and it gives what it takes.
bool can_be_off(const Document& document, const Registry& registry, NodeId id);

/// The step does nothing while it is off: the next one works on what is before it.
/// @throws Error (E_STEP) for a source, and for a step that gives another type than it takes
Document with_step_enabled(const Document& document, const Registry& registry, NodeId id, bool enabled);

/// The step one place later in its chain (by 1) or earlier (by -1).
/// @throws Error (E_STEP) when it has no such place or the types don't allow it
Document with_step_moved(const Document& document, const Registry& registry, NodeId id, int by);

/// A step like this one, after it.
/// @throws Error (E_STEP) as with_step
AddedNode with_step_copied(const Document& document, const Registry& registry, NodeId id);

/// A second object like the one that ends in this node; both are made of values that they share, and live on their own.
/// @return the end of the new chain
AddedNode with_object_copied(const Document& document, NodeId end);

/// The step becomes a source that holds what it gave; steps before it that nothing else uses go. Its id, name and
/// later steps stay.
Document with_step_frozen(const Document& document, const Registry& registry, NodeId id, Value value);

}  // namespace croquis
