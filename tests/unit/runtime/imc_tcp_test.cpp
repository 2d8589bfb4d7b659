// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A vehicle at a TCP connection, which it refuses, resets, forgets, and does not read: a real peer
// on this computer, with made-up times.

#include "runtime/imc/backseat.h"
#include "runtime/imc/tcp_line.h"
#include "tests/unit/runtime/imc_tcp_vehicle.h"
#include "tests/unit/runtime/imc_vehicle.h"

#include <algorithm>
#include <memory>

namespace glider::runtime::imc {
namespace {

using testing::Bytes;
using testing::TcpPeer;
using testing::TwoDepths;

TEST(NetworkAddress, IsFourNumbersAndAPort) {
  NetworkAddress address;
  ASSERT_TRUE(readAddress("10.0.200.255:6006", 0, address));
  EXPECT_TRUE(std::ranges::equal(address.host, std::vector{10, 0, 200, 255}));
  EXPECT_EQ(address.port, 6006);
  for (const char* wrong : {"", "10.0.0.1", "10.0.0.1:", "10.0.0.1:0", "10.0.0.1:65536",
                            "10.0.0.1:6006x", "10.0.0:6006", "10.0.0.256:6006", "10.0.0.1.2:6006",
                            "localhost:6006", "10..0.1:6006", "-1.0.0.1:6006", " 10.0.0.1:6006",
                            "10.0.0.1:4294973302", "10.0.0.4294967297:6006", ":6006"}) {
    EXPECT_FALSE(readAddress(wrong, 0, address)) << wrong;
  }
  EXPECT_EQ(address.port, 6006) << "a wrong text changes nothing";
  EXPECT_TRUE(readAddress("255.255.255.255:65535", 0, address));
  EXPECT_EQ(address.port, 65535);
}

/// A line to a peer, at made-up times.
struct LineBench {
  TcpPeer peer;
  double now_s = 0;
  TcpLine line{{{127, 0, 0, 1}, peer.port()},
               {this, [](void* self) { return static_cast<LineBench*>(self)->now_s; }},
               nullptr};

  int32_t read() {
    uint8_t bytes[64];
    const GliderByteStream stream = line.stream();
    return stream.read(stream.self, bytes, sizeof bytes);
  }
  int32_t write(uint32_t count = 4) {
    static const uint8_t bytes[4096] = {};
    const GliderByteStream stream = line.stream();
    return stream.write(stream.self, bytes, count);
  }
  /// Whether there is a connection within so long.
  bool connects(double seconds = 3) {
    for (const double end_s = now_s + seconds; now_s <= end_s; now_s += 0.5) {
      // A connection within this computer may take a moment of real time.
      for (int tries = 0; tries < 20; ++tries) {
        if (read() >= 0) {
          return true;
        }
        usleep(100);
      }
    }
    return false;
  }
};

TEST(TcpLine, WaitsForAVehicleThatIsNotUpYet) {
  LineBench bench;
  EXPECT_FALSE(bench.connects(20));
  EXPECT_EQ(bench.write(), kGliderStreamClosed);
  EXPECT_EQ(*bench.line.descriptor(), -1) << "nothing to poll: it would return at once";
  bench.peer.listen();
  ASSERT_TRUE(bench.connects(2.5));
  EXPECT_GE(*bench.line.descriptor(), 0);
  ASSERT_TRUE(bench.peer.accept());
  EXPECT_EQ(bench.write(), 4);
  EXPECT_EQ(bench.peer.receive(1000).size(), 4U);
  bench.peer.send({1, 2, 3});
  EXPECT_EQ(bench.read(), 3);
  EXPECT_EQ(bench.read(), 0);
}

TEST(TcpLine, IsOpenedAgainAfterAResetAndAfterAnEnd) {
  for (const bool reset : {false, true}) {
    LineBench bench;
    bench.peer.listen();
    ASSERT_TRUE(bench.connects());
    ASSERT_TRUE(bench.peer.accept());
    bench.peer.send({7});
    reset ? bench.peer.reset() : bench.peer.hangUp();
    int32_t count = 0;
    for (int tries = 0; tries < 1000 && (count = bench.read()) >= 0; ++tries) {
      usleep(100);
    }
    EXPECT_EQ(count, kGliderStreamClosed) << reset;
    EXPECT_EQ(*bench.line.descriptor(), -1);
    bench.now_s += 2;
    EXPECT_TRUE(bench.connects()) << reset;
    EXPECT_TRUE(bench.peer.accept()) << reset;
  }
}

TEST(TcpLine, TriesOnceInTwoSeconds) {
  LineBench bench;
  bench.peer.listen();
  for (; bench.now_s < 100; bench.now_s += 0.1) {
    (void)bench.read();
    usleep(10);
    if (bench.peer.accept()) {
      bench.peer.reset();
    }
  }
  EXPECT_GE(bench.peer.accepted(), 40);
  EXPECT_LE(bench.peer.accepted(), 51);
}

TEST(TcpLine, ASilentVehicleIsConnectedAgain) {
  LineBench bench;
  bench.peer.listen();
  ASSERT_TRUE(bench.connects());
  ASSERT_TRUE(bench.peer.accept());
  for (int i = 0; i < 5; ++i) {
    bench.now_s += 9.5;
    bench.peer.send({7});
    int32_t count = 0;
    for (int tries = 0; tries < 1000 && (count = bench.read()) == 0; ++tries) {
      usleep(100);
    }
    EXPECT_EQ(count, 1) << "one that speaks is not";
  }
  bench.now_s += 10.1;
  EXPECT_EQ(bench.read(), kGliderStreamClosed);
  (void)bench.peer.receive(1000);
  EXPECT_FALSE(bench.peer.isConnected()) << "it sees the end";
  EXPECT_TRUE(bench.connects());
}

TEST(TcpLine, AnAttemptWithoutAnAnswerIsGivenUp) {
  LineBench bench;
  bench.peer.listen(0);
  const testing::Crowd crowd(bench.peer.port());
  EXPECT_FALSE(bench.connects(9));
  EXPECT_GE(*bench.line.descriptor(), 0) << "it waits";
  bench.now_s += 1;
  EXPECT_LT(bench.read(), 0);
  EXPECT_EQ(*bench.line.descriptor(), -1) << "given up";
}

/// The process that writes the card has copies of what was open when it began.
TEST(TcpLine, ACopyOfTheDescriptorDoesNotKeepItOpen) {
  LineBench bench;
  bench.peer.listen();
  ASSERT_TRUE(bench.connects());
  ASSERT_TRUE(bench.peer.accept());
  const int copy = dup(*bench.line.descriptor());
  bench.line.renew();
  (void)bench.peer.receive(1000);
  EXPECT_FALSE(bench.peer.isConnected());
  close(copy);
}

std::vector<bool>& reports() {
  static std::vector<bool> all;
  return all;
}

TEST(TcpLine, TellsOnceThatThereIsNoConnectionAndWhenThereIsOne) {
  LineBench bench;
  reports().clear();
  TcpLine line({{127, 0, 0, 1}, bench.peer.port()},
               {&bench, [](void* self) { return static_cast<LineBench*>(self)->now_s; }},
               [](bool connected) { reports().push_back(connected); });
  const GliderByteStream stream = line.stream();
  const auto look = [&](double seconds) {
    uint8_t byte = 0;
    for (const double end_s = bench.now_s + seconds; bench.now_s < end_s; bench.now_s += 0.5) {
      (void)stream.read(stream.self, &byte, 1);
      usleep(2000);
    }
  };
  look(20);
  EXPECT_EQ(reports(), std::vector({false}));
  bench.peer.listen();
  look(5);
  EXPECT_EQ(reports(), std::vector({false, true}));
  ASSERT_TRUE(bench.peer.accept());
  bench.peer.reset();
  look(0.5);
  EXPECT_EQ(reports(), std::vector({false, true, false}));
}

TEST(TcpLine, DoesNotBlockWhenThePeerDoesNotRead) {
  LineBench bench;
  bench.peer.listen();
  ASSERT_TRUE(bench.connects());
  int32_t taken = 1;
  for (int i = 0; i < 100000 && taken > 0; ++i) {
    taken = bench.write(4096);
  }
  EXPECT_EQ(taken, 0);
}

/// A mission's program at such a vehicle.
struct TcpVehicle : testing::TcpVehicle {
  explicit TcpVehicle(const GliderMission& mission)
      : line({{127, 0, 0, 1}, peer.port()}, clock, nullptr),
        memory(gliderRuntimeSize() / sizeof(double) + 1),
        context_memory(mission.context_bytes / sizeof(double) + 1),
        backseat(std::make_unique<Backseat>(
            mission, testing::imcOf(),
            VehicleLine{.stream = line.stream(),
                        .renew = [](void* self) { static_cast<TcpLine*>(self)->renew(); },
                        .self = &line},
            nullptr)),
        runtime(gliderRuntimeInit(memory.data(), context_memory.data(), &mission, nullptr)) {
    work = [this] {
      const GliderByteStream stream = backseat->stream();
      for (GliderRuntimeStatus status = kGliderRuntimeProgressed;
           !finished && status == kGliderRuntimeProgressed;) {
        status = gliderRuntimePoll(runtime, &stream, &clock);
        finished = status == kGliderRuntimeFinished;
        EXPECT_NE(status, kGliderRuntimeLinkClosed);
      }
    };
  }
  [[nodiscard]] const GliderContext* context() const { return gliderRuntimeContext(runtime); }
  [[nodiscard]] uint32_t damaged() const { return *backseat->damaged(); }

  /// That of the SBC keeps up with the vehicle's.
  GliderClock clock{this, [](void* self) { return static_cast<TcpVehicle*>(self)->now_s - 1.7e9; }};
  TcpLine line;
  std::vector<double> memory, context_memory;
  std::unique_ptr<Backseat> backseat;
  GliderRuntime* runtime;
  bool finished = false;
};

/// From nothing to a mission that flies.
void begin(TcpVehicle& vehicle) {
  vehicle.peer.listen();
  ASSERT_LT(vehicle.secondsUntil([&] { return vehicle.toldDepth() == 20; }, 30), 30);
  ASSERT_EQ(vehicle.starts, 1);
  ASSERT_EQ(vehicle.peer.accepted(), 1);
}

TEST(ImcOverTcp, FliesAMissionFromAVehicleThatIsNotUpYetToItsEnd) {
  TwoDepths mission;
  mission.end_s = 60;
  TcpVehicle vehicle(mission.mission);
  vehicle.seconds(30);
  EXPECT_EQ(vehicle.peer.accepted(), 0);
  begin(vehicle);
  vehicle.temperature = 10;
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.toldDepth() == 40; }, 10), 10);
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.finished; }, 80), 80);
  EXPECT_EQ(vehicle.plan, std::nullopt);
  EXPECT_EQ(vehicle.peer.accepted(), 1);
  EXPECT_EQ(vehicle.damaged(), 0U);
}

TEST(ImcOverTcp, GoesOnAfterAReset) {
  TwoDepths mission;
  TcpVehicle vehicle(mission.mission);
  begin(vehicle);
  for (int times = 0; times < 5; ++times) {
    const int references = vehicle.references;
    vehicle.peer.reset();
    vehicle.seconds(6);
    EXPECT_GE(vehicle.references, references + 2) << times;
    EXPECT_EQ(vehicle.plan, "glidercc") << times;
  }
  EXPECT_EQ(vehicle.peer.accepted(), 6);
  EXPECT_EQ(vehicle.starts, 1);
  EXPECT_EQ(vehicle.toldDepth(), 20);
}

/// The first half of a long packet: what comes after it on the same connection would be taken for
/// its second half.
TEST(ImcOverTcp, HalfAPacketIsNotJoinedWithTheNextConnection) {
  TwoDepths mission;
  TcpVehicle vehicle(mission.mission);
  begin(vehicle);
  Bytes half = vehicle.packet(263, {{"value", uint64_t{0}}});
  half[4] = 0x00;
  half[5] = 0x04;  // a payload of 1024 bytes
  vehicle.peer.send(half);
  vehicle.speaks = false;
  vehicle.second();
  vehicle.peer.reset();
  vehicle.speaks = true;
  ASSERT_LT(vehicle.secondsUntil([&] { return vehicle.peer.isConnected(); }, 10), 10);
  const int references = vehicle.references;
  vehicle.second();
  EXPECT_EQ(vehicle.references, references + 1) << "its first state was read";
  EXPECT_EQ(vehicle.toldDepth(), 20);
}

TEST(ImcOverTcp, MissionTimeGoesOnWithoutAConnection) {
  TwoDepths mission;
  TcpVehicle vehicle(mission.mission);
  begin(vehicle);
  const double before_s = vehicle.context()->mission_time;
  vehicle.speaks = false;
  vehicle.peer.reset();
  vehicle.seconds(100);
  EXPECT_GT(vehicle.context()->mission_time, before_s + 60);
  EXPECT_FALSE(vehicle.finished);
  vehicle.speaks = true;
  vehicle.depth_m = 15;
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.toldDepth() == 20; }, 30), 30);
  EXPECT_EQ(vehicle.starts, 2) << "the plan has timed out, at a depth";
}

TEST(ImcOverTcp, ASwallowedStreamIsNoticedByTheReferenceThatIsReportedBack) {
  TwoDepths mission;
  TcpVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.seconds(20);
  vehicle.swallows = true;
  vehicle.temperature = 10;
  const int seconds = vehicle.secondsUntil([&] { return vehicle.toldDepth() == 40; }, 30);
  EXPECT_GE(seconds, 5);
  EXPECT_LE(seconds, 11);
  EXPECT_EQ(vehicle.peer.accepted(), 2);
  EXPECT_EQ(vehicle.starts, 1) << "before the plan has timed out";
  vehicle.seconds(60);
  EXPECT_EQ(vehicle.peer.accepted(), 2);
}

TEST(ImcOverTcp, ASwallowedStreamIsNoticedByTheTimeOut) {
  TwoDepths mission;
  TcpVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.seconds(20);
  vehicle.swallows = true;
  vehicle.depth_m = 15;
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.peer.accepted() == 2; }, 60), 20);
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.toldDepth() == 20; }, 60), 20);
  EXPECT_EQ(vehicle.starts, 2);
  EXPECT_EQ(vehicle.peer.accepted(), 2);
}

TEST(ImcOverTcp, ASwallowedStartIsAskedForOnAnotherConnection) {
  TwoDepths mission;
  TcpVehicle vehicle(mission.mission);
  vehicle.peer.listen();
  vehicle.swallows = vehicle.swallows_always = true;
  vehicle.secondsUntil([&] { return vehicle.peer.accepted() == 1; }, 10);
  vehicle.swallows_always = false;
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.toldDepth() == 20; }, 60), 25);
  EXPECT_EQ(vehicle.peer.accepted(), 2);
}

TEST(ImcOverTcp, AVehicleThatNeverAnswersIsConnectedAgainEverMoreRarely) {
  TwoDepths mission;
  TcpVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.swallows = vehicle.swallows_always = true;
  vehicle.temperature = 10;
  vehicle.seconds(600);
  EXPECT_GE(vehicle.peer.accepted(), 6);
  EXPECT_LE(vehicle.peer.accepted(), 24);
}

}  // namespace
}  // namespace glider::runtime::imc
