// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/commands.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"
#include "flights/fleet/deck_messages.h"
#include "hooks/janus/packet.h"
#include "support/counted.h"
#include "support/diagnostics/ids/flights.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace glider::driver {
namespace {

using flights::DeckMessage;
using flights::HeardMessage;

struct MessagesOptions {
  bool json = false;
  std::string mission;
  std::vector<std::string> send;
  std::string read;  ///< empty: nothing
  uint32_t source = 15;
  uint32_t janus_class = hooks::janus::kReferenceClass;
};

std::string sharesOf(const ir::Mission& mission, const ir::ShareMessage& message) {
  std::string names;
  for (uint32_t i = 0; i < message.count; ++i) {
    names += (i == 0 ? "" : ", ") + mission.shares[message.first + i].name;
  }
  return names;
}

/// "a mini packet of 10 of 13 bits", "a frame of 5 bytes".
std::string carriedBy(const ir::ShareMessage& message) {
  return message.mini_bits != 0
             ? fmt::format("a mini packet, {} of {} bits", message.mini_bits, ir::kMiniPacketBits)
             : fmt::format("a frame, {} of 32 bytes", message.bytes);
}

std::string janusRoom(const ir::ShareMessage& message) {
  return message.bits <= hooks::janus::kBlockBits
             ? fmt::format("{} of {} bits", message.bits, hooks::janus::kBlockBits)
             : fmt::format("{} bits, more than {}", message.bits, hooks::janus::kBlockBits);
}

int list(const ir::Mission& mission, Json* document) {
  std::string text;
  for (const ir::ShareMessage& message : ir::messagesOf(mission)) {
    const double period_s = mission.shares[message.first].period_s;
    if (document != nullptr) {
      Json names = Json::array();
      for (uint32_t i = 0; i < message.count; ++i) {
        names.push_back(mission.shares[message.first + i].name);
      }
      (*document)["messages"].push_back({{"shares", std::move(names)},
                                         {"every_s", period_s},
                                         {"bytes", message.bytes},
                                         {"bits", message.bits},
                                         {"mini_bits", message.mini_bits}});
    }
    text += fmt::format("every {:g} s: {}\n  from vehicles  {}\n  as JANUS       {}\n", period_s,
                        sharesOf(mission, message), carriedBy(message), janusRoom(message));
  }
  if (document != nullptr) {
    return kFine;
  }
  const auto printed =
      printOut(text.empty() ? fmt::format("mission {} shares nothing\n", mission.name) : text);
  return printed ? kFine : reportFailure(printed.error());
}

std::string textOf(const ir::Mission& mission, const DeckMessage& made) {
  std::string text = flights::shownMessage(mission, made.message, made.values) + "\n";
  if (!made.mini.empty()) {
    text += "  mini packet  " + made.mini + "\n";
  } else {
    text += "  frame        " + made.frame + "\n";
  }
  return text + (made.janus.empty() ? "" : "  JANUS        " + made.janus + "\n");
}

int send(const ir::Mission& mission, const MessagesOptions& options, Json* document) {
  const auto made = flights::messagesFor(mission, options.send, options.source,
                                         static_cast<uint8_t>(options.janus_class));
  if (!made) {
    return reportFailure(made.error());
  }
  std::string text;
  for (const DeckMessage& message : *made) {
    text += textOf(mission, message);
    if (document != nullptr) {
      (*document)["messages"].push_back(
          {{"values", flights::shownMessage(mission, message.message, message.values)},
           {"frame", message.mini.empty() ? Json(message.frame) : Json()},
           {"mini_packet", message.mini.empty() ? Json() : Json(message.mini)},
           {"janus", message.janus.empty() ? Json() : Json(message.janus)}});
    }
  }
  const auto printed = document != nullptr ? support::Result<void>() : printOut(text);
  return printed ? kFine : reportFailure(printed.error());
}

/// "ada", or "vehicle 3" if the mission names none of that address.
std::string senderOf(const ir::Mission& mission, uint32_t address) {
  return address >= 1 && address <= mission.vehicles.size() ? mission.vehicles[address - 1]
                                                            : fmt::format("vehicle {}", address);
}

int read(const ir::Mission& mission, const MessagesOptions& options, Json* document) {
  const auto input = support::readFile(options.read == "-" ? "/dev/stdin" : options.read);
  if (!input) {
    return reportFailure(input.error());
  }
  std::string text;
  size_t found = 0, others = 0;
  for (size_t at = 0; at < input->size();) {
    const size_t end = std::min(input->find('\n', at), input->size());
    const std::string_view line = std::string_view(*input).substr(at, end - at);
    at = end + 1;
    const auto heard = flights::messageIn(mission, line, static_cast<uint8_t>(options.janus_class));
    if (!heard) {
      others += line.find_first_not_of(" \t\r") != std::string_view::npos ? size_t{1} : 0;
      continue;
    }
    ++found;
    const std::string values = flights::shownMessage(mission, heard->message, heard->values);
    text += fmt::format("{}: {} ({})\n", senderOf(mission, heard->source), values,
                        flights::nameOf(heard->by));
    if (document != nullptr) {
      (*document)["messages"].push_back({{"from", senderOf(mission, heard->source)},
                                         {"by", flights::nameOf(heard->by)},
                                         {"values", values}});
    }
  }
  if (document == nullptr) {
    if (const auto printed = printOut(text); !printed) {
      return reportFailure(printed.error());
    }
  }
  if (others > 0) {
    tell(fmt::format("glidercc: note: {} without a message of mission {}\n",
                     support::counted(others, "line"), mission.name));
  }
  if (found == 0) {
    return reportFailure(support::fail(support::diagnostics::noMessages,
                                       compiler::shownName(options.read), mission.name)
                             .error());
  }
  return kFine;
}

int messages(const MessagesOptions& options, Json* document) {
  int status = kFine;
  const auto compiled = compileForFlight(options.mission, status);
  if (compiled == nullptr) {
    return status;
  }
  const ir::Mission& mission = compiled->mission;
  if (document != nullptr) {
    (*document)["mission"] = mission.name;
    (*document)["messages"] = Json::array();
  }
  if (!options.read.empty()) {
    return read(mission, options, document);
  }
  return options.send.empty() ? list(mission, document) : send(mission, options, document);
}

constexpr const char* kFooter =
    "A fleet's messages at a ship or a buoy. --read takes what its modem has said, a log of any\n"
    "program: $CARXD and $CAMUA sentences of a Micro-Modem, and lines that end with the 16\n"
    "hexadecimal digits of a JANUS packet. --send prints what its modem must be given. Vehicles\n"
    "receive by Micro-Modem; JANUS is for other stations.\n"
    "Exit codes: 0 success, 1 the mission has errors, 2 usage error, or no message was found.";

}  // namespace

void addMessagesCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<MessagesOptions>();
  CLI::App* command = app.add_subcommand(
      "messages", "Show the acoustic messages of a fleet's mission, read or write them on a ship");
  command->add_option("MISSION", options->mission, "The mission of a vehicle of the fleet")
      ->required();
  auto* read = command
                   ->add_option("--read", options->read,
                                "Show the messages in what a modem has said; `-` is standard input")
                   ->option_text("FILE");
  auto* send = command
                   ->add_option("--send", options->send,
                                "Print the message that tells the vehicles this value of a share, "
                                "such as `top=42 m`; may be repeated")
                   ->option_text("NAME=VALUE")
                   ->allow_extra_args(false)
                   ->excludes(read);
  command
      ->add_option("--from", options->source,
                   "Address of the ship's modem, which no vehicle has [15]")
      ->check(CLI::Range(1U, 15U))
      ->option_text("ADDRESS")
      ->needs(send);
  command
      ->add_option("--janus-class", options->janus_class,
                   "Class of user of JANUS packets [16, of the reference implementation]")
      ->check(CLI::Range(0U, 255U))
      ->option_text("NUMBER");
  command->footer(kFooter);
  addFormatOption(*command, options->json);
  command->callback([options, &status] {
    status = inFormat(options->json, "messages",
                      [&](Json* document) { return messages(*options, document); });
  });
}

}  // namespace glider::driver
