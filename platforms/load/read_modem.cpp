// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/read_modem.h"

#include "platforms/load/read_numbers.h"

#include <algorithm>
#include <cmath>

namespace glider::platforms {
namespace {

constexpr char kMicroModem[] = "micro-modem";
/// At rate 0.
constexpr double kMostFrameBytes = 32;
/// The steps of the simulator are shorter, so that what is sent in one is received in a later one.
constexpr double kShortest_s = 0.5, kLongest_s = 60;

constexpr NumberKey<Modem> kModem[] = {{"frame_bytes", &Modem::frame_bytes},
                                       {"cycle_init_s", &Modem::cycle_init_s},
                                       {"frame_s", &Modem::frame_s},
                                       {"range_m", &Modem::range_m},
                                       {"interference_m", &Modem::interference_m},
                                       {"send_J_per_byte", &Modem::send_j_byte, Least::Zero},
                                       {"receive_J_per_byte", &Modem::receive_j_byte, Least::Zero},
                                       {"listen_W", &Modem::listen_W, Least::Zero}};

}  // namespace

double slotOf(const Modem& modem, double cycle_s) {
  constexpr double kSpeedOfSound = 1500, kDialogue_s = 2, kNap_s = 1;
  const double cycle = std::max(cycle_s, kSlowestCycle_s);
  return std::ceil(modem.cycle_init_s + modem.frame_s + modem.interference_m / kSpeedOfSound +
                   kDialogue_s + 2 * cycle + kNap_s);
}

support::Result<std::optional<Modem>> readModem(const std::string& file, const toml::table& root) {
  if (!root.contains("modem")) {
    return std::nullopt;
  }
  TomlReader reader = tableOf(file, root["modem"], "[modem]");
  Modem modem = readNumbers(reader, kModem, {"kind"});
  modem.kind = reader.text("kind");
  if (modem.kind != kMicroModem) {
    reader.refuse("kind", "must be \"micro-modem\"");
  }
  if (modem.frame_bytes > kMostFrameBytes || modem.frame_bytes != std::floor(modem.frame_bytes)) {
    reader.refuse("frame_bytes", "must be a whole number, at most 32");
  }
  for (const auto& [key, time_s] :
       {std::pair{"cycle_init_s", modem.cycle_init_s}, {"frame_s", modem.frame_s}}) {
    if (!(time_s >= kShortest_s && time_s <= kLongest_s)) {
      reader.refuse(key, "must be between 0.5 and 60");
    }
  }
  if (!(modem.interference_m >= modem.range_m)) {
    reader.refuse("interference_m", "must not be below `range_m`");
  }
  if (reader.failure()) {
    return std::unexpected(*reader.failure());
  }
  return modem;
}

}  // namespace glider::platforms
