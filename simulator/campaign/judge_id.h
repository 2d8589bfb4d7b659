// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace glider::simulator {

/// Who found a violation.
enum class JudgeId : uint8_t {
#define JUDGE(name, text) name,
#include "simulator/campaign/judges.def"
};

inline constexpr uint32_t kJudges = 0
#define JUDGE(name, text) +1
#include "simulator/campaign/judges.def"
    ;

/// "needless guards".
constexpr const char* nameOf(JudgeId judge) {
  switch (judge) {
#define JUDGE(name, text) \
  case JudgeId::name:     \
    return text;
#include "simulator/campaign/judges.def"
  }
  return "";
}

}  // namespace glider::simulator
