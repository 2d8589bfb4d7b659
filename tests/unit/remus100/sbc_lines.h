// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/codec.h"

#include <string>

/// Lines of an SBC, for what reads them in a simulated REMUS.
namespace glider::testing {

template <typename Message>
std::string lineOf(const Message& message) {
  char bytes[hooks::recon::kMostLine];
  return {bytes, encode(message, bytes, sizeof bytes)};
}

/// Gives a message to `taker` as a line.
template <typename Taker, typename Message>
void give(Taker& taker, const Message& message, double now_s) {
  hooks::recon::LineReader reader;
  for (const char byte : lineOf(message)) {
    if (hooks::recon::Line line; reader.push(static_cast<uint8_t>(byte), &line)) {
      taker.take(line, now_s);
    }
  }
}

template <typename Taker>
void giveGoals(Taker& taker, double depth_m, double now_s) {
  give(taker, hooks::recon::HeadingGoal{90}, now_s);
  give(taker, hooks::recon::SpeedGoal{1.5, hooks::recon::SpeedUnit::MetresPerSecond}, now_s);
  give(taker, hooks::recon::DepthGoal{depth_m}, now_s);
}

}  // namespace glider::testing
