// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/findings/findings.h"
#include "report/graph/graph.h"

#include <string>
#include <vector>

/// What a pilot hands to the crew before a mission flies, as data and as a page to print.
namespace glider::report {

/// Texts are words for the page; what is in backticks in them is from the mission's text. Texts of
/// the mission itself are as written, on one line.

/// A profile or route as a state uses it.
struct BriefUse {
  std::string name;
  std::string with;     ///< "top `5 m`, bottom `20 m`"; may be empty
  std::string comment;  ///< of its declaration; may be empty
};

struct BriefEvent {
  std::string when;   ///< of the mission
  std::string then;   ///< "sets `layer` to `depth`; then goes to `track`"
  std::string never;  ///< why it never fires; empty: it may fire
};

struct BriefState {
  std::string name;
  std::string parameters;  ///< "to: position"; of the mission, may be empty
  std::string comment;     ///< of the mission, may be empty
  BriefUse profile;
  BriefUse route;
  std::string deepest;  ///< "at most 25 m deep"; empty: no bound is known
  std::string samples;  ///< "`depth` and `temp` on every tick"; empty: none
  std::string entry;    ///< "sets `n` to `0`"; empty: nothing
  std::vector<BriefEvent> events;
  bool unreached = false;        ///< nothing leads to it
  std::string instruments = {};  ///< "`ctd every 4 s` and `optode off`"; empty: as the vehicle says
};

/// A value with a name; all but `meaning` as the mission or the launch writes it.
struct BriefValue {
  std::string name;
  std::string kind;  ///< "fixed value", "variable", "place"; of a parameter its type
  std::string value;
  std::string range;   ///< may be empty
  std::string set_to;  ///< of a parameter: the value at launch, if another
  std::string meaning;
};

struct BriefSensor {
  std::string name;
  std::string vehicle_name;
  std::string from;   ///< "flight computer"
  std::string what;   ///< one line of explanation; may be empty
  std::string range;  ///< "0 to 2000 m"
  std::string stale;  ///< "20 s"
};

struct BriefRequirement {
  std::string text;
  std::string verdict;               ///< "proved", "refuted" or "undecided"
  std::vector<std::string> because;  ///< premise, reason, counterexample, flights
};

/// A warning or a remark.
struct BriefNote {
  std::string place;  ///< "line 7"; may be empty
  std::string text;
};

struct BriefHash {
  std::string of;
  std::string sha256;  ///< empty: there is none
  std::string note;    ///< may be empty
};

struct Brief {
  std::string mission;
  std::string file;
  std::string platform;
  std::string platform_description;
  std::string version;               ///< "glidercc 0.1.0"
  std::string comment;               ///< at the head of the mission's text; may be empty
  std::vector<std::string> summary;  ///< sentences
  double cycle_s = 0;                ///< between two ticks, about
  Graph graph;
  std::vector<BriefEvent> always;
  std::vector<BriefState> states;
  std::vector<BriefValue> parameters;
  std::vector<std::string> conditions;  ///< of the parameters (`where`)
  std::vector<BriefValue> values;       ///< other names
  std::vector<BriefSensor> sensors;
  std::vector<BriefRequirement> requirements;
  std::vector<BriefNote> warnings;
  std::vector<BriefNote> remarks;
  std::vector<Budget> budgets;
  std::string assumptions;
  std::vector<BriefHash> hashes;
};

/// The brief as one self-contained page without a script, for A4 paper; the same brief always gives
/// the same bytes.
std::string briefToHtml(const Brief& brief);

}  // namespace glider::report
