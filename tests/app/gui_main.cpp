// SPDX-License-Identifier: GPL-3.0-or-later
#define CATCH_CONFIG_RUNNER
#define CATCH_CONFIG_NO_POSIX_SIGNALS  // Catch's own handlers allocate, and wait forever where malloc was interrupted
#include <QApplication>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <array>
#include <csignal>

#include <execinfo.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "app/window/theme.h"

namespace {

std::string running_case;

struct CaseNames : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;
  void testCaseStarting(const Catch::TestCaseInfo& info) override { running_case = info.name + "\n"; }
};
CATCH_REGISTER_LISTENER(CaseNames)

/// A crash that happens once in a thousand runs is understood by the functions that it happened in.
extern "C" void print_calls(int signal) {
  std::array<void*, 64> calls{};
  const char title[] = "\nA signal ended the test case: ";
  (void)!write(STDERR_FILENO, title, sizeof title - 1);
  (void)!write(STDERR_FILENO, running_case.data(), running_case.size());
  backtrace_symbols_fd(calls.data(), backtrace(calls.data(), static_cast<int>(calls.size())), STDERR_FILENO);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void print_calls_of_crashes() {
#ifndef __SANITIZE_ADDRESS__  // which has its own
  std::array<void*, 1> loaded{};
  backtrace(loaded.data(), 1);                 // loads what it needs now, not in the handler
  static std::array<char, 1 << 16> own_stack;  // the other may be full: functions that call themselves without end
  const stack_t stack{own_stack.data(), 0, own_stack.size()};
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = print_calls;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(signal, &action, nullptr);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  print_calls_of_crashes();
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
  // Nobody's own settings: every run begins as on a new machine.
  const QTemporaryDir home;
  qputenv("XDG_CONFIG_HOME", home.path().toLocal8Bit());
  qputenv("XDG_STATE_HOME", home.path().toLocal8Bit());
  QApplication application(argc, argv);
  QCoreApplication::setApplicationName("croquis");
  QCoreApplication::setOrganizationName("croquis");
  croquis::app::apply_theme(application);
  return Catch::Session().run(argc, argv);
}
