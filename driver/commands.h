// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace CLI {
class App;
}

namespace glider::driver {

/// Each adds one subcommand to `app`; running it sets `status` to an ExitCode.
void addCheckCommand(CLI::App& app, int& status);
void addBuildCommand(CLI::App& app, int& status);
void addNewCommand(CLI::App& app, int& status);
void addParamsCommand(CLI::App& app, int& status);
void addGraphCommand(CLI::App& app, int& status);
void addSimCommand(CLI::App& app, int& status);
void addBriefCommand(CLI::App& app, int& status);
void addCampaignCommand(CLI::App& app, int& status);
void addDockCommand(CLI::App& app, int& status);
void addMessagesCommand(CLI::App& app, int& status);
void addMiCommand(CLI::App& app, int& status);
void addLogCommand(CLI::App& app, int& status);
void addDiffCommand(CLI::App& app, int& status);
void addExplainCommand(CLI::App& app, int& status);
void addFixCommand(CLI::App& app, int& status);
void addFmtCommand(CLI::App& app, int& status);
void addPlanCommand(CLI::App& app, int& status);
void addPlatformCommand(CLI::App& app, int& status);
void addTargetsCommand(CLI::App& app, int& status);

}  // namespace glider::driver
