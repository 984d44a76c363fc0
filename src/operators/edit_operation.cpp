// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/edit_operation.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/document/byte_size.h"
#include "croquis/document/connectivity.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"
#include "croquis/edits/apply_edits.h"
#include "croquis/operators/edit_result.h"

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
    return apply_edits(std::move(begun), more, all_edits(), context.progress);
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

EditResult result_of_editing(const PolyMesh& given, const EditedMesh& edited, const std::vector<EditLine>& lines) {
  EditResult result;
  for (const EditLine& line : lines) result.edits.push_back(to_text(line));
  result.connectivity = connectivity_name(given);
  result.new_vertices = count_new(edited.vertex_source);
  result.new_faces = count_new(edited.face_source);
  return result;
}

Report to_report(const EditResult& result) {
  Report details;
  details.set("edits", Report::list(result.edits))
      .set("connectivity", result.connectivity)
      .set("new_vertices", result.new_vertices)
      .set("new_faces", result.new_faces);
  return details;
}

}  // namespace

std::size_t byte_size(const EditResult& result) {
  std::size_t bytes = sizeof(EditResult) + result.connectivity.capacity();
  for (const std::string& line : result.edits) bytes += sizeof(std::string) + line.capacity();
  return bytes;
}

OperationDescription EditOperation::describe() const {
  return {"edit",
          1,
          "Edit",
          "Applies edits to a mesh, one after the other: move, extrude, inset, cut, dissolve, tag.",
          {{"mesh", ValueType::Mesh, "Polygons with their tags and attributes."}},
          {{"mesh", ValueType::Mesh, "The mesh after the last edit."},
           {"details", ValueType::Report, "The edits, and how many elements are new."}},
          {list_parameter("do", "Edits in their order: 'extrude faces=3,4 by=0,0,1'; see `croquis-cli edits`.")
               .titled("Edits"),
           text_parameter(
               "connectivity", "",
               "Refuses meshes whose faces are joined in another way, by the name in the details; empty: takes any.")
               .at(ParameterPlace::Nowhere)},
          "",
          "--do 'extrude faces=0 distance=1'",
          InputEdits{"do", "connectivity"}};
}

OperationResult EditOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                       Context& context) const {
  const PolyMesh& mesh = inputs.at("mesh").get<PolyMesh>();
  check_connectivity(mesh, text_of(parameters, "connectivity"));
  const std::vector<EditLine> lines = parse_edit_lines(text_of(parameters, "do"), all_edits());
  EditedMesh edited = edited_mesh(inputs.at("mesh"), lines, context);
  OperationResult result;
  EditResult details = result_of_editing(mesh, edited, lines);
  result.outputs["details"] = std::make_shared<const Report>(to_report(details));
  result.details = std::move(details);
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(std::move(edited.mesh));
  result.warnings = std::move(edited.warnings);
  context.progress.report(1);
  return result;
}

}  // namespace croquis
