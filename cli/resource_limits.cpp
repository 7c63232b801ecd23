#include "cli/resource_limits.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <fstream>
#include <latch>
#include <string>
#include <thread>
#include <vector>

#include "libbake/base/error.h"

namespace texbake {
namespace {

/// Private writable memory, which is what RLIMIT_DATA counts: VmData of /proc/self/status, 0 where there is none.
uint64_t data_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key;) {
    uint64_t kibibytes = 0;
    if (key == "VmData:" && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

/// Starts `count` threads at once, and ends them: TBB, which will start as many, does not tell its caller when the
/// system has none left. Throws std::system_error.
void try_threads(int count) {
  std::latch begin(1);
  std::vector<std::thread> threads;
  const auto end_all = [&] {
    begin.count_down();
    for (std::thread& thread : threads) thread.join();
  };
  try {
    while (static_cast<int>(threads.size()) < count) threads.emplace_back([&begin] { begin.wait(); });
  } catch (...) {
    end_all();
    throw;
  }
  end_all();
}

}  // namespace

ThreadLimit::ThreadLimit(int threads) {
  const int count = threads > 0 ? threads : tbb::info::default_concurrency();
  try_threads(count - 1);  // one is the caller's
  control_ = new tbb::global_control(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(count));
}

ThreadLimit::~ThreadLimit() { delete static_cast<tbb::global_control*>(control_); }

void limit_memory(uint64_t bytes) {
  const uint64_t taken = data_bytes();
  if (taken > bytes)
    throw Error(ErrorKind::limit,
                fmt::format("--max-memory: the program takes {} MiB before it begins, but only {} MiB are allowed",
                            taken >> 20, bytes >> 20));
  const rlimit limit{bytes, bytes};
  if (setrlimit(RLIMIT_DATA, &limit) != 0)
    throw Error(ErrorKind::unsupported, "--max-memory: this system does not allow a program to limit its memory");
}

uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace texbake
