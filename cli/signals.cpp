#include "cli/signals.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>

#include "cli/standard_streams.h"

namespace texbake {
namespace {

// What a handler of the C library may read.
void (*clean_up_on_failure)() = nullptr;
int exit_code_on_failure = 1;
pid_t cleaning_process = 0;  // a child that it forked has no files to clean up, but must not do it for its parent
std::atomic<bool> end_is_expected = false;

[[noreturn]] void end_at_once(const std::string& reason) {
  if (getpid() != cleaning_process) std::abort();
  write_to_stderr("texbake: " + reason + "\n");
  clean_up_on_failure();
  _exit(exit_code_on_failure);
}

[[noreturn]] void end_on_exception() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    end_at_once(std::string("the program cannot go on: ") + error.what());
  } catch (...) {
  }
  end_at_once("the program cannot go on, and a library gives no reason");
}

void end_on_exit() {
  if (!end_is_expected && getpid() == cleaning_process)
    end_at_once("a library ended the program; its own words, if any, stand above");
}

}  // namespace

void end_cleanly_on_exceptions(void (*clean_up)(), int exit_code) {
  clean_up_on_failure = clean_up;
  exit_code_on_failure = exit_code;
  cleaning_process = getpid();
  std::set_terminate(end_on_exception);
}

void end_cleanly_on_exit() {
  std::atexit(end_on_exit);
  // A file that grows past the user's limit fails to be written, with a message, instead of ending the program.
  signal(SIGXFSZ, SIG_IGN);
}

void expect_end() { end_is_expected = true; }

void end_cleanly_on_signals(void (*clean_up)()) {
  // Every thread inherits the blocked set, so that only the one that waits for them ever sees the signals.
  sigset_t ending;
  sigemptyset(&ending);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, number);
  pthread_sigmask(SIG_BLOCK, &ending, nullptr);
  std::thread([ending, clean_up] {
    int signal = 0;
    if (sigwait(&ending, &signal) != 0) return;
    clean_up();
    _exit(128 + signal);
  }).detach();
}

}  // namespace texbake
