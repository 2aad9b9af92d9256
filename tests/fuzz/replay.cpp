// Without libFuzzer: feeds a target each file of its corpus, and as many damaged copies of each as
// the first argument says, the same ones in every run.
//   fuzz_TARGET COPIES FILE...

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "base/rng.h"
#include "fuzz.h"

namespace {

void feed(const std::string& bytes) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// Flips bits, cuts, repeats and overwrites with what parsers trip over.
std::string damaged(std::string bytes, collage::Rng& rng) {
  static constexpr const char* stumbling_blocks[] = {
      "-1", "0",   "99999999999999999999", "1e400", "nan", "\n", "\"", "{", "[", ",", "/",
      "\\", "\xff"};
  for (std::size_t changes = 1 + rng.below(4); changes > 0 && !bytes.empty(); --changes) {
    const std::size_t at = rng.below(bytes.size());
    const std::size_t count = std::min(1 + rng.below(16), bytes.size() - at);
    switch (rng.below(4)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << rng.below(8)));
        break;
      case 1:
        bytes.erase(at, count);
        break;
      case 2:
        bytes.insert(rng.below(bytes.size()), bytes.substr(at, count));
        break;
      default:
        bytes.replace(at, count, stumbling_blocks[rng.below(std::size(stumbling_blocks))]);
    }
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s COPIES FILE...\n", argv[0]);
    return 2;
  }
  const long copies = std::atol(argv[1]);
  for (int i = 2; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    if (!file) {
      std::fprintf(stderr, "%s cannot be read\n", argv[i]);
      return 1;
    }
    feed(bytes);
    collage::Rng rng(1, static_cast<std::uint64_t>(i));
    for (long copy = 0; copy < copies; ++copy) {
      feed(damaged(bytes, rng));
    }
  }
  return 0;
}
