// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/commands.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/interruption.h"
#include "driver/json_document.h"
#include "driver/output/dock_text.h"
#include "driver/slocum/port_dock.h"
#include "driver/slocum/port_folder.h"
#include "driver/terminal.h"
#include "driver/usage/values.h"
#include "hooks/transport/host/serial_port.h"
#include "support/diagnostics/ids/target.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <poll.h>
#include <string>
#include <thread>
#include <unistd.h>

namespace glider::driver {
namespace {

using vehicles::DockEnd;
using vehicles::DockPart;

struct DockOptions {
  bool json = false;
  std::string folder;
  std::string device;
  uint32_t baud = 0;  ///< 0: that of the folder
  std::string part = "auto";
  bool steer = false;
  double minutes = 3;
  std::string output;  ///< the file of the report; empty: none
};

DockPart playedPart(const std::string& word) {
  return word == "vehicle" ? DockPart::Vehicle : word == "sbc" ? DockPart::Sbc : DockPart::Auto;
}

/// A line that the user types; false if there is none, or Ctrl-C came first.
bool readAnswer(std::string& answer) {
  constexpr int kPause = 100;  // ms
  while (Interruption::signal() == 0) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, kPause) <= 0) {
      continue;
    }
    char c = 0;
    if (::read(STDIN_FILENO, &c, 1) != 1) {
      return false;
    }
    if (c == '\n') {
      return true;
    }
    answer += c;
  }
  return false;
}

bool agrees(const std::string& text) {
  tell(text + "Type yes to write this to the vehicle: ");
  std::string answer;
  return readAnswer(answer) && answer == "yes";
}

vehicles::DockHost hostFor(const DockOptions& options, uint32_t baud, const hooks::SerialPort& port,
                           ProgressLine& line) {
  using Clock = std::chrono::steady_clock;
  vehicles::DockHost host;
  host.line = port.stream();
  host.device = options.device;
  host.baud = baud;
  host.now = [] { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); };
  host.errors = [&port]() -> std::optional<vehicles::DockHost::DeviceErrors> {
    const auto errors = port.errors();
    return errors
               ? std::optional(vehicles::DockHost::DeviceErrors{errors->overruns, errors->framing})
               : std::nullopt;
  };
  host.sleep = [](double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  };
  host.stop = [] { return Interruption::signal() != 0; };
  host.progress = [&line](const std::string& text) {
    if (line.onTerminal()) {
      line.show(text);
    }
  };
  if (options.steer) {
    host.confirm = [&line](const std::string& text) {
      line.clear();
      return agrees(text);
    };
  }
  return host;
}

int codeOf(const vehicles::DockResult& result) {
  const bool bad = std::ranges::any_of(result.checks, [](const vehicles::DockCheck& check) {
    return check.verdict == vehicles::DockVerdict::NotGood;
  });
  switch (result.end) {
    case DockEnd::LineGone:
      return kWorldFailed;
    case DockEnd::Interrupted:
      return kInterrupted + Interruption::signal();
    case DockEnd::Complete:
      break;
  }
  return bad ? kMissionHasErrors : kFine;
}

int tellResult(const vehicles::DockResult& result, const DockHeading& heading,
               const DockOptions& options, Json* document) {
  const std::string text = dockText(result, heading);
  if (!options.output.empty()) {
    if (const auto written = support::writeFileAtomically(options.output, text); !written) {
      return reportFailure(written.error());
    }
  }
  if (document != nullptr) {
    addDock(result, heading, *document);
  } else if (const auto printed = printOut(text); !printed) {
    return reportFailure(printed.error());
  }
  return codeOf(result);
}

int dock(const DockOptions& options, Json* document) {
  if (!isPortFolder(options.folder)) {
    return reportFailure(support::fail(support::diagnostics::notPortFolder, options.folder,
                                       "it has no `port.toml`; for a program with the hooks use "
                                       "`glidercc sim MISSION --serial DEVICE`")
                             .error());
  }
  const auto folder = openPortFolder(options.folder);
  if (!folder) {
    return reportFailure(folder.error());
  }
  int status = kFine;
  const auto mission = compileForFlight(folder->mission.string(), status);
  if (status != kFine) {
    return status;
  }
  const auto contents = readFolderPort(options.folder, *mission);
  if (!contents) {
    return reportFailure(contents.error());
  }
  const uint32_t baud = options.baud != 0 ? options.baud : contents->sensors.baud;
  const auto port = hooks::SerialPort::open(options.device, baud);
  if (!port) {
    return reportFailure(port.error());
  }
  constexpr double kMinute = 60;
  // What was written to a vehicle is taken back, and the report is written.
  const Interruption interruption(Interruption::Second::Ignored);
  ProgressLine line;
  const auto result =
      checkPortAtDock(*folder, *contents, *mission, playedPart(options.part),
                      options.minutes * kMinute, hostFor(options, baud, *port, line));
  line.clear();
  return tellResult(result, {options.folder, mission->mission.name, options.device, baud}, options,
                    document);
}

constexpr const char* kDockFooter =
    "With an SBC at the other end, glidercc plays a vehicle: at its prompt, flying another mission "
    "file, flying\n"
    "that of FOLDER, and after its end. With a vehicle at the other end it listens, and writes "
    "nothing without\n"
    "--steer and your `yes`.\n"
    "Exit codes: 0 nothing is wrong, 1 a check is not good, 2 usage error, or a file or the device "
    "failed,\n"
    "130 interrupted by Ctrl-C (the report is written).";

void addOptions(CLI::App& command, DockOptions& options) {
  command.add_option("FOLDER", options.folder, "The folder of `build --dialect extctl`")
      ->required();
  command.add_option("--port", options.device, "Serial device of this computer")
      ->required()
      ->option_text("DEVICE");
  constexpr uint32_t kLeastBaud = 50, kMostBaud = 4'000'000;
  command.add_option("--baud", options.baud, "Bits per second [those of extctl.ini in FOLDER]")
      ->check(CLI::Range(kLeastBaud, kMostBaud))
      ->option_text("N");
  command
      .add_option(
          "--as", options.part,
          "What glidercc plays: vehicle, to an SBC; sbc, to a vehicle; auto, which listens for "
          "10 s and is the vehicle if none reports [auto]")
      ->check(oneOf({"vehicle", "sbc", "auto"}))
      ->option_text("PART");
  command.add_flag("--steer", options.steer,
                   "To a vehicle, also write for a minute, after you have agreed on the terminal; "
                   "it is taken back at the end");
  constexpr double kLeast = 0.05, kMost = 1440;
  command.add_option("--minutes", options.minutes, "How long the check lasts [3]")
      ->check(CLI::Range(kLeast, kMost))
      ->option_text("N");
  command.add_option("-o", options.output, "Also write the check-list to this file")
      ->option_text("REPORT");
  addFormatOption(command, options.json);
}

}  // namespace

void addDockCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<DockOptions>();
  CLI::App* command = app.add_subcommand(
      "dock",
      "Check the serial line between an SBC and a vehicle without the hooks, with one of them");
  addOptions(*command, *options);
  command->footer(kDockFooter);
  command->callback([options, &status] {
    if (options->steer && ::isatty(STDIN_FILENO) == 0) {
      throw CLI::ValidationError("--steer", "needs a terminal: you must agree to what is written");
    }
    if (options->steer && options->part == "vehicle") {
      throw CLI::ExcludesError("--steer", "--as vehicle");
    }
    status =
        inFormat(options->json, "dock", [&](Json* document) { return dock(*options, document); });
  });
}

}  // namespace glider::driver
