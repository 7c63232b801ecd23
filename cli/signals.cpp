#include "cli/signals.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <thread>

namespace texbake {

void end_cleanly_on_signals(void (*clean_up)()) {
  // Every thread inherits the blocked set, so that only the one that waits for them ever sees the signals.
  sigset_t ending;
  sigemptyset(&ending);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, number);
  pthread_sigmask(SIG_BLOCK, &ending, nullptr);
  // A file that grows past the user's limit fails to be written, with a message, instead of ending the program.
  signal(SIGXFSZ, SIG_IGN);

  std::thread([ending, clean_up] {
    int signal = 0;
    if (sigwait(&ending, &signal) != 0) return;
    clean_up();
    _exit(128 + signal);
  }).detach();
}

}  // namespace texbake
