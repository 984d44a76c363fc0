// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/check_operation.h"

#include <string>
#include <thread>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"

namespace croquis::test {
namespace {

void add(std::string& text, const Findings& findings) {
  for (const Finding& finding : findings) {
    text += finding.code + ": " + finding.message + "\n";
    for (const Subject& subject : finding.subjects)
      text += "  " + std::string(to_string(subject.kind)) + name_of(subject);
  }
}

/// All that a run says, so that two runs can be compared and a difference read.
std::string said_by(const Operation& operation, const Values& inputs, const ParameterValues& parameters,
                    Quality quality, Memo* memo) {
  std::string said;
  Progress progress;
  Context context{progress, quality, memo};
  try {
    const OperationResult result = run(operation, inputs, parameters, context);
    for (const auto& [name, value] : result.outputs) {
      const ContentHash hash = content_hash(value);
      said += name + " " + std::to_string(hash.high) + " " + std::to_string(hash.low) + "\n";
    }
    add(said, result.warnings);
  } catch (const Error& error) {
    said += "refused\n";
    add(said, error.findings());
  }
  return said;
}

}  // namespace

void check_operation(const Operation& operation, const Values& inputs, const ParameterValues& parameters) {
  for (const Quality quality : {Quality::Draft, Quality::Final}) {
    INFO(operation.describe().id << (quality == Quality::Draft ? ", draft" : ", final"));
    Memo memo;
    const std::string alone = said_by(operation, inputs, parameters, quality, nullptr);
    CHECK_FALSE(alone.empty());
    CHECK(said_by(operation, inputs, parameters, quality, &memo) == alone);
    CHECK(said_by(operation, inputs, parameters, quality, &memo) == alone);
    std::string elsewhere;
    std::thread([&] { elsewhere = said_by(operation, inputs, parameters, quality, nullptr); }).join();
    CHECK(elsewhere == alone);
  }
}

}  // namespace croquis::test
