// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "croquis/base/described.h"
#include "croquis/base/error.h"
#include "croquis/document/byte_size.h"
#include "croquis/document/connectivity.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"
#include "croquis/edits/apply_edits.h"
#include "operators/operations.h"

namespace croquis {
namespace {

void check_connectivity(const PolyMesh& mesh, const std::string& expected) {
  if (expected.empty() || expected == connectivity_name(mesh)) return;
  throw Error(make_error(Category::Geometry, connectivity_code,
                         "These edits were made for a mesh with other faces: apply them to the new mesh by the "
                         "nearest places, or keep the shape.",
                         {{SubjectKind::Parameter, "connectivity", {}, {}, {}}}));
}

std::size_t count_new(const std::vector<Index>& sources) {
  return static_cast<std::size_t>(std::count(sources.begin(), sources.end(), no_index));
}

std::size_t bytes_of(const EditedMesh& edited) {
  const std::shared_ptr<const PolyMesh> mesh(std::shared_ptr<const void>(), &edited.mesh);  // owns nothing
  return byte_size(Value(mesh)) + byte_size(edited.warnings) +
         (edited.vertex_source.capacity() + edited.face_source.capacity()) * sizeof(Index);
}

ContentHash hash_of_edits(const Value& mesh, const std::vector<EditLine>& lines) {
  ContentHasher hasher;
  hasher.add(std::string_view("edit 1 lines"));
  hasher.add(content_hash(mesh));
  hasher.add(std::string_view(to_text(lines)));
  return hasher.digest();
}

/// People add one line after the other, and drags replace the last one: what is before it is kept.
EditedMesh edited_mesh(const Value& mesh, const std::vector<EditLine>& lines, Context& context) {
  const auto apply = [&](auto begun, std::span<const EditLine> more) {
    return apply_edits(std::move(begun), more, context.progress);
  };
  if (context.memo == nullptr || lines.size() < 2) return apply(mesh.get<PolyMesh>(), lines);
  std::vector<EditLine> before(lines.begin(), lines.end() - 1);
  const ContentHash key = hash_of_edits(mesh, before);
  auto begun = context.memo->find<EditedMesh>(key);
  if (!begun) {
    const EditLine last = before.back();
    before.pop_back();
    const auto earlier = before.empty() ? nullptr : context.memo->find<EditedMesh>(hash_of_edits(mesh, before));
    before.push_back(last);
    auto made = std::make_shared<const EditedMesh>(earlier ? apply(*earlier, std::span(&last, 1))
                                                           : apply(mesh.get<PolyMesh>(), before));
    begun = context.memo->keep<EditedMesh>(key, made, bytes_of(*made));
  }
  return apply(*begun, std::span(&lines.back(), 1));
}

struct EditSettings {
  std::vector<EditLine> lines;
  std::string connectivity;  ///< that the mesh has to have; empty: any
};

void list_edit_parameters(EditSettings& settings, ParameterList& list) {
  list.list("do", "Edits in their order: 'extrude faces=3,4 by=0,0,1'; see `croquis-cli edits`.",
            [&](const std::string& text) { settings.lines = parse_edit_lines(text); })
      .titled("Edits");
  list.text("connectivity", "",
            "Refuses meshes whose faces are joined in another way, by the name in the details; empty: takes any.",
            [&](const std::string& name) { settings.connectivity = name; })
      .at(ParameterPlace::Nowhere);
}

OperationResult compute_edit(const Values& inputs, EditSettings settings, Context& context) {
  const PolyMesh& mesh = inputs.at("mesh").get<PolyMesh>();
  check_connectivity(mesh, settings.connectivity);
  EditedMesh edited = edited_mesh(inputs.at("mesh"), settings.lines, context);
  OperationResult result;
  std::vector<std::string> edits;
  for (const EditLine& line : settings.lines) edits.push_back(to_text(line));
  result.outputs["details"] = std::make_shared<const Report>(to_report(fields(
      named("edits", edits), named("connectivity", connectivity_name(mesh)),
      named("new_vertices", count_new(edited.vertex_source)), named("new_faces", count_new(edited.face_source)))));
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(std::move(edited.mesh));
  result.warnings = std::move(edited.warnings);
  context.progress.report(1);
  return result;
}

}  // namespace

std::unique_ptr<const Operation> edit_operation() {
  return operation_of({"edit",
                       1,
                       "Edit",
                       "Applies edits to a mesh, one after the other: move, extrude, inset, cut, dissolve, tag.",
                       {{"mesh", ValueType::Mesh, "Polygons with their tags and attributes."}},
                       {{"mesh", ValueType::Mesh, "The mesh after the last edit."},
                        {"details", ValueType::Report, "The edits, and how many elements are new."}},
                       {},
                       "",
                       "--do 'extrude faces=0 distance=1'",
                       InputEdits{"do", "connectivity"}},
                      list_edit_parameters, compute_edit);
}

}  // namespace croquis
