// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/faults_toml.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace glider::campaign {

using simulator::LineFault;
using simulator::SensorFault;
using simulator::Span;

namespace {

std::string timesOf(const Span& span) {
  return fmt::format("from_s = {}\n", span.from_s) +
         (std::isinf(span.to_s) ? "" : fmt::format("to_s = {}\n", span.to_s));
}

std::string lineToToml(const LineFault& fault) {
  constexpr std::array<const char*, 4> kWays = {"to_sbc", "from_sbc", "to_flight", "from_flight"};
  std::string out =
      fmt::format("[[faults.line]]\nline = \"{}\"\n", kWays[static_cast<size_t>(fault.way)]) +
      timesOf(fault.when);
  const auto put = [&](const char* key, double value, double usual) {
    out += value == usual ? "" : fmt::format("{} = {}\n", key, value);
  };
  out += fault.cut ? "cut = true\n" : "";
  put("loss", fault.loss, 0);
  put("flips", fault.flips, 0);
  put("bursts", fault.bursts, 0);
  put("burst_bytes", fault.burst_bytes, LineFault().burst_bytes);
  put("delay_s", fault.delay_s, 0);
  put("doubled", fault.doubled, 0);
  put("replayed", fault.replayed, 0);
  put("heard_at_baud", fault.heard_at_baud, 0);
  return out;
}

/// The fault of a sensor in the words of a scenario file.
std::string wrongToToml(const SensorFault& fault) {
  using Kind = SensorFault::Kind;
  switch (fault.kind) {
    case Kind::Frozen:
      return "frozen = true";
    case Kind::Missing:
      return fault.share < 1 ? fmt::format("missing = true\nmissing_share = {}", fault.share)
                             : "missing = true";
    case Kind::Drift:
      return fmt::format("drift_per_s = {}", fault.value);
    case Kind::Scale:
      return fmt::format("scale = {}", fault.value);
    case Kind::Offset:
      return fmt::format("offset = {}", fault.value);
    case Kind::Jumps:
      return fmt::format("jumps = {}\njumps_share = {}", fault.value, fault.share);
    case Kind::Sways:
      return fmt::format("sways = {}\nperiod_s = {}", fault.value, fault.period_s);
    case Kind::Value:
      break;
  }
  return fmt::format("value = {}", fault.value) +
         (fault.share < 1 ? fmt::format("\nvalue_share = {}", fault.share) : "");
}

std::string sensorToToml(const SensorFault& fault) {
  return fmt::format("[[faults.sensor]]\nsensor = \"{}\"\n", fault.name) + timesOf(fault.when) +
         wrongToToml(fault) + "\n";
}

/// What happens to the computers themselves.
std::string ownMishaps(const simulator::Faults& faults) {
  std::string out;
  for (const double at_s : faults.aborts) {
    out += fmt::format("[[faults.abort]]\nat_s = {}\n", at_s);
  }
  for (const auto& fault : faults.card) {
    constexpr std::array<const char*, 3> kKeys = {"flips", "cut", "zeroed"};
    out += fmt::format("[[faults.card]]\nat_s = {}\n{} = {}\n", fault.at_s,
                       kKeys[static_cast<size_t>(fault.kind)], fault.amount);
  }
  for (const auto& restart : faults.flight) {
    out += fmt::format("[[faults.flight]]\nat_s = {}\ntakes_s = {}\nkeeps_array = {}\n",
                       restart.when.from_s, restart.when.to_s - restart.when.from_s,
                       restart.keeps_array);
  }
  for (const auto& leftover : faults.leftover) {
    out += fmt::format("[[faults.leftover]]\nsession = {}\nsequence = {}\ndepth_m = {}\n",
                       leftover.session, leftover.sequence, leftover.depth_m);
  }
  return out;
}

}  // namespace

std::string faultsToToml(const simulator::Faults& faults) {
  std::string out;
  for (const LineFault& fault : faults.lines) {
    out += lineToToml(fault);
  }
  for (const SensorFault& fault : faults.sensors) {
    out += sensorToToml(fault);
  }
  const auto spans = [&](const char* name, const std::vector<Span>& list) {
    for (const Span& span : list) {
      out += fmt::format("[[faults.{}]]\n", name) + timesOf(span);
    }
  };
  spans("power", faults.power);
  spans("port", faults.port);
  spans("stuck", faults.stuck);
  spans("modem", faults.modem);
  spans("console", faults.console);
  for (const Span& span : faults.science) {
    out += fmt::format("[[faults.science]]\nat_s = {}\ntakes_s = {}\n", span.from_s,
                       span.to_s - span.from_s);
  }
  for (const auto& jump : faults.clock) {
    out += fmt::format("[[faults.clock]]\nat_s = {}\nby_s = {}\n", jump.at_s, jump.by_s);
  }
  return out + ownMishaps(faults);
}

std::string drawnToText(const simulator::DrawnFaults& drawn) {
  std::string out = faultsToToml(drawn.faults);
  if (drawn.args) {
    out += fmt::format(
        "# in the mission file: start_secs {}, max_depth {}, min_altitude {}, max_pitch {}, "
        "hold_secs {}, d_bpump_value {}, c_bpump_value {}\n",
        drawn.args->start_secs, drawn.args->max_depth_m, drawn.args->min_altitude_m,
        drawn.args->max_pitch_rad, drawn.args->hold_secs, drawn.args->dive_pump_cc,
        drawn.args->climb_pump_cc);
  }
  if (drawn.vehicle.no_ctd) {
    out += "# in [sensors]: ctd_dropout = 1\n";
  }
  if (drawn.vehicle.altimeter_range_m > 0) {
    out += fmt::format("# in [sensors.altimeter]: range_m = {}, dropout = {}\n",
                       drawn.vehicle.altimeter_range_m, drawn.vehicle.altimeter_dropout);
  }
  if (drawn.vehicle.pressure_every_s > 0) {
    out += fmt::format("# in the mission file: sensor: c_pressure_time(sec) {}\n",
                       drawn.vehicle.pressure_every_s);
  }
  if (drawn.water_depth_m) {
    out += fmt::format("# in [ocean]: water_depth_m = {}\n", *drawn.water_depth_m);
  }
  return out;
}

}  // namespace glider::campaign
