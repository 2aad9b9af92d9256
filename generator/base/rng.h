#pragma once

#include <cstdint>

namespace collage {

/// Mixes 64 bits so that every input bit moves every output bit (the finaliser of SplitMix64,
/// Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators").
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// A random stream, the same on every machine. Streams are made where they are used, from the seed
/// and what the numbers are for, so that no result depends on the order in which others drew.
class Rng {
 public:
  Rng(std::uint64_t seed, std::uint64_t stream) : state_(mix_bits(mix_bits(seed) ^ stream)) {}

  std::uint64_t next() { return mix_bits(state_++ * 0xd1342543de82ef95ULL); }
  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// Uniform in 0 … n-1; n ≥ 1. The bias is below n / 2^53.
  std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(n));
  }

 private:
  std::uint64_t state_;
};

}  // namespace collage
