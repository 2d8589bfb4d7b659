// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The code does what the model does: the client, hookprog and hookbeh go
// through random flights of hooks/protocol/model/control.pml, with the same losses and restarts,
// and must put the same frames on the lines and be in the same states.

#include "hooks/client/client.h"
#include "hooks/hookbeh/hookbeh.h"
#include "hooks/hookprog/hookprog.h"
#include "tests/model/kept_sbc.h"
#include "tests/model/trace.h"
#include "tests/slocum.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace glider::tests {
namespace {

using namespace glider::hooks;

constexpr double kCycle = 4;

const char* nameOf(HookState state) {
  const char* const names[] = {"Absent", "Waiting", "Ready", "Active", "Silent", "Complete"};
  return names[static_cast<int>(state)];
}

std::string nameOf(HookAnswer answer) {
  return answer == HookAnswer::None           ? "None"
         : answer == HookAnswer::Accepted     ? "Accepted"
         : answer == HookAnswer::WrongSession ? "WrongSession"
         : answer == HookAnswer::NotReady     ? "NotReady"
         : answer == HookAnswer::OldSequence  ? "OldSequence"
                                              : "another";
}

const char* nameOf(MessageType type) {
  switch (type) {
#define MESSAGE(name, number, expects_answer) \
  case MessageType::name:                     \
    return #name;
#include "hooks/protocol/messages.def"
#undef MESSAGE
  }
  return "?";
}

double valueOf(std::span<const SensorValue> values, uint16_t id) {
  const auto found = std::ranges::find(values, id, &SensorValue::id);
  return found == values.end() ? 0 : found->value;
}

/// A frame of the code in the model's words.
ModelFrame inWords(const Frame& frame) {
  ModelFrame words;
  words.type = nameOf(frame.type);
  Welcome welcome;
  TickHead tick;
  Hello hello;
  Done done;
  if (decode(frame, welcome)) {
    words.link = welcome.link;
    words.session = welcome.newest_session;
  } else if (decode(frame, tick)) {
    words.link = tick.link;
    words.session = tick.session;
    words.sequence = tick.answered_sequence;
  } else if (decode(frame, hello)) {
    words.link = hello.link;
  } else if (decode(frame, done)) {
    words.session = done.session;
  } else if (SensorList list; decodeList(frame, list)) {
    words.session =
        static_cast<uint32_t>(valueOf({list.values, list.count}, GLIDER_SCI_HOOK_SESSION));
    words.sequence =
        static_cast<uint32_t>(valueOf({list.values, list.count}, GLIDER_SCI_HOOK_SEQUENCE));
  }
  return words;
}

/// What the model's message between the two computers stands for: a report of the flight
/// controller, an instruction, or a heartbeat. Here its values arrive together: how they may be
/// spread is scripts/soak/line's.
using Values = std::vector<SensorValue>;

ModelFrame inWords(const Values& values) {
  ModelFrame words;
  words.type = "Sensors";
  words.session = static_cast<uint32_t>(valueOf(values, GLIDER_SCI_HOOK_SESSION) +
                                        valueOf(values, GLIDER_X_HOOK_SESSION));
  words.sequence = static_cast<uint32_t>(valueOf(values, GLIDER_SCI_HOOK_SEQUENCE) +
                                         valueOf(values, GLIDER_X_HOOK_SEQUENCE));
  return words;
}

/// One direction of the vehicle's own line.
struct ValueWire {
  std::vector<Values> written;
  std::deque<Values> there;
  bool held = false;
  int before_held = 0;  ///< that still arrive
  Values recorded;

  [[nodiscard]] bool comes() const { return !there.empty() && !(held && before_held == 0); }
  Values take() {
    Values values = there.front();
    there.pop_front();
    before_held -= before_held > 0 ? 1 : 0;
    return values;
  }
  void carry(const std::vector<ModelFrame>& model, size_t& next) {
    for (const Values& values : written) {
      ASSERT_LT(next, model.size()) << "the model sends no values";
      const ModelFrame words = inWords(values);
      const ModelFrame& expected = model[next++];
      ASSERT_EQ(words.type, expected.type);
      EXPECT_EQ(words.session, expected.session);
      EXPECT_EQ(words.sequence, expected.sequence);
      for (int copy = 0; copy < expected.copies; ++copy) {
        there.push_back(values);
      }
      if (expected.recorded) {
        recorded = values;
      }
    }
    written.clear();
  }
};

/// One direction of a line, which does to each frame what the model did to it.
struct Wire {
  std::vector<uint8_t> written;
  std::deque<uint8_t> there;
  bool held = false;
  int frames_before_held = 0;  ///< that still arrive
  std::vector<uint8_t> recorded;

  [[nodiscard]] bool comes() const { return !there.empty() && !(held && frames_before_held == 0); }
  uint8_t take() {
    const uint8_t byte = there.front();
    there.pop_front();
    frames_before_held -= byte == 0 && frames_before_held > 0 ? 1 : 0;
    return byte;
  }

  void carry(const std::vector<ModelFrame>& model, size_t& next) {
    FrameDecoder decoder;
    size_t begin = 0;
    for (size_t i = 0; i < written.size(); ++i) {
      if (!decoder.push(written[i])) {
        continue;
      }
      ASSERT_LT(next, model.size()) << "the model sends no " << nameOf(decoder.frame().type);
      const ModelFrame words = inWords(decoder.frame());
      const ModelFrame& expected = model[next++];
      ASSERT_EQ(words.type, expected.type);
      EXPECT_EQ(words.session, expected.session) << words.type;
      EXPECT_EQ(words.sequence, expected.sequence) << words.type;
      if (words.type != "Subscribe") {
        EXPECT_EQ(words.link, expected.link) << words.type;
      }
      const std::vector<uint8_t> bytes(written.begin() + static_cast<ptrdiff_t>(begin),
                                       written.begin() + static_cast<ptrdiff_t>(i) + 1);
      for (int copy = 0; copy < expected.copies; ++copy) {
        there.insert(there.end(), bytes.begin(), bytes.end());
      }
      if (expected.recorded) {
        recorded = bytes;
      }
      begin = i + 1;
    }
    written.clear();
  }
};

/// An end of a line: reads one direction, writes the other.
struct End {
  Wire& in;
  Wire& out;
  GliderByteStream stream() {
    return {this,
            [](void* self, uint8_t* bytes, uint32_t capacity) {
              Wire& wire = static_cast<End*>(self)->in;
              uint32_t count = 0;
              for (; count < capacity && wire.comes(); ++count) {
                bytes[count] = wire.take();
              }
              return static_cast<int32_t>(count);
            },
            [](void* self, const uint8_t* bytes, uint32_t count) {
              Wire& wire = static_cast<End*>(self)->out;
              wire.written.insert(wire.written.end(), bytes, bytes + count);
              return static_cast<int32_t>(count);
            }};
  }
};

/// Each program has another name, so that the first frame of one never equals the last of another,
/// which would be the same frame once more.
ClientOptions clientOptions(int cycle) {
  static const Subscription depth{GLIDER_M_DEPTH, 1, 0};
  static std::string name;
  name = std::to_string(cycle);
  ClientOptions options;
  options.mission_name = name.c_str();
  options.sensors = &depth;
  options.sensor_count = 1;
  return options;
}

class Replay {
 public:
  Replay() {
    hookprog_.emplace(gliderDictionary);
    hookbeh_.emplace(HookbehArgs{}, kHull);
    client_.emplace(gliderDictionary, clientOptions(cycle_));
  }

  void round(const ModelRound& model) {
    size_t next[kDirections] = {};
    flightCycle();
    from_flight_.carry(model.frames[kFromFlight], next[kFromFlight]);
    scienceRun(model, next, 1);
    scienceRun(model, next, 2);
    sbcRun(model);
    wires_[kFromSbc].carry(model.frames[kFromSbc], next[kFromSbc]);
    scienceRun(model, next, 3);
    for (size_t i = 0; i < kDirections; ++i) {
      EXPECT_EQ(next[i], model.frames[i].size()) << "the code sends less in direction " << i;
    }
    EXPECT_EQ(nameOf(outputs_.state), model.state.state);
    EXPECT_EQ(nameOf(outputs_.answer), model.state.answer);
    EXPECT_EQ(outputs_.session, model.state.session);
    EXPECT_EQ(outputs_.answered_sequence, model.state.sequence);
    for (Wire& wire : wires_) {
      wire.held = false;
    }
    to_flight_.held = from_flight_.held = false;
    for (const std::string& what : model.after) {
      happen(what);
    }
    ++cycle_;
  }

 private:
  void flightCycle() {
    while (to_flight_.comes()) {
      for (const SensorValue& one : to_flight_.take()) {
        array_[one.id] = one.value;
      }
    }
    outputs_ = hookbeh_->cycle(inputs());
    from_flight_.written.push_back(
        {{GLIDER_X_HOOK_STATE, static_cast<double>(outputs_.state)},
         {GLIDER_X_HOOK_SEQUENCE, static_cast<double>(outputs_.answered_sequence)},
         {GLIDER_X_HOOK_ANSWER, static_cast<double>(outputs_.answer)},
         {GLIDER_X_HOOK_SESSION, static_cast<double>(outputs_.session)},
         {GLIDER_M_PRESENT_SECS_INTO_MISSION, kCycle * cycle_},
         {GLIDER_M_CYCLE_NUMBER, 1.0 * cycle_}});
  }

  [[nodiscard]] double array(uint16_t id) const {
    const auto found = array_.find(id);
    return found == array_.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  }

  [[nodiscard]] HookbehInputs inputs() const {
    HookbehInputs in;
    in.time_s = kCycle * cycle_;
    in.depth_m = 10;
    in.altitude_m = std::numeric_limits<double>::quiet_NaN();
    in.heartbeat = array(GLIDER_SCI_HOOK_HEARTBEAT);
    in.words.session = array(GLIDER_SCI_HOOK_SESSION);
    in.words.sequence = array(GLIDER_SCI_HOOK_SEQUENCE);
    in.words.control = array(GLIDER_SCI_HOOK_CONTROL);
    in.words.vertical = array(GLIDER_SCI_HOOK_VERTICAL);
    in.words.lateral = array(GLIDER_SCI_HOOK_LATERAL);
    in.words.hook_depth_m = array(GLIDER_SCI_HOOK_DEPTH);
    in.words.hook_pitch_rad = array(GLIDER_SCI_HOOK_PITCH);
    in.words.hook_heading_rad = array(GLIDER_SCI_HOOK_HEADING);
    in.words.hook_latitude_ddmm = array(GLIDER_SCI_HOOK_LAT);
    in.words.hook_longitude_ddmm = array(GLIDER_SCI_HOOK_LON);
    in.words.check = array(GLIDER_SCI_HOOK_CHECK);
    return in;
  }

  /// The first run of a cycle is a second after the flight controller's, the next a second later,
  /// when nothing more of its report comes, and the last when the SBC has answered: the model makes
  /// the first two in one.
  void scienceRun(const ModelRound& model, size_t* next, int second) {
    while (from_flight_.comes()) {
      for (const SensorValue& one : from_flight_.take()) {
        memory_[one.id] = {one.value, true};
      }
    }
    hookprog_->run(kCycle * cycle_ + second, {this, get, set}, at_prog_sbc_.stream());
    wires_[kToSbc].carry(model.frames[kToSbc], next[kToSbc]);
    to_flight_.carry(model.frames[kToFlight], next[kToFlight]);
  }

  static double get(void* self, uint16_t id, bool* fresh) {
    auto& memory = static_cast<Replay*>(self)->memory_;
    const auto found = memory.find(id);
    if (found == memory.end()) {
      *fresh = false;
      return std::numeric_limits<double>::quiet_NaN();
    }
    *fresh = std::exchange(found->second.second, false);
    return found->second.first;
  }

  /// The last word of an instruction is its sequence.
  static void set(void* self, uint16_t id, double value) {
    auto& replay = *static_cast<Replay*>(self);
    replay.set_.push_back({id, value});
    if (id == GLIDER_SCI_HOOK_SEQUENCE || !isInstructionSensor(id)) {
      replay.to_flight_.written.push_back(std::exchange(replay.set_, {}));
    }
  }

  void sbcRun(const ModelRound& model) {
    const GliderClock clock{nullptr, [](void*) { return 0.0; }};
    size_t tick = 0;
    for (ClientEvent event = ClientEvent::Handled; client_ && event != ClientEvent::Nothing;) {
      event = client_->poll(at_sbc_.stream(), clock);
      if (event == ClientEvent::Tick) {
        ASSERT_LT(tick, model.ticks.size()) << "the model's SBC sees no such tick";
        answerTick(model.ticks[tick++]);
      }
    }
    dropUnread();
    EXPECT_EQ(tick, model.ticks.size());
  }

  /// Nothing listens any more; what is held comes later.
  void dropUnread() {
    while (!client_ && wires_[kToSbc].comes()) {
      (void)wires_[kToSbc].take();
    }
  }

  /// As GliderRuntime::answerTick: decide about the checkpoint, fly, keep, answer.
  void answerTick(const ModelTick& tick) {
    decide(tick.decision);
    mission_time_s_ += stuck_ ? 0 : kCycle;
    instruct(tick.mission);
    if (flies_ && client_->session() != 0) {
      kept_.keep(mission_time_s_, client_->session(), client_->sequence());
    }
    if (tick.dies) {
      client_.reset();
      return;
    }
    client_->done({flies_ ? mission_time_s_ : 0, 0, 0, MissionPhase::Flying}, at_sbc_.stream());
    if (tick.decision == "leaves") {
      client_.reset();
    }
  }

  /// As GliderRuntime::considerCheckpoint.
  void decide(const std::string& what) {
    if (what == "start" || what == "leaves") {
      client_->resume(0, client_->sequence());
    }
    if (what == "start") {
      mission_time_s_ = 0;
    }
    flies_ = flies_ || what == "start" || what == "on";
  }

  void instruct(const std::string& what) {
    if (what == "rests") {
      return;
    }
    Instruction instruction;
    instruction.control = what == "Take"    ? HookControl::Take
                          : what == "Steer" ? HookControl::Steer
                                            : HookControl::Release;
    instruction.vertical = HookVertical::Descend;
    instruction.depth_m = 20;
    instruction.pitch_rad = -0.4;
    client_->instruct(instruction);
  }

  void happen(const std::string& what) {
    if (what.starts_with("hold ")) {
      const auto direction = static_cast<size_t>(what[5] - '0');
      const int before = what[7] - '0';
      if (direction == kToFlight || direction == kFromFlight) {
        ValueWire& wire = direction == kToFlight ? to_flight_ : from_flight_;
        wire.held = true;
        wire.before_held = before;
      } else {
        wires_[direction].held = true;
        wires_[direction].frames_before_held = before;
      }
    } else if (what.starts_with("replay ")) {
      const auto direction = static_cast<size_t>(what[7] - '0');
      if (direction == kToFlight || direction == kFromFlight) {
        ValueWire& wire = direction == kToFlight ? to_flight_ : from_flight_;
        wire.there.push_back(wire.recorded);
      } else {
        Wire& wire = wires_[direction];
        wire.there.insert(wire.there.end(), wire.recorded.begin(), wire.recorded.end());
      }
    } else if (what == "sbc off") {
      client_.reset();
      stuck_ = false;
    } else if (what == "sbc on") {
      startSbc(false);
      mission_time_s_ = 0;
    } else if (what == "sbc on with its checkpoint") {
      startSbc(true);
      client_->resume(kept_.facts().session, static_cast<uint16_t>(kept_.facts().instruction));
    } else if (what == "stuck") {
      stuck_ = true;
    } else if (what == "restart flight") {
      hookbeh_.emplace(HookbehArgs{}, kHull);
    } else if (what == "restart science") {
      hookprog_.emplace(gliderDictionary);
      memory_.clear();
    } else {
      FAIL() << "the model tells of `" << what << "`";
    }
  }

  void startSbc(bool keeps) {
    client_.emplace(gliderDictionary, clientOptions(cycle_));
    EXPECT_EQ(kept_.start(keeps), keeps) << "there is no checkpoint";
    flies_ = !keeps;
    stuck_ = false;
  }

  Wire wires_[kDirections];
  End at_sbc_{wires_[kToSbc], wires_[kFromSbc]};
  End at_prog_sbc_{wires_[kFromSbc], wires_[kToSbc]};
  ValueWire to_flight_, from_flight_;
  Values set_;                                          ///< of an instruction that is being written
  std::map<uint16_t, std::pair<double, bool>> memory_;  ///< of the science computer; true: fresh
  std::optional<Hookprog> hookprog_;
  std::optional<Hookbeh> hookbeh_;
  std::optional<Client> client_;
  KeptSbc kept_;
  bool flies_ = true;  ///< nothing is undecided about a checkpoint
  std::map<uint16_t, double> array_;
  HookbehOutputs outputs_;
  double mission_time_s_ = 0;
  bool stuck_ = false;
  int cycle_ = 1;
};

/// The value of `#define NAME VALUE` in one of the model's files.
double defined(const std::string& file, const std::string& name) {
  const std::string text = slurp(GLIDER_SOURCE_DIR "/hooks/protocol/model/" + file);
  const std::string wanted = "#define " + name + " ";
  const size_t at = text.find("\n" + wanted);
  EXPECT_NE(at, std::string::npos) << file << " defines no " << name;
  return std::stod(text.substr(at + 1 + wanted.size()));
}

TEST(Model, HasTheCodesTimeouts) {
  EXPECT_EQ(defined("control.pml", "SILENCE") * kCycle, HookbehArgs{}.silence_secs);
  EXPECT_EQ(defined("control.pml", "LOST") * kCycle, double{kHookSeatLostSecs});
  EXPECT_EQ(defined("control.pml", "UNANSWERED"), Client::kMostUnansweredTicks);
  EXPECT_EQ(defined("readings.pml", "LOST") * kCycle, double{kHookSeatLostSecs});
  EXPECT_LE(defined("readings.pml", "REMEMBERED"), 8);
}

TEST(Model, TheCodeFliesAsItDoes) {
  constexpr int kFlights = 120;
  size_t rounds = 0;
  std::map<std::string, int> met;
  for (int seed = 1; seed <= kFlights; ++seed) {
    Replay replay;
    size_t number = 0;
    for (const ModelRound& model : flyModel(seed)) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(++number));
      replay.round(model);
      ++met[model.state.state];
      ++met[model.state.answer];
      for (const ModelTick& tick : model.ticks) {
        ++met[tick.decision];
        met["dies"] += tick.dies ? 1 : 0;
      }
      for (const std::string& what : model.after) {
        ++met[what];
      }
      if (testing::Test::HasFailure()) {
        return;
      }
    }
    rounds += number;
  }
  EXPECT_GT(rounds, kFlights * 50U);
  for (const char* what : {"Ready",
                           "Active",
                           "Silent",
                           "Complete",
                           "Accepted",
                           "WrongSession",
                           "sbc off",
                           "sbc on",
                           "sbc on with its checkpoint",
                           "start",
                           "on",
                           "leaves",
                           "dies",
                           "stuck",
                           "restart flight",
                           "restart science",
                           "OldSequence",
                           "replay 0",
                           "replay 1",
                           "replay 2",
                           "replay 3",
                           "hold 0 0",
                           "hold 1 0",
                           "hold 2 0",
                           "hold 3 0",
                           "hold 0 1",
                           "hold 1 1",
                           "hold 2 1",
                           "hold 3 1"}) {
    EXPECT_GT(met[what], 0) << what;
  }
}

}  // namespace
}  // namespace glider::tests
