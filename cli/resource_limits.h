// Holds the program to the threads and the memory that the user granted.
#pragma once

#include <cstdint>

namespace texbake {

/// Lets stages use `threads` threads, 0 for all, for as long as the object lives. Never changes a result. Throws
/// std::system_error where the system does not let that many be started.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();

 private:
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

  void* control_ = nullptr;
};

/// From now on an allocation that would take the program's own memory (heap, stacks; not the code it has loaded) past
/// `bytes` fails with std::bad_alloc. Throws Error(limit) when the program has already taken more.
void limit_memory(uint64_t bytes);

/// The most memory the program has had resident so far.
uint64_t peak_memory_bytes();

}  // namespace texbake
