// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The page of a brief: everything in it is shown, in its place, and escaped.

#include "report/brief/brief.h"

#include "report/brief/html.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Brief sample() {
  Brief brief;
  brief.mission = "survey";
  brief.file = "a<b.mission";
  brief.platform = "slocum";
  brief.version = "glidercc 0";
  brief.cycle_s = 4;
  brief.summary = {"It ends in `home`."};
  brief.graph.mission = "survey";
  brief.graph.states = {{"look", "", "yo", "nav", "state look", true, false, false, {}}};
  brief.always = {{"depth > 50 m", "ends the mission", ""}};
  brief.states = {{"look",
                   "",
                   "",
                   {"yo", "top `5 m`", "Up & down."},
                   {"nav", "", ""},
                   "at most 25 m deep",
                   "`depth` on every tick",
                   "logs “<hi>”",
                   {},
                   false}};
  brief.states[0].events = {{"temp < 4 degC", "goes to `home`", ""},
                            {"temp > 90 degC", "stays", "never fires: its guard is always false"}};
  brief.requirements = {{"require stack <= 2", "proved", {"if the depth is known"}},
                        {"require always depth <= 9 m", "refuted", {"at 8 s"}},
                        {"require exit within 1 h", "undecided", {"too many steps"}}};
  brief.hashes = {{"survey.mission", "abc123", ""}, {"survey-host", "", "`spiral` is missing"}};
  return brief;
}

size_t place(const std::string& page, const std::string& text) {
  const size_t at = page.find(text);
  EXPECT_NE(at, std::string::npos) << text;
  return at;
}

TEST(BriefPage, EscapesWhatItShows) {
  const std::string page = briefToHtml(sample());
  EXPECT_THAT(page, HasSubstr("a&lt;b.mission"));
  EXPECT_THAT(page, HasSubstr("logs “&lt;hi&gt;”"));
  EXPECT_THAT(page, HasSubstr("when <code>temp &lt; 4 degC</code>: goes to <code>home</code>"));
  EXPECT_THAT(page, HasSubstr("Up &amp; down."));
  EXPECT_THAT(page, Not(HasSubstr("<hi>")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
}

TEST(BriefPage, TextInBackticksIsCode) {
  EXPECT_EQ(html::words("a `b < c` d"), "a <code>b &lt; c</code> d");
  EXPECT_EQ(html::words("`a``b`"), "<code>a</code><code>b</code>");
  EXPECT_EQ(html::words("one ` & alone"), "one ` &amp; alone");
  EXPECT_EQ(html::words("`a` and ` alone"), "<code>a</code> and ` alone");
  EXPECT_EQ(html::words(""), "");
}

TEST(BriefPage, AColumnWithoutEntriesIsLeftOut) {
  EXPECT_EQ(html::table({"a", "b"}, {{"1", ""}, {"2", ""}}),
            "<table>\n<thead><tr><th>a</th></tr></thead>\n<tbody>\n<tr><td>1</td></tr>\n"
            "<tr><td>2</td></tr>\n</tbody>\n</table>\n");
}

TEST(BriefPage, ViolatedRequirementsComeFirstAndStandOut) {
  const std::string page = briefToHtml(sample());
  EXPECT_THAT(page, HasSubstr("<p class=\"bad\"><strong>Do not fly:</strong> this mission violates "
                              "1 of its requirements.</p>"));
  const size_t refuted = place(page,
                               "<div class=\"bad\"><strong>violated:</strong> "
                               "<code>require always depth &lt;= 9 m</code>");
  const size_t undecided = place(page,
                                 "<div class=\"warned\"><strong>undecided:</strong> "
                                 "<code>require exit within 1 h</code>");
  const size_t proved = place(page,
                              "<div class=\"good\"><strong>proved:</strong> "
                              "<code>require stack &lt;= 2</code>");
  EXPECT_LT(refuted, undecided);
  EXPECT_LT(undecided, proved);
  EXPECT_LT(place(page, "<li>at 8 s</li>"), undecided);
  EXPECT_LT(proved, place(page, "<li>if the depth is known</li>"));
}

TEST(BriefPage, NothingSaysDoNotFlyIfNothingIsViolated) {
  Brief brief = sample();
  brief.requirements.erase(brief.requirements.begin() + 1);
  EXPECT_THAT(briefToHtml(brief), Not(HasSubstr("Do not fly")));
}

TEST(BriefPage, SectionsComeInTheOrderOfReading) {
  Brief brief = sample();
  brief.parameters = {{"rich", "plain number", "2", "1 to 3", "", "micrograms"}};
  brief.sensors = {{"depth", "m_depth", "flight computer", "depth", "0 m to 9 m", "20 s"}};
  brief.warnings = {{"line 7", "`n` is never read [GL2057]"}};
  brief.remarks = {{"", "possible livelock"}};
  brief.assumptions = "Readings are right.";
  const std::string page = briefToHtml(brief);
  size_t before = 0;
  for (const char* next :
       {"<h1>survey", "It ends in <code>home</code>.", "<svg ", "In every state", "<h3>look",
        "<h2>Parameters", "<h2>Sensors", "<h2>Requirements", "<h2>Warnings",
        "<li>line 7: <code>n</code> is never read [GL2057]", "<h2>Remarks", "Readings are right.",
        "<h2>SHA-256", "abc123", "<code>spiral</code> is missing"}) {
    const size_t at = place(page, next);
    EXPECT_LT(before, at) << next;
    before = at;
  }
}

TEST(BriefPage, EventsKeepTheirOrderAndSayIfTheyNeverFire) {
  const std::string page = briefToHtml(sample());
  EXPECT_LT(place(page, "when <code>temp &lt; 4 degC"),
            place(page, "when <code>temp &gt; 90 degC"));
  EXPECT_THAT(page, HasSubstr("stays <em>(never fires: its guard is always false)</em>"));
}

TEST(BriefPage, ValuesAtLaunchHaveAColumnIfThereAreAny) {
  Brief brief = sample();
  brief.parameters = {{"rich", "plain number", "2", "1 to 3", "", ""},
                      {"top", "length", "5 m", "3 m to 8 m", "7 m", ""}};
  const std::string page = briefToHtml(brief);
  EXPECT_THAT(page, HasSubstr("<th>at launch</th>"));
  EXPECT_THAT(page, HasSubstr("<td>default</td>"));
  EXPECT_THAT(page, HasSubstr("<td><strong>7 m</strong></td>"));
  brief.parameters[1].set_to.clear();
  EXPECT_THAT(briefToHtml(brief), Not(HasSubstr("at launch</th>")));
}

TEST(BriefPage, OnlyQuantitiesWithALimitAreShown) {
  Brief brief = sample();
  brief.budgets = {{"ts7800",
                    {{"executable", 58436, 131072, "bytes", "the file"},
                     {"data", 38812, std::nullopt, "bytes", "part of memory"}}}};
  const std::string page = briefToHtml(brief);
  EXPECT_THAT(page, HasSubstr("<li>ts7800: executable 58,436 of 131,072 bytes</li>"));
  EXPECT_THAT(page, Not(HasSubstr("38,812")));
}

}  // namespace
}  // namespace glider::report
