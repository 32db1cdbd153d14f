#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

// Random numbers that are the same on every machine. Standard distributions are not: each standard
// library draws them in its own way.
namespace swathplan {

/// The last step of splitmix64: a hash of 64 bits. Each value has one image only; 0 gives 0.
[[nodiscard]] std::uint64_t scrambled(std::uint64_t z);

/// What splitmix64 adds to its state for each number, the golden ratio as a fraction of 2^64.
inline constexpr std::uint64_t kSplitmixStep = 0x9E3779B97F4A7C15ULL;

/// A number in [0, 1) from the upper 53 of 64 random bits.
[[nodiscard]] double uniform(std::uint64_t bits);
/// The same half a step higher, in (0, 1]: never 0, so that a logarithm may be taken of it.
[[nodiscard]] double uniform_above_0(std::uint64_t bits);

/// A standard normal number from two uniform ones (Box and Muller): `u` in (0, 1], `v` in [0, 1].
/// u = 1 gives 0, u = 0 an infinite number.
[[nodiscard]] double normal(double u, double v);
/// Two that do not depend on each other; normal(u, v) comes first.
[[nodiscard]] std::array<double, 2> normal_pair(double u, double v);

/// A sequence of random numbers (splitmix64) that its seed alone decides.
class SeededNumbers {
 public:
  explicit SeededNumbers(std::uint64_t seed) : state_(seed) {}
  /// 64 random bits.
  std::uint64_t next();
  /// In [0, 1).
  double uniform();
  /// In [0, count); 0 where `count` is 0.
  std::size_t below(std::size_t count);
  /// Standard normal; takes two numbers of the sequence.
  double normal();

 private:
  std::uint64_t state_;
};

/// A seed of its own for each pair (a, b), so that the cells and repeats of a study draw different
/// numbers.
[[nodiscard]] std::uint64_t mixed_seed(std::uint64_t seed, std::uint64_t a, std::uint64_t b = 0);

}  // namespace swathplan
