// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/operation_runner.h"

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {
namespace {

OperationOutcome failure(Findings findings) {
  OperationOutcome outcome;
  outcome.failed = true;
  outcome.repeatable = std::none_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.code == "E_MEMORY" || finding.category == Category::Io;
  });
  outcome.result.warnings = std::move(findings);
  return outcome;
}

Finding internal(const std::string& reason) {
  return make_error(Category::Internal, "E_INTERNAL",
                    "Internal error (" + reason + "); please report it with the input.");
}

}  // namespace

OperationOutcome guarded(const std::function<OperationResult()>& work, const Progress& progress) {
  try {
    OperationOutcome outcome;
    outcome.result = work();
    return outcome;
  } catch (const Cancelled&) {
    if (progress.cancelled()) throw;
    return failure({internal("cancelled by nobody")});
  } catch (const Error& error) {
    return failure(error.findings());
  } catch (const std::bad_alloc&) {
    return failure({make_error(Category::Limit, "E_MEMORY",
                               "There is not enough memory for this; make the input smaller or free some memory.")});
  } catch (const std::exception& exception) {
    return failure({internal(exception.what())});
  }
}

OperationOutcome run_guarded(const Operation& operation, const Values& inputs, const ParameterValues& parameters,
                             Context& context) {
  return guarded([&] { return run(operation, inputs, parameters, context); }, context.progress);
}

}  // namespace croquis
