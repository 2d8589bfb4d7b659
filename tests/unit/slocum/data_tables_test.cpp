// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Several data files as one table: summary, CSV and netCDF.

#include "tests/unit/slocum/data_bench.h"
#include "vehicles/slocum/data_tables/csv.h"
#include "vehicles/slocum/data_tables/netcdf.h"
#include "vehicles/slocum/data_tables/summary.h"

#include <algorithm>
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

/// A flight file of `count` records from `begin_s` on, 4 s apart, northwards.
Draft northwards(double begin_s, int count, const std::string& name = "unit-2024-183-2-7") {
  Draft draft;
  draft.full_name = name;
  draft.sensors = {{"m_present_time", "timestamp", 8, true},
                   {"m_depth", "m", 4, true},
                   {"m_gps_lat", "lat", 8, true},
                   {"m_gps_lon", "lon", 8, true},
                   {"m_lat", "lat", 8, true},
                   {"m_lon", "lon", 8, true}};
  for (int i = 0; i < count; ++i) {
    const double lat = 3910.5 + 0.001 * i;
    draft.rows.push_back(
        {{'*', begin_s + 4 * i}, {'*', 0.25 * i}, {}, {}, {'*', lat}, {'*', -7349.8}});
  }
  for (const int i : {0, 1, count - 2, count - 1}) {
    draft.rows[static_cast<size_t>(i)][2] = {'*', 3910.5 + 0.001 * i};
    draft.rows[static_cast<size_t>(i)][3] = {'*', -7349.8};
  }
  return draft;
}

constexpr double kJuly2024 = 1719946527;

LogFiles readAll(const TestFolder& folder) {
  SensorLists lists;
  return readLogFiles({folder.path()}, lists);
}

std::vector<std::string> warningCodes(const LogFiles& logs) {
  std::vector<std::string> codes;
  for (const support::Failure& warning : logs.warnings) {
    codes.push_back(support::code(warning.id));
  }
  return codes;
}

using Codes = std::vector<std::string>;

TEST(DoubtfulLogs, NothingIsSaidOfAGoodFile) {
  const TestFolder folder;
  folder.write("a.sbd", write(northwards(kJuly2024, 40)));
  // accepts: GL5211 GL5212 GL5213 GL5214
  EXPECT_EQ(warningCodes(readAll(folder)), Codes());
}

TEST(DoubtfulLogs, RecordsOfAWrongTimeAreLeftOut) {
  for (const double wrong : {0.0, 4.0, 1e12, -5.0, kJuly2024 + 1e7, kJuly2024 - 1e7}) {
    Draft draft = northwards(kJuly2024, 40);
    draft.rows[20][0].value = wrong;
    draft.rows[21][0].value = wrong + 4;
    const TestFolder folder;
    folder.write("a.sbd", write(draft));
    const LogFiles logs = readAll(folder);
    EXPECT_EQ(warningCodes(logs), Codes({"GL5212"})) << wrong;
    const Merged merged = merge(logs.files, {"m_depth"});
    EXPECT_EQ(merged.rows.size(), 37U) << "without the initial one";
    for (const MergedRow& row : merged.rows) {
      EXPECT_NEAR(row.time, kJuly2024 + 80, 100);
    }
    const std::string csv = csvOf(merged);
    EXPECT_EQ(csv.find(",5\n"), std::string::npos) << "the depth of record 20: " << csv;
    EXPECT_NE(csv.find(",5.5\n"), std::string::npos);
    EXPECT_EQ(logs.files[0].span(), std::pair(kJuly2024 + 4, kJuly2024 + 156));
    EXPECT_NE(summaryOf(logs.files, {}).find("2024-07-02"), std::string::npos);
    EXPECT_EQ(summaryOf(logs.files, {}).find("1970"), std::string::npos);
  }
}

TEST(DoubtfulLogs, AFileWhoseClockWasNotSetIsLeftOutBesideOthers) {
  const TestFolder folder;
  folder.write("a.sbd", write(northwards(kJuly2024, 40)));
  folder.write("b.sbd", write(northwards(100, 40, "unit-2024-183-2-8")));
  const LogFiles logs = readAll(folder);
  EXPECT_EQ(warningCodes(logs), Codes({"GL5212"}));
  EXPECT_EQ(merge(logs.files, {}).rows.size(), 39U);
  const TestFolder alone;
  alone.write("b.sbd", write(northwards(100, 40)));
  EXPECT_EQ(warningCodes(readAll(alone)), Codes());
  EXPECT_EQ(merge(readAll(alone).files, {}).rows.size(), 39U) << "no clock at all: by its own time";
}

TEST(DoubtfulLogs, WildFixesAreLeftOut) {
  struct Fix {
    double lat, lon;
  };
  for (const Fix& wild : {Fix{3910.5, 512}, Fix{4010.5, -7349.8}, Fix{-3910.5, -7349.8},
                          Fix{9999, -7349.8}, Fix{0, 0}, Fix{-7349.8, 3910.5}}) {
    Draft draft = northwards(kJuly2024, 40);
    draft.rows[10][2] = {'*', wild.lat};
    draft.rows[10][3] = {'*', wild.lon};
    const TestFolder folder;
    folder.write("a.sbd", write(draft));
    const LogFiles logs = readAll(folder);
    const std::string about = std::to_string(wild.lat) + " " + std::to_string(wild.lon);
    EXPECT_EQ(warningCodes(logs), Codes({"GL5213"})) << about;
    EXPECT_EQ(logs.files[0].wild_fixes, std::vector<uint32_t>{10}) << about;
    const std::string csv = csvOf(merge(logs.files, {"m_gps_lat", "m_gps_lon", "m_depth"}));
    EXPECT_NE(csv.find(",2.5,,\n"), std::string::npos) << "the record without the fix: " << csv;
  }
}

TEST(DoubtfulLogs, AFixThatWasNeverSetIsNotWild) {
  Draft draft = northwards(kJuly2024, 40);
  draft.rows[10][2] = draft.rows[10][3] = {'*', 69696969};
  const TestFolder folder;
  folder.write("a.sbd", write(draft));
  EXPECT_EQ(warningCodes(readAll(folder)), Codes());
}

TEST(DoubtfulLogs, AVehicleThatWasCarriedIsNotWild) {
  const TestFolder folder;
  folder.write("a.sbd", write(northwards(kJuly2024, 40)));
  Draft later = northwards(kJuly2024 + 30 * 86400.0, 40, "unit-2024-213-0-0");
  later.opened = "Thu_Aug__1_18:55:27_2024";
  for (auto& row : later.rows) {
    for (const size_t lat : {2U, 4U}) {
      row[lat].value = row[lat].state == '*' ? row[lat].value + 1200 : row[lat].value;
    }
  }
  folder.write("b.sbd", write(later));
  EXPECT_EQ(warningCodes(readAll(folder)), Codes());
}

TEST(DoubtfulLogs, UnitsAreNotMixed) {
  const auto science = [](const char* unit, double factor, double begin_s, const char* name) {
    Draft draft;
    draft.extension = "tbd";
    draft.full_name = name;
    draft.opened = begin_s > kJuly2024 ? "Tue_Jul__2_19:55:27_2024" : "Tue_Jul__2_18:55:27_2024";
    draft.sensors = {{"sci_m_present_time", "timestamp", 8, true},
                     {"sci_water_pressure", unit, 4, true}};
    for (int i = 0; i < 5; ++i) {
      draft.rows.push_back({{'*', begin_s + 4 * i}, {'*', factor * i}});
    }
    return write(draft);
  };
  const TestFolder folder;
  folder.write("a.tbd", science("bar", 1, kJuly2024, "unit-2024-183-2-7"));
  folder.write("b.tbd", science("dbar", 10, kJuly2024 + 1000, "unit-2024-183-2-8"));
  const LogFiles logs = readAll(folder);
  ASSERT_EQ(warningCodes(logs), Codes({"GL5211"}));
  EXPECT_EQ(logs.warnings[0].message,
            "the unit of `sci_water_pressure` differs between the files of `unit`: `bar` at first, "
            "and `dbar` from `b.tbd` on");
  const std::string csv = csvOf(merge(logs.files, {"sci_water_pressure*"}));
  EXPECT_EQ(csv,
            "time_s,computer,sci_water_pressure,sci_water_pressure_in_dbar\n"
            "1719946531,science,1,\n1719946535,science,2,\n1719946539,science,3,\n"
            "1719946543,science,4,\n1719947531,science,,10\n1719947535,science,,20\n"
            "1719947539,science,,30\n1719947543,science,,40\n");
  const TestFolder same;
  same.write("a.tbd", science("sec", 1, kJuly2024, "unit-2024-183-2-7"));
  same.write("b.tbd", science("s", 1, kJuly2024 + 1000, "unit-2024-183-2-8"));
  EXPECT_EQ(warningCodes(readAll(same)), Codes()) << "two spellings of one unit";
}

TEST(DoubtfulLogs, ATransferAsTextIsNamed) {
  const std::string whole = write(northwards(kJuly2024, 200));
  std::string text;
  for (const char c : whole) {
    text += c == '\n' ? "\r\n" : std::string(1, c);
  }
  const TestFolder folder;
  folder.write("a.sbd", text);
  const LogFiles logs = readAll(folder);
  EXPECT_EQ(warningCodes(logs), Codes({"GL5214"}));
  EXPECT_TRUE(logs.failures.empty());
  EXPECT_EQ(merge(logs.files, {}).rows.size(), 199U);
}

TEST(DataTable, NamesOfSensorsAreTheSameWhateverTheirCase) {
  Draft upper = northwards(kJuly2024 + 1000, 40, "unit-2024-183-2-8");
  for (auto& sensor : upper.sensors) {
    std::ranges::transform(sensor.name, sensor.name.begin(),
                           [](char c) { return c == 'm' ? 'M' : c; });
  }
  const TestFolder folder;
  folder.write("a.sbd", write(northwards(kJuly2024, 40)));
  folder.write("b.sbd", write(upper));
  const LogFiles logs = readAll(folder);
  const Merged merged = merge(logs.files, {"m_depth"});
  ASSERT_EQ(merged.columns.size(), 1U);
  EXPECT_EQ(merged.rows.size(), 78U);
  size_t depths = 0;
  merged.forEachUpdateOf(0, [&](uint32_t, double) { ++depths; });
  EXPECT_EQ(depths, 78U);
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
