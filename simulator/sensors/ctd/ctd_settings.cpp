// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/ctd/ctd.h"
#include "simulator/tables/scenario_tables.h"

namespace glider::simulator {
namespace {

void readStaleClimbs(Fields& f, StaleClimbs& stale) {
  stale.on = f.reader().flagOr("stale_climb", false);
  for (const char* key :
       {"stale_climb_s", "stale_climb_flush_s", "stale_climb_after_s", "stale_climb_count"}) {
    if (f.has(key) && !stale.on) {
      f.reader().refuse(key, "has no effect without `stale_climb = true`");
    }
  }
  f.number("stale_climb_s", stale.frozen_s, 0, 1e6);
  f.number("stale_climb_flush_s", stale.flush_s, 0, 1e4);
  f.number("stale_climb_after_s", stale.after_s, 0, 1e7);
  f.number("stale_climb_count", stale.count, 0, 1e6);
}

void readCtd(Fields& f, bool noise_given, CtdSettings& ctd) {
  f.reader().only({"noise_degC", "noise_Spm", "repeat_fraction", "late_s", "non_monotonic_m",
                   "stale_climb", "stale_climb_s", "stale_climb_flush_s", "stale_climb_after_s",
                   "stale_climb_count"});
  if (f.has("noise_degC") && noise_given) {
    f.reader().refuse("noise_degC", "repeats `temperature_degC` of [sensors]");
  }
  f.number("noise_degC", ctd.noise_degC, 0, 10);
  f.number("noise_Spm", ctd.noise_Spm, 0, 1);
  f.number("repeat_fraction", ctd.repeat_fraction, 0, 1);
  f.number("late_s", ctd.late_s, 0, 600);
  f.number("non_monotonic_m", ctd.non_monotonic_m, 0, 100);
  readStaleClimbs(f, ctd.stale_climbs);
}

StaleWater readStaleWater(Fields& f) {
  f.reader().only({"from_s", "to_s"});
  const StaleWater stale{f.reader().number("from_s"), f.reader().number("to_s")};
  if (!(stale.from_s < stale.to_s)) {
    f.reader().refuse("to_s", "must be after `from_s`");
  }
  return stale;
}

}  // namespace

void CtdSettings::read(ScenarioTables& tables) {
  bool noise_given = false;
  tables.table("ocean", [&](Fields& f) { f.number("conductivity_Spm", conductivity, 0, 9); });
  tables.table("sensors", [&](Fields& f) {
    noise_given = f.has("temperature_degC");
    f.number("temperature_degC", noise_degC, 0, 10);
    f.number("ctd_dropout", dropout, 0, 1);
  });
  tables.each("sensors", "stale_water",
              [&](Fields& f) { stale_water.push_back(readStaleWater(f)); });
  tables.part("sensors", "ctd", [&](Fields& f) { readCtd(f, noise_given, *this); });
}

}  // namespace glider::simulator
