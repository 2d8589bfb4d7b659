// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/dock_text.h"

#include "report/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::driver {
namespace {

using vehicles::DockCheck;
using vehicles::DockEnd;
using vehicles::DockPart;
using vehicles::DockResult;
using vehicles::DockVerdict;

constexpr size_t kColumns = 100;

const char* otherEnd(DockPart played) {
  return played == DockPart::Vehicle ? "an SBC"
         : played == DockPart::Sbc   ? "a vehicle"
                                     : "not known";
}

const char* markOf(DockVerdict verdict) {
  switch (verdict) {
    case DockVerdict::Good:
      return "good";
    case DockVerdict::NotGood:
      return "NOT GOOD";
    case DockVerdict::NotChecked:
      break;
  }
  return "not checked";
}

std::string lineOf(const DockCheck& check) {
  constexpr size_t kIndent = 13;
  const std::string begin = report::padded(markOf(check.verdict), kIndent);
  std::string text = report::wrapped(
      fmt::format("{}{}: {}", begin, check.what, report::plain(check.measured)), kColumns, kIndent);
  if (!check.todo.empty()) {
    text +=
        report::wrapped(fmt::format("{}→ {}", std::string(kIndent, ' '), report::plain(check.todo)),
                        kColumns, kIndent + 2);
  }
  return text;
}

size_t countOf(const DockResult& result, DockVerdict verdict) {
  return static_cast<size_t>(std::ranges::count(result.checks, verdict, &DockCheck::verdict));
}

}  // namespace

std::string dockText(const DockResult& result, const DockHeading& heading) {
  std::string text = fmt::format("{} ({}) on {} at {} baud, {}; at the other end: {}\n\n",
                                 heading.mission, heading.folder, heading.device, heading.baud,
                                 report::clockText(result.seconds), otherEnd(result.played));
  for (const DockCheck& check : result.checks) {
    text += lineOf(check);
  }
  text +=
      fmt::format("\n{} good, {} not good, {} not checked{}\n", countOf(result, DockVerdict::Good),
                  countOf(result, DockVerdict::NotGood), countOf(result, DockVerdict::NotChecked),
                  result.end == DockEnd::Interrupted ? "; interrupted before its end" : "");
  if (result.has_begun) {
    text +=
        "Before the flight, start the program on the SBC again without its checkpoint: its mission "
        "has begun.\n";
  }
  return text;
}

void addDock(const DockResult& result, const DockHeading& heading, Json& document) {
  document["folder"] = heading.folder;
  document["mission"] = heading.mission;
  document["device"] = heading.device;
  document["baud"] = heading.baud;
  document["other_end"] = result.played == DockPart::Vehicle ? Json("sbc")
                          : result.played == DockPart::Sbc   ? Json("vehicle")
                                                             : Json();
  document["end"] = result.end == DockEnd::Complete      ? "complete"
                    : result.end == DockEnd::Interrupted ? "interrupted"
                                                         : "line gone";
  document["seconds"] = result.seconds;
  document["checks"] = Json::array();
  for (const DockCheck& check : result.checks) {
    document["checks"].push_back(
        {{"id", check.id},
         {"what", check.what},
         {"measured", check.measured},
         {"verdict", check.verdict == DockVerdict::Good      ? "good"
                     : check.verdict == DockVerdict::NotGood ? "not good"
                                                             : "not checked"},
         {"todo", check.todo}});
  }
  document["has_begun"] = result.has_begun;
  document["numbers"] = Json::object();
  for (const auto& [name, value] : result.numbers) {
    document["numbers"][name] = value;
  }
}

}  // namespace glider::driver
