// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/remus100/remus_judge.h"

#include "hooks/recon/codec.h"

namespace glider::remus100 {

using namespace hooks::recon;

void RemusJudge::said(std::span<const uint8_t> bytes, double now_s) {
  for (const uint8_t byte : bytes) {
    if (Line line; lines_.push(byte, &line)) {
      hear(line, now_s);
    }
  }
}

void RemusJudge::hear(const Line& line, double now_s) {
  HeadingGoal heading;
  SpeedGoal speed;
  DepthGoal depth;
  Override request;
  if (decode(line, heading)) {
    heading_ = true;
  } else if (decode(line, speed)) {
    speed_ = true;
  } else if (decode(line, depth)) {
    takeCommand(depth.depth_m, heading_ && speed_, now_s);
    heading_ = speed_ = false;
  } else if (decode(line, request)) {
    takeEnd(!request.on, now_s);
  }
}

}  // namespace glider::remus100
