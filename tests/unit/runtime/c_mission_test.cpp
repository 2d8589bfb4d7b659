// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The missions in C as programs of their own, over a pseudo-terminal, in lockstep with a vehicle on
// the bench.

#include "hooks/protocol/lockstep.h"
#include "hooks/transport/host/pty.h"
#include "runtime/c/glider.h"
#include "runtime/c/kept_state.h"
#include "tests/unit/runtime/log_csv.h"
#include "tests/unit/runtime/vehicle_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <memory>
#include <optional>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace glider::runtime::testing {
namespace {

/// The missions' programs. scripts/mutants_code names others, which have a fault.
const char* programOr(const char* variable, const char* built) {
  const char* other = std::getenv(variable);
  return other != nullptr ? other : built;
}
const char* const kFigure2 = programOr("GLIDER_FIGURE2", GLIDER_FIGURE2);
const char* const kFigure3 = programOr("GLIDER_FIGURE3", GLIDER_FIGURE3);

/// A C mission's process at the far end of the vehicle's line.
class CMission {
 public:
  CMission(const char* program, VehicleBench& vehicle, std::vector<std::string> options = {})
      : vehicle_(vehicle) {
    auto opened = hooks::Pty::open();
    if (!opened) {
      return;
    }
    pty_.emplace(std::move(*opened));
    options.insert(options.begin(), {program, "--port", pty_->name()});
    std::vector<char*> arguments;
    for (std::string& option : options) {
      arguments.push_back(option.data());
    }
    arguments.push_back(nullptr);
    if (posix_spawn(&process_, program, nullptr, nullptr, arguments.data(), environ) != 0) {
      process_ = -1;
    }
    vehicle_.sbc = [this] { exchange(); };
  }
  CMission(const CMission&) = delete;
  CMission& operator=(const CMission&) = delete;
  ~CMission() { (void)exitStatus(); }

  /// The process that writes its log; 0 if there is none.
  [[nodiscard]] pid_t writer() const {
    const std::string number = std::to_string(process_);
    std::ifstream children("/proc/" + number + "/task/" + number + "/children");
    pid_t child = 0;
    children >> child;
    return child;
  }
  [[nodiscard]] bool started() const { return process_ > 0; }
  bool hung = false;  ///< a frame got no answer in 10 s

  /// Its processes die where they are.
  void cutPower() {
    const pid_t writer_process = writer();
    kill(process_, SIGKILL);
    if (writer_process > 0) {
      kill(writer_process, SIGKILL);
    }
    vehicle_.sbc = [] {};
    over_ = true;
    (void)exitStatus();
  }

  void hangUp() {
    over_ = true;
    pty_.reset();
  }
  /// Waits for its end; kills it if it does not come.
  int exitStatus() {
    if (process_ <= 0) {
      return status_;
    }
    int status = 0;
    pid_t ended = 0;
    for (int i = 0; i < 500 && ended == 0; ++i) {
      ended = waitpid(process_, &status, WNOHANG);
      usleep(ended == 0 ? 10000 : 0);
    }
    if (ended == 0) {
      kill(process_, SIGKILL);
      waitpid(process_, &status, 0);
    }
    process_ = -1;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return status_;
  }

 private:
  void exchange() {
    if (over_) {
      return;
    }
    const GliderByteStream line = vehicle_.sbcEnd();
    const GliderByteStream pty = pty_->stream();
    uint8_t bytes[512];
    for (int32_t got = 1; got > 0;) {
      got = line.read(line.self, bytes, sizeof bytes);
      if (got > 0) {
        lockstep_.toSbc(bytes, static_cast<uint32_t>(got));
        (void)pty.write(pty.self, bytes, static_cast<uint32_t>(got));
      }
    }
    while (!lockstep_.settled() && !over_) {
      hear(line, pty);
    }
  }

  void hear(const GliderByteStream& line, const GliderByteStream& pty) {
    uint8_t bytes[512];
    pollfd wanted{pty_->descriptor(), POLLIN, 0};
    hung = hung || ::poll(&wanted, 1, 10000) == 0;
    const int32_t got = hung ? -1 : pty.read(pty.self, bytes, sizeof bytes);
    over_ = got < 0;
    if (got > 0) {
      if (!heard_) {
        heard_ = true;
        pty_->releaseUserSide();  // from now on its end shows as a closed line
      }
      lockstep_.fromSbc(bytes, static_cast<uint32_t>(got));
      (void)line.write(line.self, bytes, static_cast<uint32_t>(got));
    }
  }

  VehicleBench& vehicle_;
  std::optional<hooks::Pty> pty_;
  hooks::Lockstep lockstep_;
  pid_t process_ = -1;
  int status_ = -1;
  bool heard_ = false;
  bool over_ = false;
};

struct EmptyFile {
  EmptyFile() { close(mkstemp(name)); }
  EmptyFile(const EmptyFile&) = delete;
  EmptyFile& operator=(const EmptyFile&) = delete;
  ~EmptyFile() { unlink(name); }
  char name[32] = "/tmp/glider-file-XXXXXX";
};

std::string logOf(const EmptyFile& file) {
  std::stringstream bytes;
  bytes << std::ifstream(file.name, std::ios::binary).rdbuf();
  return csvOf(bytes.str());
}

/// A glider that does what hookbeh says, in water with a thermocline at 14 m; remembers what it was
/// commanded.
class Diver {
 public:
  explicit Diver(VehicleBench& vehicle) : vehicle_(vehicle) {
    vehicle.depth = [this](double t) { return move(t); };
    vehicle.temperature = [this](double) { return 15.5 - 8.5 * std::tanh((depth_ - 14) / 2.5); };
  }
  double shallowest = 1e9;  ///< since the last forget()
  double deepest = 0;
  void forget() {
    shallowest = 1e9;
    deepest = 0;
  }

 private:
  double move(double t) {
    const double speed =
        vehicle_.hookbeh().commanding ? (vehicle_.hookbeh().pump_cc < 0 ? 0.17 : -0.17) : 0.0;
    depth_ = std::max(0.0, depth_ + speed * (t - time_));
    time_ = t;
    shallowest = std::min(shallowest, depth_);
    deepest = std::max(deepest, depth_);
    return depth_;
  }
  VehicleBench& vehicle_;
  double depth_ = 6;
  double time_ = 0;
};

TEST(CMission, Figure3TracksTheThermoclineAndReleasesControl) {
  VehicleBench vehicle({});
  Diver diver(vehicle);
  CMission mission(kFigure3, vehicle);
  ASSERT_TRUE(mission.started());
  vehicle.run(400);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  diver.forget();
  vehicle.run(900);
  EXPECT_GT(diver.shallowest, 8) << "no longer the whole range of 5…20 m";
  EXPECT_LT(diver.deepest, 20);
  EXPECT_LT(diver.shallowest, 13);
  EXPECT_GT(diver.deepest, 15);
  vehicle.run(1100);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Complete);
  EXPECT_FALSE(mission.hung);
  EXPECT_EQ(mission.exitStatus(), 0);
}

TEST(CMission, Figure2FliesItsStates) {
  VehicleBench vehicle({});
  Diver diver(vehicle);
  CMission mission(kFigure2, vehicle);
  ASSERT_TRUE(mission.started());
  vehicle.run(200);
  diver.forget();
  vehicle.run(480);
  EXPECT_LT(diver.deepest, 13) << "s1: 5…10 m";
  vehicle.run(800);
  EXPECT_GT(diver.deepest, 15) << "s2 looks for the thermocline";
  EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_LATERAL), 0) << "noheading";
  vehicle.run(1700);
  diver.forget();
  vehicle.run(1980);
  EXPECT_LT(diver.deepest, 13) << "s1 again";
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_LON), -7349.8058, 1e-6);
  vehicle.run(2400);
  EXPECT_GT(diver.deepest, 19) << "s3: 5…20 m";
  EXPECT_NEAR(vehicle.array(GLIDER_SCI_HOOK_LON), -7349.5058, 1e-6);
  vehicle.run(2600);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Complete);
  EXPECT_FALSE(mission.hung);
  EXPECT_EQ(mission.exitStatus(), 0);
}

TEST(CMission, ACardThatStopsRespondingEndsNothing) {
  VehicleBench vehicle({}, false);
  Diver diver(vehicle);
  const EmptyFile log;
  CMission mission(kFigure3, vehicle, {"--log", log.name});
  ASSERT_TRUE(mission.started());
  vehicle.run(1);
  const pid_t writer = mission.writer();
  ASSERT_GT(writer, 0);
  kill(writer, SIGSTOP);
  vehicle.run(400);
  EXPECT_FALSE(mission.hung);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  EXPECT_GT(diver.deepest, 12) << "it dives as ever";
  vehicle.run(1100);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Complete);
  EXPECT_EQ(mission.exitStatus(), 0);
  EXPECT_EQ(std::ifstream(log.name).get(), EOF) << "the card did not respond at any time";
  kill(writer, SIGKILL);
}

/// Figure 2 with checkpoints, to its end; the power goes at `cut` for `outage` seconds. What
/// hookbeh did.
std::vector<std::string> figure2(std::optional<double> cut, double outage) {
  VehicleBench vehicle({});
  const Diver diver(vehicle);
  const EmptyFile checkpoints;
  const std::vector<std::string> options{"--checkpoint", checkpoints.name};
  auto mission = std::make_unique<CMission>(kFigure2, vehicle, options);
  if (cut) {
    vehicle.run(*cut);
    mission->cutPower();
    vehicle.run(*cut + outage);
    mission = std::make_unique<CMission>(kFigure2, vehicle, options);
  }
  vehicle.run(2600);
  EXPECT_FALSE(mission->hung);
  EXPECT_EQ(mission->exitStatus(), 0);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Complete);
  return vehicle.doings;
}

TEST(CMission, GoesOnAfterAPowerCutAsIfThereHadBeenNone) {
  const std::vector<std::string> undisturbed = figure2(std::nullopt, 0);
  EXPECT_GT(undisturbed.size(), 20U);
  // In each of its states, and while the called one has seen half of the thermocline. Nothing is
  // decided in those seconds.
  for (const double cut : {301.0, 529.0, 1101.0, 1703.0, 2202.0}) {
    EXPECT_EQ(figure2(cut, 7), undisturbed) << "cut at " << cut << " s";
  }
}

TEST(CMission, LeavesControlToTheVehicleAfterTooLongAnOutage) {
  VehicleBench vehicle({});
  const Diver diver(vehicle);
  const EmptyFile checkpoints;
  const EmptyFile log;
  const std::vector<std::string> options{"--checkpoint", checkpoints.name, "--log", log.name};
  {
    CMission mission(kFigure2, vehicle, options);
    vehicle.run(600);
    EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
    mission.cutPower();
  }
  vehicle.run(1000);
  CMission mission(kFigure2, vehicle, options);
  vehicle.run(1100);
  EXPECT_EQ(mission.exitStatus(), 0);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
  EXPECT_THAT(logOf(log), ::testing::HasSubstr("control left to the vehicle"));
}

TEST(CMission, WithoutKeptStateThereAreNoCheckpoints) {
  VehicleBench vehicle({});
  const EmptyFile checkpoints;
  CMission mission(kFigure3, vehicle, {"--checkpoint", checkpoints.name});
  EXPECT_EQ(mission.exitStatus(), 1);
}

TEST(KeptState, StoresWhatFitsAndReturnsIt) {
  KeptState kept;
  EXPECT_FALSE(kept.isDeclared());
  EXPECT_TRUE(kept.add(nullptr, 0));
  EXPECT_TRUE(kept.isDeclared()) << "nothing, but said so";
  double a = 1;
  char b[3] = {'x', 'y', 'z'};
  EXPECT_FALSE(kept.add(nullptr, 1));
  EXPECT_TRUE(kept.add(&a, sizeof a) && kept.add(b, sizeof b));
  EXPECT_EQ(kept.size(), 11U);
  EXPECT_FALSE(kept.add(b, KeptState::kMostBytes - 10));
  EXPECT_FALSE(kept.add(b, UINT32_MAX)) << "no wrap-around";
  uint8_t image[11];
  kept.save(image);
  a = 0;
  b[1] = 0;
  kept.restore(image);
  EXPECT_EQ(a, 1);
  EXPECT_EQ(b[1], 'y');
  while (kept.size() < 11U + KeptState::kMostPieces - 2) {
    ASSERT_TRUE(kept.add(b, 1));
  }
  EXPECT_FALSE(kept.add(b, 1)) << "too many pieces";
}

TEST(CMission, LogsControlAndWhatIsRefused) {
  VehicleBench vehicle({.greatest_depth_m = 15, .silence_secs = 24});
  const Diver diver(vehicle);
  const EmptyFile log;
  {
    CMission mission(kFigure2, vehicle, {"--log", log.name});
    vehicle.run(2600);
    EXPECT_EQ(mission.exitStatus(), 0);
  }
  const std::string csv = logOf(log);
  EXPECT_EQ(std::ranges::count_if(vehicle.events,
                                  [](const hooks::SeatEvent& e) {
                                    return e.kind == hooks::SeatEvent::Kind::SbcNote &&
                                           std::string(e.text) == "calls s 2";
                                  }),
            1);
  for (const char* wanted :
       {"control taken", "instruction refused", "control released", "500,log,calls s,2"}) {
    EXPECT_THAT(csv, ::testing::HasSubstr(wanted));
  }
}

TEST(CMission, TellsTheVehicleThatTheCardIsGone) {
  VehicleBench vehicle({});
  const Diver diver(vehicle);
  const EmptyFile log;
  CMission mission(kFigure3, vehicle, {"--log", log.name});
  vehicle.run(1);
  ASSERT_GT(mission.writer(), 0);
  kill(mission.writer(), SIGKILL);
  vehicle.run(200);
  const auto told = std::ranges::count_if(vehicle.events, [](const hooks::SeatEvent& e) {
    return e.kind == hooks::SeatEvent::Kind::SbcNote &&
           std::string_view(e.text).find("declination") == std::string_view::npos;
  });
  EXPECT_EQ(told, 1);
  mission.hangUp();
}

TEST(CMission, EndsWithStatus2WhenTheLineIsLost) {
  VehicleBench vehicle({});
  int status = 0;
  {
    auto mission = std::make_unique<CMission>(kFigure3, vehicle);
    ASSERT_TRUE(mission->started());
    vehicle.run(60);
    mission->hangUp();
    status = mission->exitStatus();
  }
  EXPECT_EQ(status, 2);
}

}  // namespace
}  // namespace glider::runtime::testing
