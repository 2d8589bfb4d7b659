// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The picture of a flight: what it says, that nothing in a trace breaks it, and that it stays
// small. How it looks is seen in docs/gallery.

#include "report/picture/picture.h"

#include "report/picture/axis.h"
#include "report/picture/contours.h"
#include "report/picture/flight_view.h"
#include "report/picture/polyline.h"
#include "report/picture/track_map.h"
#include "report/picture/waypoints.h"
#include "tests/report/sample_trace.h"
#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace glider::report {
namespace {

using picture::Line;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(PictureAxis, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(picture::niceStep(100, 10), 10);
  EXPECT_DOUBLE_EQ(picture::niceStep(101, 10), 20);
  EXPECT_DOUBLE_EQ(picture::niceStep(0.3, 7), 0.05);
  EXPECT_DOUBLE_EQ(picture::niceStep(7, 1), 10);
}

TEST(PictureAxis, TicksLieOnMultiplesAndInside) {
  EXPECT_THAT(picture::ticks(-3, 4.1, 2), ElementsAre(-2, 0, 2, 4));
  EXPECT_THAT(picture::ticks(0, 0.3, 0.1).size(), 4U) << "the last one in spite of rounding";
  EXPECT_EQ(picture::tickText(0.30000000000000004, 0.1), "0.3");
  EXPECT_EQ(picture::tickText(-200, 100), "\u2212200");
}

TEST(PictureLine, SimplificationKeepsWhatIsFurtherOffThanTheTolerance) {
  const Line zigzag = {{0, 0}, {1, 0.2}, {2, 0}, {3, 5}, {4, 0}};
  const Line thin = picture::simplified(zigzag, 0.3);
  ASSERT_EQ(thin.size(), 4U);
  EXPECT_EQ(thin[1].x, 2);
  EXPECT_EQ(thin[2].y, 5);
  EXPECT_EQ(picture::simplified(zigzag, 0.1).size(), 5U);
}

TEST(PictureLine, StepsDoNotDriftFromThePoints) {
  EXPECT_EQ(picture::pathData({{1.04, 2}, {1.08, 2}, {1.12, 1.5}}), "M1 2l.1 0 0-.5");
  EXPECT_EQ(picture::pathData({{1, 2}}), "");
}

TEST(PictureContours, FollowTheFieldBetweenItsPoints) {
  support::TraceField field;
  field.times_s = {0, 10, 20};
  field.depths_m = {0, 10};
  field.values = {20, 10, 20, 10, 18, 10};
  const auto lines = picture::contours(field, 15);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].size(), 3U);
  const auto [first, last] =
      std::minmax(lines[0].front(), lines[0].back(), [](auto& a, auto& b) { return a.x < b.x; });
  EXPECT_DOUBLE_EQ(first.y, 5);
  EXPECT_DOUBLE_EQ(last.y, 10 * 3.0 / 8);
  EXPECT_TRUE(picture::contours(field, 30).empty());
}

TEST(PictureContours, AClosedLineEndsWhereItBegins) {
  support::TraceField field;
  field.times_s = field.depths_m = {0, 1, 2};
  field.values = {0, 0, 0, 0, 9, 0, 0, 0, 0};
  const auto lines = picture::contours(field, 5);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].size(), 5U);
  EXPECT_EQ(lines[0].front().x, lines[0].back().x);
  EXPECT_EQ(lines[0].front().y, lines[0].back().y);
}

TEST(Picture, SaysWhatTheFlightWas) {
  const std::string svg = drawPicture(sampleTrace());
  for (const char* text : {"depth (m)", "time (min)", "temperature (°C)", "layered control",
                           "class=\"isotherm\"", "marked isotherm", "commanded range"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  EXPECT_THAT(svg, Not(HasSubstr("payload computer"))) << "every row of control has a state";
  EXPECT_EQ(svg, drawPicture(sampleTrace())) << "the same bytes for the same trace";
}

TEST(Picture, ColoursBySomethingElse) {
  const std::string by_state = drawPicture(sampleTrace(), {"state"});
  EXPECT_THAT(by_state, Not(HasSubstr("temperature (°C)")));
  EXPECT_THAT(drawPicture(sampleTrace(), {"battery"}), HasSubstr("battery (V)"));
  const std::string unknown = drawPicture(sampleTrace(), {"oxygen"});
  EXPECT_THAT(unknown, HasSubstr("not known")) << "grey, and said so";
}

TEST(Picture, AMissionInCHasNoStatesButIsInControl) {
  support::Trace trace = sampleTrace();
  const int state = trace.column("state");
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    trace.rows[row * trace.columns.size() + static_cast<size_t>(state)] = kUnknown;
  }
  EXPECT_THAT(drawPicture(trace), HasSubstr("payload computer"));
}

TEST(Picture, StaysSmallHoweverLongTheFlight) {
  EXPECT_LT(drawPicture(longTrace(20000)).size(), 200000U);
  EXPECT_LT(drawPicture(sampleTrace()).size(), 60000U);
}

TEST(Picture, NamesCannotRunAnything) {
  const std::string svg = drawPicture(hostileTrace());
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  EXPECT_THAT(svg, HasSubstr("&lt;script"));
}

TEST(Picture, IsDrawnOfWhatThereIs) {
  EXPECT_THAT(drawPicture(bareTrace()), HasSubstr("</svg>"));
  EXPECT_THAT(drawPicture(support::Trace()), HasSubstr("</svg>"));
  const auto unknown = smallTrace({{"time", "s"}, {"m_depth", "m"}, {"true_x", "m"}},
                                  {{0, kUnknown, kUnknown}, {4, kUnknown, kUnknown}});
  EXPECT_THAT(drawPicture(unknown), Not(HasSubstr("nan")));
  const auto one = smallTrace({{"time", "s"}, {"m_depth", "m"}}, {{0, 3}});
  EXPECT_THAT(drawPicture(one), Not(HasSubstr("nan")));
  EXPECT_THAT(drawPicture(support::Trace()), Not(HasSubstr("nan")));
}

/// 400 m out to the east and back, steering to one place near and one far away.
support::Trace outAndBack() {
  return smallTrace({{"time", "s"},
                     {"m_depth", "m"},
                     {"true_x", "m"},
                     {"true_y", "m"},
                     {"true_lat", "deg"},
                     {"true_lon", "deg"},
                     {"c_wpt_lat", "deg"},
                     {"c_wpt_lon", "deg"}},
                    {{0, 1, 0, 0, 40, -70, 40, -69.9953},
                     {1000, 1, 400, 0, 40, -69.9953, 40, -69},
                     {2000, 1, 10, 0, 40, -69.9999, kUnknown, kUnknown}});
}

TEST(PictureMap, IsThereWhenTheWayDidNotGoStraightOn) {
  EXPECT_TRUE(picture::deservesMap(outAndBack()));
  EXPECT_THAT(drawPicture(outAndBack()), HasSubstr("north (m)"));
  support::Trace straight = outAndBack();
  straight.rows.resize(2 * straight.columns.size());
  EXPECT_FALSE(picture::deservesMap(straight));
}

TEST(PictureMap, HasTheWaypointsThatAreNear) {
  const auto waypoints = picture::waypointsOf(outAndBack());
  ASSERT_EQ(waypoints.size(), 1U);
  EXPECT_NEAR(waypoints[0].x, 401, 2);
  EXPECT_NEAR(waypoints[0].y, 0, 0.1);
}

TEST(Picture, OfALogHasItsVehicleTimeStatesAndSimulatedFlight) {
  const std::string svg = drawPicture(logTrace());
  EXPECT_THAT(svg, HasSubstr(">comet: SPIRAL.MI</text>"));
  EXPECT_THAT(svg, HasSubstr("from 2019-08-09 15:24:32 UTC · 41 min"));
  EXPECT_THAT(svg, HasSubstr("dead-reckoned track"));
  EXPECT_THAT(svg, HasSubstr(">climb</text>"));
  EXPECT_THAT(svg, HasSubstr("<style>.beside { stroke"));
  EXPECT_THAT(svg, HasSubstr("<path class=\"beside\""));
  EXPECT_THAT(svg, HasSubstr(">simulated flight</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("layered")));
  EXPECT_THAT(svg, Not(HasSubstr("scenario")));
  EXPECT_THAT(drawPicture(sampleTrace()), Not(HasSubstr("beside")));
}

TEST(Picture, ALogWithoutStatesHasNoBandOfThem) {
  support::Trace trace = logTrace();
  EXPECT_THAT(drawPicture(trace), Not(HasSubstr("state not known")));
  trace.rows[static_cast<size_t>(trace.column("state"))] = kUnknown;
  EXPECT_THAT(drawPicture(trace), HasSubstr("state not known")) << "but of one row it is";
  trace.columns[static_cast<size_t>(trace.column("state"))].name = "m_vacuum";
  EXPECT_THAT(drawPicture(trace), Not(HasSubstr("state not known")));
}

TEST(Picture, NoLineIsDrawnOverAGapOfALog) {
  auto trace = smallTrace({{"time", "s"}, {"m_depth", "m"}},
                          {{0, 1}, {100, 9}, {200, kUnknown}, {300, 5}, {400, 2}});
  const auto strokes = [](const std::string& svg) {
    const size_t begin = svg.find("<path class=\"track\"");
    const std::string path = svg.substr(begin, svg.find("/>", begin) - begin);
    return std::ranges::count(path, 'M');
  };
  EXPECT_EQ(strokes(drawPicture(trace)), 1);
  trace.log.emplace();
  EXPECT_EQ(strokes(drawPicture(trace)), 2);
}

TEST(Picture, TheBandOfStatesIsInterruptedByAGapOfALog) {
  auto trace =
      smallTrace({{"time", "s"}, {"m_depth", "m"}, {"state", "id"}},
                 {{0, 1, 0}, {100, 1, 0}, {550, kUnknown, kUnknown}, {1000, 1, 0}, {1100, 2, 1}});
  trace.state_names = {"surface", "dive"};
  trace.log.emplace();
  EXPECT_EQ(picture::spansOf(trace).size(), 4U);
  EXPECT_THAT(drawPicture(trace), HasSubstr("state not known"));
  trace.log->gaps = {{100, 1000}};
  const auto spans = picture::spansOf(trace);
  ASSERT_EQ(spans.size(), 3U);
  EXPECT_EQ(spans[0].end, 1U);
  EXPECT_EQ(spans[1].begin, 3U);
  EXPECT_EQ(spans[1].end, 4U);
  EXPECT_EQ(spans[2].pilot, 1);
  EXPECT_THAT(drawPicture(trace), Not(HasSubstr("state not known")));
}

TEST(Picture, ALogHasOneGreyForWhatIsNotKnown) {
  const auto greys = [](const support::Trace& trace) {
    const std::string svg = drawPicture(trace, {"temp"});
    const std::string sample = "<rect class=\"swatch\"";
    size_t count = 0;
    for (size_t at = svg.find(sample); at != std::string::npos; at = svg.find(sample, at + 1)) {
      const bool grey = svg.substr(at, svg.find("/>", at) - at).find("#98a2ac") < svg.size();
      count += grey ? 1U : 0U;
    }
    return count;
  };
  support::Trace trace = logTrace();
  for (size_t row = 0; row < trace.rowCount() / 2; ++row) {
    for (const char* name : {"state", "sci_water_temp"}) {
      trace.rows[row * trace.columns.size() + static_cast<size_t>(trace.column(name))] = kUnknown;
    }
  }
  EXPECT_EQ(greys(trace), 1U);
  EXPECT_THAT(drawPicture(trace, {"temp"}), HasSubstr(">not known</text>"));
  trace.log.reset();
  EXPECT_EQ(greys(trace), 2U) << "layered control, and what is not known";
}

TEST(Picture, ChlorophyllOfAnyInstrumentColoursTheTrack) {
  const auto trace =
      smallTrace({{"time", "s"}, {"m_depth", "m"}, {"sci_flntu_chlor_units", "ug/l"}},
                 {{0, 1, 2}, {4, 2, 3}, {8, 3, 4}});
  EXPECT_THAT(drawPicture(trace), HasSubstr("chlorophyll"));
  EXPECT_THAT(drawPicture(trace, {"chlorophyll"}), Not(HasSubstr("not known")));
}

TEST(Picture, WithoutAMeasuredQuantityTheColoursAreThoseOfStates) {
  const auto trace = smallTrace({{"time", "s"}, {"m_depth", "m"}}, {{0, 1}, {4, 2}});
  EXPECT_THAT(drawPicture(trace), Not(HasSubstr("chlorophyll")));
}

/// The names of the legend of the map of `trace`.
std::string legendOf(const support::Trace& trace) {
  SvgText text;
  std::string names;
  for (const picture::LegendEntry& entry : picture::drawMap(text, trace, {0, 0, 300, 300})) {
    names += entry.text + ";";
  }
  return names;
}

TEST(PictureMap, OfALogHasTheWaypointsThatAreNear) {
  auto trace = smallTrace({{"time", "s"},
                           {"m_lat", "deg"},
                           {"m_lon", "deg"},
                           {"dr_x", "m"},
                           {"dr_y", "m"},
                           {"c_wpt_lat", "deg"},
                           {"c_wpt_lon", "deg"}},
                          {{0, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown},
                           {4, 40, -70, 100, 0, 40, -69.9953},
                           {8, 40, -69.9953, 501, 0, 41, -69.9953}});
  trace.log.emplace();
  const auto waypoints = picture::waypointsOf(trace);
  ASSERT_EQ(waypoints.size(), 1U);
  EXPECT_NEAR(waypoints[0].x, 501, 2);
}

TEST(PictureMap, OfALogHasItsFixesAndNoLineToThem) {
  support::Trace trace = logTrace();
  EXPECT_THAT(legendOf(trace), HasSubstr("GPS fix"));
  EXPECT_THAT(legendOf(outAndBack()), Not(HasSubstr("GPS fix")));
  const std::string svg = [&] {
    SvgText text;
    (void)picture::drawMap(text, trace, {0, 0, 300, 300});
    return text.take();
  }();
  size_t fixes = 0;
  for (size_t at = svg.find("r=\"2.5\""); at != std::string::npos;
       at = svg.find("r=\"2.5\"", at + 1)) {
    ++fixes;
  }
  EXPECT_EQ(fixes, 2U);
  EXPECT_THAT(svg, HasSubstr("<path class=\"beside\" d=\"M")) << "the simulated track";
  const auto strokes = [](const std::string& text) { return std::ranges::count(text, 'M'); };
  SvgText whole;
  trace.columns[static_cast<size_t>(trace.column("dr_leg"))].name = "m_vacuum";
  (void)picture::drawMap(whole, trace, {0, 0, 300, 300});
  EXPECT_EQ(strokes(svg), strokes(whole.take()) + 1);
}

}  // namespace
}  // namespace glider::report
