// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/sentence.h"
#include "platforms/load/load_platform.h"
#include "tests/slocum.h"
#include "vehicles/slocum/dock/dock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A check at the dock in virtual time, with a line of 9600 baud and something at its other end.
namespace glider::slocum::testing {

/// What is at the other end.
class OtherEnd {
 public:
  OtherEnd() = default;
  OtherEnd(const OtherEnd&) = delete;
  OtherEnd& operator=(const OtherEnd&) = delete;
  virtual ~OtherEnd() = default;
  /// Takes what has arrived by `now_s`; returns what it sends.
  virtual std::string run(double now_s, const std::string& arrived) = 0;
};

/// The body of each sentence of `text`, changed by `change`; an empty one is not sent.
inline std::string changed(const std::string& text,
                           const std::function<std::string(const std::string&)>& change) {
  hooks::extctl::SentenceReader reader;
  std::string out;
  for (const char c : text) {
    if (!reader.push(static_cast<uint8_t>(c))) {
      continue;
    }
    const std::string body = change(std::string(reader.body(), reader.size()));
    char sentence[1200];
    hooks::extctl::SentenceWriter writer(sentence, sizeof sentence);
    writer.put(body.c_str());
    out += body.empty() ? "" : std::string(sentence, writer.end());
  }
  return out;
}

class DockBench {
 public:
  DockBench() : platform(*platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml")) {
    choice.greatest_depth_m = 60;
    usePlan({GLIDER_M_DEPTH, GLIDER_SCI_WATER_TEMP});
  }
  /// The mission reads these sensors.
  void usePlan(const std::vector<uint16_t>& read) {
    plan = *planPort("bench", "content", platform, read, choice);
    sensors = plan.extctl;
  }

  vehicles::DockResult check(OtherEnd& end) {
    end_ = &end;
    DockSetup setup{.plan = plan,
                    .sensors = sensors,
                    .platform = platform,
                    .program = "sbc/bench",
                    .part = part,
                    .times = times};
    vehicles::DockHost host;
    host.line = {this, read, write};
    host.device = "/dev/bench";
    host.baud = baud;
    host.now = [this] { return now_s; };
    host.sleep = [this](double seconds) { pass(seconds); };
    host.stop = [this] { return now_s >= stop_s; };
    host.progress = [this](const std::string& text) { progress.push_back(text); };
    host.confirm = confirm;
    host.errors = errors;
    return checkAtDock(setup, host);
  }

  platforms::Platform platform;
  PortChoice choice;
  PortPlan plan;
  ExtctlFile sensors;
  vehicles::DockPart part = vehicles::DockPart::Auto;
  DockTimes times;
  uint32_t baud = 9600;
  double now_s = 0;
  double stop_s = 1e9, unplug_s = 1e9;
  std::function<bool(const std::string&)> confirm;
  std::function<std::optional<vehicles::DockHost::DeviceErrors>()> errors = [] {
    return std::nullopt;
  };
  /// What the line does to each byte towards this computer.
  std::function<uint8_t(uint8_t)> damage = [](uint8_t byte) { return byte; };
  std::vector<std::string> progress;
  std::string written;  ///< by the check, all of it

 private:
  /// Bytes on a line, each with the time at which it arrives.
  struct Way {
    void put(double now_s, std::string_view bytes) {
      for (const char c : bytes) {
        free_s = std::max(now_s, free_s) + 10.0 / 9600;
        bytes_.emplace_back(free_s, c);
      }
    }
    std::string take(double now_s, size_t most) {
      std::string taken;
      while (!bytes_.empty() && bytes_.front().first <= now_s && taken.size() < most) {
        taken += bytes_.front().second;
        bytes_.pop_front();
      }
      return taken;
    }
    std::deque<std::pair<double, char>> bytes_;
    double free_s = 0;
  };
  void pass(double seconds) {
    now_s += seconds;
    to_dock_.put(now_s, end_->run(now_s, from_dock_.take(now_s, 1 << 20)));
  }
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity) {
    auto& bench = *static_cast<DockBench*>(self);
    if (bench.now_s >= bench.unplug_s) {
      return kGliderStreamClosed;
    }
    const std::string taken = bench.to_dock_.take(bench.now_s, capacity);
    for (size_t i = 0; i < taken.size(); ++i) {
      bytes[i] = bench.damage(static_cast<uint8_t>(taken[i]));
    }
    return static_cast<int32_t>(taken.size());
  }
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    auto& bench = *static_cast<DockBench*>(self);
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    bench.from_dock_.put(bench.now_s, text);
    bench.written += text;
    return static_cast<int32_t>(count);
  }

  OtherEnd* end_ = nullptr;
  Way to_dock_, from_dock_;
};

/// The check with this id; an empty one if there is none.
inline vehicles::DockCheck checkNamed(const vehicles::DockResult& result, std::string_view id) {
  const auto found = std::ranges::find(result.checks, id, &vehicles::DockCheck::id);
  EXPECT_NE(found, result.checks.end()) << id;
  return found == result.checks.end() ? vehicles::DockCheck{} : *found;
}

/// Each check is explained in the page for people.
inline void expectOnPage(const vehicles::DockResult& result) {
  std::ifstream file(GLIDER_SOURCE_DIR "/docs/at-the-dock.md");
  const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (const vehicles::DockCheck& check : result.checks) {
    EXPECT_NE(page.find("\n| " + check.what + " |"), std::string::npos) << check.what;
  }
}

/// The ids of what has this verdict.
inline std::vector<std::string> withVerdict(const vehicles::DockResult& result,
                                            vehicles::DockVerdict verdict) {
  std::vector<std::string> ids;
  for (const vehicles::DockCheck& check : result.checks) {
    if (check.verdict == verdict) {
      ids.push_back(check.id);
    }
  }
  return ids;
}

}  // namespace glider::slocum::testing
