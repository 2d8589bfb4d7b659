// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The check at the dock plays a vehicle: the program of a mission is at the other end.

#include "runtime/extctl/backseat.h"
#include "runtime/library/library.h"
#include "tests/unit/runtime/bench_mission.h"
#include "tests/unit/slocum/dock_bench.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace glider::slocum::testing {
namespace {

using runtime::extctl::Backseat;
using runtime::testing::BenchMission;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using vehicles::DockEnd;
using vehicles::DockPart;
using vehicles::DockVerdict;

/// A mission that dives to 40 m, to the east.
struct OneState : BenchMission {
  OneState() {
    sensors = {runtime::testing::depthSensor(), runtime::testing::temperatureSensor()};
    states = {runtime::testing::benchState("dive", nullptr, 0)};
    fly = [](GliderContext& c, uint32_t phase) {
      if (phase != kGliderTick) {
        gliderDescend(&c, 40, -0.4);
        gliderSteer(&c, 1.5);
      }
    };
    finish(2);
  }
};

/// An SBC with a program for the port.
class Sbc final : public OtherEnd {
 public:
  explicit Sbc(const GliderPortMission& port) : port_(port) { start(); }

  std::string run(double now_s, const std::string& arrived) override {
    now_s_ = now_s;
    if (now_s >= restart_s) {
      restart_s = INFINITY;
      start();
    }
    for (const char c : arrived) {
      to_sbc_ += c;
    }
    poll();
    held_ += std::exchange(from_sbc_, {});
    held_s_ = held_.empty() ? now_s : held_s_;
    if (now_s - held_s_ < slow_s) {
      return "";
    }
    return changed(std::exchange(held_, {}), change);
  }

  /// Of each sentence that it sends.
  std::function<std::string(const std::string&)> change = [](const std::string& body) {
    return body;
  };
  double restart_s = INFINITY;
  double slow_s = 0;  ///< it needs this long for an answer

 private:
  void start() {
    memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, 0);
    context_.assign(mission_.mission.context_bytes / sizeof(double) + 1, 0);
    backseat_ =
        std::make_unique<Backseat>(mission_.mission, port_, GliderByteStream{this, read, write},
                                   runtime::extctl::BackseatOptions{});
    runtime_ = gliderRuntimeInit(memory_.data(), context_.data(), &mission_.mission, nullptr);
  }
  void poll() {
    const GliderClock clock{this, [](void* self) { return static_cast<Sbc*>(self)->now_s_; }};
    const GliderByteStream stream = backseat_->stream();
    while (gliderRuntimePoll(runtime_, &stream, &clock) == kGliderRuntimeProgressed) {
    }
  }
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity) {
    auto& sbc = *static_cast<Sbc*>(self);
    const size_t count = sbc.to_sbc_.copy(reinterpret_cast<char*>(bytes), capacity);
    sbc.to_sbc_.erase(0, count);
    return static_cast<int32_t>(count);
  }
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    static_cast<Sbc*>(self)->from_sbc_.append(reinterpret_cast<const char*>(bytes), count);
    return static_cast<int32_t>(count);
  }

  OneState mission_;
  GliderPortMission port_;
  double now_s_ = 0, held_s_ = 0;
  std::string to_sbc_, from_sbc_, held_;
  std::vector<double> memory_, context_;
  std::unique_ptr<Backseat> backseat_;
  GliderRuntime* runtime_ = nullptr;
};

/// What is at the other end, as a function of the time and of what arrives.
class Says final : public OtherEnd {
 public:
  explicit Says(std::function<std::string(double, const std::string&)> what)
      : what_(std::move(what)) {}
  std::string run(double now_s, const std::string& arrived) override {
    return what_(now_s, arrived);
  }

 private:
  std::function<std::string(double, const std::string&)> what_;
};

TEST(DockSbc, AllIsGoodForTheProgramOfTheFolder) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  const auto result = bench.check(sbc);
  EXPECT_EQ(result.played, DockPart::Vehicle) << "it was found by itself";
  EXPECT_EQ(result.end, DockEnd::Complete);
  EXPECT_THAT(withVerdict(result, DockVerdict::NotGood), IsEmpty());
  EXPECT_THAT(withVerdict(result, DockVerdict::NotChecked), IsEmpty());
  EXPECT_EQ(result.checks.size(), 12U);
  expectOnPage(result);
  EXPECT_NE(bench.written.find("$BY*1b\r\n$HI*01\r\n$SD,"), std::string::npos)
      << "the port is closed and opened once";
  EXPECT_TRUE(result.has_begun);
  EXPECT_THAT(checkNamed(result, "program").measured,
              HasSubstr(fmt::format("u_mission_param_l {}", bench.plan.port.program)));
  EXPECT_NEAR(result.seconds, 180, 5);
  EXPECT_FALSE(bench.progress.empty());
  EXPECT_EQ(bench.written.find("$SW"), std::string::npos);
  EXPECT_EQ(bench.written.find("$MD"), std::string::npos);
}

TEST(DockSbc, TheNextCheckOfTheSameProgramIsGoodToo) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  (void)bench.check(sbc);
  DockBench next;
  next.now_s = bench.now_s;
  next.part = DockPart::Vehicle;
  next.times.whole_s = 180;
  EXPECT_THAT(withVerdict(next.check(sbc), DockVerdict::NotGood), IsEmpty());
}

TEST(DockSbc, TheProgramOfAnotherFolderIsFound) {
  DockBench bench;
  GliderPortMission other = bench.plan.port;
  other.program += 5;
  Sbc sbc(other);
  const auto result = bench.check(sbc);
  EXPECT_THAT(withVerdict(result, DockVerdict::NotGood), ElementsAre("program"));
  EXPECT_THAT(checkNamed(result, "program").measured, HasSubstr("not that of this folder"));
  EXPECT_THAT(checkNamed(result, "program").todo, HasSubstr("`sbc/bench`"));
  EXPECT_FALSE(result.has_begun);
}

TEST(DockSbc, AProgramWithAnotherListOfSensorsIsFound) {
  DockBench longer;  // its clock has a higher index than any that this vehicle reports
  Sbc silent(longer.plan.port);
  longer.usePlan({GLIDER_M_DEPTH});
  EXPECT_THAT(checkNamed(longer.check(silent), "other-end").todo,
              HasSubstr("that of another folder may expect more sensors"));

  DockBench shorter;  // what it takes for the clock is another sensor, which does not change
  Sbc deaf(shorter.plan.port);
  shorter.usePlan({GLIDER_M_DEPTH, GLIDER_SCI_WATER_TEMP, GLIDER_M_PITCH});
  const auto result = shorter.check(deaf);
  EXPECT_EQ(checkNamed(result, "program").verdict, DockVerdict::NotGood);
  EXPECT_EQ(checkNamed(result, "answers").verdict, DockVerdict::NotGood);
}

TEST(DockSbc, AMissionWithAnotherNameIsNamed) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  sbc.change = [](const std::string& body) {
    return body == "TXT,mission,bench" ? "TXT,mission,winter" : body;
  };
  EXPECT_THAT(checkNamed(bench.check(sbc), "mission-name").measured,
              HasSubstr("`winter`, but `bench`"));
}

TEST(DockSbc, AProgramThatSteersAnyMissionIsFound) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  sbc.change = [](const std::string& body) {
    return body.starts_with("SW,") ? "SW,3:20.000000" + body.substr(2) : body;
  };
  const auto result = bench.check(sbc);
  EXPECT_THAT(checkNamed(result, "other-mission").measured,
              HasSubstr("it writes `u_mission_param_d` although no mission flies"));
  EXPECT_EQ(checkNamed(result, "release").verdict, DockVerdict::NotGood);
}

TEST(DockSbc, AProgramThatStillSteersAfterTheMissionIsFound) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  sbc.change = [&](const std::string& body) {
    return body.starts_with("SW,") && bench.now_s > 168 ? "SW,0:1.000000" + body.substr(2) : body;
  };
  EXPECT_THAT(withVerdict(bench.check(sbc), DockVerdict::NotGood), ElementsAre("release"));
}

TEST(DockSbc, WhatIsOutOfBoundsIsNamedWithItsBounds) {
  const std::pair<const char*, const char*> wrong[] = {
      {"3:61.000000", "`u_mission_param_d` 61, outside 0 to 60 m"},
      {"5:-1.200000", "`u_mission_param_f` -1.2, outside -0.785"},
      {"0:nan", "`u_mission_param_a` nan"},
      {"11:4.000000", "index 11, which an SBC does not write"},
      {"3;20", "1 pair that is no `index:value`"}};
  for (const auto& [pair, found] : wrong) {
    DockBench bench;
    Sbc sbc(bench.plan.port);
    bool done = false;
    sbc.change = [&](const std::string& body) {
      const bool now = !done && body.starts_with("SW,0:");
      done = done || now;
      return now ? body + "," + pair : body;
    };
    const auto result = bench.check(sbc);
    EXPECT_THAT(checkNamed(result, "written").measured, HasSubstr(found));
    EXPECT_EQ(checkNamed(result, "written").verdict, DockVerdict::NotGood) << pair;
  }
}

TEST(DockSbc, BitsOfTheMissionModeAreOnlyForSoftwareThatHasThem) {
  for (const Release release : {Release::Common, Release::MissionModes}) {
    DockBench bench;
    bench.choice.release = release;
    bench.usePlan({GLIDER_M_DEPTH, GLIDER_SCI_WATER_TEMP});
    GliderPortMission port = bench.plan.port;
    port.mission_modes = 1;
    Sbc sbc(port);
    EXPECT_EQ(checkNamed(bench.check(sbc), "written").verdict,
              release == Release::Common ? DockVerdict::NotGood : DockVerdict::Good);
  }
}

TEST(DockSbc, AfterARestartOfThePortAllIsWrittenAgain) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  int full = 0;
  sbc.change = [&](const std::string& body) {  // it does not notice $HI: only the first of all
    const bool all = body.starts_with("SW,0:") && body.find(",4:") != std::string::npos;
    full += all ? 1 : 0;
    return all && bench.now_s > 100 ? "SW" + body.substr(body.find(",8:")) : body;
  };
  const auto result = bench.check(sbc);
  EXPECT_THAT(withVerdict(result, DockVerdict::NotGood), ElementsAre("restart"));
  EXPECT_GT(full, 1);
}

TEST(DockSbc, NoiseIsCounted) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  int count = 0, flipped = 0;
  bench.damage = [&](uint8_t byte) {
    const bool now = ++count > 300 && count % 400 == 0 && byte > ' ' && byte != '$';
    flipped += now ? 1 : 0;
    return now ? static_cast<uint8_t>(byte ^ 1) : byte;
  };
  const auto result = bench.check(sbc);
  EXPECT_EQ(checkNamed(result, "line").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "line").measured, HasSubstr(fmt::format("{} damaged", flipped)));
  EXPECT_EQ(checkNamed(result, "program").verdict, DockVerdict::Good);
}

TEST(DockSbc, BytesBetweenTheSentencesAreNoise) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  Says noisy([&](double now_s, const std::string& arrived) {
    const std::string said = sbc.run(now_s, arrived);
    return said.empty() ? said : said + "\x81\x82\x83";
  });
  const auto result = bench.check(noisy);
  EXPECT_EQ(checkNamed(result, "line").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "line").measured, HasSubstr("0 damaged"));
}

TEST(DockSbc, LostAnswersAreToldFromLostReports) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  int answers = 0;
  sbc.change = [&](const std::string& body) {
    return body.starts_with("SW,") && (++answers == 20 || answers == 25) ? "" : body;
  };
  EXPECT_THAT(checkNamed(bench.check(sbc), "answers").measured,
              HasSubstr("; 2 lost on the way here, 0 on the way there"));

  DockBench deaf;
  Sbc other(deaf.plan.port);
  Says drops([&](double now_s, const std::string& arrived) {
    return other.run(now_s, now_s > 100 && now_s < 104 ? "" : arrived);
  });
  const auto result = deaf.check(drops);
  EXPECT_EQ(checkNamed(result, "answers").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "answers").measured,
              HasSubstr("; 0 lost on the way here, 1 on the way there"));
}

TEST(DockSbc, AProgramThatStartsAgainIsNoticed) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  sbc.restart_s = 130;
  const auto result = bench.check(sbc);
  EXPECT_EQ(checkNamed(result, "answers").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "answers").measured, HasSubstr("the program began again 1 time"));
}

TEST(DockSbc, SlowAnswersAreNotGood) {
  for (const double slow_s : {1.0, 2.5}) {
    DockBench bench;
    Sbc sbc(bench.plan.port);
    sbc.slow_s = slow_s;
    const auto result = bench.check(sbc);
    EXPECT_EQ(checkNamed(result, "answer-time").verdict,
              slow_s > 2 ? DockVerdict::NotGood : DockVerdict::Good);
    EXPECT_THAT(checkNamed(result, "answer-time").measured,
                HasSubstr(fmt::format("{:.0f}.", std::floor(slow_s))));
  }
}

TEST(DockSbc, ALineThatIsTooSlowIsNotGood) {
  DockBench bench;
  bench.baud = bench.sensors.baud = 300;
  Sbc sbc(bench.plan.port);
  const auto result = bench.check(sbc);
  EXPECT_EQ(checkNamed(result, "load").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "load").measured, HasSubstr("of the capacity at 300 baud"));
}

TEST(DockSbc, WhatTheDeviceCountsMeanwhileIsReported) {
  for (const uint32_t overruns : {0U, 2U}) {
    for (const uint32_t framing : {0U, 3U}) {
      DockBench bench;
      Sbc sbc(bench.plan.port);
      bench.errors = [&] {
        const bool late = bench.now_s > 60;
        return vehicles::DockHost::DeviceErrors{7 + (late ? overruns : 0),
                                                1 + (late ? framing : 0)};
      };
      const auto result = bench.check(sbc);
      const auto device = checkNamed(result, "device-errors");
      EXPECT_EQ(device.verdict, overruns + framing == 0 ? DockVerdict::Good : DockVerdict::NotGood);
      EXPECT_EQ(device.measured, fmt::format("{} overruns, {} framing errors", overruns, framing));
      EXPECT_EQ(device.todo.find("baud") != std::string::npos, framing > 0);
      expectOnPage(result);
    }
  }
}

TEST(DockSbc, NobodyIsFoundOutInTime) {
  DockBench bench;
  Says nothing([](double, const std::string&) { return ""; });
  const auto result = bench.check(nothing);
  EXPECT_EQ(result.played, DockPart::Auto);
  EXPECT_LT(result.seconds, 30);
  EXPECT_THAT(checkNamed(result, "other-end").measured, HasSubstr("nothing arrived in 22 s"));
  EXPECT_THAT(checkNamed(result, "other-end").todo,
              AllOf(HasSubstr("for an SBC"), HasSubstr("for a vehicle"), HasSubstr("TX")));
  bench.part = DockPart::Vehicle;
  EXPECT_THAT(checkNamed(bench.check(nothing), "other-end").todo,
              AllOf(HasSubstr("--baud 9600"), ::testing::Not(HasSubstr("c_extctl_on"))));
  bench.part = DockPart::Sbc;
  EXPECT_THAT(checkNamed(bench.check(nothing), "other-end").todo,
              AllOf(HasSubstr("c_extctl_on"), ::testing::Not(HasSubstr("sbc/bench"))));
}

TEST(DockSbc, AnEchoIsNobody) {
  DockBench bench;
  Says echo([](double, const std::string& arrived) { return arrived; });
  const auto result = bench.check(echo);
  EXPECT_THAT(checkNamed(result, "other-end").measured, HasSubstr("only what was sent came back"));
  EXPECT_LT(result.seconds, 30);
}

TEST(DockSbc, AnEchoBesideTheAnswersIsNotGood) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  Says both(
      [&](double now_s, const std::string& arrived) { return arrived + sbc.run(now_s, arrived); });
  const auto result = bench.check(both);
  EXPECT_EQ(result.played, DockPart::Vehicle);
  EXPECT_EQ(checkNamed(result, "line").verdict, DockVerdict::NotGood);
  EXPECT_THAT(checkNamed(result, "line").measured, HasSubstr("of them what was sent"));
}

TEST(DockSbc, AnotherBaudRateLooksLikeNoSentences) {
  DockBench bench;
  Says garbage([](double now_s, const std::string&) {
    return std::fmod(now_s, 1.0) < 0.002 ? std::string("\xf8\x80\x1c\xe0\xfe\x06\x98\xff") : "";
  });
  const auto result = bench.check(garbage);
  EXPECT_THAT(checkNamed(result, "other-end").measured,
              HasSubstr("bytes arrived, but no sentence"));
  EXPECT_THAT(checkNamed(result, "other-end").todo, HasSubstr("another baud rate than 9600"));
}

TEST(DockSbc, ALoginPromptIsShown) {
  DockBench bench;
  Says login([](double, const std::string& arrived) {
    return arrived.empty() ? "" : "\r\n\r\nts7800  login: ";
  });
  EXPECT_THAT(checkNamed(bench.check(login), "other-end").measured,
              HasSubstr("no sentence: \"ts7800 login: ts7800"));
}

TEST(DockSbc, WhatIsKnownIsReportedWhenItEndsEarly) {
  DockBench bench;
  Sbc sbc(bench.plan.port);
  bench.unplug_s = 101;
  const auto gone = bench.check(sbc);
  EXPECT_EQ(gone.end, DockEnd::LineGone);
  EXPECT_THAT(withVerdict(gone, DockVerdict::NotGood), ElementsAre("device"));
  EXPECT_THAT(checkNamed(gone, "device").measured, HasSubstr("after 101.0 s"));
  EXPECT_EQ(checkNamed(gone, "program").verdict, DockVerdict::Good);
  EXPECT_EQ(checkNamed(gone, "release").verdict, DockVerdict::NotChecked);

  DockBench stopped;
  Sbc other(stopped.plan.port);
  stopped.stop_s = 40;
  const auto interrupted = stopped.check(other);
  EXPECT_EQ(interrupted.end, DockEnd::Interrupted);
  EXPECT_THAT(withVerdict(interrupted, DockVerdict::NotGood), IsEmpty());
  EXPECT_EQ(checkNamed(interrupted, "program").verdict, DockVerdict::NotChecked);
}

TEST(DockSbc, TheListOfTheFolderMustBeThatOfTheProgram) {
  const struct {
    std::function<void(ExtctlFile&)> change;
    const char* found;
  } cases[] = {
      {[](ExtctlFile& file) { file.reported.erase(file.reported.begin() + 4); },
       "`m_lat` (lat) with index 15 is missing"},
      {[](ExtctlFile& file) { file.reported.insert(file.reported.begin() + 4, {"m_roll", "rad"}); },
       "`m_roll` (rad) with index 15 is not in the program's list"},
      {[](ExtctlFile& file) { std::swap(file.reported[4], file.reported[5]); },
       "index 15 is `m_lon` (lon), but `m_lat` (lat) for the program"},
      {[](ExtctlFile& file) { file.reported.back().unit = "s"; }, "`m_present_time` (s), but"},
  };
  for (const auto& [change, found] : cases) {
    DockBench bench;
    change(bench.sensors);
    bench.stop_s = 1;
    Says nothing([](double, const std::string&) { return ""; });
    const auto result = bench.check(nothing);
    EXPECT_EQ(checkNamed(result, "sensor-list").verdict, DockVerdict::NotGood);
    EXPECT_THAT(checkNamed(result, "sensor-list").measured, HasSubstr(found));
  }
  DockBench bench;
  for (ExtctlSensor& sensor : bench.sensors.reported) {
    std::ranges::transform(sensor.unit, sensor.unit.begin(), ::tolower);
  }
  bench.stop_s = 1;
  Says nothing([](double, const std::string&) { return ""; });
  EXPECT_EQ(checkNamed(bench.check(nothing), "sensor-list").verdict, DockVerdict::Good)
      << "the reader of extctl.ini has no capitals";
}

TEST(DockSbc, AnotherBaudRateThanInTheListIsNamed) {
  DockBench bench;
  bench.sensors.baud = 38400;
  bench.stop_s = 1;
  Says nothing([](double, const std::string&) { return ""; });
  EXPECT_THAT(checkNamed(bench.check(nothing), "baud").measured,
              HasSubstr("9600 baud, but 38400 in extctl.ini"));
}

TEST(DockSbc, AVehicleThereIsNamed) {
  DockBench bench;
  bench.part = DockPart::Vehicle;
  Says vehicle([](double now_s, const std::string&) {
    return std::fmod(now_s, 1.0) < 0.002 ? "$SD,0:658.165286680912*2e\r\n" : "";
  });
  EXPECT_THAT(checkNamed(bench.check(vehicle), "other-end").todo, HasSubstr("--as sbc"));
}

}  // namespace
}  // namespace glider::slocum::testing
