// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/content.h"

#include <cmath>
#include <utility>

#include "croquis/tools/backdrop/backdrop_editor.h"

namespace croquis::app {
namespace {

constexpr double first_opacity = 0.7;  // of a picture: strokes over it are seen well

}  // namespace

void start_with(Studio& studio, Drawing drawing) {
  studio.load(add_drawing(Document(), std::make_shared<const Drawing>(std::move(drawing)), studio.tool_options()));
}

void start_with(Studio& studio, PerspectiveDrawing drawing, const std::string& name) {
  PerspectiveToolOptions options = studio.sheet_options();
  if (!name.empty()) options.name = name;
  studio.load(add_perspective_drawing(Document(), std::move(drawing), options));
}

void start_with(Studio& studio, AttributeNetwork network, const std::string& name) {
  SurfaceToolOptions options = studio.network_options();
  if (!name.empty()) options.name = name;
  studio.load(studio.with_network(Document(), std::move(network), options));
}

void start_with(Studio& studio, const std::string& name, Value value, const std::string& operation) {
  Node source;
  source.name = name;
  source.source = std::move(value);
  const Document document = Document().with(std::move(source));
  studio.load(with_step(document, studio.registry(), document.nodes().front()->id, operation).document);
}

void add_picture(Studio& studio, std::shared_ptr<const PictureFile> picture) {
  Document document = studio.session().document();
  const bool is_empty = document.nodes().empty();
  const bool is_first = is_empty && !studio.begun();
  NodeId drawing = studio.shown_drawing();
  if (drawing == 0) {
    drawing = document.next_id();
    PerspectiveToolOptions options = studio.sheet_options();
    options.name = free_name(document, options.name);
    document = is_empty && studio.begun()
                   ? add_drawing(document, std::make_shared<const Drawing>(), studio.tool_options())
                   : add_perspective_drawing(document, empty_sheet(sheet_for(*picture)), options);
  }
  const auto sheet = source_of<PerspectiveDrawing>(document.find(drawing));
  if (sheet && sheet->strokes.empty()) {
    Node resized = *document.find(drawing);
    PerspectiveDrawing fitting = *sheet;
    fitting.image_size = sheet_for(*picture);
    resized.source = std::make_shared<const PerspectiveDrawing>(std::move(fitting));
    document = document.with(std::move(resized));
  }
  const Node& node = *document.find(drawing);
  const bool replaces = node.backdrop && !(sheet && sheet->strokes.empty());
  Backdrop backdrop = fitted(std::move(picture), replaces ? area_of(*node.backdrop) : backdrop_area(node));
  backdrop.opacity = node.backdrop ? node.backdrop->opacity : first_opacity;
  document = with_backdrop(document, drawing, backdrop);
  if (is_first) return studio.load(std::move(document));
  studio.session().edit("Add picture", std::move(document));
  studio.session().select({{drawing, ""}});
}

void add_traced(Studio& studio, std::shared_ptr<const Drawing> drawing) {
  Document document = studio.session().document();
  const bool is_first = document.nodes().empty() && !studio.begun();
  NodeId node = studio.drawing_node();
  const auto sketch = source_of<Drawing>(document.find(node));
  if (studio.sheet_node() == 0 && sketch && sketch->strokes.empty()) {
    Node filled = *document.find(node);
    filled.source = std::move(drawing);
    document = document.with(std::move(filled));
  } else {
    node = document.next_id();
    SketchToolOptions options = studio.tool_options();
    options.name = free_name(document, options.name);
    document = add_drawing(document, std::move(drawing), options);
  }
  if (is_first) return studio.load(std::move(document));
  studio.session().edit("Trace picture", std::move(document));
  studio.session().select({{node, ""}});
}

void state_camera(Studio& studio, const Camera& camera) {
  Document document = studio.session().document();
  NodeId drawing = studio.sheet_node();
  const bool is_first = drawing == 0 && document.nodes().empty();
  if (drawing == 0) {
    drawing = document.next_id();
    PerspectiveToolOptions options = studio.sheet_options();
    options.name = free_name(document, options.name);
    document = add_perspective_drawing(document, empty_sheet(camera.image_size), options);
  }
  Node edited = *document.find(drawing);
  PerspectiveDrawing stated = *source_of<PerspectiveDrawing>(&edited);
  const Vec2 share = stated.image_size.cwiseQuotient(camera.image_size);
  stated.field_of_view = 2 * std::atan(camera.image_size.x() / (2 * camera.focal_length));
  stated.principal_point = stated.origin + share.cwiseProduct(camera.principal_point - camera.image_origin);
  edited.source = std::make_shared<const PerspectiveDrawing>(std::move(stated));
  document = document.with(std::move(edited));
  if (is_first) return studio.load(std::move(document));
  studio.session().edit("State the camera", std::move(document));
  studio.session().select({{drawing, ""}});
}

ParameterValues first_parameters(const Studio& studio, const std::string& operation) {
  const SketchToolOptions sketches = studio.tool_options();
  return operation == sketches.operation ? sketches.parameters : ParameterValues();
}

}  // namespace croquis::app
