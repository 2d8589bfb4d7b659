// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the serial lines carry at saturation and in a usual cycle, and the latency from a sensor's
// change to the command at hookbeh. See bench/link.

#include "bench/link_parts/chain.h"
#include "bench/link_parts/saturation.h"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <vector>

namespace {

using namespace glider::bench;

void latency(const char* name, uint16_t watched, double damage, uint64_t seed) {
  constexpr size_t kChanges = 10000;
  const auto chain = std::make_unique<Chain>(watched, damage, seed);
  const std::vector<double> sorted = chain->latencies(kChanges);
  const auto at = [&](double share) {
    return sorted[static_cast<size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  fmt::print("  {:<24} {:7.3f} % of bytes damaged: p50 {:5.2f}  p99 {:5.2f}  most {:6.2f} cycles\n",
             name, 100 * damage, at(0.5), at(0.99), sorted.back());
}

}  // namespace

int main(int argc, char** argv) {
  const uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
  constexpr double kSeconds = 60;
  fmt::print("115200 baud, 8N1, Ticks back to back for {} s, shares of 11520 bytes/s:\n", kSeconds);
  for (const size_t sensors : {4U, 8U, 16U, 32U, 64U}) {
    std::make_unique<Saturation>(sensors, 1)->run(kSeconds);
  }
  std::make_unique<Saturation>(64, 0.25)->run(kSeconds);
  fmt::print(
      "\nFrom a sensor's change on board to hookbeh obeying the instruction that it caused, 10,000 "
      "changes, seed {}:\n",
      seed);
  for (const double damage : {0.0, 0.0001, 0.001}) {
    latency("flight sensor (depth)", GLIDER_M_DEPTH, damage, seed);
    latency("science sensor (temp)", GLIDER_SCI_WATER_TEMP, damage, seed);
  }
  return 0;
}
