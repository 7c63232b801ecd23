// A target, FUZZ_TARGET, under libFuzzer.
#include <cstring>

#include "tests/fuzz/target.h"

namespace {

const texbake::fuzz::Target& this_target() {
  static const texbake::fuzz::Target& found = texbake::fuzz::target(FUZZ_TARGET);
  return found;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  this_target().run({reinterpret_cast<const char*>(bytes), size});
  return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* bytes, size_t size, size_t max_size, unsigned seed) {
  texbake::Random random(seed);
  const std::string before(reinterpret_cast<const char*>(bytes), size);
  const std::string after = this_target().mutate(before, random);
  if (after.size() > max_size) return size;
  std::memcpy(bytes, after.data(), after.size());
  return after.size();
}
