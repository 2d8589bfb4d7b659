// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/recon/takeover.h"

#include "hooks/recon/messages.h"

namespace glider::runtime::recon {

using hooks::recon::Mode;

void Takeover::take(uint8_t mode, double time_s) {
  silent_ = silent_ || time_s - newest_s_ >= kSilenceSecs;
  newest_s_ = time_s;
  if (state_ == State::Taken) {
    return;
  }
  if ((mode & hooks::recon::kNotDeployed) != 0 || mode == Mode::Over) {
    state_ = hasFlown() ? State::Taken : State::Away;
  } else if (mode == Mode::Override) {
    state_ = State::Following;
    silent_ = false;
  } else if (mode == Mode::Launched && state_ == State::Following) {
    state_ = silent_ ? State::Lost : State::Taken;
  } else if (mode == Mode::Launched && state_ == State::Away) {
    state_ = State::Ready;
  }
}

}  // namespace glider::runtime::recon
