// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A vehicle that speaks RECON by UDP, one that is not up yet, restarts, and is not alone in the
// network: real datagrams on this computer, with made-up times.

#include "runtime/recon/udp_line.h"
#include "tests/unit/runtime/recon_udp_vehicle.h"
#include "tests/unit/runtime/recon_vehicle.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <memory>

namespace glider::runtime::recon {
namespace {

using ::testing::ElementsAre;
using testing::ReconUdpVehicle;
using testing::TwoDepths;
using testing::UdpPeer;
using News = UdpLine::News;

TEST(ReconAddress, MayBeWithoutItsPort) {
  NetworkAddress address;
  ASSERT_TRUE(readAddress("192.168.1.10", kUsualPort, address));
  EXPECT_TRUE(std::ranges::equal(address.host, std::vector{192, 168, 1, 10}));
  EXPECT_EQ(address.port, 23456);
  ASSERT_TRUE(readAddress("10.0.0.1:5000", kUsualPort, address));
  EXPECT_EQ(address.port, 5000);
  for (const char* wrong :
       {"", "10.0.0", "10.0.0.1:", "10.0.0.1:0", "10.0.0.1:65536", "10.0.0.1x", "10.0.0.1.2",
        "10.0.0.256", "remus", "10..0.1", ":23456", "10.0.0.1 "}) {
    EXPECT_FALSE(readAddress(wrong, kUsualPort, address)) << wrong;
  }
  EXPECT_EQ(address.port, 5000) << "a wrong text changes nothing";
}

std::vector<std::pair<News, uint32_t>>& reports() {
  static std::vector<std::pair<News, uint32_t>> all;
  return all;
}

/// A line to a peer, at made-up times.
struct LineBench {
  explicit LineBench(const UdpPeer& vehicle) : port(vehicle.port()) { reports().clear(); }
  uint16_t port;
  double now_s = 0;
  UdpLine line{{{127, 0, 0, 2}, port},
               {this, [](void* self) { return static_cast<LineBench*>(self)->now_s; }},
               [](News news, uint32_t count) { reports().emplace_back(news, count); }};

  std::string read(uint32_t capacity = 64) {
    std::string all(capacity, '\0');
    const GliderByteStream stream = line.stream();
    const int32_t count =
        stream.read(stream.self, reinterpret_cast<uint8_t*>(all.data()), capacity);
    EXPECT_GE(count, 0) << "the line is never closed";
    all.resize(static_cast<size_t>(std::max(count, 0)));
    return all;
  }
  /// All that is there.
  std::string readAll() {
    std::string all;
    for (std::string some = read(); !some.empty(); some = read()) {
      all += some;
    }
    return all;
  }
  int32_t write(const std::string& text) {
    const GliderByteStream stream = line.stream();
    return stream.write(stream.self, reinterpret_cast<const uint8_t*>(text.data()),
                        static_cast<uint32_t>(text.size()));
  }
};

TEST(ReconUdpLine, EachLineIsADatagramOfItsOwnAfterAPause) {
  const UdpPeer vehicle;
  LineBench bench(vehicle);
  EXPECT_EQ(bench.read(), "");
  const std::string answer = "#one\n#two\n#three\n";
  size_t sent = 0;
  while (sent < answer.size()) {
    const int32_t taken = bench.write(answer.substr(sent));
    ASSERT_GT(taken, 0);
    sent += static_cast<size_t>(taken);
  }
  const auto datagrams = vehicle.receive(100);
  ASSERT_EQ(datagrams.size(), 3U);
  EXPECT_EQ(datagrams[0].bytes, "#one\n");
  EXPECT_EQ(datagrams[1].bytes, "#two\n");
  EXPECT_EQ(datagrams[2].bytes, "#three\n");
  EXPECT_GE(datagrams[1].time_s - datagrams[0].time_s, 0.0019);
  EXPECT_GE(datagrams[2].time_s - datagrams[1].time_s, 0.0019);
}

TEST(ReconUdpLine, ReadsDatagramsHoweverSoonTheyFollow) {
  const UdpPeer vehicle;
  LineBench bench(vehicle);
  EXPECT_EQ(bench.read(), "");
  for (const char* text : {"#one\n", "#two\n", "#three\n"}) {
    vehicle.send(text);
  }
  EXPECT_EQ(bench.read(3), "#on");
  EXPECT_EQ(bench.read(), "e\n");
  EXPECT_EQ(bench.readAll(), "#two\n#three\n");
}

TEST(ReconUdpLine, HalfALineIsNotJoinedWithTheNext) {
  const UdpPeer vehicle;
  LineBench bench(vehicle);
  EXPECT_EQ(bench.read(), "");
  vehicle.send("#S,T12");
  vehicle.send("");
  vehicle.send("#two\n");
  EXPECT_EQ(bench.readAll(), "#S,T12\n#two\n");
}

/// The longest line is 1024 bytes long.
TEST(ReconUdpLine, WhatIsTooLongIsDamaged) {
  const UdpPeer vehicle;
  LineBench bench(vehicle);
  EXPECT_EQ(bench.read(), "");
  for (const size_t size : {1023U, 1024U, 1025U, 1026U, 3000U, 60000U}) {
    const std::string text = recon_described::summed("#" + std::string(size - 5, 'x') + "*");
    ASSERT_EQ(text.size(), size);
    vehicle.send(text);
    hooks::recon::LineReader reader;
    hooks::recon::Line line;
    bool whole = false;
    const std::string all = bench.readAll();
    for (const char byte : all) {
      whole = reader.push(static_cast<uint8_t>(byte), &line) || whole;
    }
    EXPECT_EQ(whole, size <= 1024) << size;
    EXPECT_EQ(reader.skippedBytes(), size <= 1024 ? 0 : std::min<size_t>(size, 1026)) << size;
    EXPECT_EQ(all.back(), '\n') << "the next line is not lost with it";
  }
}

TEST(ReconUdpLine, DatagramsOfOthersAreCountedAndPassedOver) {
  const UdpPeer vehicle, other_port(0, 2);
  const UdpPeer stranger(0, 3);
  LineBench bench(vehicle);
  EXPECT_EQ(bench.read(), "");
  for (int i = 0; i < 12; ++i) {
    stranger.send("#stranger\n", vehicle.port());
  }
  vehicle.send("#vehicle\n");
  EXPECT_EQ(bench.readAll(), "#vehicle\n");
  EXPECT_EQ(bench.line.strangers(), 12U);
  EXPECT_THAT(reports(), ElementsAre(std::pair(News::Stranger, 1U), std::pair(News::Stranger, 10U),
                                     std::pair(News::Heard, 0U)));
  other_port.send("#from any port\n", vehicle.port());
  EXPECT_EQ(bench.readAll(), "#from any port\n");
  EXPECT_EQ(reports().size(), 3U) << "only once";
  for (uint32_t i = 0; i < 2 * UdpLine::kMostStrangersAtOnce; ++i) {
    stranger.send("#stranger\n", vehicle.port());
  }
  EXPECT_EQ(bench.read(), "");
  EXPECT_EQ(bench.line.strangers(), 12 + UdpLine::kMostStrangersAtOnce) << "not all at once";
}

TEST(ReconUdpLine, AVehicleThatIsNotThereIsNoError) {
  UdpPeer vehicle;
  LineBench bench(vehicle);
  EXPECT_EQ(bench.read(), "");
  vehicle.close();
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(bench.write("#refused\n"), 9);
    EXPECT_EQ(bench.read(), "");
    EXPECT_GE(*bench.line.descriptor(), 0) << "the same socket";
  }
  ASSERT_TRUE(vehicle.open());
  EXPECT_EQ(bench.write("#taken\n"), 7);
  EXPECT_EQ(vehicle.receive(100).size(), 1U);
  vehicle.send("#back\n");
  EXPECT_EQ(bench.readAll(), "#back\n");
}

TEST(ReconUdpLine, WaitsForAPortThatAnotherProgramHas) {
  const UdpPeer vehicle;
  auto other = std::make_unique<UdpPeer>(vehicle.port(), 1);
  ASSERT_TRUE(other->isOpen());
  LineBench bench(vehicle);
  for (; bench.now_s < 10; bench.now_s += 0.5) {
    EXPECT_EQ(bench.read(), "");
  }
  EXPECT_EQ(*bench.line.descriptor(), -1) << "nothing to poll: it would return at once";
  EXPECT_EQ(bench.write("#lost\n"), 6) << "not kept for later";
  EXPECT_THAT(reports(), ElementsAre(std::pair(News::NoPort, 0U)));
  other = nullptr;
  bench.now_s += 2;
  EXPECT_EQ(bench.read(), "");
  EXPECT_GE(*bench.line.descriptor(), 0);
  vehicle.send("#vehicle\n");
  EXPECT_EQ(bench.readAll(), "#vehicle\n");
}

/// Two programs that steer the same vehicle.
TEST(ReconUdpLine, HasItsPortForItself) {
  const UdpPeer vehicle;
  LineBench first(vehicle), second(vehicle);
  EXPECT_EQ(first.read(), "");
  EXPECT_EQ(second.read(), "");
  EXPECT_GE(*first.line.descriptor(), 0);
  EXPECT_EQ(*second.line.descriptor(), -1);
}

/// A mission's program at such a vehicle.
struct UdpVehicle : ReconUdpVehicle {
  explicit UdpVehicle(const GliderMission& mission)
      : line({{127, 0, 0, 2}, peer.port()}, clock, nullptr),
        memory(gliderRuntimeSize() / sizeof(double) + 1),
        context_memory(mission.context_bytes / sizeof(double) + 1),
        backseat(std::make_unique<Backseat>(mission, testing::reconOf(), line.stream(), nullptr)),
        runtime(gliderRuntimeInit(memory.data(), context_memory.data(), &mission, nullptr)) {
    answer_ms = 1;
    work = [this] {
      const GliderByteStream stream = backseat->stream();
      for (GliderRuntimeStatus status = kGliderRuntimeProgressed;
           !finished && status == kGliderRuntimeProgressed;) {
        status = gliderRuntimePoll(runtime, &stream, &clock);
        finished = status == kGliderRuntimeFinished && backseat->mayEnd();
        EXPECT_NE(status, kGliderRuntimeLinkClosed);
      }
    };
    work();
  }
  [[nodiscard]] uint32_t damaged() const { return *backseat->damaged(); }

  /// That of the SBC keeps up with the vehicle's.
  GliderClock clock{this, [](void* self) { return static_cast<UdpVehicle*>(self)->now_s - 1.7e9; }};
  UdpLine line;
  std::vector<double> memory, context_memory;
  std::unique_ptr<Backseat> backseat;
  GliderRuntime* runtime;
  bool finished = false;
};

TEST(ReconOverUdp, FliesAMissionToItsEnd) {
  TwoDepths mission;
  mission.end_s = 40;
  UdpVehicle vehicle(mission.mission);
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.told_depth_m == 20; }, 30), 30);
  EXPECT_EQ(vehicle.queries, 1);
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.finished; }, 80), 80);
  EXPECT_FALSE(vehicle.obeys());
  EXPECT_EQ(vehicle.asks, 1);
  EXPECT_GE(vehicle.goals, 20);
  EXPECT_EQ(vehicle.damaged(), 0U);
  EXPECT_GE(vehicle.shortest_pause_s, 0.0019);
}

TEST(ReconOverUdp, GoesOnAfterAVehicleThatHasRestarted) {
  TwoDepths mission;
  UdpVehicle vehicle(mission.mission);
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.told_depth_m == 20; }, 30), 30);
  vehicle.restart(30);
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.told_depth_m == 20; }, 30), 30);
  EXPECT_EQ(vehicle.asks, 2);
  EXPECT_TRUE(vehicle.obeys());
}

TEST(ReconOverUdp, DamageIsCountedAndStrangersDoNotSteerIt) {
  TwoDepths mission;
  UdpVehicle vehicle(mission.mission);
  EXPECT_LT(vehicle.secondsUntil([&] { return vehicle.told_depth_m == 20; }, 30), 30);
  const UdpPeer stranger(0, 3);
  auto state = vehicle.state();
  state["mode"].number = 0x03;  // a mission that is over
  stranger.send(recon_described::lineOf("State", state), vehicle.peer.port());
  vehicle.seconds(3);
  EXPECT_TRUE(vehicle.obeys());
  EXPECT_EQ(vehicle.line.strangers(), 1U);
  EXPECT_EQ(vehicle.damaged(), 0U) << "what a stranger sends does not count";
  const int goals = vehicle.goals;
  const std::string line = recon_described::lineOf("State", vehicle.state());
  vehicle.peer.send(line.substr(0, line.size() / 2));
  vehicle.peer.send(std::string(2000, 'x'));
  vehicle.seconds(3);
  EXPECT_EQ(vehicle.goals, goals + 3) << "the next line is not lost with them";
  EXPECT_EQ(vehicle.damaged(), line.size() / 2 + 1 + 1026);
}

}  // namespace
}  // namespace glider::runtime::recon
