// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <typeinfo>
#include <utility>
#include <variant>
#include <vector>

#include "croquis/base/finding.h"

/// The one description of a parameter: the command line's option and help, the panel's slider, the project file's
/// field and the reference page are all made from it.
namespace croquis {

enum class ParameterType {
  Flag,     ///< bool
  Integer,  ///< std::int64_t
  Number,   ///< double
  Choice,   ///< std::string, one of `choices`
  Text,     ///< std::string or ParsedText
  File      ///< std::string, a path
};

/// A Text that was written by a program from a value: files and people read the text, operations take the value and
/// parse nothing. Two of equal text are equal.
class ParsedText {
 public:
  /// @param value what the text stands for
  template <class Parsed>
  explicit ParsedText(std::string text, Parsed value)
      : text_(std::move(text)), value_(std::make_shared<const Parsed>(std::move(value))), type_(&typeid(Parsed)) {}

  const std::string& text() const { return text_; }
  operator const std::string&() const { return text_; }

  /// What it stands for, or null when that is of another type.
  template <class Parsed>
  const Parsed* value() const {
    return *type_ == typeid(Parsed) ? static_cast<const Parsed*>(value_.get()) : nullptr;
  }

  friend bool operator==(const ParsedText& a, const ParsedText& b) { return a.text_ == b.text_; }

 private:
  std::string text_;
  std::shared_ptr<const void> value_;
  const std::type_info* type_;
};

/// Files and recordings hold a ParsedText as the text that it has.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string, ParsedText>;

/// Values by parameter name. Holds every parameter of its description once `complete` has run.
using ParameterValues = std::map<std::string, ParameterValue>;
/// Where windows show a parameter.
enum class ParameterPlace {
  Panel,   ///< with the others
  Expert,  ///< where people ask for all of them
  Nowhere  ///< it is shown and changed at the model itself, or is of no use in a window
};

/// Which length one unit of a Number is, so that windows can show what it comes to.
enum class ParameterLength {
  None,   ///< it is no length
  Model,  ///< one unit of the model
  // Relative ones: where no value is given, windows show the default as "auto".
  Input,   ///< the diagonal of the box around the operation's first input
  Output,  ///< the diagonal of the box around its first output
  Inner    ///< one that only the operation knows
};

/// What one unit of a Number is.
struct ParameterUnit {
  // NOLINTNEXTLINE(google-explicit-constructor): most are words alone
  ParameterUnit(const char* shown, ParameterLength of = ParameterLength::None, double part = 1)
      : words(shown), length(of), share(part) {}

  std::string words;
  ParameterLength length;
  double share;  ///< of that length: 0.001 of a parameter in ‰
};

struct ParameterDescription {
  std::string name;  ///< "weight-curvature": the option is `--weight-curvature`
  ParameterType type = ParameterType::Number;
  ParameterValue default_value;  ///< of the type above; an empty Text or File means "not given"
  double minimum = -std::numeric_limits<double>::infinity();  ///< Integer and Number only, inclusive
  double maximum = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;  ///< Choice only
  std::string unit;                  ///< what one unit of it is ("× median radius"), empty for none
  std::string sentence;              ///< one sentence of help
  bool repeatable = false;           ///< Text only: a list separated by ';'; command lines may give the option often
  std::string title = {};            ///< what windows call it; empty: its name in words
  std::vector<std::string> choice_titles = {};  ///< what windows call the choices; empty: as they are. Of a Number two
                                                ///< words for what its least and its greatest value give, or none
  ParameterPlace place = ParameterPlace::Panel;
  std::map<std::string, ParameterValues> presets = {};  ///< Choice only: the values of other parameters that go with a
                                                        ///< choice, where they aren't given
  std::string default_title = {};  ///< what windows show for a default that is no number: "auto", "no limit"
  ParameterLength length = ParameterLength::None;
  double share = 1;  ///< see ParameterUnit
};

/// What people read: the title, else the name in words, "Weight curvature".
std::string title_of(const ParameterDescription& description);
/// "Level 3", "Quality refined", "Mark patches off"; of a text the title alone.
std::string title_with(const ParameterDescription& description, const ParameterValue& value);

ParameterDescription flag_parameter(const std::string& name, bool value, const std::string& sentence);
ParameterDescription integer_parameter(const std::string& name, std::int64_t value, double minimum, double maximum,
                                       const std::string& unit, const std::string& sentence);
ParameterDescription number_parameter(const std::string& name, double value, double minimum, double maximum,
                                      const ParameterUnit& unit, const std::string& sentence);
/// The first choice is the default.
ParameterDescription choice_parameter(const std::string& name, const std::vector<std::string>& choices,
                                      const std::string& sentence);
ParameterDescription text_parameter(const std::string& name, const std::string& value, const std::string& sentence);
/// A path, empty by default.
ParameterDescription file_parameter(const std::string& name, const std::string& sentence);
/// A list separated by ';', empty by default.
ParameterDescription list_parameter(const std::string& name, const std::string& sentence);

/// Whether a value counts as given: not the choice "preset", nor an empty text, unless the default is another one.
/// With an empty text windows leave a parameter of any type to the default again.
bool is_given(const ParameterDescription& description, const ParameterValue& value);

/// Fills in what isn't given: by the presets that are chosen, then by the defaults. A value that is given stays, also
/// where it equals the default. Checks nothing.
ParameterValues with_defaults(const std::vector<ParameterDescription>& descriptions, ParameterValues given);

/// The description of that name, or null. Linear.
const ParameterDescription* find_parameter(std::span<const ParameterDescription> descriptions, std::string_view name);

/// Checks each value against its description and fills in the others, see with_defaults.
/// @throws Error with one E_PARAMETER finding for every unknown name, wrong type, and value out of its range
ParameterValues complete(const std::vector<ParameterDescription>& descriptions, ParameterValues values);

/// E_PARAMETER: "'VALUE' is no value for NAME: it takes ACCEPTED."
Finding refused_value(const std::string& name, std::string_view value, const std::string& accepted);

/// The value of that name in complete values.
/// @throws std::out_of_range, std::bad_variant_access for a name or a type that isn't the described one: a mistake of
///         the program, not of the input
bool flag_of(const ParameterValues& values, const std::string& name);
std::int64_t integer_of(const ParameterValues& values, const std::string& name);
double number_of(const ParameterValues& values, const std::string& name);
const std::string& text_of(const ParameterValues& values,
                           const std::string& name);  ///< of Choice and File too; of a ParsedText its text

/// Reads a value of the described type from text.
/// @throws Error (E_PARAMETER) naming the parameter and what would have been accepted
ParameterValue parse_parameter(const ParameterDescription& description, const std::string& text);

/// The text that parse_parameter turns back into the same value.
std::string to_text(const ParameterValue& value);

/// "flag", "integer", "number", "choice", "text", "file".
const char* to_string(ParameterType type);

}  // namespace croquis
