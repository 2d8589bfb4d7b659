// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/runtime.h"

#include "hooks/protocol/crc.h"
#include "runtime/abi/context_layout.h"
#include "runtime/core/instruction.h"
#include "runtime/core/lay_out.h"
#include "runtime/core/tell_notes.h"
#include "runtime/numbers/numbers.h"

#include <new>

using glider::hooks::ClientEvent;
using glider::hooks::Instruction;
using glider::runtime::Checkpoint;
using glider::runtime::ControlNews;
using glider::runtime::StartDepth;

namespace {

/// True if no list with a nonzero count is missing.
bool hasTables(const GliderMission& mission) {
  return mission.states != nullptr && (mission.sensors != nullptr || mission.sensor_count == 0) &&
         (mission.always != nullptr || mission.always_count == 0) &&
         (mission.parameters != nullptr || mission.parameter_count == 0);
}

/// True if every state exists, and each list of cases has guards.
bool hasGuards(const GliderMission& mission) {
  bool all = mission.guards != nullptr || mission.always_count == 0;
  for (uint32_t i = 0; i < mission.state_count; ++i) {
    const GliderStateInfo* state = mission.states[i];
    all = all && state != nullptr && (state->guards != nullptr || state->case_count == 0);
  }
  return all;
}

/// True if all sensors that the program subscribes to fit into a frame.
bool hasRoom(const GliderMission& mission) {
  const uint32_t most = glider::hooks::kMostSubscriptions;
  const uint32_t added =
      (StartDepth(mission).needsDepth() ? 1U : 0U) + glider::runtime::sensorsForNaps(mission);
  return mission.sensor_count + added <= most;
}

/// Includes the parameters: with different ones it is another program.
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
      client_(*mission.dictionary, subscribe(mission, sensors_)),
      log_(options.log, mission),
      link_log_(log_),
      variation_(glider::runtime::unknown()),
      start_depth_(mission),
      persistence_(Checkpoint(options.checkpoints, programOf(mission, options)),
                   {client_, control_, clock_, log_}) {
  persistence_.look(*glider::runtime::layOut(context_memory_, mission_));
}

glider::hooks::ClientOptions GliderRuntime::subscribe(const GliderMission& mission,
                                                      glider::hooks::Subscription* sensors) {
  glider::hooks::ClientOptions options;
  options.mission_name = mission.name;
  options.sensors = sensors;
  options.features.needs = static_cast<uint16_t>(mission.needs);
  for (uint32_t i = 0; i < mission.sensor_count; ++i) {
    const auto id = static_cast<uint16_t>(mission.sensors[i].id);
    if (mission.sensors[i].poll == nullptr) {  // the vehicle's
      hookUsualSubscription(mission.dictionary, id, &sensors[options.sensor_count++]);
    }
  }
  if (glider::runtime::sensorsForNaps(mission) != 0) {
    hookUsualSubscription(mission.dictionary, glider::runtime::napLimitSensor(mission),
                          &sensors[options.sensor_count++]);
  }
  if (StartDepth(mission).needsDepth()) {
    const auto depth = static_cast<uint16_t>(mission.dictionary->roles[kGliderRoleDepth]);
    hookUsualSubscription(mission.dictionary, depth, &sensors[options.sensor_count++]);
  }
  return options;
}

bool GliderRuntime::acceptable(const GliderMission& mission) {
  return mission.abi_version == GLIDER_ABI_VERSION && mission.dictionary != nullptr &&
         mission.state_count > 0 && mission.parameter_count <= GLIDER_MOST_PARAMETERS &&
         mission.parameter_count <= mission.variable_count &&
         mission.context_bytes == glider::runtime::layoutOf(mission).bytes && hasTables(mission) &&
         hasGuards(mission) && hasRoom(mission);
}

GliderRuntimeStatus GliderRuntime::poll(const GliderByteStream& stream, const GliderClock& clock) {
  if (isBroken()) {
    return kGliderRuntimeFailed;
  }
  switch (client_.poll(stream, clock)) {
    case ClientEvent::Nothing:
      return kGliderRuntimeIdle;
    case ClientEvent::Closed:
      return kGliderRuntimeLinkClosed;
    case ClientEvent::Tick:
      answerTick(stream, ownTime(clock));
      return control_.released() ? kGliderRuntimeFinished : kGliderRuntimeProgressed;
    case ClientEvent::SilentLink:
      tickOfClockAlone(clock.now(clock.self));
      return kGliderRuntimeProgressed;
    case ClientEvent::Refused:
      link_log_.refusedLink(client_.refusal());
      return kGliderRuntimeProgressed;
    case ClientEvent::Handled:
      break;
  }
  return kGliderRuntimeProgressed;
}

/// Checks what is kept from one poll to the next. True if that, or a check in the newest tick,
/// failed; the first time, the log reports it.
bool GliderRuntime::isBroken() {
  if (silent_) {
    return true;
  }
  GliderContext& context = memory();
  (void)GLIDER_ASSERT(context, context_ == nullptr || context_ == &context, ContextPointer);
  persistence_.check(context, context_ == nullptr ? nullptr : &mission_);
  if (hasFailed()) {
    silent_ = true;
    context_ = nullptr;
    persistence_.giveUp(context, mission_);
  }
  return silent_;
}

double GliderRuntime::ownTime(const GliderClock& clock) const {
  return client_.virtualTime() ? static_cast<double>(client_.tick().clock_s)
                               : clock.now(clock.self);
}

void GliderRuntime::answerTick(const GliderByteStream& stream, double sbc_time) {
  const glider::hooks::VehicleTick& tick = client_.tick();
  if (persistence_.isUndecided()) {
    tryToGoOn(tick, sbc_time);
  }
  const ControlNews news = control_.observe(tick);
  const bool may_begin = context_ == nullptr && mayBegin(tick);
  const uint32_t count = gatherUpdates();
  if (context_ != nullptr) {
    stepMission(missionTimeAt(tick, sbc_time), count);
  } else if (may_begin) {
    clock_.start(tick.vehicle_time_s, sbc_time);
    startMission(count);
  }
  bool commands = false;
  if (context_ != nullptr) {
    commands = command();
    link_log_.news(*context_, news);
    link_log_.unanswered(*context_, tick);
    link_log_.damagedInput(*context_, damaged_ != nullptr ? *damaged_ : client_.badFrames());
  }
  if (after_tick_.report != nullptr) {
    after_tick_.report(after_tick_.self, persistence_);
  }
  persistence_.commit(context_);
  if (context_ != nullptr && mission_.naps != nullptr) {
    const glider::runtime::NapTick now{*context_, tick,     client_,
                                       link_log_, commands, control_.isSettled()};
    mission_.naps->after_tick(&naps_, &now);
    if (naps_.asleep) {
      clock_.sleeps(mission_.naps->longest);
    }
  }
  if (!hasFailed()) {
    client_.done(status(), stream);
  }
}

double GliderRuntime::missionTimeAt(const glider::hooks::VehicleTick& tick, double sbc_time) {
  double time = 0;
  return glider::runtime::takeKeptFrame(clock_, tick, sbc_time, time)
             ? time
             : clock_.atFrame(tick.vehicle_time_s, tick.cycle, sbc_time);
}

/// Of a mission that does not continue from a checkpoint.
bool GliderRuntime::mayBegin(const glider::hooks::VehicleTick& tick) {
  const bool at_surface = start_depth_.look(tick);  // of every tick
  if (persistence_.isUndecided() || control_.released() || !control_.mayTake()) {
    return false;
  }
  if (start_depth_.takeWaiting()) {
    persistence_.waits(start_depth_.depth());
  }
  return at_surface;
}

/// Continues by its own clock. Its commands go with the next answer, because the SBC never sends
/// first.
void GliderRuntime::tickOfClockAlone(double sbc_time) {
  if (context_ == nullptr || finished()) {
    return;
  }
  stepMission(clock_.withoutFrame(sbc_time), 0);
  link_log_.silence(*context_);
  persistence_.commit(context_);
}

void GliderRuntime::tryToGoOn(const glider::hooks::VehicleTick& tick, double sbc_time) {
  auto* found = static_cast<GliderContext*>(context_memory_);
  if (persistence_.decide(tick, *found, sbc_time)) {
    context_ = found;
    link_log_.resume(*context_);
  }
}

uint32_t GliderRuntime::gatherUpdates() {
  const glider::hooks::VehicleTick& tick = client_.tick();
  for (uint32_t i = 0; i < tick.reading_count; ++i) {
    updates_[i] = {tick.readings[i].value, tick.readings[i].id, 0};
  }
  return convertHeadings(updates_, tick.reading_count);
}

/// Converts the headings of a frame before its tick, or, without a frame, the commanded heading
/// after a tick. Returns the number of updates.
__attribute__((noinline)) uint32_t GliderRuntime::convertHeadings(GliderUpdate* updates,
                                                                  uint32_t count) {
  return mission_.compass == nullptr
             ? count
             : mission_.compass->convert(&mission_, context_, &variation_, updates, count);
}

/// Runs after each step of the mission, before its values are logged.
void GliderRuntime::endStep() {
  convertHeadings(nullptr, 0);
  glider::runtime::tellNotes(*context_, log_, client_);
}

void GliderRuntime::startMission(uint32_t update_count) {
  context_ = gliderStart(context_memory_, &mission_, parameters_, updates_, update_count);
  log_.begin(*context_);
  persistence_.begun();
  endStep();
  log_.values(*context_);
  link_log_.refusedCommands(*context_);
}

void GliderRuntime::stepMission(double mission_time, uint32_t update_count) {
  if (finished()) {
    return;
  }
  const uint32_t from = context_->state;
  const glider::runtime::StateTimes times{context_->entered, context_->resumed};
  gliderStep(context_, mission_time, updates_, update_count);
  endStep();
  tellTransition(from, times);
  if (!finished()) {
    log_.values(*context_);
  }
  link_log_.refusedCommands(*context_);
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

/// True if there was something to command.
bool GliderRuntime::command() {
  Instruction instruction;
  const bool news =
      control_.choose(glider::runtime::instructionFor(*context_), finished(), instruction);
  if (news) {
    control_.sent(instruction, client_.instruct(instruction));
  }
  return news;
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

extern "C" uint32_t gliderRuntimeFailedCheck(const GliderRuntime* runtime) {
  return runtime->failedCheck();
}

extern "C" const GliderContext* gliderRuntimeContext(const GliderRuntime* runtime) {
  return runtime->context();
}
