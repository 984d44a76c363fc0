// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include "croquis/base/error.h"
#include "croquis/io/file.h"

namespace croquis::cli {
namespace {

/// Everything CLI11 writes into; one per subcommand.
struct Slot {
  const Command* command = nullptr;
  CLI::App* app = nullptr;
  Invocation invocation;
  std::string memory;
  std::map<std::string, std::string> texts;  ///< parameters as typed
  std::map<std::string, bool> flags;
};

Error usage_error(std::string message) { return Error(make_error(Category::Usage, "E_USAGE", std::move(message))); }

std::string help_of(const ParameterDescription& parameter) {
  std::string help = parameter.sentence;
  if (parameter.type == ParameterType::Flag || parameter.type == ParameterType::File) return help;
  const std::string value = to_text(parameter.default_value);
  help += " [" + (value.empty() ? std::string("none") : value);
  if (!parameter.unit.empty()) help += " " + parameter.unit;
  const bool is_number = parameter.type == ParameterType::Integer || parameter.type == ParameterType::Number;
  if (is_number && std::isfinite(parameter.minimum) && std::isfinite(parameter.maximum)) {
    help += ", " + to_text(parameter.minimum) + ".." + to_text(parameter.maximum);
  }
  return help + "]";
}

std::string type_word(const ParameterDescription& parameter) {
  if (parameter.type == ParameterType::Choice) return CLI::detail::join(parameter.choices, "|");
  if (parameter.type == ParameterType::File) return "FILE";
  return parameter.type == ParameterType::Integer ? "N" : parameter.type == ParameterType::Number ? "X" : "TEXT";
}

void add_parameters(Slot& slot) {
  for (const ParameterDescription& parameter : slot.command->description.parameters) {
    const std::string name = "--" + parameter.name;
    if (parameter.type == ParameterType::Flag) {
      slot.app->add_flag(name, slot.flags[parameter.name], help_of(parameter));
    } else {
      CLI::Option* option = slot.app->add_option(name, slot.texts[parameter.name], help_of(parameter));
      option->type_name(type_word(parameter));
      if (parameter.repeatable) option->join(';');
    }
  }
}

void add_common_options(Slot& slot) {
  Invocation& invocation = slot.invocation;
  const auto group = [&](CLI::Option* option) { option->group("Common options"); };
  group(slot.app->add_flag("--json", invocation.json, "Print one JSON object on standard output"));
  group(slot.app->add_flag("--quiet", invocation.quiet, "Print nothing but errors"));
  group(slot.app->add_flag("--strict", invocation.strict, "Exit with 1 when there are warnings"));
  group(slot.app->add_option("--progress", invocation.progress, "Show progress on standard error")
            ->type_name("auto|none|json")
            ->check(CLI::IsMember({"auto", "none", "json"})));
  group(slot.app->add_option("--threads", invocation.threads, "Number of threads; the result is the same for any")
            ->type_name("N")
            ->check(CLI::Range(1, 1024)));
  group(slot.app->add_option("--seed", invocation.seed, "Seed of whatever is random")->type_name("N"));
  group(slot.app->add_option("--max-memory", slot.memory, "Stop with exit code 5 beyond this (512M, 2G)")
            ->type_name("SIZE"));
  group(slot.app->add_option("--timeout", invocation.timeout, "Stop with exit code 5 after this many seconds")
            ->type_name("SECONDS")
            ->check(CLI::PositiveNumber));
}

std::string footer_of(const CommandDescription& description) {
  std::string footer = description.examples.size() > 1 ? "Examples:" : "Example:";
  for (const std::string& example : description.examples) footer += "\n  " + example;
  return footer;
}

void add_subcommand(CLI::App& app, Slot& slot) {
  const CommandDescription& description = slot.command->description;
  slot.app = app.add_subcommand(description.name, description.sentence);
  slot.app->footer(footer_of(description));
  if (description.needs_input) {
    slot.app->add_option("input", slot.invocation.input, "What to read; - is standard input")
        ->type_name(description.input_word)
        ->required();
    slot.app
        ->add_option("--input-format", slot.invocation.input_format, "Format of the input, if its name doesn't show it")
        ->type_name("FORMAT");
  }
  if (description.output != OutputNeed::None) {
    slot.app->add_option("-o,--output", slot.invocation.output, "Where to write; - is standard output")
        ->type_name("FILE")
        ->required(description.output == OutputNeed::Required);
    slot.app
        ->add_option("--output-format", slot.invocation.output_format,
                     "Format of the output, if its name doesn't show it")
        ->type_name("FORMAT");
  }
  add_parameters(slot);
  add_common_options(slot);
}

/// A list as it was typed, with what files hold in place of every "@FILE".
std::string with_files_read(const std::string& list) {
  std::string text;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(';', at), list.size());
    const std::string part = list.substr(at, end - at);
    text += (at == 0 ? "" : ";") + (part.starts_with("@") ? read_file(part.substr(1)) : part);
    at = end + 1;
  }
  return text;
}

/// "512M", "2G", "1.5GiB", "1000000": a number of bytes, with K, M, G or T as powers of 1024.
std::int64_t parse_byte_size(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  std::string_view suffix(stopped, static_cast<std::size_t>(end - stopped));
  if (suffix.ends_with("iB")) {
    suffix.remove_suffix(2);
  } else if (suffix.ends_with("B")) {
    suffix.remove_suffix(1);
  }
  constexpr std::string_view units = "KMGT";
  if (suffix.size() == 1) {
    const auto power = units.find(static_cast<char>(std::toupper(static_cast<unsigned char>(suffix[0]))));
    if (power != std::string_view::npos) {
      number *= std::pow(1024.0, static_cast<double>(power + 1));
      suffix = {};
    }
  }
  if (error != std::errc{} || !suffix.empty() || !(number >= 1) || number > 1e18) {
    throw Error(refused_value("max-memory", text, "a size such as 512M or 2G"));
  }
  return static_cast<std::int64_t>(number);
}

/// Converts what was typed into values, with findings for what can't be.
void read_parameters(Slot& slot) {
  Findings findings;
  ParameterValues& values = slot.invocation.parameters;
  for (const ParameterDescription& parameter : slot.command->description.parameters) {
    const CLI::Option* option = slot.app->get_option("--" + parameter.name);
    if (option->count() == 0) continue;
    try {
      if (parameter.type == ParameterType::Flag) {
        values[parameter.name] = slot.flags[parameter.name];
      } else {
        const std::string& typed = slot.texts[parameter.name];
        values[parameter.name] = parse_parameter(parameter, parameter.repeatable ? with_files_read(typed) : typed);
      }
    } catch (const Error& error) {
      findings.insert(findings.end(), error.findings().begin(), error.findings().end());
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  values = complete(slot.command->description.parameters, std::move(values));
  if (!slot.memory.empty()) slot.invocation.memory_limit = parse_byte_size(slot.memory);
}

/// CLI11's own words, shortened to one sentence.
std::string sentence_of(const CLI::Error& error) {
  std::string message = error.what();
  std::replace(message.begin(), message.end(), '\n', ' ');
  while (!message.empty() && (message.back() == ' ' || message.back() == '.')) message.pop_back();
  return message + "; see --help.";
}

std::string help_text(CLI::App& app) {
  for (const CLI::App* chosen : app.get_subcommands()) return chosen->help(app.get_name());
  return app.help();
}

/// CLI11 would only report that a subcommand is missing.
void check_subcommand(const std::vector<std::string>& arguments, const std::vector<std::unique_ptr<Slot>>& slots) {
  if (arguments.empty() || arguments.front().starts_with("-")) return;
  const bool known = std::any_of(slots.begin(), slots.end(), [&](const auto& slot) {
    return slot->command->description.name == arguments.front();
  });
  if (!known) throw usage_error("There is no subcommand '" + arguments.front() + "'; see --help.");
}

Error no_value(const std::string& option) {
  return usage_error("There is no value behind " + option + "; see --help.");
}

/// CLI11 would take the next option for a value that is missing behind "=", and the "=" behind a letter for a part of
/// the value.
void check_equal_signs(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument == "--") return;  // what follows are names of files
    if (argument.starts_with("--") && argument.find('=') == argument.size() - 1) throw no_value(argument);
    if (argument.size() > 2 && argument[0] == '-' && argument[1] != '-' && argument[2] == '=') {
      throw usage_error("Write a space between " + argument.substr(0, 2) + " and its value, not '='; see --help.");
    }
  }
}

/// An empty argument, as unset variables of scripts leave it, is a mistake.
void check_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string>& values = option->results();
    const bool is_flag = option->get_items_expected_max() == 0;
    if (is_flag || std::find(values.begin(), values.end(), "") == values.end()) continue;
    if (option->get_positional()) throw usage_error("The name of the file to read is empty; see --help.");
    throw no_value(option->get_name());
  }
}

void set_up(CLI::App& app) {
  app.name("croquis-cli");
  app.require_subcommand(1);
  app.set_version_flag("--version", "croquis-cli " CROQUIS_VERSION);
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.footer(
      "Every subcommand has its own --help.\n"
      "Exit codes: 0 done, 1 warnings under --strict, 2 wrong usage, 3 unreadable input, 4 no valid result,\n"
      "5 limit reached, 6 cannot write, 70 internal error, 130 interrupted.");
}

}  // namespace

ParsedLine parse_command_line(const std::vector<std::string>& arguments, const std::vector<Command>& commands) {
  CLI::App app("Croquis: drawn lines become solid models.");
  set_up(app);
  std::vector<std::unique_ptr<Slot>> slots;
  for (const Command& command : commands) {
    slots.push_back(std::make_unique<Slot>());
    slots.back()->command = &command;
    add_subcommand(app, *slots.back());
  }
  check_subcommand(arguments, slots);
  check_equal_signs(arguments);

  ParsedLine line;
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp&) {
    line.text = help_text(app);
    return line;
  } catch (const CLI::CallForVersion& version) {
    line.text = version.what();
    return line;
  } catch (const CLI::ParseError& error) {
    throw usage_error(sentence_of(error));
  }
  for (const auto& slot : slots) {
    if (!slot->app->parsed()) continue;
    check_values(*slot->app);
    read_parameters(*slot);
    line.command = slot->command;
    line.invocation = std::move(slot->invocation);
  }
  return line;
}

}  // namespace croquis::cli
