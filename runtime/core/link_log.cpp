// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/link_log.h"

#include "hooks/protocol/features.h"
#include "runtime/numbers/numbers.h"

using glider::hooks::HookAnswer;

namespace glider::runtime {
namespace {

LogEvent eventOf(ControlNews::Kind kind) {
  switch (kind) {
    case ControlNews::Kind::Taken:
      return LogEvent::ControlTaken;
    case ControlNews::Kind::Refused:
      return LogEvent::InstructionRefused;
    case ControlNews::Kind::Lost:
      return LogEvent::ControlLost;
    case ControlNews::Kind::Released:
    case ControlNews::Kind::None:
      break;
  }
  return LogEvent::ControlReleased;
}

constexpr bool sameNumber(LogDetail detail, HookAnswer answer) {
  return static_cast<uint8_t>(detail) == static_cast<uint8_t>(answer);
}
// A refusal is logged with the number of its answer.
static_assert(sameNumber(LogDetail::BadCheck, HookAnswer::BadCheck));
static_assert(sameNumber(LogDetail::TooDeep, HookAnswer::TooDeep));
static_assert(sameNumber(LogDetail::BadPitch, HookAnswer::BadPitch));
static_assert(sameNumber(LogDetail::BadCommand, HookAnswer::BadCommand));
static_assert(sameNumber(LogDetail::NotOnEarth, HookAnswer::NotOnEarth));
static_assert(sameNumber(LogDetail::WrongSession, HookAnswer::WrongSession));
static_assert(sameNumber(LogDetail::NotReady, HookAnswer::NotReady));
static_assert(sameNumber(LogDetail::OldSequence, HookAnswer::OldSequence));
static_assert(sameNumber(LogDetail::BadFin, HookAnswer::BadFin));
static_assert(sameNumber(LogDetail::BadPump, HookAnswer::BadPump));
static_assert(sameNumber(LogDetail::BadBattery, HookAnswer::BadBattery));

/// Feature `bit` of the protocol, which is missing.
constexpr LogDetail featureDetail(uint8_t bit) {
  constexpr uint8_t kFirst = 32;
  return hooks::featureName(bit) != nullptr ? static_cast<LogDetail>(kFirst + bit)
                                            : LogDetail::UnknownFeature;
}
#define FEATURE(name, bit, text) static_assert(featureDetail(bit) == LogDetail::No##name);
#include "hooks/protocol/features.def"

}  // namespace

void LinkLog::news(const GliderContext& context, const ControlNews& news) {
  if (news.kind != ControlNews::Kind::None) {
    const bool refused = news.kind == ControlNews::Kind::Refused;
    log_.event(context.mission_time, eventOf(news.kind),
               refused ? static_cast<LogDetail>(news.answer) : LogDetail::None,
               static_cast<double>(news.sequence));
  }
}

void LinkLog::unanswered(const GliderContext& context, const hooks::VehicleTick& tick) {
  // The release of a mission that is over may have to wait until the vehicle is up (by the port).
  if (tick.unanswered_ticks == hooks::Client::kMostUnansweredTicks && context.finished == 0) {
    log_.event(context.mission_time, LogEvent::InstructionUnanswered, LogDetail::None,
               static_cast<double>(tick.instruction_sequence));
  }
}

void LinkLog::refusedCommands(const GliderContext& context) {
  if (context.refused_commands != told_refusals_) {
    log_.event(context.mission_time, LogEvent::UnknownCommand, LogDetail::None,
               static_cast<double>(context.refused_commands - told_refusals_));
    told_refusals_ = context.refused_commands;
  }
}

void LinkLog::damagedInput(const GliderContext& context, uint32_t sum) {
  if (sum != told_damages_ && damage_told_ticks_ == 0) {
    log_.event(context.mission_time, LogEvent::DamagedInput, LogDetail::None,
               static_cast<double>(sum - told_damages_));
    told_damages_ = sum;
    damage_told_ticks_ = kBetweenDamages;
  } else if (damage_told_ticks_ != 0) {
    --damage_told_ticks_;
  }
}

void LinkLog::refusedLink(const hooks::Refusal& refusal) {
  if (refusal.version != hooks::kProtocolVersion) {
    log_.event(0.0, LogEvent::LinkRefused, LogDetail::OtherVersion, refusal.version);
  } else if (refusal.missing_features != 0) {
    const uint8_t bit = hooks::lowestFeature(refusal.missing_features);
    log_.event(0.0, LogEvent::LinkRefused, featureDetail(bit), bit);
  } else {
    log_.event(0.0, LogEvent::LinkRefused, LogDetail::OtherDictionary,
               static_cast<double>(refusal.dictionary));
  }
  log_.flush();
}

void LinkLog::sleeps(const GliderContext& context, uint32_t seconds) {
  log_.event(context.mission_time, LogEvent::Sleeps, LogDetail::None, seconds);
}

void LinkLog::wokenLate(const GliderContext& context, double seconds) {
  log_.event(context.mission_time, LogEvent::WokenLate, LogDetail::None, seconds);
}

void LinkLog::silence(const GliderContext& context) {
  log_.event(context.mission_time, LogEvent::SilentLink, LogDetail::None, unknown());
}

}  // namespace glider::runtime
