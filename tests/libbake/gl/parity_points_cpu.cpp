// Compares the points of parity_points.h, as this compiler makes them, with those that a GPU wrote to the file given.
// Exit: 0 equal, 1 different, 4 unreadable.
#include <bit>
#include <cstdio>
#include <cstring>

#include "tests/libbake/gl/parity_points.h"

int main(int argc, char** argv) {
  using texbake::parity::Pixel;
  const std::vector<Pixel> here = texbake::parity::evaluate();
  std::vector<Pixel> there(here.size());
  std::FILE* const file = argc == 2 ? std::fopen(argv[1], "rb") : nullptr;
  if (!file || std::fread(there.data(), sizeof(Pixel), there.size(), file) != there.size()) return 4;
  std::fclose(file);

  unsigned long decisions = 0, values = 0, bits = 0;
  for (size_t i = 0; i < here.size(); ++i) {
    decisions += std::memcmp(here[i].decided, there[i].decided, sizeof here[i].decided) != 0;
    uint32_t a[4], b[4];
    std::memcpy(a, &here[i].value, sizeof a);
    std::memcpy(b, &there[i].value, sizeof b);
    unsigned long differing = 0;
    for (int c = 0; c < 4; ++c) differing += static_cast<unsigned long>(std::popcount(a[c] ^ b[c]));
    values += differing > 0;
    bits += differing;
  }
  std::printf("%zu points: %lu decisions, %lu values, %lu bits differ\n", here.size(), decisions, values, bits);
  return decisions + values > 0 ? 1 : 0;
}
