// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/runtime.h"

#include "hooks/protocol/crc.h"
#include "runtime/abi/context_layout.h"
#include "runtime/core/instruction.h"
#include "runtime/core/lay_out.h"
#include "runtime/log/format.h"
#include "runtime/numbers/numbers.h"

#include <new>

using glider::hooks::ClientEvent;
using glider::hooks::HookAnswer;
using glider::hooks::Instruction;
using glider::runtime::Checkpoint;
using glider::runtime::ControlNews;
using glider::runtime::LogDetail;
using glider::runtime::LogEvent;

namespace {

LogEvent eventOf(ControlNews::Kind kind) {
  switch (kind) {
    case ControlNews::Kind::Taken:
      return LogEvent::ControlTaken;
    case ControlNews::Kind::Refused:
      return LogEvent::InstructionRefused;
    case ControlNews::Kind::Lost:
      return LogEvent::ControlLost;
    default:
      return LogEvent::ControlGivenBack;
  }
}

constexpr bool sameNumber(LogDetail detail, HookAnswer answer) {
  return static_cast<uint8_t>(detail) == static_cast<uint8_t>(answer);
}
// A refusal is logged by the number of its answer.
static_assert(sameNumber(LogDetail::BadCheck, HookAnswer::BadCheck));
static_assert(sameNumber(LogDetail::TooDeep, HookAnswer::TooDeep));
static_assert(sameNumber(LogDetail::BadPitch, HookAnswer::BadPitch));
static_assert(sameNumber(LogDetail::BadCommand, HookAnswer::BadCommand));
static_assert(sameNumber(LogDetail::NotOnEarth, HookAnswer::NotOnEarth));
static_assert(sameNumber(LogDetail::WrongSession, HookAnswer::WrongSession));
static_assert(sameNumber(LogDetail::NotReady, HookAnswer::NotReady));

/// The text of a note with its values after it, as much as a notice holds.
void writeNote(const GliderContext& context, const GliderNote& note, char* out) {
  glider::runtime::Text text(out, glider::hooks::kMostNoteBytes);
  text.put(note.text);
  for (uint32_t i = 0; i < note.count; ++i) {
    const double value = context.note_values[note.first + i];
    text.put(' ');
    value == value ? text.put(value) : text.put("unknown");
  }
}

/// True if each list that the mission counts is there.
bool hasTables(const GliderMission& mission) {
  return mission.states != nullptr && (mission.sensors != nullptr || mission.sensor_count == 0) &&
         (mission.always != nullptr || mission.always_count == 0) &&
         (mission.parameters != nullptr || mission.parameter_count == 0);
}

/// True if every state is there, and whatever has cases has guards.
bool hasGuards(const GliderMission& mission) {
  bool all = mission.guards != nullptr || mission.always_count == 0;
  for (uint32_t i = 0; i < mission.state_count; ++i) {
    const GliderStateInfo* state = mission.states[i];
    all = all && state != nullptr && (state->guards != nullptr || state->case_count == 0);
  }
  return all;
}

/// With other parameters it is another program.
uint32_t programOf(const GliderMission& mission, const GliderRuntimeOptions& options) {
  const auto* bytes = reinterpret_cast<const uint8_t*>(options.parameters);
  const uint32_t count = bytes == nullptr ? 0 : mission.parameter_count * sizeof(double);
  return glider::hooks::crc32c(bytes, count, options.program);
}

}  // namespace

GliderRuntime::GliderRuntime(void* context_memory, const GliderMission& mission,
                             const GliderRuntimeOptions& options)
    : context_memory_(context_memory),
      mission_(mission),
      parameters_(options.parameters),
      client_(subscribe(mission, sensors_)),
      log_(options.log, mission),
      persistence_(Checkpoint(options.checkpoints, programOf(mission, options)),
                   {client_, control_, clock_, log_}) {
  persistence_.look(*glider::runtime::layOut(context_memory_, mission_));
}

glider::hooks::ClientOptions GliderRuntime::subscribe(const GliderMission& mission,
                                                      glider::hooks::Subscription* sensors) {
  glider::hooks::ClientOptions options;
  options.mission_name = mission.name;
  options.sensors = sensors;
  for (uint32_t i = 0; i < mission.sensor_count; ++i) {
    const auto id = static_cast<uint16_t>(mission.sensors[i].id);
    bool known = mission.sensors[i].poll != nullptr;  // not the vehicle's
    for (uint32_t k = 0; k < options.sensor_count; ++k) {
      known = known || sensors[k].id == id;
    }
    if (!known) {
      sensors[options.sensor_count++] = glider::hooks::usualSubscription(id);
    }
  }
  return options;
}

bool GliderRuntime::acceptable(const GliderMission& mission) {
  return mission.abi_version == GLIDER_ABI_VERSION && mission.state_count > 0 &&
         mission.sensor_count <= glider::hooks::kMostSubscriptions &&
         mission.parameter_count <= GLIDER_MOST_PARAMETERS &&
         mission.parameter_count <= mission.variable_count &&
         mission.context_bytes == gliderContextLayout(&mission).bytes && hasTables(mission) &&
         hasGuards(mission);
}

GliderRuntimeStatus GliderRuntime::poll(const GliderByteStream& stream, const GliderClock& clock) {
  switch (client_.poll(stream, clock)) {
    case ClientEvent::Nothing:
      return kGliderRuntimeIdle;
    case ClientEvent::Closed:
      return kGliderRuntimeLinkClosed;
    case ClientEvent::Tick:
      answerTick(stream, clock.now(clock.self));
      return control_.released() ? kGliderRuntimeFinished : kGliderRuntimeProgressed;
    case ClientEvent::SilentLink:
      tickOfClockAlone(clock.now(clock.self));
      return kGliderRuntimeProgressed;
    case ClientEvent::Refused:
      logRefusedLink();
      return kGliderRuntimeProgressed;
    default:
      return kGliderRuntimeProgressed;
  }
}

void GliderRuntime::answerTick(const GliderByteStream& stream, double sbc_time) {
  const glider::hooks::VehicleTick& tick = client_.tick();
  if (persistence_.isUndecided()) {
    tryToGoOn(tick, sbc_time);
  }
  const ControlNews news = control_.observe(tick);
  const uint32_t count = gatherUpdates();
  if (context_ != nullptr) {
    stepMission(clock_.atFrame(tick.vehicle_time_s, sbc_time), count);
  } else if (!persistence_.isUndecided() && !control_.released() && control_.mayTake()) {
    clock_.start(tick.vehicle_time_s, sbc_time);
    startMission(count);
  }
  if (context_ != nullptr) {
    command();
  }
  logNews(news);
  logUnanswered(tick);
  persistence_.commit(context_);
  client_.done(status(), stream);
}

/// Flies on by its own clock; what it commands now goes with the next answer, for the SBC never
/// speaks first.
void GliderRuntime::tickOfClockAlone(double sbc_time) {
  if (context_ == nullptr || finished()) {
    return;
  }
  stepMission(clock_.withoutFrame(sbc_time), 0);
  log_.event(context_->mission_time, LogEvent::SilentLink, LogDetail::None,
             glider::runtime::unknown());
  persistence_.commit(context_);
}

void GliderRuntime::tryToGoOn(const glider::hooks::VehicleTick& tick, double sbc_time) {
  auto* found = static_cast<GliderContext*>(context_memory_);
  if (persistence_.goesOn(tick, *found, sbc_time)) {
    context_ = found;
    logged_refusals_ = context_->refused_commands;
  }
}

uint32_t GliderRuntime::gatherUpdates() {
  const glider::hooks::VehicleTick& tick = client_.tick();
  for (uint32_t i = 0; i < tick.reading_count; ++i) {
    updates_[i] = {tick.readings[i].value, tick.readings[i].id, 0};
  }
  return tick.reading_count;
}

void GliderRuntime::startMission(uint32_t update_count) {
  context_ = gliderStart(context_memory_, &mission_, parameters_, updates_, update_count);
  log_.begin(*context_);
  persistence_.begun();
  tellNotes();
  log_.values(*context_);
  logRefusedCommands();
}

void GliderRuntime::stepMission(double mission_time, uint32_t update_count) {
  if (finished()) {
    return;
  }
  const uint32_t from = context_->state;
  const glider::runtime::StateTimes times{context_->entered, context_->resumed};
  gliderStep(context_, mission_time, updates_, update_count);
  tellNotes();
  tellTransition(from, times);
  if (!finished()) {
    log_.values(*context_);
  }
  logRefusedCommands();
}

void GliderRuntime::tellTransition(uint32_t from, const glider::runtime::StateTimes& times) {
  if (context_->moved_list == GLIDER_NO_LIST) {
    return;
  }
  glider::hooks::TransitionNotice notice;
  notice.mission_time_s = context_->mission_time;
  notice.transition = static_cast<uint8_t>(glider::runtime::madeCase(*context_, from).transition);
  notice.list = static_cast<uint8_t>(context_->moved_list);
  notice.from = from;
  notice.to = context_->state;
  notice.fired_case = context_->moved_case;
  client_.notify(notice);
  log_.transition(*context_, from, times);
}

/// What `log` and unknown values left in this tick: to the log, and as texts to the vehicle.
void GliderRuntime::tellNotes() {
  for (uint32_t i = 0; i < context_->note_count; ++i) {
    log_.note(*context_, i);
    glider::hooks::MissionNote told;
    told.mission_time_s = context_->mission_time;
    told.kind = static_cast<uint8_t>(context_->notes[i].kind);
    writeNote(*context_, context_->notes[i], told.text);
    client_.tell(told);
  }
  if (context_->lost_notes != 0) {
    log_.event(context_->mission_time, LogEvent::NotesLost, LogDetail::None,
               static_cast<double>(context_->lost_notes));
  }
}

void GliderRuntime::command() {
  Instruction instruction;
  if (control_.choose(glider::runtime::instructionFor(*context_), finished(), instruction)) {
    control_.sent(instruction, client_.instruct(instruction));
  }
}

void GliderRuntime::logNews(const ControlNews& news) {
  if (news.kind != ControlNews::Kind::None && context_ != nullptr) {
    const bool refused = news.kind == ControlNews::Kind::Refused;
    log_.event(context_->mission_time, eventOf(news.kind),
               refused ? static_cast<LogDetail>(news.answer) : LogDetail::None,
               static_cast<double>(news.sequence));
  }
}

/// Told once, when the client stops claiming control.
void GliderRuntime::logUnanswered(const glider::hooks::VehicleTick& tick) {
  if (context_ != nullptr && tick.unanswered_ticks == glider::hooks::Client::kMostUnansweredTicks) {
    log_.event(context_->mission_time, LogEvent::InstructionUnanswered, LogDetail::None,
               static_cast<double>(tick.instruction_sequence));
  }
}

void GliderRuntime::logRefusedCommands() {
  if (context_->refused_commands != logged_refusals_) {
    log_.event(context_->mission_time, LogEvent::UnknownCommand, LogDetail::None,
               static_cast<double>(context_->refused_commands - logged_refusals_));
    logged_refusals_ = context_->refused_commands;
  }
}

void GliderRuntime::logRefusedLink() {
  const glider::hooks::Refusal& refusal = client_.refusal();
  const bool same_version = refusal.version == glider::hooks::kProtocolVersion;
  log_.event(0.0, LogEvent::LinkRefused,
             same_version ? LogDetail::OtherDictionary : LogDetail::OtherVersion,
             static_cast<double>(same_version ? refusal.dictionary : refusal.version));
  log_.flush();
}

glider::hooks::MissionStatus GliderRuntime::status() const {
  glider::hooks::MissionStatus status;
  if (context_ != nullptr) {
    status.mission_time_s = context_->mission_time;
    status.state = context_->state;
    status.stack_depth = static_cast<uint8_t>(context_->stack_depth);
    using glider::hooks::MissionPhase;
    status.phase = finished() ? MissionPhase::Finished : MissionPhase::Flying;
  }
  return status;
}

extern "C" uint32_t gliderRuntimeSize(void) {
  return sizeof(GliderRuntime);
}

extern "C" GliderRuntime* gliderRuntimeInit(void* memory, void* context_memory,
                                            const GliderMission* mission,
                                            const GliderRuntimeOptions* options) {
  if (memory == nullptr || context_memory == nullptr || mission == nullptr ||
      !GliderRuntime::acceptable(*mission)) {
    return nullptr;
  }
  const GliderRuntimeOptions none{};
  return ::new (memory)
      GliderRuntime(context_memory, *mission, options != nullptr ? *options : none);
}

extern "C" GliderRuntimeStatus gliderRuntimePoll(GliderRuntime* runtime,
                                                 const GliderByteStream* stream,
                                                 const GliderClock* clock) {
  return runtime->poll(*stream, *clock);
}

extern "C" const GliderContext* gliderRuntimeContext(const GliderRuntime* runtime) {
  return runtime->context();
}
