// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/fleet/fleet_trouble.h"

#include "simulator/campaign/draw.h"

#include <fmt/format.h>

#include <array>

namespace glider::campaign {
namespace {

using simulator::Draw;
using simulator::Manner;

void addLoss(Draw& draw, FleetTrouble& trouble) {
  trouble.loss = draw.between(0.05, 0.98);
}

/// Each vehicle, or only one, at several times; some noise does not end.
void addNoise(Draw& draw, FleetTrouble& trouble) {
  const size_t count = trouble.noise.size();
  const bool everywhere = draw.chance(0.5);
  const size_t only = draw.below(static_cast<uint32_t>(count));
  for (size_t vehicle = 0; vehicle < count; ++vehicle) {
    if (everywhere || vehicle == only) {
      trouble.noise[vehicle] = draw.windows();
    }
  }
}

void addLiar(Draw& draw, FleetTrouble& trouble) {
  const auto count = static_cast<uint32_t>(trouble.noise.size());
  trouble.liar = {draw.below(count), static_cast<simulator::Lie>(draw.below(simulator::kLies))};
}

}  // namespace

const char* nameOf(FleetFault fault) {
  constexpr std::array<const char*, kFleetFaults> kNames = {"none",  "loss", "silence",
                                                            "noise", "liar", "several"};
  return kNames[static_cast<size_t>(fault)];
}

FleetTrouble drawTrouble(FleetFault fault, uint64_t seed, size_t vehicles, double flight_s) {
  simulator::FlightTimes times;
  times.flight_s = flight_s;
  Draw draw(seed, seed % 2 == 0 ? Manner::Once : Manner::Recurring, times);
  FleetTrouble trouble;
  trouble.noise.resize(vehicles);
  switch (fault) {
    case FleetFault::None:
      break;
    case FleetFault::Loss:
      addLoss(draw, trouble);
      break;
    case FleetFault::Silence:
      trouble.loss = 1;
      break;
    case FleetFault::Noise:
      addNoise(draw, trouble);
      break;
    case FleetFault::Liar:
      addLiar(draw, trouble);
      break;
    case FleetFault::Several:
      addLoss(draw, trouble);
      addNoise(draw, trouble);
      addLiar(draw, trouble);
  }
  return trouble;
}

std::string describe(const FleetTrouble& trouble, const std::vector<std::string>& names) {
  std::string text;
  if (trouble.loss > 0) {
    text += fmt::format("messages lost: {:.0f} %\n", 100 * trouble.loss);
  }
  for (size_t vehicle = 0; vehicle < trouble.noise.size(); ++vehicle) {
    for (const simulator::Span& span : trouble.noise[vehicle]) {
      text += fmt::format(
          "noise at {} from {:.0f} s {}\n", names[vehicle], span.from_s,
          span.to_s == simulator::kForever ? "on" : fmt::format("to {:.0f} s", span.to_s));
    }
  }
  if (trouble.liar) {
    text += fmt::format("{} sends {}\n", names[trouble.liar->vehicle],
                        simulator::nameOf(trouble.liar->lie));
  }
  return text;
}

}  // namespace glider::campaign
