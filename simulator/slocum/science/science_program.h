// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/science/program_lines.h"
#include "simulator/slocum/science/sbc_proglet.h"
#include "support/result.h"

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glider::simulator {

/// hookprog in a program of an integrator, built from the kit: it acts as the science computer, on
/// this machine or under an emulator of the vehicle's processor. kit/science_bench.c is one, and
/// describes the lines that it speaks.
class ScienceProgram final : public SbcProglet {
 public:
  /// What it is started as, and with which sensors.
  struct Setup {
    std::vector<std::string> command;  ///< the program, looked up in PATH, and its arguments
    GliderDictionary dictionary;       ///< what it points to outlives the program
    bool virtual_time = true;
    /// Called once, with the reason, if the program ends or answers wrongly: from then on the
    /// science computer does nothing.
    std::function<void(const std::string&)> ended;
  };
  explicit ScienceProgram(Setup setup);

  /// Starts the program and greets it, as a flight does. GL9151 if that fails.
  static support::Result<void> tryOut(const std::vector<std::string>& command,
                                      const GliderDictionary& dictionary);

  void run(double now_s, const hooks::ScienceMemory& memory, const GliderByteStream& sbc) override;
  hooks::SeatEvent nextEvent() override;
  [[nodiscard]] hooks::SbcView sbc() const override { return view_; }

 private:
  void fail(const std::string& why);
  void tellSensors(const hooks::ScienceMemory& memory);
  void tellBytes(const GliderByteStream& sbc);
  void sendLeft(const GliderByteStream& sbc);
  /// Obeys one line of the answer to `run`; false if it is not one.
  bool obey(const std::string& line, const hooks::ScienceMemory& memory);

  Setup setup_;
  std::unique_ptr<ProgramLines> lines_;  ///< null: it has ended
  std::string cycle_;                    ///< what it receives in this cycle
  std::vector<uint8_t> to_sbc_;          ///< that the line has not taken yet
  std::deque<hooks::SeatEvent> events_;
  hooks::SbcView view_;
};

}  // namespace glider::simulator
