// Ends the program without leaving temporary files behind, whatever ends it.
#pragma once

namespace texbake {

/// Must be called before any other thread is started. When SIGINT, SIGTERM or SIGHUP arrives, `clean_up` is called on a
/// thread of its own, where it may do what any code may, and the program ends with exit code 128 + signal. Throws
/// std::system_error where no thread can be started.
void end_cleanly_on_signals(void (*clean_up)());

/// From now on an exception that nothing catches, as in a thread of a library, ends the program with `exit_code`, a
/// message on stderr and a call of `clean_up`.
void end_cleanly_on_exceptions(void (*clean_up)(), int exit_code);
/// The same for a call of exit, as a library's, before `expect_end`.
void end_cleanly_on_exit();
/// The program is about to end as it should.
void expect_end();

}  // namespace texbake
