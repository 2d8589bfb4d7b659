// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::driver {

/// The exit status of the command.
enum ExitCode : int {
  kFine = 0,
  kMissionHasErrors = 1,  ///< the mission has errors, its flight ended with a warning,
                          ///< or a data file is damaged
  kWorldFailed = 2,       ///< usage error, or a file, port or tool failed
  kInterrupted = 128,     ///< plus the number of the signal that ended it: 130 after Ctrl-C
};

}  // namespace glider::driver
