// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Several data files as one table: summary, CSV and netCDF.

#include "slocum/data_tables/csv.h"
#include "slocum/data_tables/netcdf.h"
#include "slocum/data_tables/summary.h"
#include "tests/unit/slocum/data_bench.h"

#include <limits>
#include <netcdf.h>

namespace glider::slocum {
namespace {

using second::Draft;

/// A flight file and a science file of one segment. Both have sci_water_temp and m_depth.
Draft flightDraft() {
  Draft draft;
  draft.extension = "dbd";
  draft.sensors = {{"m_depth", "m", 4, true},
                   {"m_lat", "lat", 8, true},
                   {"m_present_time", "timestamp", 8, true},
                   {"sci_water_temp", "degC", 4, true},
                   {"x_state", "enum", 1, true}};
  draft.rows = {{{'*', 99}, {'*', 5440.5}, {'*', 999}, {'*', 88}, {'*', 7}},
                {{'*', 1.5}, {}, {'*', 1000}, {'*', 17}, {}},
                {{'=', 1.5}, {'*', 5441.25}, {'*', 1004}, {}, {}},
                {{'*', 0.1}, {}, {'*', 1008}, {}, {}}};
  return draft;
}

Draft scienceDraft() {
  Draft draft;
  draft.extension = "ebd";
  draft.sensors = {{"m_depth", "m", 4, true},
                   {"sci_m_present_time", "timestamp", 8, true},
                   {"sci_water_temp", "degC", 4, true}};
  draft.rows = {{{'*', 99}, {'*', 998}, {'*', 88}},
                {{}, {'*', 1002}, {'*', 17.25}},
                {{'*', 1.4}, {}, {'=', 17.25}}};
  return draft;
}

LogFiles readPair(const TestFolder& folder) {
  folder.write("a.ebd", write(scienceDraft()));
  folder.write("a.dbd", write(flightDraft()));
  SensorLists lists;
  return readLogFiles({folder.path()}, lists);
}

TEST(DataTable, MergesTheComputersByTime) {
  const TestFolder folder;
  const LogFiles logs = readPair(folder);
  ASSERT_EQ(logs.files.size(), 2U);
  EXPECT_EQ(logs.files[0].data.computer, Computer::Flight);
  EXPECT_EQ(csvOf(merge(logs.files, {})),
            "time_s,computer,gld_dup_sci_water_temp,m_depth,m_lat,m_present_time,sci_dup_m_depth,"
            "sci_m_present_time,sci_water_temp,x_state\n"
            "1000,flight,17,1.5,,1000,,,,\n"
            "1002,science,,,,,,1002,17.25,\n"
            "1002,science,,,,,1.4,,17.25,\n"
            "1004,flight,,1.5,5441.25,1004,,,,\n"
            "1008,flight,,0.1,,1008,,,,\n");
  EXPECT_EQ(csvOf(merge(logs.files, {"sci_water*", "x_state"})),
            "time_s,computer,sci_water_temp,x_state\n1000,flight,,\n1002,science,17.25,\n"
            "1002,science,17.25,\n1004,flight,,\n1008,flight,,\n");
}

TEST(DataTable, EachComputerHasItsOwnClock) {
  Draft flight = flightDraft(), science = scienceDraft();
  flight.sensors.push_back({"sci_m_present_time", "timestamp", 8, true});
  science.sensors.push_back({"m_present_time", "timestamp", 8, true});
  for (Draft* draft : {&flight, &science}) {
    for (auto& row : draft->rows) {
      row.push_back({'*', 5000});  // the other computer's clock, as this one received it
    }
  }
  const TestFolder folder;
  folder.write("a.dbd", write(flight));
  folder.write("a.ebd", write(science));
  SensorLists lists;
  const LogFiles logs = readLogFiles({folder.path()}, lists);
  ASSERT_EQ(logs.files.size(), 2U);
  EXPECT_EQ(logs.files[0].span(), std::pair(1000.0, 1008.0));
  EXPECT_EQ(logs.files[1].span(), std::pair(1002.0, 1002.0));
  // A file with the other one's clock only is shown by that.
  science.sensors[1].name = "sci_x";
  folder.write("a.ebd", write(science));
  const LogFiles other = readLogFiles({folder.path()}, lists);
  EXPECT_EQ(other.files[1].span(), std::pair(5000.0, 5000.0));
}

TEST(DataTable, SummaryCountsUpdatesWithoutInitialValues) {
  const TestFolder folder;
  const LogFiles logs = readPair(folder);
  const std::string text = summaryOf(logs.files, {"m_depth", "x_state", "m_l*", "sci_water_temp"});
  EXPECT_EQ(
      text,
      "unit: 2 files, times in UTC\n"
      "  a.dbd  flight   TEST.MI  segment unit-2024-183-2-7, 1970-01-01 00:16:40 to 1970-01-01 "
      "00:16:48, 4 records\n"
      "  a.ebd  science  TEST.MI  segment unit-2024-183-2-7, 1970-01-01 00:16:42 to 1970-01-01 "
      "00:16:42, 3 records\n"
      "\n"
      "  sensor          unit  updates      min      max     last\n"
      "  m_depth         m           3      0.1      1.5      0.1\n"
      "  m_lat           lat         1  5441.25  5441.25  5441.25\n"
      "  sci_water_temp  degC        2    17.25    17.25    17.25\n"
      "  x_state         enum        0        -        -        7\n");
  EXPECT_NE(summaryOf(logs.files, {}).find("and 1 sensor that was never updated"),
            std::string::npos);
}

TEST(DataTable, PatternsMatchWholeNames) {
  EXPECT_TRUE(matches("m_gps_lat", "m_gps_lat"));
  EXPECT_FALSE(matches("m_gps_lat", "m_gps"));
  EXPECT_TRUE(matches("m_gps_lat", "m_*"));
  EXPECT_TRUE(matches("m_gps_lat", "*lat"));
  EXPECT_FALSE(matches("m_lat_x", "*lat")) << "at the end, not anywhere";
  EXPECT_TRUE(matches("m_gps_lat", "*gps*"));
  EXPECT_TRUE(matches("m_gps_lat", "m*_l*t"));
  EXPECT_TRUE(matches("m_gps_lat", "*"));
  EXPECT_FALSE(matches("m_gps_lat", "x*"));
  EXPECT_FALSE(matches("m_gps_lat", "*lon"));
  EXPECT_FALSE(matches("ab", "ab*b")) << "one letter cannot be used twice";
  EXPECT_FALSE(matches("", "a"));
}

TEST(DataTable, OfOneSegmentTheFileWithMostSensorsIsKept) {
  const TestFolder folder;
  Draft small = flightDraft();
  small.extension = "sbd";
  small.sensors.pop_back();
  for (auto& row : small.rows) {
    row.pop_back();
  }
  folder.write("a.dbd", write(flightDraft()));
  folder.write("a.dcd", second::pack(write(flightDraft())));
  folder.write("a.sbd", write(small));
  SensorLists lists;
  const LogFiles logs = readLogFiles({folder.path()}, lists);
  ASSERT_EQ(logs.files.size(), 1U);
  EXPECT_EQ(logs.files[0].path.filename(), "a.dbd");
  EXPECT_EQ(logs.skipped.size(), 2U);
}

TEST(DataTable, ALaterFileBringsTheListThatAnEarlierOneNeeds) {
  const TestFolder folder;
  Draft factored = flightDraft(), whole = flightDraft();
  factored.factored = true;
  whole.full_name = "unit-2024-183-2-8";
  folder.write("a.dbd", write(factored));
  folder.write("b.dbd", write(whole));
  SensorLists lists;
  const LogFiles logs = readLogFiles({folder.path()}, lists);
  EXPECT_EQ(logs.files.size(), 2U);
  EXPECT_TRUE(logs.failures.empty());
}

TEST(DataTable, DamageIsListedAndTheRestIsKept) {
  const TestFolder folder;
  const std::string bytes = write(flightDraft());
  folder.write("a.dbd", bytes.substr(0, bytes.size() - 3));
  folder.write("b.dbd", "hello");
  SensorLists lists;
  const LogFiles logs = readLogFiles({folder.path(), folder.path() / "none"}, lists);
  ASSERT_EQ(logs.files.size(), 1U);
  EXPECT_EQ(logs.files[0].data.records, 3U);
  ASSERT_EQ(logs.failures.size(), 3U);
  EXPECT_EQ(support::code(logs.failures[0].id), "GL5203");
  EXPECT_NE(logs.failures[0].message.find("is damaged at byte "), std::string::npos);
  EXPECT_EQ(logs.failures[0].hint, "3 records were read");
  EXPECT_EQ(support::code(logs.failures[1].id), "GL5200");
  EXPECT_EQ(support::code(logs.failures[2].id), "GL9001");
}

/// Reads one variable of a netCDF file back.
std::vector<double> variableOf(int file, const char* name, size_t count) {
  int id = -1;
  EXPECT_EQ(nc_inq_varid(file, name, &id), NC_NOERR) << name;
  std::vector<double> values(count);
  EXPECT_EQ(nc_get_var_double(file, id, values.data()), NC_NOERR) << name;
  return values;
}

std::string attributeOf(int file, const char* variable, const char* name) {
  int id = NC_GLOBAL;
  size_t size = 0;
  if (*variable != '\0') {
    EXPECT_EQ(nc_inq_varid(file, variable, &id), NC_NOERR);
  }
  EXPECT_EQ(nc_inq_attlen(file, id, name, &size), NC_NOERR) << name;
  std::string text(size, '\0');
  EXPECT_EQ(nc_get_att_text(file, id, name, text.data()), NC_NOERR) << name;
  return text;
}

TEST(DataTable, NetcdfHoldsTheSameTable) {
  const TestFolder folder;
  const LogFiles logs = readPair(folder);
  const auto path = folder.path() / "out.nc";
  const auto written = writeNetcdf(merge(logs.files, {}), path);
  ASSERT_TRUE(written) << written.error().message;
  int file = -1;
  ASSERT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file), NC_NOERR);
  EXPECT_EQ(variableOf(file, "time", 5), (std::vector<double>{1000, 1002, 1002, 1004, 1008}));
  EXPECT_EQ(variableOf(file, "computer", 5), (std::vector<double>{0, 1, 1, 0, 0}));
  const auto depth = variableOf(file, "m_depth", 5);
  EXPECT_EQ(depth[0], 1.5);
  EXPECT_TRUE(std::isnan(depth[1]) && std::isnan(depth[2]));
  EXPECT_EQ(depth[4], static_cast<double>(0.1F));
  EXPECT_EQ(variableOf(file, "x_state", 5), std::vector<double>(5, -32768));
  EXPECT_EQ(attributeOf(file, "m_lat", "units"), "lat");
  EXPECT_EQ(attributeOf(file, "sci_water_temp", "computer"), "science");
  EXPECT_EQ(attributeOf(file, "", "segments"), "unit-2024-183-2-7");
  EXPECT_EQ(attributeOf(file, "", "source"), "a.dbd a.ebd");
  nc_close(file);
}

/// Real logs have them: `m_time_til_wpt` of a vehicle that does not approach its waypoint.
TEST(DataTable, NetcdfHoldsInfinities) {
  Draft flight = flightDraft();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  flight.sensors.push_back({"m_time_til_wpt", "s", 4, true});
  for (size_t i = 0; i < flight.rows.size(); ++i) {
    flight.rows[i].push_back({'*', i == 2 ? -kInfinity : kInfinity});
  }
  const TestFolder folder;
  folder.write("a.dbd", write(flight));
  SensorLists lists;
  const LogFiles logs = readLogFiles({folder.path()}, lists);
  const auto path = folder.path() / "out.nc";
  const auto written = writeNetcdf(merge(logs.files, {}), path);
  ASSERT_TRUE(written) << written.error().message;
  int file = -1;
  ASSERT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file), NC_NOERR);
  EXPECT_EQ(variableOf(file, "m_time_til_wpt", 3),
            (std::vector<double>{kInfinity, -kInfinity, kInfinity}));
  nc_close(file);
}

TEST(DataTable, ANetcdfFileThatCannotBeWrittenIsAFailure) {
  const TestFolder folder;
  const LogFiles logs = readPair(folder);
  const auto written = writeNetcdf(merge(logs.files, {}), folder.path() / "none" / "out.nc");
  ASSERT_FALSE(written);
  EXPECT_EQ(support::code(written.error().id), "GL9002");
}

TEST(DataTable, ANetcdfFileWithoutRowsIsValid) {
  const TestFolder folder;
  Draft draft = flightDraft();
  draft.rows.resize(1);
  folder.write("a.dbd", write(draft));
  SensorLists lists;
  const LogFiles logs = readLogFiles({folder.path()}, lists);
  const auto path = folder.path() / "out.nc";
  ASSERT_TRUE(writeNetcdf(merge(logs.files, {}), path));
  int file = -1;
  ASSERT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file), NC_NOERR);
  nc_close(file);
}

}  // namespace
}  // namespace glider::slocum
