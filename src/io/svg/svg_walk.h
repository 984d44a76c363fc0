// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <pugixml.hpp>

#include "croquis/base/progress.h"
#include "io/svg/svg_findings.h"
#include "io/svg/svg_outline.h"
#include "io/svg/svg_scanner.h"

namespace croquis {

/// A shape that is to be shown, with its outline in its own coordinates.
struct SvgShownShape {
  pugi::xml_node node;
  std::string id;  ///< of its own or "stroke-N" for the N-th shape; no other one's
  std::int64_t line = 0;
  std::vector<SvgSubpath> subpaths;
  Eigen::Affine2d map = Eigen::Affine2d::Identity();  ///< of the shape and all groups around it
};

/// What is made of the elements.
class SvgVisitor {
 public:
  virtual ~SvgVisitor() = default;
  virtual void enter(const pugi::xml_node& group) = 0;  ///< a group that is to be shown, before what is in it
  virtual void add(SvgShownShape shape) = 0;
};

/// One reading of one file: XML, groups, transforms, visibility, names, and all that can be wrong with them.
class SvgWalk {
 public:
  SvgWalk(std::string_view bytes, const std::string& file, Progress& progress)
      : bytes_(bytes), lines_(bytes), findings_(file), progress_(progress) {}

  /// Parses the file. @throws Error
  pugi::xml_node parse();

  /// Shows all shapes to the visitor, in the order of the file. What is wrong goes into the findings.
  void visit(const pugi::xml_node& root, SvgVisitor& visitor);

  /// To be called for each subpath that is kept: no more pieces and bytes than fit. False when they don't.
  bool count_pieces(std::size_t pieces, std::size_t bytes, std::int64_t line);

  /// The name itself when it is free, else the name with the next free number, and a warning.
  std::string unique_name(const std::string& wanted, std::int64_t line);

  void limit(const std::string& message, std::int64_t line);
  [[noreturn]] void throw_findings();

  /// What is wrong with the file as a whole, at once. @throws Error
  [[noreturn]] void refuse(const char* code, const std::string& message, std::optional<std::int64_t> line);

  std::int64_t line_of(const pugi::xml_node& node);
  SvgFindings& findings() { return findings_; }
  bool limit_reached() const { return limit_reached_; }

  /// An attribute that can't be read: of a shape, or of a group.
  void report(const pugi::xml_node& node, const SvgTextError& error, const char* attribute);

 private:
  struct Surroundings {
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    bool visible = true;
    int level = 0;
  };

  void visit(const pugi::xml_node& node, Surroundings around, SvgVisitor& visitor);
  void ignore(const pugi::xml_node& node, std::string_view name);
  bool enter(const pugi::xml_node& node, Surroundings& around, SvgVisitor& visitor);
  void enter_inner_svg(const pugi::xml_node& node, Surroundings& around);
  void read_shape(const pugi::xml_node& node, std::string_view element, const Surroundings& around,
                  SvgVisitor& visitor);
  void warn_of_ignored();

  std::string_view bytes_;
  std::string text_;  ///< the copy that pugixml takes apart
  pugi::xml_document document_;
  LineCounter lines_;
  SvgFindings findings_;
  Progress& progress_;
  std::set<std::string> names_;
  std::map<std::string, int> copies_;
  std::map<std::string, std::pair<int, std::int64_t>> ignored_;  ///< element name: how many, line of the first
  std::size_t shape_count_ = 0;
  std::size_t elements_ = 0;
  std::size_t copied_ = 0;
  std::size_t segments_ = 0;
  bool limit_reached_ = false;
};

}  // namespace croquis
