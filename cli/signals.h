// Ends the program on SIGINT and SIGTERM without leaving temporary files behind.
#pragma once

namespace texbake {

/// Must be called before any other thread is started. When a signal arrives, `clean_up` is called on a thread of its
/// own, where it may do what any code may, and the program ends with exit code 128 + signal.
void end_cleanly_on_signals(void (*clean_up)());

}  // namespace texbake
