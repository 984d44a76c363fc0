// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/base/limits.h"
#include "croquis/io/perspective_drawing_file.h"
#include "io/perspective/perspective_strokes.h"
#include "io/svg/svg_file.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr double straight_tolerance = 4e-4;  // × diagonal of the sheet; half a pixel of an ordinary one

/// Exactly so many usable numbers, separated as SVG allows.
template <std::size_t N>
std::optional<Eigen::Matrix<double, N, 1>> vector_of(std::string_view text) {
  SvgScanner scanner(text);
  const auto numbers = scanner.numbers<N>();
  scanner.skip_blanks();
  if (!numbers || !scanner.at_end() || !are_usable_numbers(*numbers)) return std::nullopt;
  return Eigen::Matrix<double, N, 1>(numbers->data());
}

std::optional<double> positive_number_of(std::string_view text) {
  const auto number = vector_of<1>(text);
  return number && number->x() > 0 ? std::optional(number->x()) : std::nullopt;
}

std::optional<bool> flag_of(std::string_view word) {
  if (word == "true" || word == "1") return true;
  if (word == "false" || word == "0") return false;
  return std::nullopt;
}

/// A word or one digit.
std::optional<StrokeGroup> stated_group_of(std::string_view word) {
  if (word == "unknown") return StrokeGroup::Unknown;
  const bool is_group = word.size() == 1 && word[0] >= '0' && word[0] <= '5';
  return is_group ? std::optional(static_cast<StrokeGroup>(word[0] - '0')) : std::nullopt;
}

/// Whether a layer around an element has a name that begins so.
bool is_in_layer(pugi::xml_node node, std::string_view beginning) {
  for (; node; node = node.parent()) {
    const bool is_group = svg_local_name(node) == "g";
    if (is_group && lower_case(node.attribute("inkscape:label").value()).starts_with(beginning)) return true;
  }
  return false;
}

/// What attributes of the profile's namespace begin with.
std::string prefix_of(const pugi::xml_node& root) {
  std::string prefix = "cq:";
  for (const pugi::xml_attribute& attribute : root.attributes()) {
    const std::string_view name = attribute.name();
    if (name.starts_with("xmlns:") && std::string_view(attribute.value()) == perspective_namespace) {
      prefix = std::string(name.substr(6)) + ':';
    }
  }
  return prefix;
}

/// The pieces of each stroke that a subpath stands for, with whether they are a straight line.
std::vector<std::pair<std::vector<PictureCubic>, bool>> strokes_of(const SvgSubpath& subpath) {
  if (subpath.segments.empty()) return {{{straight_piece(subpath.start, subpath.start)}, true}};
  const bool single = subpath.segments.size() == 1;
  const bool straight = single && subpath.segments[0].kind == SvgSegment::Kind::Line;
  const bool loop = single && subpath.segments[0].kind == SvgSegment::Kind::Cubic && subpath.last() == subpath.start;
  const bool apart = subpath.closed && !straight && !loop;
  std::vector<std::pair<std::vector<PictureCubic>, bool>> strokes;
  if (!apart) strokes.push_back({{}, straight});
  Vec2 from = subpath.start;
  for (const SvgSegment& segment : subpath.segments) {
    for (const PictureCubic& piece : cubics_of(segment, from)) {
      if (apart) strokes.push_back({{}, segment.kind == SvgSegment::Kind::Line});
      strokes.back().first.push_back(piece);
    }
    from = segment.end;
  }
  if (apart && from != subpath.start) strokes.push_back({{straight_piece(from, subpath.start)}, true});
  return strokes;
}

/// Reads the strokes and facts of one file.
class PerspectiveSvgReader {
 public:
  explicit PerspectiveSvgReader(SvgFile& file) : file_(file), prefix_(prefix_of(file.root())) {}

  PerspectiveDrawing read(Progress& progress) {
    visit_svg(file_, {[](const pugi::xml_node&) {}, [&](SvgShownShape shape) { add(std::move(shape)); }}, progress);
    if (drawing_.strokes.empty() && !file_.limit_reached()) file_.add(no_svg_strokes(), std::nullopt);
    file_.stop_on_errors();
    read_sheet();
    for (const pugi::xml_node& child : file_.root().children()) {
      if (svg_local_name(child) == "metadata") read_metadata(child);
    }
    for (PerspectiveStroke& stroke : drawing_.strokes) straighten(stroke, straight_tolerance * drawing_.diagonal());
    return std::move(drawing_);
  }

 private:
  void add(SvgShownShape shape) {
    PerspectiveStroke stroke;
    stroke.line = shape.line;
    read_attributes(shape, stroke);
    int number = 0;
    // A coordinate that isn't finite would take the other one with it.
    const bool moves_nothing = shape.map.matrix() == Eigen::Matrix3d::Identity();
    for (SvgSubpath& subpath : shape.subpaths) {
      if (!moves_nothing) transform(subpath, shape.map);
      for (auto& [pieces, straight] : strokes_of(subpath)) {
        const std::string wanted = shape.id + '/' + std::to_string(++number);
        stroke.id = number == 1 ? shape.id : file_.unique_name(wanted, shape.line);
        stroke.pieces = std::move(pieces);
        stroke.straight = straight;
        const std::size_t bytes = stroke.id.size() + stroke.colour.size() + stroke.from.size() + stroke.to.size();
        if (!file_.count_pieces(stroke.pieces.size(), bytes, shape.line)) return;
        drawing_.strokes.push_back(stroke);
      }
    }
  }

  std::string_view own(const pugi::xml_node& node, const std::string& name) const {
    return node.attribute((prefix_ + name).c_str()).value();
  }

  /// Of the element or the nearest one around it that has the attribute.
  std::string_view inherited(pugi::xml_node node, const std::string& name) const {
    for (; node; node = node.parent()) {
      if (const pugi::xml_attribute attribute = node.attribute((prefix_ + name).c_str())) return attribute.value();
    }
    return {};
  }

  /// Takes over an attribute's value if it is there and understood.
  template <typename T>
  void take(const SvgShownShape& shape, const std::string& name, std::string_view value, std::optional<T> understood,
            T& target) {
    if (value.empty()) return;
    if (understood) {
      target = *understood;
      return;
    }
    file_.add(make_warning(Category::Malformed, "W_VALUE",
                           "Stroke " + in_quotes(shape.id) + " has " + prefix_ + name + "=" + in_quotes(value) +
                               ", which isn't understood and was ignored"),
              shape.line, shape.id);
  }

  void read_attributes(const SvgShownShape& shape, PerspectiveStroke& stroke) {
    const pugi::xml_node& node = shape.node;
    const std::string dashes = file_.inherited_property(node, "stroke-dasharray");
    const bool dashed = !dashes.empty() && dashes != "none";
    stroke.role = dashed || is_in_layer(node, "construction") ? StrokeRole::Construction : StrokeRole::Edge;
    stroke.hidden = is_in_layer(node, "hidden");
    const std::string_view role = inherited(node, "role");
    take(shape, "role", role, value_of_word<StrokeRole>(role, stroke_role_words), stroke.role);
    for (const StrokeField& field : stroke_fields) {
      std::string name = field.name;
      std::ranges::replace(name, '_', '-');
      const std::string_view text = name == "hidden" ? inherited(node, name) : own(node, name);
      struct Visitor {
        std::string_view text;
        std::optional<std::string> operator()(std::string PerspectiveStroke::*) const { return std::string(text); }
        std::optional<bool> operator()(bool PerspectiveStroke::*) const { return flag_of(text); }
        std::optional<double> operator()(double PerspectiveStroke::*) const { return positive_number_of(text); }
        std::optional<EndLock> operator()(EndLock PerspectiveStroke::*) const {
          return value_of_word<EndLock>(text, end_lock_words);
        }
      };
      std::visit([&](auto member) { take(shape, name, text, Visitor{text}(member), stroke.*member); }, field.member);
    }
    read_group(shape, stroke);
  }

  void read_group(const SvgShownShape& shape, PerspectiveStroke& stroke) {
    stroke.colour = file_.inherited_property(shape.node, "stroke");
    if (stroke.colour == "none") stroke.colour.clear();
    const StrokeGroup by_colour = group_of_colour(stroke.colour);
    const std::string_view word = inherited(shape.node, "group");
    const std::optional<StrokeGroup> stated = stated_group_of(word);
    stroke.group = by_colour;
    take(shape, "group", word, stated, stroke.group);
    const bool both =
        stated.value_or(StrokeGroup::Unknown) != StrokeGroup::Unknown && by_colour != StrokeGroup::Unknown;
    if (both && *stated != by_colour) {
      Finding note =
          make_warning(Category::Malformed, "GROUP_COLOUR",
                       "Stroke " + in_quotes(shape.id) + " is of group " + std::string(word) +
                           " although its colour is that of group " + std::to_string(static_cast<int>(by_colour)) +
                           ": change one of them if that isn't meant");
      note.severity = Severity::Info;
      file_.add(std::move(note), shape.line, shape.id);
    }
    if (lower_case(stroke.colour) == lower_case(colour_of_group(stroke.group))) stroke.colour.clear();
  }

  /// The viewBox, else width and height, else what the strokes take.
  void read_sheet() {
    const pugi::xml_node root = file_.root();
    const auto box = vector_of<4>(root.attribute("viewBox").value());
    if (box && box->tail<2>().minCoeff() > 0) {
      drawing_.origin = box->head<2>();
      drawing_.image_size = box->tail<2>();
      return;
    }
    SvgLengths lengths(root, Vec2::Zero());
    const Vec2 size(lengths.at("width"), lengths.at("height"));
    if (!lengths.error() && are_usable_numbers(size) && size.minCoeff() > 0) {
      drawing_.image_size = size;
      return;
    }
    Eigen::AlignedBox2d strokes;
    for (const PerspectiveStroke& stroke : drawing_.strokes) {
      for (const PictureCubic& piece : stroke.pieces) {
        for (const Vec2& point : piece) {
          if (are_usable_numbers(point)) strokes.extend(point);
        }
      }
    }
    if (strokes.isEmpty()) strokes.extend(Vec2::Zero());
    drawing_.origin = strokes.min();
    drawing_.image_size = strokes.sizes().cwiseMax(1.0);
    file_.add(make_warning(Category::Malformed, "W_NO_SHEET",
                           "The drawing has no viewBox: its sheet was taken to end where the strokes end, so the eye "
                           "point may be off"),
              file_.line_of(root));
  }

  void read_metadata(const pugi::xml_node& metadata) {
    for (const pugi::xml_node& fact : metadata.children()) {
      const std::string_view name = fact.name();
      if (!name.starts_with(prefix_) || read_fact(name.substr(prefix_.size()), fact)) continue;
      file_.add(make_warning(Category::Malformed, "W_VALUE",
                             "The element " + in_quotes(name) + " isn't understood and was ignored"),
                file_.line_of(fact));
    }
  }

  /// False where it isn't understood.
  bool read_fact(std::string_view name, const pugi::xml_node& fact) {
    const std::string_view value = fact.attribute("value").value();
    const auto at = vector_of<2>(fact.attribute("at").value());
    if (name == "known") {
      const auto point = vector_of<3>(fact.attribute("point").value());
      if (at && point) drawing_.known_point = KnownPoint{*at, *point};
      return at && point;
    }
    if (name == "principal") {
      if (at) drawing_.principal_point = *at;
      return at.has_value();
    }
    if (name == "unit") {
      drawing_.unit = value;
      return true;
    }
    const double number = positive_number_of(value).value_or(0);
    if (number == 0) return false;
    if (name == "length") {
      drawing_.known_lengths.push_back({fact.attribute("stroke").value(), number});
    } else if (name == "fov_x_deg" && number < 180) {
      drawing_.field_of_view = radians_of(number);
    } else if (name == "f_px") {
      drawing_.field_of_view = radians_of(degrees_of(2 * std::atan(drawing_.image_size.x() / 2 / number)));
    } else if (name == "shells" && number < 1e6 && number == std::floor(number)) {
      drawing_.shells = static_cast<int>(number);
    } else {
      return false;
    }
    return true;
  }

  SvgFile& file_;
  std::string prefix_;
  PerspectiveDrawing drawing_;
};

}  // namespace

PerspectiveReadResult read_perspective_svg(std::string_view bytes, const std::string& file_name, Progress& progress) {
  SvgFile file(bytes, file_name);
  PerspectiveReadResult result;
  result.drawing = PerspectiveSvgReader(file).read(progress);
  result.drawing.file = file_name;
  result.warnings = file.take();
  return result;
}

}  // namespace croquis
