// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/launch_choice.h"
#include "flights/port_end.h"
#include "flights/requirement_watch.h"
#include "simulator/ports/sbc_port.h"
#include "support/result.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::platforms {
struct Platform;
}  // namespace glider::platforms

namespace glider::flights {

/// The end for a vehicle that has no hookprog; empty: hookprog's.
support::Result<std::optional<PortEnd>> usualEnd(const platforms::Platform& platform);

/// Returns, for each flight, what starts its SBC with a card of its own.
using NewFlight = std::function<simulator::StartSbc()>;

/// The same; `watch` (null: none) watches the flight and outlives it.
using NewWatchedFlight = std::function<simulator::StartSbc(RequirementWatch* watch)>;

/// Compiles the mission for this process and loads it; `user_code` is what --link names.
/// `keeps_time`: see InProcessSbc.
support::Result<NewWatchedFlight> flightsInProcess(const compiler::Optimised& mission,
                                                   const LaunchChoice& launch,
                                                   const std::vector<std::string>& user_code,
                                                   bool keeps_time,
                                                   const std::optional<PortEnd>& port = {});

// Each returns what starts the SBC of one flight, again each time that its power returns.

/// As flightsInProcess, for one flight. `watch` (null: none) watches it and outlives it. `port`: as
/// for InProcessSbc.
support::Result<simulator::StartSbc> sbcInProcess(const compiler::Optimised& mission,
                                                  const LaunchChoice& launch,
                                                  const std::vector<std::string>& user_code,
                                                  bool keeps_time, RequirementWatch* watch,
                                                  const std::optional<PortEnd>& port = {});

/// For a mission that is already loaded. `port`: as for InProcessSbc. `turn`: as in LaunchChoice.
simulator::StartSbc startInProcess(std::shared_ptr<const codegen::LoadedMission> mission,
                                   std::vector<double> parameters, bool keeps_time,
                                   RequirementWatch* watch = nullptr,
                                   const std::optional<PortEnd>& port = {},
                                   const std::optional<Turn>& turn = {});

/// The program of sbcProgram, which should be `mission` with its default parameters and keep
/// checkpoints. `watch` (null: none) watches the same mission in this process beside it.
support::Result<simulator::StartSbc> sbcProgramOf(const compiler::Optimised& mission,
                                                  const std::vector<std::string>& user_code,
                                                  const std::string& program,
                                                  RequirementWatch* watch,
                                                  const std::optional<PortEnd>& port = {});

/// Builds the mission's binary for `board` at `binary`; returns the command that runs it here,
/// without its arguments.
support::Result<std::vector<std::string>> buildOnBoard(const compiler::Optimised& mission,
                                                       const LaunchChoice& launch,
                                                       const std::vector<std::string>& user_code,
                                                       const std::string& board,
                                                       const std::filesystem::path& binary,
                                                       const std::optional<PortEnd>& port = {});
/// Starts the binary of buildOnBoard, with its log and its checkpoints (`name`.checkpoint) in
/// `folder`; those of an earlier flight are removed. It counts as hung after `hang_secs` of real
/// time without an answer.
simulator::StartSbc startOnBoard(const std::string& board, std::vector<std::string> command,
                                 const LaunchChoice& launch, const std::filesystem::path& folder,
                                 const std::string& name, double hang_secs,
                                 const std::optional<PortEnd>& port = {});

/// A board, and the TCP port on which its binary waits for a debugger; none: it does not.
struct BoardChoice {
  std::string board;
  std::optional<uint16_t> debugger;
};

/// Builds the mission's binary for the board into `folder` as `name`-`board`, to be started behind
/// a pseudo-terminal, under the board's emulator if it has one. With a debugger it is never taken
/// to be hung. `watch` (null: none) watches the same mission in this process beside it.
support::Result<simulator::StartSbc> sbcOnBoard(const compiler::Optimised& mission,
                                                const LaunchChoice& launch,
                                                const std::vector<std::string>& user_code,
                                                const BoardChoice& choice, const std::string& name,
                                                const std::filesystem::path& folder,
                                                RequirementWatch* watch = nullptr,
                                                const std::optional<PortEnd>& port = {});

/// A program that the user has built, with `--port PTY` as its only arguments.
simulator::StartSbc sbcProgram(const std::string& program, const std::optional<PortEnd>& port = {});

/// A real SBC at the other end of the serial line at `device`, in real time or, with `lockstep`, as
/// fast as it answers. `port`: as for InProcessSbc; empty: the line is hookprog's.
simulator::StartSbc sbcOnSerialLine(const std::string& device, bool lockstep,
                                    const std::optional<PortEnd>& port = {});

}  // namespace glider::flights
