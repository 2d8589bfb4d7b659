// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/remus100/remus_judge.h"

#include "hooks/recon/codec.h"

#include <fmt/format.h>

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
  TimeQuery query;
  if (decode(line, heading)) {
    heading_ = true;
  } else if (decode(line, speed)) {
    speed_ = true;
  } else if (decode(line, depth)) {
    takeCommand(depth.depth_m, heading_ && speed_, now_s);
    heading_ = speed_ = false;
    surface_ = depth.depth_m <= 0;
    if (let_go_ && depth.depth_m > 0) {
      violate(simulator::JudgeId::Commands, now_s,
              fmt::format("a goal of {:.1f} m after the end of the override", depth.depth_m));
    }
  } else if (decode(line, request)) {
    let_go_ = !request.on;
    if (let_go_ && !surface_) {
      violate(simulator::JudgeId::Commands, now_s,
              "an end of the override without goals of the surface, should it be lost");
    }
    surface_ = false;
    takeEnd(!request.on, now_s);
  } else if (decode(line, query)) {
    let_go_ = false;  // a program that has just started
  }
}

}  // namespace glider::remus100
