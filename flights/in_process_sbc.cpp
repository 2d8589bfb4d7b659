// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/in_process_sbc.h"

#include "hooks/protocol/crc.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/core/lay_out.h"
#include "runtime/log/check_text.h"
#include "simulator/faults/card_damage.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>

namespace glider::flights {
namespace {

/// As a board's program ends after a failed check; its standard error has the number.
std::string exitReasonOf(uint32_t failed_check) {
  const char* text = runtime::checkText(failed_check);
  return "exited with status 3: internal check failed: " +
         (text != nullptr ? std::string(text) : std::to_string(failed_check));
}

/// Bit for bit: an unknown value is not equal to itself.
bool isSame(const support::LoggedNote& one, const support::LoggedNote& other) {
  const auto sameBits = [](double a, double b) {
    return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
  };
  return one.mission_time_s == other.mission_time_s && one.text == other.text &&
         std::ranges::equal(one.values, other.values, sameBits);
}

}  // namespace

InProcessSbc::InProcessSbc(std::shared_ptr<const codegen::LoadedMission> mission,
                           std::vector<double> parameters, std::shared_ptr<Card> card,
                           bool keeps_time, const std::optional<PortEnd>& port)
    : mission_(std::move(mission)),
      parameters_(std::move(parameters)),
      card_(std::move(card)),
      turns_(port ? port->turns() : simulator::hookTurns()),
      keeps_time_(keeps_time) {
  // operator new aligns for every fundamental type, which is what the runtime asks for.
  runtime_memory_ = std::make_unique<std::byte[]>(mission_->runtimeSize());
  context_memory_ = std::make_unique<std::byte[]>(mission_->mission().context_bytes);
  const GliderStore store{this, readCard, writeCard, [](void*) { return 0; }};
  kept_ = findKept();
  const GliderRuntimeOptions options{{}, parameters_.data(), store, 0};
  if (port) {
    seat_ = makeSeat(port->mission, mission_->mission(),
                     GliderByteStream{this, readBytes, writeBytes}, kept_ ? &kept_link_ : nullptr);
  }
  runtime_ = mission_->init(runtime_memory_.get(), context_memory_.get(), &options);
}

/// As the runtime looks for it: other parameters make another program.
std::optional<double> InProcessSbc::findKept() {
  const GliderMission& mission = mission_->mission();
  const GliderStore store{this, readCard, writeCard, [](void*) { return 0; }};
  const auto* bytes = reinterpret_cast<const uint8_t*>(parameters_.data());
  const uint32_t count = mission.parameter_count * sizeof(double);
  GliderContext* context = runtime::layOut(context_memory_.get(), mission);
  const bool found =
      runtime::Checkpoint(store, hooks::crc32c(bytes, count, 0)).find(*context, kept_link_) ==
      runtime::Checkpoint::Found::Good;
  return found ? std::optional(context->mission_time) : std::nullopt;
}

int32_t InProcessSbc::readBytes(void* self, uint8_t* bytes, uint32_t capacity) {
  auto& sbc = *static_cast<InProcessSbc*>(self);
  if (!sbc.plugged_) {
    return -1;
  }
  const size_t count = std::min<size_t>(capacity, sbc.to_sbc_.size() - sbc.taken_);
  if (count > 0) {
    std::memcpy(bytes, sbc.to_sbc_.data() + sbc.taken_, count);
  }
  sbc.taken_ += count;
  return static_cast<int32_t>(count);
}

int32_t InProcessSbc::writeBytes(void* self, const uint8_t* bytes, uint32_t count) {
  auto& sbc = *static_cast<InProcessSbc*>(self);
  if (!sbc.plugged_) {
    return -1;
  }
  sbc.from_sbc_.insert(sbc.from_sbc_.end(), bytes, bytes + count);
  return static_cast<int32_t>(count);
}

/// The card stores slot after slot, without the gaps between them.
size_t InProcessSbc::onCard(uint32_t offset) const {
  using runtime::Checkpoint;
  const uint32_t context = mission_->mission().context_bytes;
  const uint32_t stride = Checkpoint::offsetOf(1, context);
  return size_t{offset / stride} * Checkpoint::slotBytes(context) + offset % stride;
}

int32_t InProcessSbc::readCard(void* self, uint32_t offset, uint8_t* bytes, uint32_t count) {
  const auto& sbc = *static_cast<InProcessSbc*>(self);
  const Card& card = *sbc.card_;
  const size_t from = std::min(sbc.onCard(offset), card.size());
  const size_t taken = std::min<size_t>(count, card.size() - from);
  std::copy_n(card.begin() + static_cast<ptrdiff_t>(from), taken, bytes);
  return static_cast<int32_t>(taken);
}

int32_t InProcessSbc::writeCard(void* self, uint32_t offset, const uint8_t* bytes, uint32_t count) {
  const auto& sbc = *static_cast<InProcessSbc*>(self);
  Card& card = *sbc.card_;
  const size_t from = sbc.onCard(offset);
  card.resize(std::max<size_t>(card.size(), from + count));
  std::copy_n(bytes, count, card.begin() + static_cast<ptrdiff_t>(from));
  return static_cast<int32_t>(count);
}

void InProcessSbc::talk(const Turn& turn) {
  if (const GliderTalk* talk = mission_->talk()) {
    talker_.emplace(*talk, turn.address, turn.vehicles);
  }
}

int32_t InProcessSbc::readModem(void* self, uint8_t* bytes, uint32_t capacity) {
  std::vector<uint8_t>& there = static_cast<InProcessSbc*>(self)->from_modem_;
  const auto count = static_cast<ptrdiff_t>(std::min<size_t>(capacity, there.size()));
  std::copy_n(there.begin(), count, bytes);
  there.erase(there.begin(), there.begin() + count);
  return static_cast<int32_t>(count);
}

int32_t InProcessSbc::writeModem(void* self, const uint8_t* bytes, uint32_t count) {
  std::vector<uint8_t>& out = static_cast<InProcessSbc*>(self)->to_modem_;
  out.insert(out.end(), bytes, bytes + count);
  return static_cast<int32_t>(count);
}

void InProcessSbc::hearModem(std::span<const uint8_t> bytes) {
  from_modem_.insert(from_modem_.end(), bytes.begin(), bytes.end());
}

void InProcessSbc::hearValue(uint16_t id, double raw) {
  const GliderMission& mission = mission_->mission();
  if (mission_->context(runtime_) == nullptr) {
    return;
  }
  auto* context = reinterpret_cast<GliderContext*>(context_memory_.get());
  for (uint32_t i = 0; i < mission.sensor_count; ++i) {
    if (mission.sensors[i].id == id) {
      context->readings[i].raw = raw;
      context->readings[i].waiting = 1;
    }
  }
}

/// As the program on a board does about once a second.
std::vector<uint8_t> InProcessSbc::toModem() {
  if (talker_ && alive() && !finished_) {
    const bool begun = mission_->context(runtime_) != nullptr;
    auto* context = reinterpret_cast<GliderContext*>(context_memory_.get());
    talker_->poll({this, readModem, writeModem}, begun ? context : nullptr, vehicle_now_s_);
  }
  return std::exchange(to_modem_, {});
}

void InProcessSbc::damageCard(const simulator::CardFault& fault, uint64_t seed) {
  simulator::damageCard(fault, seed, *card_);
}

double InProcessSbc::now(void* self) {
  return static_cast<InProcessSbc*>(self)->now_s_;
}

void InProcessSbc::deliver(std::span<const uint8_t> bytes, double now_s) {
  now_s_ = now_s;
  if (alive()) {
    turns_->toSbc(bytes.data(), static_cast<uint32_t>(bytes.size()));
    to_sbc_.insert(to_sbc_.end(), bytes.begin(), bytes.end());
  }
}

void InProcessSbc::end(const std::string& exit_reason) {
  if (alive()) {
    exit_reason_ = exit_reason;
  }
}

void InProcessSbc::showToWatcher() const {
  const GliderContext* context = watcher_ ? mission_->context(runtime_) : nullptr;
  if (context != nullptr) {
    watcher_(*context, vehicle_now_s_);
  }
}

/// The context has the notes of its newest tick until the next one. Two ticks may have the same
/// mission time; if they have the same notes too, they are kept once.
void InProcessSbc::keepNotes() {
  const GliderContext* const context = mission_->context(runtime_);
  if (context == nullptr) {
    return;
  }
  std::vector<support::LoggedNote> found;
  for (uint32_t i = 0; i < context->note_count; ++i) {
    const GliderNote& note = context->notes[i];
    const double* const values = context->note_values + note.first;
    found.push_back({context->mission_time, note.text, {values, values + note.count}});
  }
  if (!std::ranges::equal(found, newest_notes_, isSame)) {
    std::ranges::copy(found, std::back_inserter(notes_));
    newest_notes_ = std::move(found);
  }
}

void InProcessSbc::run() {
  // A poll handles a frame of what was delivered, or one of the few time-outs that may be due.
  constexpr int kMostPolls = 10000;
  const GliderByteStream stream =
      seat_.holder ? seat_.stream : GliderByteStream{this, readBytes, writeBytes};
  const GliderClock clock{this, now};
  for (int i = 0; i < kMostPolls && alive() && !finished_; ++i) {
    const GliderRuntimeStatus status = mission_->poll(runtime_, stream, clock);
    showToWatcher();
    keepNotes();
    switch (status) {
      case kGliderRuntimeIdle:
        return;
      case kGliderRuntimeProgressed:
        break;
      case kGliderRuntimeFinished:
        finished_ = !seat_.may_end || seat_.may_end();
        break;
      case kGliderRuntimeLinkClosed:
        end("exited with status 2");
        return;
      case kGliderRuntimeFailed:
        end(exitReasonOf(mission_->failedCheck(runtime_)));
        return;
    }
  }
  if (!finished_) {
    end("hung");
  }
}

std::vector<uint8_t> InProcessSbc::collect() {
  run();
  turns_->fromSbc(from_sbc_.data(), static_cast<uint32_t>(from_sbc_.size()));
  // Ends as the program on a board does; the vehicle notices when it does not answer any more.
  if (finished_ && !turns_->settled()) {
    end("exited with status 0");
  }
  to_sbc_.erase(to_sbc_.begin(), to_sbc_.begin() + static_cast<ptrdiff_t>(taken_));
  taken_ = 0;
  return std::exchange(from_sbc_, {});
}

}  // namespace glider::flights
