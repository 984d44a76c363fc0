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
};

/// Values by parameter name. Holds every parameter of its description once `complete` has run.
using ParameterValues = std::map<std::string, ParameterValue>;

/// The description of that name, or null. Linear.
const ParameterDescription* find_parameter(std::span<const ParameterDescription> descriptions, std::string_view name);

/// Fills in defaults and checks each value against its description.
/// @throws Error with one E_PARAMETER finding for every unknown name, wrong type, and value out of its range
ParameterValues complete(const std::vector<ParameterDescription>& descriptions, ParameterValues values);

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
