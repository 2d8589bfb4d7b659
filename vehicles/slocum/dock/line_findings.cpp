// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/findings.h"
#include "vehicles/slocum/mission_files/line_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace glider::slocum {

using vehicles::DockCheck;
using vehicles::DockPart;
using vehicles::DockVerdict;

DockCheck good(std::string id, std::string what, std::string measured) {
  return {std::move(id), std::move(what), std::move(measured), DockVerdict::Good, ""};
}

DockCheck notGood(std::string id, std::string what, std::string measured, std::string todo) {
  return {std::move(id), std::move(what), std::move(measured), DockVerdict::NotGood,
          std::move(todo)};
}

DockCheck notChecked(std::string id, std::string what, std::string why, std::string todo) {
  return {std::move(id), std::move(what), std::move(why), DockVerdict::NotChecked, std::move(todo)};
}

std::string timeText(double seconds) {
  constexpr double kShort = 0.1, kMilli = 1000;
  return seconds < kShort ? fmt::format("{:.0f} ms", seconds * kMilli)
                          : fmt::format("{:.2f} s", seconds);
}

std::string counted(uint64_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

namespace {

std::string shown(const ExtctlSensor& sensor) {
  return fmt::format("`{}` ({})", sensor.name, sensor.unit);
}

bool has(const std::vector<ExtctlSensor>& list, const std::string& name) {
  return std::ranges::find(list, name, &ExtctlSensor::name) != list.end();
}

/// How the list first differs from that of the program; empty: it does not.
std::string differenceOf(const std::vector<ExtctlSensor>& planned,
                         const std::vector<ExtctlSensor>& given) {
  const size_t common = std::min(planned.size(), given.size());
  size_t at = 0;
  while (at < common && planned[at].name == given[at].name &&
         lowerCase(planned[at].unit) == lowerCase(given[at].unit)) {
    ++at;
  }
  if (at == planned.size() && at == given.size()) {
    return "";
  }
  if (at < planned.size() && !has(given, planned[at].name)) {
    return fmt::format(
        "{} with index {} is missing: the program would read other sensors from there on",
        shown(planned[at]), at);
  }
  if (at < given.size() && !has(planned, given[at].name)) {
    return fmt::format("{} with index {} is not in the program's list", shown(given[at]), at);
  }
  return at < common ? fmt::format("index {} is {}, but {} for the program", at, shown(given[at]),
                                   shown(planned[at]))
                     : fmt::format("index {} is given twice or is missing", at);
}

/// At least nine of ten characters could be read by a person.
bool isText(const std::string& bytes) {
  const auto readable = std::ranges::count_if(bytes, [](unsigned char c) {
    return std::isprint(c) != 0 || c == '\r' || c == '\n' || c == '\t' || c == '\x1b';
  });
  return static_cast<size_t>(readable) * 10 >= bytes.size() * 9;
}

/// The first words of what arrived, on one line.
std::string wordsOf(const std::string& bytes) {
  constexpr size_t kMost = 40;
  std::string text;
  for (const char letter : bytes) {
    const auto c = static_cast<unsigned char>(letter);
    const bool space = c == ' ' || c == '\r' || c == '\n' || c == '\t';
    if (!space || !(text.empty() || text.back() == ' ')) {
      text += space ? ' ' : std::isprint(c) != 0 ? letter : '?';
    }
  }
  return text.substr(0, kMost);
}

std::string silenceTodo(const DockRun& run, DockPart part) {
  const std::string wires =
      "check that TX of each end is wired to RX of the other, and ground to ground";
  const std::string sbc = fmt::format(
      "start `{}` of the folder on the SBC with `--port DEVICE --baud {}` (that of another folder "
      "may expect more sensors, and stay silent)",
      run.setup().program, run.host().baud);
  const std::string vehicle =
      "at the vehicle type `put c_extctl_on 1`, and check `uart` in its proglets.dat";
  return part == DockPart::Vehicle ? fmt::format("{}; {}", sbc, wires)
         : part == DockPart::Sbc
             ? fmt::format("{}; {}", vehicle, wires)
             : fmt::format("for an SBC: {}; for a vehicle: {}; {}", sbc, vehicle, wires);
}

}  // namespace

DockCheck listFinding(const DockSetup& setup) {
  const std::string difference = differenceOf(setup.plan.extctl.sensors(), setup.sensors.sensors());
  const auto count = setup.sensors.sensors().size();
  return difference.empty()
             ? good("sensor-list", "extctl.ini of the folder",
                    fmt::format("{}, as the program knows them", counted(count, "sensor")))
             : notGood("sensor-list", "extctl.ini of the folder", difference,
                       "build the folder again, and copy its extctl.ini to the vehicle");
}

DockCheck baudFinding(const DockSetup& setup, uint32_t baud) {
  const std::string text = fmt::format("{} baud", baud);
  return baud == setup.sensors.baud
             ? good("baud", "baud rate", text + ", as extctl.ini says")
             : notGood("baud", "baud rate",
                       fmt::format("{}, but {} in extctl.ini", text, setup.sensors.baud),
                       "leave out `--baud`, or write the rate of the vehicle into extctl.ini");
}

DockCheck lineFinding(const DockLine& line) {
  const DockLine::Counts& counts = line.counts();
  std::string text = counted(counts.sentences, "sentence");
  if (counts.damaged == 0 && counts.stray == 0 && counts.echoes == 0) {
    return good("line", "what arrives", text + ", none damaged, nothing between them");
  }
  text +=
      fmt::format(", {} damaged, {} between them", counts.damaged, counted(counts.stray, "byte"));
  text += counts.echoes == 0 ? "" : fmt::format(", {} of them what was sent", counts.echoes);
  return notGood("line", "what arrives", text,
                 counts.echoes != 0
                     ? "the other end echoes: end the login prompt (getty) on its port"
                     : "a shorter or shielded cable, a common ground, the same baud rate at both "
                       "ends, and nothing else that writes to the port");
}

DockCheck loadFinding(uint32_t baud, double most_bytes, double cycle_s, const std::string& text) {
  constexpr double kMostShare = 0.8;
  const double needs_s = most_bytes * kBitsOfByte / baud;
  const double share = needs_s / cycle_s;
  const std::string measured = fmt::format(
      "{}; the fullest control cycle needs {} of {:.3g} s, {:.0f} % of the capacity at {} baud",
      text, timeText(needs_s), cycle_s, 100 * share, baud);
  return share <= kMostShare
             ? good("load", "load of the line", measured)
             : notGood("load", "load of the line", measured,
                       "read fewer sensors in the mission, or raise `baud` in extctl.ini and of "
                       "the program");
}

DockCheck deviceFinding(const vehicles::DockHost::DeviceErrors& before,
                        const vehicles::DockHost::DeviceErrors& after) {
  const std::string what = "errors that the device counts";
  const uint32_t overruns = after.overruns - before.overruns;
  const uint32_t framing = after.framing - before.framing;
  const std::string text =
      fmt::format("{}, {}", counted(overruns, "overrun"), counted(framing, "framing error"));
  return overruns + framing == 0
             ? good("device-errors", what, text)
             : notGood("device-errors", what, text,
                       overruns > framing
                           ? "this computer is too busy or its adapter too slow: use another port"
                           : "check that both ends have the same baud rate and levels");
}

DockCheck goneFinding(double now_s) {
  return notGood("device", "the device",
                 fmt::format("it was closed or unplugged after {:.1f} s", now_s),
                 "plug it in again, and repeat the check");
}

DockCheck sameSideFinding(DockPart part) {
  const bool vehicle = part == DockPart::Vehicle;
  return notGood(
      "other-end", "the other end",
      vehicle ? "it is a vehicle: it reports sensors" : "it is an SBC: it writes sensors",
      vehicle ? "use `--as sbc`" : "use `--as vehicle`");
}

DockCheck nobodyFinding(const DockRun& run, DockPart part, double seconds) {
  const DockLine::Counts& counts = run.line().counts();
  const std::string what = "the other end";
  if (counts.echoes > 0) {
    return notGood(
        "other-end", what,
        fmt::format("only what was sent came back: {}", counted(counts.echoes, "sentence")),
        "RX and TX of this end are joined, or a login prompt (getty) at the other end "
        "echoes");
  }
  constexpr uint64_t kFew = 8;
  if (counts.bytes < kFew) {
    return notGood("other-end", what, fmt::format("nothing arrived in {:.0f} s", seconds),
                   silenceTodo(run, part));
  }
  if (isText(run.line().beginning())) {
    return notGood(
        "other-end", what,
        fmt::format("text arrived, but no sentence: \"{}\"", wordsOf(run.line().beginning())),
        "end the console or login prompt (getty) that uses the port at the other end");
  }
  return notGood("other-end", what,
                 fmt::format("{} arrived, but no sentence", counted(counts.bytes, "byte")),
                 fmt::format("the other end has another baud rate than {}: try `--baud`; or its "
                             "levels are others (RS-232 or TTL)",
                             run.host().baud));
}

}  // namespace glider::slocum
