// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookprog/hookprog.h"
#include "hooks/seat/seat.h"
#include "hooks/transport/byte_stream.h"

#include <functional>
#include <memory>

namespace glider::simulator {

/// The proglet of the science computer that serves the SBC.
class SbcProglet {
 public:
  SbcProglet() = default;
  SbcProglet(const SbcProglet&) = delete;
  SbcProglet& operator=(const SbcProglet&) = delete;
  virtual ~SbcProglet() = default;

  /// A science cycle at `now_s` of the flight: takes the flight controller's updates, serves the
  /// SBC.
  virtual void run(double now_s, const hooks::ScienceMemory& memory,
                   const GliderByteStream& sbc) = 0;
  virtual hooks::SeatEvent nextEvent() = 0;
  [[nodiscard]] virtual hooks::SbcView sbc() const = 0;
  /// It does not expect the SBC to read its line now.
  [[nodiscard]] virtual bool sbcMaySleep() const { return false; }
};

/// Makes the proglet, at the start of the science computer and after each restart.
using MakeProglet = std::function<std::unique_ptr<SbcProglet>(const GliderDictionary&)>;

/// hookprog.
class HookprogProglet final : public SbcProglet {
 public:
  HookprogProglet(const GliderDictionary& dictionary, const hooks::SeatOptions& options)
      : hookprog_(dictionary, options) {}

  void run(double now_s, const hooks::ScienceMemory& memory, const GliderByteStream& sbc) override {
    hookprog_.run(now_s, memory, sbc);
  }
  hooks::SeatEvent nextEvent() override { return hookprog_.nextEvent(); }
  [[nodiscard]] hooks::SbcView sbc() const override { return hookprog_.sbc(); }
  [[nodiscard]] bool sbcMaySleep() const override { return !hookprog_.wantsSbc(); }

 private:
  hooks::Hookprog hookprog_;
};

/// `virtual_time`: reported to the SBC, whose clock then waits.
inline MakeProglet makeHookprog(bool virtual_time) {
  return [virtual_time](const GliderDictionary& dictionary) {
    return std::make_unique<HookprogProglet>(dictionary,
                                             hooks::SeatOptions{.virtual_time = virtual_time});
  };
}

}  // namespace glider::simulator
