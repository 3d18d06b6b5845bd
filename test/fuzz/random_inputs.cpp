// Feeds the fuzz target with random inputs: what stands in for a fuzzer in the test suite. Each input has a seed of its
// own, so that the one that fails can be run alone:  stripe_fuzz_random 1 SEED
#include <sanitizer/common_interface_defs.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{
constexpr unsigned kHangSeconds = 60;  ///< an input takes milliseconds
char where[64];                        ///< told when a sanitizer or a broken promise ends the program

void tellWhere()
{
  // NOLINTNEXTLINE(bugprone-unused-return-value)
  if (write(STDERR_FILENO, where, std::strlen(where)) < 0)
    _exit(2);
}

void onSignal(int signal)
{
  tellWhere();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}
}  // namespace

int main(int argc, char** argv)
{
  const long count = argc > 1 ? std::atol(argv[1]) : 1000;
  const long first = argc > 2 ? std::atol(argv[2]) : 1;
  __sanitizer_set_death_callback(tellWhere);
  std::signal(SIGABRT, onSignal);
  std::signal(SIGALRM, onSignal);
  std::vector<std::uint8_t> input;
  for (long seed = first; seed < first + count; ++seed)
  {
    std::snprintf(where, sizeof where, "stripe_fuzz_random: with seed %ld\n", seed);
    alarm(kHangSeconds);
    std::mt19937 random(static_cast<unsigned>(seed));
    input.resize(64 + random() % 448);
    for (std::uint8_t& byte : input)
      byte = static_cast<std::uint8_t>(random());
    // As the fuzzer hands it over: a block of its own, so that reading beyond it is seen.
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::printf("%ld inputs, seeds %ld to %ld, nothing found\n", count, first, first + count - 1);
  return count > 0 ? 0 : 1;
}
