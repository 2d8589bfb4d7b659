// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// --format json of the commands that print data: one valid document, for errors too.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using nlohmann::json;

const std::string kTree = GLIDER_SOURCE_DIR;
const std::string kThermocline = kTree + "/missions/gallery/thermocline.mission";

/// The document of a command, which must be all that is on standard output.
json documentOf(const std::string& words, int status) {
  const Outcome outcome = runShell("$GLIDERCC " + words + " --format json --color=always");
  EXPECT_EQ(outcome.status, status) << words << "\n" << outcome.err;
  EXPECT_EQ(outcome.out.find('\x1b'), std::string::npos) << words;
  const json document = json::parse(outcome.out, nullptr, false);
  EXPECT_FALSE(document.is_discarded()) << words << "\n" << outcome.out;
  return document;
}

/// The same for the commands that share a frame of the document.
json framed(const std::string& words, int status) {
  const json document = documentOf(words, status);
  EXPECT_EQ(document.value("command", ""), words.substr(0, words.find(' '))) << words;
  EXPECT_EQ(document.value("status", -1), status) << words;
  EXPECT_TRUE(document.contains("glidercc") && document.at("diagnostics").is_array()) << words;
  return document;
}

TEST(JsonFormat, Params) {
  const json document = framed("params " + kThermocline + " --set change=2degC", 0);
  EXPECT_EQ(document.at("mission"), "thermocline");
  EXPECT_EQ(document.at("parameters"),
            json::parse(R"([{"name": "change", "type": "temperature", "default": "10 degC",
                             "range": "0.2 degC to 20 degC", "set_to": "2 degC"}])"));
}

TEST(JsonFormat, Targets) {
  const json targets = framed("targets", 0).at("targets");
  ASSERT_EQ(targets.size(), 5U);
  EXPECT_EQ(targets[4].at("name"), "ts7800");
}

TEST(JsonFormat, Sim) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "f").string();
  const json document = framed("sim " + kThermocline + " -o " + out, 0);
  EXPECT_EQ(document.at("mission"), "thermocline");
  EXPECT_EQ(document.at("folder"), out);
  EXPECT_GT(document.at("flown_s"), 1000);
  json written = json::parse(slurp(folder.path() / "f/flight.json"));
  for (const auto& [key, value] : written.items()) {
    EXPECT_EQ(document.at(key), value) << key;
  }
}

TEST(JsonFormat, Diff) {
  const TemporaryFolder folder;
  const std::string other = (folder.path() / "other.mission").string();
  ASSERT_EQ(runShell("sed 's/20 min/21 min/' " + kThermocline + " > " + other).status, 0);
  const json document = framed("diff " + kThermocline + " " + other, 1);
  EXPECT_EQ(document.at("same"), false);
  EXPECT_EQ(document.at("parts").size(), 1U);
  EXPECT_TRUE(document.at("flight").at("found").is_boolean());
  EXPECT_EQ(framed("diff --no-flights " + kThermocline + " " + kThermocline, 0).at("same"), true);
}

TEST(JsonFormat, Mi) {
  const json document = framed("mi " + kTree + "/scenarios/skeleton.mi", 0);
  ASSERT_EQ(document.at("behaviours").size(), 4U);
  const json& abend = document.at("behaviours")[0];
  EXPECT_EQ(abend.at("name"), "abend");
  EXPECT_EQ(
      abend.at("arguments")[1],
      json::parse(R"({"name": "overtime", "value": 43200.0, "unit": "s", "file": "skeleton.mi"})"));
}

TEST(JsonFormat, Campaign) {
  const json document = framed("campaign " + kThermocline + " --flights 6 --boards 0", 0);
  EXPECT_EQ(document.at("flown"), 6);
  uint64_t flights = 0;
  for (const auto& [fault, row] : document.at("faults").items()) {
    flights += row.at("flights").get<uint64_t>();
    uint64_t outcomes = 0;
    for (const auto& [outcome, count] : row.at("outcomes").items()) {
      outcomes += count.get<uint64_t>();
    }
    EXPECT_EQ(outcomes, row.at("flights")) << fault;
  }
  EXPECT_EQ(flights, 6U);
  EXPECT_EQ(document.at("violations"), json::array());
  const json one = framed("campaign " + kThermocline + " --flights 6 --boards 0 --only 4", 0);
  EXPECT_EQ(one.at("flight").at("number"), 4);
}

TEST(JsonFormat, Log) {
  const TemporaryFolder folder;
  ASSERT_EQ(runShell("cd " + folder.path().string() + "; $GLIDERCC sim " + kThermocline +
                     " --board host -o f; find f -name '*.log' -exec cp {} m.log ';'")
                .status,
            0);
  const std::string log = (folder.path() / "m.log").string();
  const json entries = framed("log " + log, 0).at("entries");
  EXPECT_EQ(entries.at(0).at("record"), "start");
  EXPECT_EQ(entries.at(0).at("name"), "thermocline");
  bool ends = false;
  for (const json& entry : entries) {
    ends = ends || (entry.at("record") == "transition" && entry.at("to").is_null());
  }
  EXPECT_TRUE(ends) << "the exit";
}

TEST(JsonFormat, Brief) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "b.html").string();
  const json document = framed("brief " + kThermocline + " -o " + page, 0);
  EXPECT_EQ(document.at("page"), page);
  EXPECT_EQ(document.at("states").size(), 2U);
  EXPECT_EQ(documentOf("brief " + kThermocline + " -o -", 2).at("status"), 2);
}

TEST(JsonFormat, AFailureIsADocumentToo) {
  for (const std::string words :
       {"params x", "sim x", "diff x x", "mi x", "campaign x", "log x", "brief x", "platform x"}) {
    const json document = framed(words, 2);
    ASSERT_FALSE(document.at("diagnostics").empty()) << words;
    EXPECT_EQ(document.at("diagnostics")[0].at("severity"), "error") << words;
    EXPECT_TRUE(document.at("diagnostics")[0].contains("id")) << words;
  }
  EXPECT_FALSE(documentOf("check x", 2).at("missions")[0].at("ok"));
}

TEST(JsonFormat, AMissionWithErrorsIsADocumentToo) {
  const TemporaryFolder folder;
  const std::string mission = folder.write("m.mission", "mission m\nstate s begin end\n").string();
  for (const std::string command : {"params ", "sim ", "campaign ", "brief "}) {
    const json document = framed(command + mission, 1);
    ASSERT_FALSE(document.at("diagnostics").empty()) << command;
    const json& first = document.at("diagnostics")[0];
    EXPECT_EQ(first.at("file"), mission) << command;
    EXPECT_EQ(first.at("begin").at("line"), 2) << command;
  }
}

TEST(JsonFormat, AUsageErrorIsADocumentToo) {
  const json document = framed("sim --senario x", 2);
  EXPECT_THAT(document.at("diagnostics")[0].at("message").get<std::string>(),
              testing::HasSubstr("did you mean `--scenario`?"));
  const Outcome text = runShell("$GLIDERCC sim --senario x");
  EXPECT_EQ(text.out, "");
}

}  // namespace
}  // namespace glider::tests
