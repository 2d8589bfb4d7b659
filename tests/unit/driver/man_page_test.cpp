// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/man_page.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <string>

namespace glider::driver {
namespace {

TEST(ManPage, HasEveryCommandAndItsOptionsInRoff) {
  CLI::App app("checks `missions`\n.and flies them\n'so", "glidercc");
  bool quiet = false;
  std::string file;
  CLI::App* check = app.add_subcommand("check", "find errors - all of them");
  check->add_flag("--quiet", quiet, "say a back\\slash");
  check->add_option("FILE", file, "the mission");
  (void)app.add_subcommand("sim", "fly it");
  const std::string page = manPage(app, CLI::Formatter());
  const auto at = [&](const std::string& text) {
    const size_t found = page.find(text);
    EXPECT_NE(found, std::string::npos) << text << "\n" << page;
    return found;
  };
  EXPECT_EQ(at(".\\\" SPDX"), 0U);
  at(".TH GLIDERCC 1");
  at("checks \\(gamissions\\(ga\n\\&.and flies them\n\\&'so\n");
  at(".SS glidercc check\nfind errors \\- all of them.\n");
  at("\\fB\\-\\-quiet\\fR");
  at("say a back\\eslash");
  // Positional arguments come before options, commands in their order, the ends last.
  EXPECT_LT(at("\\fBFILE\\fR"), at("\\fB\\-\\-quiet\\fR"));
  EXPECT_LT(at("\\fB\\-\\-quiet\\fR"), at(".SS glidercc sim\nfly it.\n"));
  EXPECT_LT(at(".SS glidercc sim"), at(".SH EXIT STATUS"));
  EXPECT_LT(at(".SH EXIT STATUS"), at(".SH FILES"));
  EXPECT_LT(at(".SH OPTIONS"), at(".SH COMMANDS"));
  EXPECT_EQ(page.find("FILE", at("\\fBFILE\\fR") + 10), page.rfind("FILES"));
}

}  // namespace
}  // namespace glider::driver
