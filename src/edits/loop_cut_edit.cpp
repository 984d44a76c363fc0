// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "croquis/base/error.h"
#include "edits/edit_parameters.h"
#include "edits/one_edit.h"

namespace croquis {
namespace {

class LoopCutEdit final : public Edit {
 public:
  EditDescription describe() const override {
    return {"loop-cut",
            "Loop cut",
            "Cuts the quads that lie opposite to each other across an edge, all around.",
            {ComponentKind::Edge},
            {number_parameter("at", 0.5, 0, 1, "share of the edge", "Where the edge is cut, from its first vertex.")}};
  }

  MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind /*kind*/,
                 std::span<const Index> elements, const ParameterValues& parameters) const override {
    if (elements.size() != 1) {
      throw Error(make_error(Category::Usage, "E_INPUT",
                             "A loop is cut from one edge, and " + std::to_string(elements.size()) + " are given"));
    }
    return loop_cut(mesh, topology, elements.front(), number_of(parameters, "at"));
  }
};

}  // namespace

std::unique_ptr<const Edit> make_loop_cut_edit() { return std::make_unique<LoopCutEdit>(); }

}  // namespace croquis
