// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace glider::tests {

/// The directions of the two lines, as hooks/protocol/model/control.pml numbers them.
enum Direction { kToSbc, kFromSbc, kToFlight, kFromFlight, kDirections };

/// A frame that the model puts on a line, and how many of it get through.
struct ModelFrame {
  std::string type;
  uint32_t link = 0, session = 0, sequence = 0;
  int copies = 0;
  bool recorded = false;  ///< it comes again later
};

/// What hookbeh shows at the end of a round.
struct ModelState {
  std::string state, answer;
  uint32_t session = 0, sequence = 0;
};

/// A tick as the model's SBC lives it.
struct ModelTick {
  std::string decision;  ///< about its checkpoint: "start", "on", "leaves"; empty: none
  std::string mission;   ///< what it does then: "rests", "Take", "Steer", "Release"
  bool dies = false;     ///< it loses its power before the answer
};

struct ModelRound {
  std::array<std::vector<ModelFrame>, kDirections> frames;
  std::vector<ModelTick> ticks;
  ModelState state;
  std::vector<std::string> after;  ///< what goes wrong, or comes right, before the next round
};

/// Flies the model at random with `spin` and reads what it prints.
std::vector<ModelRound> flyModel(int seed);

}  // namespace glider::tests
