#include "mesh/base/random.h"

#include <cmath>
#include <numbers>

namespace swathplan {

std::uint64_t scrambled(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31U);
}

double uniform(std::uint64_t bits) { return static_cast<double>(bits >> 11U) * 0x1.0p-53; }

double uniform_above_0(std::uint64_t bits) {
  return (static_cast<double>(bits >> 11U) + 0.5) * 0x1.0p-53;
}

double normal(double u, double v) {
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

std::array<double, 2> normal_pair(double u, double v) {
  const double radius = std::sqrt(-2.0 * std::log(u));
  const double angle = 2.0 * std::numbers::pi * v;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::uint64_t SeededNumbers::next() { return scrambled(state_ += kSplitmixStep); }

double SeededNumbers::uniform() { return swathplan::uniform(next()); }

std::size_t SeededNumbers::below(std::size_t count) {
  return static_cast<std::size_t>(uniform() * static_cast<double>(count));
}

double SeededNumbers::normal() {
  const double u = 1.0 - uniform();
  return swathplan::normal(u, uniform());
}

std::uint64_t mixed_seed(std::uint64_t seed, std::uint64_t a, std::uint64_t b) {
  SeededNumbers numbers(seed ^ SeededNumbers(a ^ SeededNumbers(b).next()).next());
  return numbers.next();
}

}  // namespace swathplan
