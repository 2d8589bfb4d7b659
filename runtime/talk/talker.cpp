// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/talk/talker.h"

#include "hooks/share/message.h"

namespace glider::runtime::talk {
namespace {

using namespace hooks::micro_modem;
using hooks::share::MessageReader;
using hooks::share::MessageWriter;
using hooks::share::Scale;

/// The setting that is the modem's own address.
constexpr char kAddressSetting[] = "SRC";
constexpr double kMillisecond = 1e-3;  ///< s

Scale scaleOf(const GliderShare& share) {
  return {share.lowest, share.step, share.values};
}

uint8_t signatureOf(const GliderMessage& message) {
  return static_cast<uint8_t>(message.signature);
}

double valueOf(const GliderShare& share, const GliderContext& context) {
  return share.reading != GLIDER_NO_PLACE ? context.readings[share.reading].value
                                          : context.variables[share.variable];
}

}  // namespace

void Talker::poll(const GliderByteStream& modem, GliderContext* context, double clock_s) {
  if (closed_ || !isAddress(address_, vehicles_)) {
    return;
  }
  clock_.look(context, clock_s);
  if (context != nullptr) {
    forget(*context);
  }
  read(modem, context);
  if (step_ != Step::Idle && clock_.now() - since_ > kPatienceSecs) {
    giveUp();
  }
  if (!has_address_) {
    askForAddress();
  } else if (step_ == Step::Idle && context != nullptr && context->finished == 0) {
    begin(*context);
  }
  flush(modem);
  if (step_ == Step::SendsMini && !hasRoom() && clock_.now() - since_ >= kLongestDialogueSecs) {
    giveUp();  // later, it would be in the slot of another vehicle
  }
}

/// Takes some of what is there. The rest waits, so that a modem that never stops cannot hold up the
/// mission.
void Talker::read(const GliderByteStream& modem, GliderContext* context) {
  constexpr uint32_t kAtOnce = 64;
  uint8_t bytes[kAtOnce];
  for (uint32_t total = 0; total < kMostBytesPerPoll;) {
    const int32_t count = modem.read(modem.self, bytes, kAtOnce);
    if (count <= 0) {
      closed_ = count < 0;
      return;
    }
    for (int32_t i = 0; i < count; ++i) {
      if (reader_.push(bytes[i])) {
        take(reader_.text(), context);
      }
    }
    total += static_cast<uint32_t>(count);
  }
}

void Talker::flush(const GliderByteStream& modem) {
  if (hasRoom() || closed_) {
    return;
  }
  const auto* rest = reinterpret_cast<const uint8_t*>(out_) + out_taken_;
  const int32_t taken = modem.write(modem.self, rest, out_size_ - out_taken_);
  closed_ = taken < 0;
  out_taken_ += taken > 0 ? static_cast<uint32_t>(taken) : 0;
  if (out_taken_ >= out_size_) {
    out_size_ = out_taken_ = 0;
  }
}

/// False while the modem has not taken the one before.
template <typename Sentence>
bool Talker::say(const Sentence& sentence) {
  if (!hasRoom()) {
    return false;
  }
  out_size_ = encode(sentence, out_, sizeof out_);
  return out_size_ != 0;
}

void Talker::take(const hooks::Text& sentence, GliderContext* context) {
  if (DataRequest request; decode(sentence, request)) {
    takeRequest(request, context);
  } else if (Received frame; decode(sentence, frame)) {
    takeFrame(frame, context);
  } else if (MiniPacketReceived mini; decode(sentence, mini)) {
    takeMini(mini, context);
  } else if (MiniPacketEcho echo; decode(sentence, echo)) {
    takeEcho(echo);
  } else if (SettingIs setting; decode(sentence, setting)) {
    takeSetting(setting);
  } else if (TransmitEnds ends; decode(sentence, ends)) {
    counts_.sent += step_ == Step::Sends ? 1 : 0;
    step_ = step_ == Step::Sends ? Step::Idle : step_;
  } else if (Damaged damaged; decode(sentence, damaged)) {
    ++counts_.damaged;
  } else if (Refusal refusal; decode(sentence, refusal)) {
    if (step_ != Step::Idle) {
      giveUp();
    }
  }
}

void Talker::takeSetting(const SettingIs& setting) {
  if (setting.name == hooks::textOf(kAddressSetting)) {
    has_address_ = setting.value == address_;
  }
}

/// No data is the answer to a request for which there was no cycle of ours: the modem then asks for
/// nothing more.
void Talker::takeRequest(const DataRequest& request, const GliderContext* context) {
  if (request.source != address_) {
    return;
  }
  Transmit answer;
  answer.source = address_;
  answer.destination = request.destination;
  answer.acknowledge = request.acknowledge;
  const bool wanted = step_ == Step::Begins && context != nullptr &&
                      clock_.now() - since_ <= kLongestDialogueSecs &&
                      request.bytes >= talk_.messages[message_].bytes;
  if (wanted) {
    const GliderMessage& message = talk_.messages[message_];
    MessageWriter writer;
    pack(message, *context, writer);
    answer.data.size = message.bytes;
    if (!writer.end(signatureOf(message), answer.data.bytes, answer.data.size)) {
      answer.data.size = 0;  // never: the compiler has counted them
    }
  }
  if (say(answer) && wanted) {
    step_ = Step::Sends;
    wasGiven();
  }
}

void Talker::takeEcho(const MiniPacketEcho& echo) {
  if (step_ == Step::SendsMini && echo.source == address_ && echo.bits == mini_bits_) {
    ++counts_.sent;
    wasGiven();
    step_ = Step::Idle;
  }
}

/// The modem has the message.
void Talker::wasGiven() {
  since_ = sent_[message_] = clock_.now();
  was_sent_[message_] = true;
}

void Talker::pack(const GliderMessage& message, const GliderContext& context,
                  MessageWriter& writer) const {
  for (uint32_t i = message.count; i != 0; --i) {
    const GliderShare& share = talk_.shares[message.first + i - 1];
    writer.put(scaleOf(share), valueOf(share, context));
  }
}

void Talker::takeFrame(const Received& frame, GliderContext* context) {
  receive(frame, MessageReader(frame.data.bytes, frame.data.size), context,
          [](const GliderMessage& message, const MessageReader& reader) {
            return message.bytes != GLIDER_MINI_PACKET &&
                   reader.end(signatureOf(message), message.bytes);
          });
}

void Talker::takeMini(const MiniPacketReceived& packet, GliderContext* context) {
  receive(packet, MessageReader(packet.bits), context,
          [](const GliderMessage& message, const MessageReader& reader) {
            return message.bytes == GLIDER_MINI_PACKET && reader.endMini(signatureOf(message));
          });
}

/// Keeps what `packet` carries as the message that `isIt`, asked of a reader behind the message's
/// values, says it is.
template <typename Packet, typename IsIt>
void Talker::receive(const Packet& packet, const MessageReader& data, GliderContext* context,
                     IsIt isIt) {
  if (packet.destination != kEverybody && packet.destination != address_) {
    return;
  }
  // What has our own address is not ours: a modem does not receive what it sends.
  const bool others = packet.source != address_ && packet.source != 0;
  for (uint32_t i = 0; others && i < talk_.message_count; ++i) {
    const GliderMessage& message = talk_.messages[i];
    MessageReader reader = data;
    skip(message, reader);
    if (isIt(message, reader)) {
      keep(message, data, packet.source, context);
      return;
    }
  }
  ++counts_.refused;
}

void Talker::skip(const GliderMessage& message, MessageReader& reader) const {
  for (uint32_t i = 0; i < message.count; ++i) {
    (void)reader.take(scaleOf(talk_.shares[message.first + i]));
  }
}

/// For the vehicle's next frame. A value that the sender did not know changes nothing.
void Talker::keep(const GliderMessage& message, MessageReader reader, uint32_t source,
                  GliderContext* context) {
  ++counts_.received;
  if (context == nullptr) {
    return;
  }
  for (uint32_t share = message.first; share < message.first + message.count; ++share) {
    const double value = reader.take(scaleOf(talk_.shares[share]));
    if (value != value) {
      continue;
    }
    if (talk_.shares[share].peer != GLIDER_NO_PLACE) {
      wait(context->readings[talk_.shares[share].peer], value, received_[share]);
    }
    for (uint32_t i = 0; i < talk_.named_count; ++i) {
      const GliderNamed& named = talk_.named[i];
      if (named.share == share && named.source == source) {
        wait(context->readings[named.reading], value, named_received_[i]);
      }
    }
  }
}

void Talker::wait(GliderReading& reading, double value, double& received) {
  reading.raw = value;
  reading.waiting = 1;
  received = clock_.now();
}

/// Drops what has waited for a frame of the vehicle for so long that its age would be wrong.
void Talker::forget(GliderContext& context) const {
  for (uint32_t i = 0; i < talk_.share_count; ++i) {
    const uint32_t peer = talk_.shares[i].peer;
    if (peer != GLIDER_NO_PLACE && clock_.now() - received_[i] > kLongestWaitSecs) {
      context.readings[peer].waiting = 0;
    }
  }
  for (uint32_t i = 0; i < talk_.named_count; ++i) {
    if (clock_.now() - named_received_[i] > kLongestWaitSecs) {
      context.readings[talk_.named[i].reading].waiting = 0;
    }
  }
}

void Talker::askForAddress() {
  if (clock_.now() - asked_ < kAskAgainSecs) {
    return;
  }
  SetSetting setting;
  setting.name = hooks::textOf(kAddressSetting);
  setting.value = address_;
  if (say(setting)) {
    asked_ = clock_.now();
  }
}

/// Starts a cycle, or sends a mini packet, if this is the beginning of a slot of this vehicle and a
/// message is due.
void Talker::begin(const GliderContext& context) {
  uint64_t slot = 0;
  double passed_s = 0;
  if (!clock_.slot(&slot, &passed_s) || slot % vehicles_ != address_ - 1 || slot == slot_ ||
      passed_s > talk_.begin_within_ms * kMillisecond) {
    return;
  }
  const uint32_t message = mostOverdue();
  if (message == talk_.message_count) {
    return;
  }
  StartCycle cycle;
  cycle.source = address_;
  const bool mini = talk_.messages[message].bytes == GLIDER_MINI_PACKET;
  if (!(mini ? beginMini(talk_.messages[message], context) : say(cycle))) {
    return;
  }
  slot_ = slot;
  message_ = message;
  step_ = mini ? Step::SendsMini : Step::Begins;
  since_ = clock_.now();
}

bool Talker::beginMini(const GliderMessage& message, const GliderContext& context) {
  MessageWriter writer;
  pack(message, context, writer);
  SendMiniPacket packet;
  packet.source = address_;
  const bool fits = writer.endMini(signatureOf(message), packet.bits);
  mini_bits_ = packet.bits;
  return fits && say(packet);
}

/// The number of the message that should have been sent for the longest time; one that was never
/// sent comes first. message_count: none is due.
uint32_t Talker::mostOverdue() const {
  uint32_t found = talk_.message_count;
  double most = 0;
  for (uint32_t i = 0; i < talk_.message_count; ++i) {
    if (!was_sent_[i]) {
      return i;
    }
    const double overdue = clock_.now() - sent_[i] - talk_.messages[i].period;
    if (overdue >= most && (overdue > most || found == talk_.message_count)) {
      found = i;
      most = overdue;
    }
  }
  return found;
}

/// The modem may have started again, and have lost its address.
void Talker::giveUp() {
  ++counts_.unanswered;
  out_size_ = out_taken_ = 0;  // what the modem has not taken would begin a cycle in another slot
  step_ = Step::Idle;
  has_address_ = false;
}

}  // namespace glider::runtime::talk
