// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/launch_choice.h"
#include "simulator/sbc_port.h"
#include "support/result.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glider::flights {

/// For each flight what starts its SBC, which has a card of its own.
using NewFlight = std::function<simulator::StartSbc()>;

/// Compiles the mission for this process and loads it; `user_code` is what --link names.
/// `keeps_time`: see InProcessSbc.
support::Result<NewFlight> flightsInProcess(const compiler::Optimised& mission,
                                            const LaunchChoice& launch,
                                            const std::vector<std::string>& user_code,
                                            bool keeps_time);

// Each makes what starts the SBC of one flight, as often as its power comes back.

/// flightsInProcess, of one flight.
support::Result<simulator::StartSbc> sbcInProcess(const compiler::Optimised& mission,
                                                  const LaunchChoice& launch,
                                                  const std::vector<std::string>& user_code,
                                                  bool keeps_time);

/// Of a mission that is loaded.
simulator::StartSbc startInProcess(std::shared_ptr<const codegen::LoadedMission> mission,
                                   std::vector<double> parameters, bool keeps_time);

/// Builds the mission's binary for `board` at `binary`; the command that runs it here, without its
/// arguments.
support::Result<std::vector<std::string>> buildOnBoard(const compiler::Optimised& mission,
                                                       const LaunchChoice& launch,
                                                       const std::vector<std::string>& user_code,
                                                       const std::string& board,
                                                       const std::filesystem::path& binary);
/// Starts what buildOnBoard has built, with its log and, as `name`.checkpoint, its checkpoints in
/// `folder`; those of an earlier flight are removed. After `hang_secs` of real time without an
/// answer it counts as hung.
simulator::StartSbc startOnBoard(const std::string& board, std::vector<std::string> command,
                                 const LaunchChoice& launch, const std::filesystem::path& folder,
                                 const std::string& name, double hang_secs);

/// Builds the mission's binary for `board` into `folder` as `name`-`board`, to be started behind a
/// pseudo-terminal, under the board's emulator if it has one.
support::Result<simulator::StartSbc> sbcOnBoard(const compiler::Optimised& mission,
                                                const LaunchChoice& launch,
                                                const std::vector<std::string>& user_code,
                                                const std::string& board, const std::string& name,
                                                const std::filesystem::path& folder);

/// A program that somebody has built, with `--port PTY` as its only arguments.
simulator::StartSbc sbcProgram(const std::string& program);

/// A real SBC at the other end of the serial line at `device`, in real time or, with `lockstep`, as
/// fast as it answers.
simulator::StartSbc sbcOnSerialLine(const std::string& device, bool lockstep);

}  // namespace glider::flights
