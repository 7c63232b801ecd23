// A target without libFuzzer: a fixed number of executions from its seeds, the same on every machine.
//   fuzz_smoke TARGET EXECUTIONS [SEED]     mutate and run
//   fuzz_smoke TARGET --seeds FOLDER        write the seeds
//   fuzz_smoke TARGET --run FILE...         run these inputs
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/fuzz/target.h"

namespace texbake::fuzz {
namespace {

void write_seeds(const Target& target, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : target.seeds()) write_file(folder / ("seed-" + std::to_string(number++)), seed);
}

/// Mutants of mutants, up to eight generations from a seed.
void smoke(const Target& target, long executions, uint64_t seed) {
  Random random(seed);
  const std::vector<std::string> seeds = target.seeds();
  for (const std::string& one : seeds) target.run(one);
  std::string input;
  for (long i = 0; i < executions; ++i) {
    if (i % 8 == 0) input = seeds[random.below(static_cast<uint32_t>(seeds.size()))];
    input = target.mutate(input, random);
    if (std::getenv("FUZZ_KEEP")) write_file(std::getenv("FUZZ_KEEP"), input);  // the one that crashes stays there
    target.run(input);
  }
  std::printf("%s: %ld executions\n", target.name, executions);
}

}  // namespace
}  // namespace texbake::fuzz

int main(int argc, char** argv) {
  using namespace texbake::fuzz;
  if (argc < 3) return 2;
  const Target& chosen = target(argv[1]);
  if (std::strcmp(argv[2], "--seeds") == 0 && argc == 4)
    write_seeds(chosen, argv[3]);
  else if (std::strcmp(argv[2], "--run") == 0)
    for (int i = 3; i < argc; ++i) chosen.run(read_file(argv[i]));
  else
    smoke(chosen, std::atol(argv[2]), argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  return 0;
}
