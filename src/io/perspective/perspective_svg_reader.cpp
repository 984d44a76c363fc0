// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/base/limits.h"
#include "croquis/io/perspective_drawing_file.h"
#include "io/perspective/perspective_strokes.h"
#include "io/svg/svg_shapes.h"
#include "io/svg/svg_walk.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr double straight_tolerance = 4e-4;  // × diagonal of the sheet; half a pixel of an ordinary one

/// Exactly so many numbers, separated as SVG allows.
template <std::size_t N>
std::optional<std::array<double, N>> numbers_of(std::string_view text) {
  SvgScanner scanner(text);
  std::array<double, N> result;
  for (double& value : result) {
    scanner.skip_separators();
    const std::optional<double> number = scanner.number();
    if (!number || !is_usable_number(*number)) return std::nullopt;
    value = *number;
  }
  scanner.skip_blanks();
  return scanner.at_end() ? std::optional(result) : std::nullopt;
}

std::optional<bool> flag_of(std::string_view word) {
  if (word == "true" || word == "1") return true;
  if (word == "false" || word == "0") return false;
  return std::nullopt;
}

bool is_layer_named(const pugi::xml_node& node, std::string_view beginning) {
  return svg_local_name(node) == "g" && lower_case(node.attribute("inkscape:label").value()).starts_with(beginning);
}

class PerspectiveSvgReader : public SvgVisitor {
 public:
  PerspectiveSvgReader(std::string_view bytes, const std::string& file, Progress& progress)
      : walk_(bytes, file, progress) {
    drawing_.file = file;
  }

  PerspectiveReadResult read() {
    const pugi::xml_node root = walk_.parse();
    find_prefix(root);
    classes_.read(root);
    walk_.visit(root, *this);
    if (drawing_.strokes.empty() && !walk_.limit_reached()) {
      walk_.findings().file_error(
          Category::Malformed, "E_NO_STROKES",
          "The drawing has no visible path, line or other shape: there is nothing to make a solid of");
    }
    walk_.findings().stop_on_errors();
    read_sheet(root);
    read_metadata(root);
    for (PerspectiveStroke& stroke : drawing_.strokes) straighten(stroke, straight_tolerance * drawing_.diagonal());
    return {std::move(drawing_), walk_.findings().take()};
  }

  void enter(const pugi::xml_node&) override {}

  void add(SvgShownShape shape) override {
    PerspectiveStroke stroke;
    stroke.line = shape.line;
    read_attributes(shape, stroke);
    int number = 0;
    const auto add_pieces = [&](std::vector<PictureCubic> pieces, bool straight) {
      const std::string wanted = shape.id + '/' + std::to_string(++number);
      stroke.id = number == 1 ? shape.id : walk_.unique_name(wanted, shape.line);
      stroke.pieces = std::move(pieces);
      stroke.straight = straight;
      const std::size_t bytes = stroke.id.size() + stroke.colour.size() + stroke.from.size() + stroke.to.size();
      if (walk_.count_pieces(stroke.pieces.size(), bytes, shape.line)) drawing_.strokes.push_back(stroke);
      return !walk_.limit_reached();
    };
    // A coordinate that isn't finite would take the other one with it.
    const bool moves_nothing = shape.map.matrix() == Eigen::Matrix3d::Identity();
    for (SvgSubpath& subpath : shape.subpaths) {
      if (!moves_nothing) transform(subpath, shape.map);
      if (!add_subpath(subpath, add_pieces)) return;
    }
  }

 private:
  template <typename AddPieces>
  bool add_subpath(const SvgSubpath& subpath, const AddPieces& add_pieces) {
    if (subpath.segments.empty()) return add_pieces({straight_piece(subpath.start, subpath.start)}, true);
    const bool single = subpath.segments.size() == 1;
    const bool straight = single && subpath.segments[0].kind == SvgSegment::Kind::Line;
    const bool loop = single && subpath.segments[0].kind == SvgSegment::Kind::Cubic && subpath.last() == subpath.start;
    const bool apart = subpath.closed && !straight && !loop;
    std::vector<PictureCubic> whole;
    Vec2 from = subpath.start;
    for (const SvgSegment& segment : subpath.segments) {
      for (const PictureCubic& piece : cubics_of(segment, from)) {
        if (!apart) whole.push_back(piece);
        if (apart && !add_pieces({piece}, segment.kind == SvgSegment::Kind::Line)) return false;
      }
      from = segment.end;
    }
    if (!apart) return add_pieces(std::move(whole), straight);
    return from == subpath.start || add_pieces({straight_piece(from, subpath.start)}, true);
  }

  void find_prefix(const pugi::xml_node& root) {
    for (const pugi::xml_attribute& attribute : root.attributes()) {
      const std::string_view name = attribute.name();
      if (name.starts_with("xmlns:") && std::string_view(attribute.value()) == perspective_namespace) {
        prefix_ = std::string(name.substr(6)) + ':';
      }
    }
  }

  std::string_view own(const pugi::xml_node& node, const char* name) const {
    return node.attribute((prefix_ + name).c_str()).value();
  }

  /// Of the element or the nearest one around it that has the attribute.
  std::string_view inherited(pugi::xml_node node, const char* name) const {
    const std::string full = prefix_ + name;
    for (; node; node = node.parent()) {
      if (const pugi::xml_attribute attribute = node.attribute(full.c_str())) return attribute.value();
    }
    return {};
  }

  void warn_of_value(const SvgShownShape& shape, const char* name, std::string_view value) {
    walk_.findings().stroke_warning("W_VALUE",
                                    "Stroke " + in_quotes(shape.id) + " has " + prefix_ + name + "=" +
                                        in_quotes(value) + ", which isn't understood and was ignored",
                                    shape.id, shape.line);
  }

  /// Takes over an attribute's value if it is there and understood.
  template <typename T>
  void take(const SvgShownShape& shape, const char* name, std::string_view value, std::optional<T> understood,
            T& target) {
    if (value.empty()) return;
    if (!understood) return warn_of_value(shape, name, value);
    target = *understood;
  }

  void read_attributes(const SvgShownShape& shape, PerspectiveStroke& stroke) {
    const pugi::xml_node& node = shape.node;
    stroke.role = drawn_role(node);
    take(shape, "role", inherited(node, "role"), role_of(inherited(node, "role")), stroke.role);
    stroke.hidden = is_in_layer(node, "hidden");
    take(shape, "hidden", inherited(node, "hidden"), flag_of(inherited(node, "hidden")), stroke.hidden);
    take(shape, "link", own(node, "link"), flag_of(own(node, "link")), stroke.link);
    take(shape, "start-lock", own(node, "start-lock"), lock_of(own(node, "start-lock")), stroke.start_lock);
    take(shape, "end-lock", own(node, "end-lock"), lock_of(own(node, "end-lock")), stroke.end_lock);
    stroke.from = own(node, "from");
    stroke.to = own(node, "to");
    read_weight(shape, stroke);
    read_group(shape, stroke);
  }

  void read_weight(const SvgShownShape& shape, PerspectiveStroke& stroke) {
    const std::string_view text = own(shape.node, "weight");
    const auto numbers = numbers_of<1>(text);
    const bool positive = numbers && (*numbers)[0] > 0;
    take(shape, "weight", text, positive ? std::optional((*numbers)[0]) : std::nullopt, stroke.weight);
  }

  void read_group(const SvgShownShape& shape, PerspectiveStroke& stroke) {
    stroke.colour = classes_.inherited(shape.node, "stroke");
    if (stroke.colour == "none") stroke.colour.clear();
    const StrokeGroup by_colour = group_of_colour(stroke.colour);
    const std::string_view word = inherited(shape.node, "group");
    std::optional<StrokeGroup> stated;
    if (word == "unknown") stated = StrokeGroup::Unknown;
    if (word.size() == 1 && word[0] >= '0' && word[0] <= '5') stated = static_cast<StrokeGroup>(word[0] - '0');
    stroke.group = by_colour;
    take(shape, "group", word, stated, stroke.group);
    const bool both =
        stated.value_or(StrokeGroup::Unknown) != StrokeGroup::Unknown && by_colour != StrokeGroup::Unknown;
    if (both && *stated != by_colour) {
      walk_.findings().stroke_note("GROUP_COLOUR",
                                   "Stroke " + in_quotes(shape.id) + " is of group " + std::string(word) +
                                       " although its colour is that of group " +
                                       std::to_string(static_cast<int>(by_colour)) +
                                       ": change one of them if that isn't meant",
                                   shape.id, shape.line);
    }
    if (lower_case(stroke.colour) == lower_case(colour_of_group(stroke.group))) stroke.colour.clear();
  }

  static bool is_in_layer(pugi::xml_node node, std::string_view beginning) {
    for (; node; node = node.parent()) {
      if (is_layer_named(node, beginning)) return true;
    }
    return false;
  }

  StrokeRole drawn_role(const pugi::xml_node& node) const {
    const std::string dashes = classes_.inherited(node, "stroke-dasharray");
    const bool dashed = !dashes.empty() && dashes != "none";
    return dashed || is_in_layer(node, "construction") ? StrokeRole::Construction : StrokeRole::Edge;
  }

  void read_sheet(const pugi::xml_node& root) {
    const auto box = numbers_of<4>(root.attribute("viewBox").value());
    if (box && (*box)[2] > 0 && (*box)[3] > 0) {
      drawing_.origin = {(*box)[0], (*box)[1]};
      drawing_.image_size = {(*box)[2], (*box)[3]};
      return;
    }
    const SvgAttributes attributes = [&](const char* name) { return std::string_view(root.attribute(name).value()); };
    SvgLengths lengths(attributes, {});
    const Vec2 size(lengths.at("width"), lengths.at("height"));
    if (!lengths.error() && are_usable_numbers(size) && size.minCoeff() > 0) {
      drawing_.image_size = size;
      return;
    }
    take_sheet_of_strokes(root);
  }

  void take_sheet_of_strokes(const pugi::xml_node& root) {
    Eigen::AlignedBox2d box;
    for (const PerspectiveStroke& stroke : drawing_.strokes) {
      for (const PictureCubic& piece : stroke.pieces) {
        for (const Vec2& point : piece) {
          if (are_usable_numbers(point)) box.extend(point);
        }
      }
    }
    if (box.isEmpty()) box.extend(Vec2::Zero());
    drawing_.origin = box.min();
    drawing_.image_size = box.sizes().cwiseMax(1.0);
    walk_.findings().file_warning(
        "W_NO_SHEET",
        "The drawing has no viewBox: its sheet was taken to end where the strokes end, so the "
        "eye point may be off",
        walk_.line_of(root));
  }

  void read_metadata(const pugi::xml_node& root) {
    for (const pugi::xml_node& child : root.children()) {
      if (svg_local_name(child) != "metadata") continue;
      for (const pugi::xml_node& fact : child.children()) {
        const std::string_view name = fact.name();
        if (!name.starts_with(prefix_) || read_fact(name.substr(prefix_.size()), fact)) continue;
        walk_.findings().file_warning("W_VALUE", "The element " + in_quotes(name) + " isn't understood and was ignored",
                                      walk_.line_of(fact));
      }
    }
  }

  bool read_fact(std::string_view name, const pugi::xml_node& fact) {
    const std::string_view value = fact.attribute("value").value();
    const auto number = numbers_of<1>(value);
    if (name == "known") return read_known_point(fact);
    if (name == "unit") {
      drawing_.unit = value;
      return true;
    }
    if (name == "principal") {
      const auto at = numbers_of<2>(fact.attribute("at").value());
      if (at) drawing_.principal_point = Vec2((*at)[0], (*at)[1]);
      return at.has_value();
    }
    return number && (*number)[0] > 0 && read_figure(name, fact, (*number)[0]);
  }

  bool read_known_point(const pugi::xml_node& fact) {
    const auto at = numbers_of<2>(fact.attribute("at").value());
    const auto point = numbers_of<3>(fact.attribute("point").value());
    if (!at || !point) return false;
    drawing_.known_point = KnownPoint{Vec2((*at)[0], (*at)[1]), Vec3((*point)[0], (*point)[1], (*point)[2])};
    return true;
  }

  bool read_figure(std::string_view name, const pugi::xml_node& fact, double value) {
    if (name == "length") {
      drawing_.known_lengths.push_back({fact.attribute("stroke").value(), value});
    } else if (name == "fov_x_deg" && value < 180) {
      drawing_.field_of_view = radians_of(value);
    } else if (name == "f_px") {
      drawing_.field_of_view = radians_of(degrees_of(2 * std::atan(drawing_.image_size.x() / 2 / value)));
    } else if (name == "shells" && value < 1e6 && value == std::floor(value)) {
      drawing_.shells = static_cast<int>(value);
    } else {
      return false;
    }
    return true;
  }

  SvgWalk walk_;
  SvgClasses classes_;
  std::string prefix_ = "cq:";
  PerspectiveDrawing drawing_;
};

}  // namespace

PerspectiveReadResult read_perspective_svg(std::string_view bytes, const std::string& file_name, Progress& progress) {
  return PerspectiveSvgReader(bytes, file_name, progress).read();
}

}  // namespace croquis
