// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/report.h"

#include "report/page.h"
#include "support/diagnostics/ids/flights.h"
#include "support/files.h"
#include "tests/report/sample_trace.h"
#include "tests/unit/report/small_trace.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace glider::report {
namespace {

namespace fs = std::filesystem;

class Report : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("glider_report_") +
                      testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// The JSON that `page` holds for its script.
std::string dataOf(const std::string& page) {
  const std::string mark = "<script type=\"application/json\" id=\"flight\">";
  const size_t begin = page.find(mark) + mark.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

TEST(Page, ScriptEndsAndLineSeparatorsAreEscaped) {
  EXPECT_EQ(escapeForScript("\"</script><!--\""), "\"\\u003c/script>\\u003c!--\"");
  EXPECT_EQ(escapeForScript("\"a\xE2\x80\xA8"
                            "b\xE2\x80\xA9"
                            "c\""),
            "\"a\\u2028b\\u2029c\"");
  EXPECT_EQ(escapeForScript("\"→ ° \xE2\x80\""), "\"→ ° \xE2\x80\"") << "their neighbours stay";
  EXPECT_EQ(escapeHtml("<b a=\"1\" c='2'>&"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
}

TEST(Page, CarriesTheTraceWithUnknownAsNull) {
  const auto trace = smallTrace({{"time", "s"}, {"m_depth", "m"}}, {{0, 1.5}, {4, kUnknown}});
  const auto data = nlohmann::json::parse(dataOf(renderPage(trace)));
  EXPECT_EQ(data.at("trace").at("rows"), nlohmann::json::parse("[0.0, 1.5, 4.0, null]"));
  EXPECT_EQ(data.at("figures").at("rows"), 2);
}

TEST(Page, CarriesWhatWentWrong) {
  const auto trace = smallTrace({{"time", "s"}}, {{0}});
  EXPECT_EQ(nlohmann::json::parse(dataOf(renderPage(trace))).at("warnings").size(), 0);
  const support::Diagnostic aborted{support::diagnostics::flightAborted,
                                    support::Severity::Warning,
                                    {},
                                    "the vehicle aborted </script>",
                                    "",
                                    {},
                                    {}};
  const auto data = nlohmann::json::parse(dataOf(renderPage(trace, {aborted})));
  EXPECT_EQ(data.at("warnings").at(0).at("code"), "GL9370");
  EXPECT_EQ(data.at("warnings").at(0).at("message"), "the vehicle aborted </script>");
}

TEST(Page, TheTitleOfALogNamesTheVehicle) {
  EXPECT_NE(renderPage(logTrace()).find("<title>comet: SPIRAL.MI</title>"), std::string::npos);
}

TEST(Page, HostileNamesReadBackAsTheyWereAndStayInsideTheirPlace) {
  const support::Trace trace = hostileTrace();
  const std::string page = renderPage(trace);
  const auto data = nlohmann::json::parse(dataOf(page));
  EXPECT_EQ(data.at("trace").at("scenario"), trace.scenario);
  EXPECT_EQ(data.at("trace").at("states"), trace.state_names);
  EXPECT_EQ(page.find("<script>window.glider"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
}

TEST(Page, NamesNoPlaceOutsideItself) {
  const std::string page = renderPage({});
  EXPECT_EQ(page.find(" src="), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url(http"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(Page, OfALongFlightIsDownsampledButCountsAllRows) {
  const auto data = nlohmann::json::parse(dataOf(renderPage(longTrace(40'000))));
  EXPECT_EQ(data.at("figures").at("rows"), 40'000);
  const auto& trace = data.at("trace");
  EXPECT_LE(trace.at("rows").size() / trace.at("columns").size(), kPageRows);
}

// accepts: GL9201
TEST_F(Report, IsWritten) {
  const fs::path path = folder_ / "report.html";
  ASSERT_TRUE(writeReport(sampleTrace(), path).has_value());
  const auto page = support::readFile(path);
  ASSERT_TRUE(page.has_value());
  EXPECT_TRUE(page->starts_with("<!doctype html>"));
  EXPECT_TRUE(page->ends_with("</html>\n"));
}

TEST_F(Report, InAFolderThatIsNotThereIsRefused) {
  const auto written = writeReport(sampleTrace(), folder_ / "missing" / "report.html");
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(support::code(written.error().id), "GL9201");
  EXPECT_NE(written.error().message.find("missing/report.html"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Report, ThatCannotReplaceWhatIsThereLeavesNothingBehind) {
  fs::create_directories(folder_ / "report.html" / "inside");
  const auto written = writeReport(sampleTrace(), folder_ / "report.html");
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(support::code(written.error().id), "GL9201");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace glider::report
