// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <catch2/catch.hpp>

#include "croquis/operators/all_operations.h"

namespace croquis {
namespace {

TEST_CASE("windows show every parameter in words, and ask for no text that a program wrote") {
  const Registry registry = all_operations();
  for (const OperationDescription& operation : registry.descriptions()) {
    std::set<std::string> titles;
    for (const ParameterDescription& parameter : operation.parameters) {
      INFO(operation.id << " " << parameter.name);
      const std::size_t titled = parameter.type == ParameterType::Number ? 2 : parameter.choices.size();  // its ends
      CHECK((parameter.choice_titles.empty() || parameter.choice_titles.size() == titled));
      if (parameter.place == ParameterPlace::Nowhere || parameter.name == operation.list_flag) continue;
      CHECK(titles.insert(title_of(parameter)).second);
      CHECK(parameter.unit.find("diagonal / ") == std::string::npos);
      const bool lists_edits = operation.edits_input && operation.edits_input->lines == parameter.name;
      if (parameter.place == ParameterPlace::Panel && !lists_edits) CHECK(parameter.type != ParameterType::Text);
      for (const std::string& title : parameter.choice_titles) CHECK(title != "preset");
      if (parameter.place == ParameterPlace::Panel && parameter.type == ParameterType::Choice &&
          parameter.choices.front() != "2")
        CHECK_FALSE(parameter.choice_titles.empty());
    }
  }
}

}  // namespace
}  // namespace croquis
