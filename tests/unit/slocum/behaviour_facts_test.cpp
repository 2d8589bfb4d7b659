// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The arguments of each behaviour with their defaults, as facts of the vehicle's release 10.05: a
// changed row of behaviours.def fails here.

#include "vehicles/slocum/mission_files/behaviour_catalogue.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace glider::slocum {
namespace {

struct Facts {
  std::string_view behaviour;
  std::string_view arguments;  ///< "name default, name default"
};

constexpr Facts kFacts[] = {
    {"abend",
     "overdepth 10000, overdepth_sample_time 15, overtime -1, undervolts 10, "
     "undervolts_sample_time 60, samedepth_for 1800, samedepth_for_sample_time 30, "
     "stalled_for 1800, stalled_for_sample_time 1800, no_cop_tickle_for 48600, "
     "no_cop_tickle_percent -1, no_comms_tickle_for 72, eng_pressure_mul 0.9, "
     "eng_pressure_sample_time 15, max_wpt_distance -1, chk_sensor_reasonableness 1, "
     "reqd_free_heap 50000, leakdetect_sample_time 60, vacuum_min 4, vacuum_max 12, "
     "vacuum_sample_time 120, oil_volume_sample_time 180, max_allowable_busy_cpu_cycles 75, "
     "remaining_charge_min 10, remaining_charge_sample_time 60, use_thruster_for_ascent 0, "
     "invalid_gps 10, check_emergency_battery_active 0, samedepth_for_surfacing 900"},
    {"surface",
     "args_from_file -1, start_when 12, when_secs 1200, when_wpt_dist 10, "
     "when_num_inflections -1, end_action 1, report_all 0, gps_wait_time 300, "
     "keystroke_wait_time 300, end_wpt_dist 0, c_use_bpump 2, c_bpump_value 1000, "
     "c_use_pitch 3, c_pitch_value 0.4538, c_stop_when_air_pump 0, c_use_thruster 0, "
     "c_thruster_value 0, printout_cycle_time 60, gps_postfix_wait_time 60, "
     "force_iridium_use 0, min_time_between_gps_fixes 300, sensor_input_wait_time 10, "
     "when_utc_timestamp -1, when_utc_on_surface 0, strobe_on 0, thruster_burst 0"},
    {"yo",
     "args_from_file -1, start_when 2, start_diving 1, num_half_cycles_to_do -1, "
     "d_target_depth 12, d_target_altitude 5, d_use_bpump 2, d_bpump_value -260, d_use_pitch "
     "3, d_pitch_value -0.4538, d_stop_when_hover_for 180, d_stop_when_stalled_for 240, "
     "d_speed_min -100, d_speed_max 100, d_use_thruster 0, d_thruster_value 0, "
     "d_depth_rate_method 3, d_wait_for_pitch 1, d_wait_for_ballast 100, d_delta_bpump_speed "
     "50, d_delta_bpump_ballast 25, d_time_ratio 1.1, d_use_sc_model 0, "
     "d_max_thermal_charge_time 1200, d_max_pumping_charge_time 300, d_thr_reqd_pres_mul "
     "1.5, c_target_depth 3, c_target_altitude -1, c_use_bpump 2, c_bpump_value 260, "
     "c_use_pitch 3, c_pitch_value 0.4538, c_stop_when_hover_for 180, "
     "c_stop_when_stalled_for 240, c_speed_min 100, c_speed_max -100, c_use_thruster 0, "
     "c_thruster_value 0, end_action 2, stop_when 5, when_secs 1200, when_wpt_dist 10"},
    {"set_heading",
     "args_from_file -1, use_heading 2, heading_value 1000, start_when 0, stop_when 5, "
     "when_secs 1200, end_action 0"},
    {"goto_wpt",
     "start_when 0, stop_when 2, when_wpt_dist 0, wpt_units 0, wpt_x 0, wpt_y 0, utm_zd 19, "
     "utm_zc 19, end_action 0"},
    {"goto_list",
     "args_from_file -1, start_when 0, num_waypoints 0, num_legs_to_run -1, initial_wpt -2, "
     "list_stop_when 7, list_when_wpt_dist 10, end_action 0, primary_wpt 0, "
     "primary_stop_when 15, primary_when_wpt_dist 10"},
    {"dive_to",
     "target_depth 10, target_altitude -1, use_bpump 2, bpump_value -260, use_pitch 1, "
     "pitch_value 0, start_when 0, stop_when_hover_for 180, stop_when_stalled_for 240, "
     "stop_when_air_pump 0, initial_inflection 1, speed_min -100, speed_max 100, "
     "use_thruster 0, thruster_value 0, depth_rate_method 3, wait_for_pitch 1, "
     "wait_for_ballast 100, delta_bpump_speed 50, delta_bpump_ballast 25, time_ratio 1.1, "
     "use_sc_model 0, max_thermal_charge_time 1200, max_pumping_charge_time 300, "
     "thr_reqd_pres_mul 1.5"},
    {"climb_to",
     "target_depth 10, target_altitude -1, use_bpump 2, bpump_value 260, use_pitch 1, "
     "pitch_value 0, start_when 0, stop_when_hover_for -1, stop_when_stalled_for 240, "
     "stop_when_air_pump 0, initial_inflection 1, speed_min 100, speed_max -100, "
     "use_thruster 0, thruster_value 0"},
    {"drift_at_depth",
     "args_from_file -1, start_when 4, when_secs 180, when_wpt_dist 10, when_utc_timestamp "
     "-1, end_action 0, stop_when_hover_for 3600, est_time_to_settle 360, target_depth 100, "
     "target_altitude 20, alt_time 120, target_deadband 5, start_dist_from_target -1, "
     "depth_ctrl 0, bpump_delta_value 1, bpump_delay 0, bpump_deadz_width 30, "
     "bpump_db_frac_dz 0.1, use_pitch 1, pitch_value 0, wait_for_pitch 0, use_thruster 0, "
     "thruster_value 0, enable_steering 0, d_use_bpump 2, d_bpump_value -260, d_use_pitch 3, "
     "d_pitch_value -0.4538, d_use_thruster 0, d_thruster_value 0, c_use_bpump 2, "
     "c_bpump_value 260, c_use_pitch 3, c_pitch_value 0.4538, c_use_thruster 0, "
     "c_thruster_value 0, depth_pitch_limit 0.174, depth_gain_scale 1, depth_p_gain -0.15, "
     "depth_i_gain -0.0001, depth_d_gain 0.1, depth_pitch_deadband 0.0349, "
     "depth_pitch_max_time 60, pressure_median 1, battpos_db 1"},
    {"prepare_to_dive",
     "args_from_file -1, start_when 0, wait_time 720, max_thermal_charge_time 120, "
     "max_pumping_charge_time 1000"},
    {"sensors_in",
     "c_att_time -1, c_pressure_time -1, c_alt_time -1, u_battery_time -1, u_vacuum_time -1, "
     "c_leakdetect_time -1, c_gps_on 0, c_science_all_on -1"},
    {"sample",
     "args_from_file -1, sensor_type 0, state_to_sample 1, sample_time_after_state_change "
     "15, intersample_time 0, nth_yo_to_sample 1, intersample_depth -1, min_depth -5, "
     "max_depth 2000"},
    {"nop_cmds",
     "nop_pitch 0, nop_bpump 0, nop_heading 0, nop_threng 0, secs_to_run -1, nop_air_pump -1"},
    {"mission_ender", "start_when 1"},
    {"oob_abort", "start_when 6, when_secs 120"},
    {"compass_cal", "start_when 0, when_secs 0, num_samples -1, init_wait_time 300"},
    {"comatose",
     "start_sci_hydrophone_collecting 1, start_sci_viper_collecting 1, start_sci_wants_quiet "
     "1, post_inflection_holdoff 30"},
    {"bconsci", "terminate_mission_when_done 1"},
    {"badd_b",
     "args_from_file -1, start_when 1, when_wpt_dist 0, stop_when 0, max_collection_time "
     "1800, max_search_time 1800, min_download_range 2000, max_tries_to_connect 15, "
     "max_badd_errors 30, run_on_surface 0, collect_data_after_range 1, c_badd_mode -1, "
     "c_badd_target_id 0, c_badd_range_secs 60, c_badd_input_parse_secs 30, "
     "c_badd_datacol_status_secs 300, c_badd_clear_remote_data 0, c_badd_transaction_num 0, "
     "air_pump 0"},
};

/// Arguments that glidercc also reads: other releases and simulators of the vehicle have them.
constexpr Facts kOthers[] = {
    {"set_heading", "when_wpt_dist 10"},
    {"goto_wpt", "when_secs 1200"},
    {"dive_to", "when_secs 1200, when_wpt_dist 10, end_action 0"},
    {"climb_to", "when_secs 1200, when_wpt_dist 10, end_action 0"},
    {"drift_at_depth",
     "d_target_depth 100, d_target_altitude 5, d_stop_when_hover_for 180, "
     "d_stop_when_stalled_for 240, d_speed_min -100, d_speed_max 100, c_target_depth 100, "
     "c_target_altitude -1, c_stop_when_hover_for 180, c_stop_when_stalled_for 240, c_speed_min "
     "100, "
     "c_speed_max -100"},
};

using Arguments = std::map<std::string, double, std::less<>>;

void add(std::string_view text, Arguments& to) {
  while (!text.empty()) {
    const size_t comma = std::min(text.find(','), text.size());
    const std::string_view one = text.substr(0, comma);
    const size_t blank = one.find(' ');
    double value = 0;
    std::from_chars(one.data() + blank + 1, one.data() + one.size(), value);
    to.emplace(one.substr(0, blank), value);
    text.remove_prefix(std::min(comma + 2, text.size()));
  }
}

Arguments factsOf(std::string_view behaviour) {
  Arguments all;
  for (const std::span<const Facts> list :
       {std::span<const Facts>(kFacts), std::span<const Facts>(kOthers)}) {
    for (const Facts& facts : list) {
      if (facts.behaviour == behaviour) {
        add(facts.arguments, all);
      }
    }
  }
  if (behaviour == "goto_list") {
    for (int i = 0; i < 8; ++i) {
      for (const char* name : {"wpt_units_", "wpt_x_", "wpt_y_"}) {
        all.emplace(fmt::format("{}{}", name, i), 0);
      }
    }
  }
  return all;
}

TEST(BehaviourFacts, EachArgumentHasTheDefaultOfTheVehicle) {
  size_t count = 0;
  for (const Facts& facts : kFacts) {
    const KnownBehaviour* known = findBehaviour(facts.behaviour);
    ASSERT_NE(known, nullptr) << facts.behaviour;
    for (const auto& [name, value] : factsOf(facts.behaviour)) {
      const KnownArgument* argument = known->find(name);
      ASSERT_NE(argument, nullptr) << facts.behaviour << " " << name;
      EXPECT_EQ(argument->fallback, value) << facts.behaviour << " " << name;
      ++count;
    }
  }
  EXPECT_GT(count, 270U);
}

TEST(BehaviourFacts, TheCatalogueHasNoOtherArgument) {
  std::set<std::string_view> seen;
  for (const KnownBehaviour& known : knownBehaviours()) {
    EXPECT_TRUE(seen.insert(known.name).second) << known.name << " is there twice";
    if (known.name == "hookbeh") {
      continue;  // ours
    }
    const Arguments facts = factsOf(known.name);
    EXPECT_FALSE(facts.empty()) << known.name;
    for (const KnownArgument& argument : known.arguments) {
      EXPECT_TRUE(facts.contains(argument.name)) << known.name << " " << argument.name;
    }
    EXPECT_EQ(known.arguments.size(), facts.size()) << known.name;
  }
}

TEST(BehaviourFacts, DivesAndClimbsOfTheirOwnDifferFromThoseOfAYo) {
  const auto value = [](const char* behaviour, const char* argument) {
    return BehaviourBlock{behaviour, {}, {}}.value(argument);
  };
  EXPECT_EQ(value("yo", "d_target_depth"), 12);
  EXPECT_EQ(value("dive_to", "target_depth"), 10);
  EXPECT_EQ(value("yo", "d_target_altitude"), 5);
  EXPECT_EQ(value("dive_to", "target_altitude"), -1);
  EXPECT_EQ(value("yo", "d_use_pitch"), 3);
  EXPECT_EQ(value("dive_to", "use_pitch"), 1) << "a position of the battery: 0 in";
  EXPECT_EQ(value("climb_to", "stop_when_hover_for"), -1);
  EXPECT_EQ(value("drift_at_depth", "start_when"), 4);
}

}  // namespace
}  // namespace glider::slocum
