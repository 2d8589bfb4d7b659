// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/extctl/port.h"
#include "runtime/abi/port_mission.h"
#include "vehicles/slocum/dock/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::slocum {
namespace {

using hooks::extctl::PortSensor;
using vehicles::DockCheck;

/// A program that steers takes control in this time of the vehicle's mission, s.
constexpr double kToTakeControl = 32;

/// The names of what steers among the sensors written in `cycle`.
std::string namesOf(const AnsweredCycle& cycle, const DockSetup& setup) {
  const std::vector<ExtctlSensor> sensors = setup.plan.extctl.sensors();
  std::string names;
  for (const auto& [index, value] : cycle.written) {
    if (index < kFirstOfItself) {
      names += fmt::format("{}`{}`", names.empty() ? "" : ", ", sensors[index].name);
    }
  }
  return names;
}

/// How the count of the SBC advanced: one an answer, from the start in each mission of the vehicle.
struct Counting {
  uint32_t lost = 0;    ///< answers that did not arrive
  uint32_t starts = 0;  ///< the program began again
};

Counting countingOf(const std::vector<AnsweredCycle>& cycles) {
  Counting counting;
  const AnsweredCycle* before = nullptr;
  for (const AnsweredCycle& cycle : cycles) {
    if (!cycle.answered_s) {
      continue;
    }
    if (before != nullptr && cycle.cycle.mission_s > before->cycle.mission_s) {
      const double step = cycle.count - before->count;
      counting.lost += step > 1 ? static_cast<uint32_t>(step) - 1 : 0;
      counting.starts += step < 0 ? 1 : 0;
    }
    before = &cycle;
  }
  return counting;
}

DockCheck answersFinding(const SbcRecord& record) {
  const std::string what = "answers of the SBC";
  const auto answered = std::ranges::count_if(
      record.cycles, [](const AnsweredCycle& cycle) { return cycle.answered_s.has_value(); });
  const size_t missing = record.cycles.size() - static_cast<size_t>(answered);
  const Counting counting = countingOf(record.cycles);
  std::string text =
      fmt::format("{} of {} answered", answered, counted(record.cycles.size(), "report"));
  if (counting.starts > 0) {
    return notGood(
        "answers", what,
        fmt::format("{}; the program began again {}", text, counted(counting.starts, "time")),
        "look into its log on the SBC, and at the power supply");
  }
  if (missing == 0) {
    return good("answers", what, text);
  }
  const size_t back = std::min<size_t>(counting.lost, missing);
  text += fmt::format("; {} lost on the way here, {} on the way there or not answered", back,
                      missing - back);
  return notGood("answers", what, text,
                 "see `what arrives` above; else the SBC loses bytes: end other programs that use "
                 "the port there");
}

DockCheck timeFinding(const DockSetup& setup, uint32_t baud, const DockLine& line,
                      const SbcRecord& record) {
  std::vector<double> times;
  for (const AnsweredCycle& cycle : record.cycles) {
    if (cycle.answered_s) {
      times.push_back(*cycle.answered_s - cycle.said_s);
    }
  }
  const std::string what = "time from report to answer";
  if (times.empty()) {
    return notChecked("answer-time", what, "no answer");
  }
  std::ranges::sort(times);
  const auto bytes = static_cast<double>(line.counts().bytes + line.counts().sent_bytes);
  const std::string text =
      fmt::format("median {}, longest {}; the line itself needs about {}",
                  timeText(times[times.size() / 2]), timeText(times.back()),
                  timeText(bytes / static_cast<double>(record.cycles.size()) * kBitsOfByte / baud));
  return times.back() <= setup.times.cycle_s / 2
             ? good("answer-time", what, text)
             : notGood("answer-time", what, text,
                       "the SBC is busy or its clock is slow: look at its load; an answer must "
                       "come before half of a control cycle");
}

DockCheck nameFinding(const DockSetup& setup, const SbcRecord& record) {
  const std::string what = "name of the mission";
  if (record.mission.empty()) {
    return notChecked("mission-name", what,
                      "the program says it once, after its start, and has said it before");
  }
  return record.mission == setup.plan.mission
             ? good("mission-name", what, fmt::format("`{}`", record.mission))
             : notGood(
                   "mission-name", what,
                   fmt::format("`{}`, but `{}` in the folder", record.mission, setup.plan.mission),
                   fmt::format("copy `{}` of the folder to the SBC, and start it", setup.program));
}

const AnsweredCycle* firstThatSteers(const SbcRecord& record, DockScene scene) {
  const auto found = std::ranges::find_if(record.cycles, [&](const AnsweredCycle& cycle) {
    return cycle.cycle.scene == scene && steers(cycle);
  });
  return found == record.cycles.end() ? nullptr : &*found;
}

DockCheck otherMissionFinding(const DockSetup& setup, const SbcRecord& record) {
  const std::string what = "leaves other missions alone";
  const AnsweredCycle* wrong = firstThatSteers(record, DockScene::Prompt);
  const bool at_prompt = wrong != nullptr;
  wrong = at_prompt ? wrong : firstThatSteers(record, DockScene::OtherMission);
  if (wrong != nullptr) {
    return notGood(
        "other-mission", what,
        fmt::format(
            "it writes {} {}", namesOf(*wrong, setup),
            at_prompt ? "although no mission flies" : "into a mission file with another number"),
        fmt::format("it is another program: copy `{}` of the folder to the SBC", setup.program));
  }
  const auto last = std::ranges::find_if(record.cycles, [](const AnsweredCycle& cycle) {
    return cycle.cycle.scene == DockScene::OwnMission;
  });
  return last == record.cycles.end()
             ? notChecked("other-mission", what, "the check was too short")
             : good("other-mission", what,
                    "it writes nothing that steers at the prompt, nor into a mission file with "
                    "another number");
}

DockCheck programFinding(const DockSetup& setup, const SbcRecord& record) {
  const std::string what = "program on the SBC";
  const AnsweredCycle* first = firstThatSteers(record, DockScene::OwnMission);
  if (first != nullptr) {
    return good("program", what,
                fmt::format("that of this folder (u_mission_param_l {}): it steers after {:.0f} s "
                            "of the mission",
                            setup.plan.port.program, first->cycle.mission_s));
  }
  const bool waited = std::ranges::any_of(record.cycles, [](const AnsweredCycle& cycle) {
    return cycle.cycle.scene == DockScene::OwnMission && cycle.cycle.mission_s >= kToTakeControl;
  });
  return waited ? notGood("program", what,
                          fmt::format("not that of this folder: it does not steer the mission file "
                                      "with u_mission_param_l {}",
                                      setup.plan.port.program),
                          fmt::format("copy `{}` of the folder to the SBC, and start it",
                                      setup.program))
                : notChecked("program", what, "the check was too short", "use `--minutes 3`");
}

/// What is out of bounds in `cycle`; empty: nothing.
std::string outOfBounds(const AnsweredCycle& cycle, const DockSetup& setup) {
  const GliderPortMission& port = setup.plan.port;
  constexpr double kTurn = 6.2832, kSlack = 1e-4;
  const struct {
    PortSensor sensor;
    double least, most;
  } bounds[] = {{PortSensor::Heading, 0, kTurn},
                {PortSensor::DiveDepth, 0, port.greatest_depth_m},
                {PortSensor::ClimbDepth, 0, port.greatest_depth_m},
                {PortSensor::DivePitch, -port.steepest_pitch_rad, 0},
                {PortSensor::ClimbPitch, 0, port.steepest_pitch_rad},
                {PortSensor::WantsSurface, 0, 2}};
  const std::vector<ExtctlSensor> sensors = setup.plan.extctl.sensors();
  for (const auto& [sensor, least, most] : bounds) {
    const auto found = cycle.written.find(static_cast<uint32_t>(sensor));
    if (found != cycle.written.end() &&
        !(found->second >= least - kSlack && found->second <= most + kSlack)) {
      const ExtctlSensor& named = sensors[found->first];
      return fmt::format("`{}` {:.6g}, outside {:.6g} to {:.6g} {}", named.name, found->second,
                         least, most, named.unit);
    }
  }
  return "";
}

DockCheck writtenFinding(const DockSetup& setup, const SbcRecord& record) {
  const std::string what = "what it writes";
  const std::string todo =
      fmt::format("it is another program: copy `{}` of the folder to the SBC", setup.program);
  if (!record.unknown.empty() || record.bad_pairs > 0) {
    return notGood(
        "written", what,
        record.unknown.empty()
            ? counted(record.bad_pairs, "pair") + " that is no `index:value`"
            : fmt::format("index {}, which an SBC does not write", *record.unknown.begin()),
        todo);
  }
  if (record.mode_sentences > 0 && setup.plan.choice.release != Release::MissionModes) {
    return notGood("written", what, "bits of u_mission_mode, for which the folder was not built",
                   todo);
  }
  std::set<uint32_t> written;
  for (const AnsweredCycle& cycle : record.cycles) {
    if (const std::string wrong = outOfBounds(cycle, setup); !wrong.empty()) {
      return notGood("written", what, wrong, todo);
    }
    for (const auto& [index, value] : cycle.written) {
      written.insert(index);
    }
  }
  return written.empty()
             ? notChecked("written", what, "nothing was written")
             : good("written", what,
                    fmt::format("{}, each within its bounds", counted(written.size(), "sensor")));
}

DockCheck restartFinding(const SbcRecord& record) {
  const std::string what = "writes all again after $BY and $HI";
  const auto at = std::ranges::find_if(
      record.cycles, [](const AnsweredCycle& cycle) { return cycle.cycle.restarts_port; });
  if (at == record.cycles.end() || at == record.cycles.begin() ||
      firstThatSteers(record, DockScene::OwnMission) == nullptr) {
    return notChecked("restart", what,
                      at == record.cycles.end() ? "the check was too short" : "it does not steer");
  }
  std::set<uint32_t> before, after;
  for (auto cycle = record.cycles.begin(); cycle != record.cycles.end(); ++cycle) {
    std::set<uint32_t>& into = cycle < at ? before : after;
    const bool counts = cycle < at ? cycle->cycle.scene == DockScene::OwnMission : cycle - at < 2;
    for (const auto& [index, value] : cycle->written) {
      if (counts && index < kFirstOfItself) {
        into.insert(index);
      }
    }
  }
  return std::ranges::includes(after, before)
             ? good("restart", what, counted(before.size(), "sensor"))
             : notGood("restart", what, fmt::format("only {} of {}", after.size(), before.size()),
                       "it is another program, or its answer was lost: repeat the check");
}

DockCheck releaseFinding(const DockSetup& setup, const SbcRecord& record) {
  const std::string what = "stops at the end of the mission";
  const bool ends = std::ranges::any_of(record.cycles, [](const AnsweredCycle& cycle) {
    return cycle.cycle.scene == DockScene::PromptAgain;
  });
  if (!ends || firstThatSteers(record, DockScene::OwnMission) == nullptr) {
    return notChecked("release", what, ends ? "it does not steer" : "the check was too short");
  }
  const AnsweredCycle* wrong = firstThatSteers(record, DockScene::PromptAgain);
  return wrong == nullptr
             ? good("release", what, "it writes nothing that steers at the prompt after it")
             : notGood("release", what, fmt::format("it still writes {}", namesOf(*wrong, setup)),
                       fmt::format("it is another program: copy `{}` of the folder to the SBC",
                                   setup.program));
}

}  // namespace

std::vector<DockCheck> sbcFindings(const DockSetup& setup, const DockLine& line, uint32_t baud,
                                   const SbcRecord& record) {
  uint64_t sent = 0, heard = 0;
  for (const AnsweredCycle& cycle : record.cycles) {
    sent = std::max(sent, cycle.sent_bytes);
    heard = std::max(heard, cycle.heard_bytes);
  }
  return {
      answersFinding(record),
      timeFinding(setup, baud, line, record),
      loadFinding(baud, static_cast<double>(std::max(sent, heard)), kCycleSecs,
                  fmt::format("at most {} bytes a control cycle to the SBC, {} back", sent, heard)),
      nameFinding(setup, record),
      otherMissionFinding(setup, record),
      programFinding(setup, record),
      writtenFinding(setup, record),
      restartFinding(record),
      releaseFinding(setup, record)};
}

}  // namespace glider::slocum
