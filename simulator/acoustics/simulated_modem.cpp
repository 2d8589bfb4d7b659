// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/acoustics/simulated_modem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace glider::simulator {
namespace {

namespace micro_modem = hooks::micro_modem;

constexpr double kBaud = 19200;
/// How long it waits for the data that it has asked for.
constexpr double kDataTimeout_s = 2;
constexpr double kDay_s = 86400;

uint32_t secondOfDay(double now_s) {
  return static_cast<uint32_t>(std::fmod(now_s, kDay_s));
}

/// "5 bytes", "a mini packet".
std::string sizeText(const AcousticFrame& frame) {
  return frame.is_mini          ? "a mini packet"
         : frame.data.size == 1 ? "1 byte"
                                : std::to_string(frame.data.size) + " bytes";
}

const char* reasonOf(Loss loss) {
  switch (loss) {
    case Loss::None:
      break;
    case Loss::Sending:
      return "the modem was sending";
    case Loss::Jammed:
      return "noise";
    case Loss::Collision:
      return "collision";
    case Loss::Faint:
      return "faint";
    case Loss::Off:
      return "the modem had no power";
  }
  return "";
}

}  // namespace

SimulatedModem::SimulatedModem(const ModemSettings& settings, std::shared_ptr<Channel> channel,
                               uint32_t vehicle)
    : settings_(settings),
      channel_(std::move(channel)),
      vehicle_(vehicle),
      line_(kBaud),
      modem_end_(line_.left()),
      host_end_(line_.right()) {}

void SimulatedModem::fromHost(std::span<const uint8_t> bytes, double now_s) {
  line_.setNow(now_s);
  (void)host_end_.write(host_end_.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
}

std::vector<uint8_t> SimulatedModem::toHost(double now_s) {
  line_.setNow(now_s);
  std::array<uint8_t, SerialLine::kCapacity> bytes;
  const int32_t count =
      host_end_.read(host_end_.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
  return {bytes.begin(), bytes.begin() + std::max(count, 0)};
}

double SimulatedModem::step(double now_s, bool powered) {
  const double before_J = drawnJ();
  line_.setNow(now_s);
  if (powered && !powered_) {
    turnOn(now_s);
  } else if (!powered && powered_) {
    turnOff();
  }
  if (powered) {
    totals_.listen_J += settings_.listen_W * (now_s - std::max(stepped_s_, on_since_s_));
    readLine(now_s);
    followTime(now_s);
  }
  receive(now_s);
  stepped_s_ = now_s;
  return drawnJ() - before_J;
}

void SimulatedModem::turnOn(double now_s) {
  powered_ = true;
  on_since_s_ = now_s;
}

void SimulatedModem::turnOff() {
  powered_ = false;
  doing_ = Doing::Listening;
  sentences_ = {};
  line_.dropLeft();
  line_.dropRight();
}

void SimulatedModem::readLine(double now_s) {
  std::array<uint8_t, SerialLine::kCapacity> bytes;
  const int32_t count =
      modem_end_.read(modem_end_.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
  for (int32_t i = 0; i < count; ++i) {
    if (sentences_.push(bytes[static_cast<size_t>(i)])) {
      answer(sentences_.text(), now_s);
    }
  }
}

void SimulatedModem::answer(const hooks::Text& body, double now_s) {
  micro_modem::SetSetting setting;
  micro_modem::StartCycle cycle;
  micro_modem::Transmit data;
  micro_modem::SendMiniPacket mini;
  if (decode(body, setting)) {
    configure(setting, now_s);
  } else if (decode(body, cycle)) {
    startCycle(cycle, now_s);
  } else if (decode(body, data)) {
    transmit(data, now_s);
  } else if (decode(body, mini)) {
    sendMini(mini, now_s);
  } else {
    refuse("NMEA", now_s);
  }
}

void SimulatedModem::configure(const micro_modem::SetSetting& setting, double now_s) {
  if (!(setting.name == hooks::textOf("SRC")) || setting.value == 0 ||
      setting.value > micro_modem::kMostAddress) {
    refuse("CFG", now_s);
    return;
  }
  address_ = setting.value;
  say(micro_modem::SettingIs{setting.name, setting.value});
}

void SimulatedModem::startCycle(const micro_modem::StartCycle& cycle, double now_s) {
  if (doing_ != Doing::Listening || address_ == 0 || cycle.source != address_ || cycle.rate != 0 ||
      cycle.acknowledge || cycle.frames != 1) {
    refuse("CYC", now_s);
    return;
  }
  cycle_ = cycle;
  doing_ = Doing::WaitingForData;
  until_s_ = now_s + kDataTimeout_s;
  say(micro_modem::CycleStarts{cycle.source, cycle.destination, cycle.rate, cycle.acknowledge,
                               cycle.frames});
  say(micro_modem::DataRequest{secondOfDay(now_s), cycle.source, cycle.destination, false,
                               settings_.frame_bytes, 1});
}

void SimulatedModem::transmit(const micro_modem::Transmit& data, double now_s) {
  if (doing_ != Doing::WaitingForData || data.source != cycle_.source ||
      data.destination != cycle_.destination || data.data.size > settings_.frame_bytes) {
    refuse("TXD", now_s);
    return;
  }
  if (data.data.size == 0) {
    doing_ = Doing::Listening;
    return;
  }
  doing_ = Doing::Sending;
  send({data.source, data.destination, data.data}, now_s);
}

void SimulatedModem::sendMini(const micro_modem::SendMiniPacket& packet, double now_s) {
  if (doing_ != Doing::Listening || address_ == 0 || packet.source != address_) {
    refuse("MUC", now_s);
    return;
  }
  say(micro_modem::MiniPacketEcho{packet.source, packet.destination, packet.bits});
  doing_ = Doing::SendingMini;
  send({packet.source, packet.destination, {}, true, packet.bits}, now_s);
}

void SimulatedModem::send(const AcousticFrame& frame, double now_s) {
  const double length_s = settings_.lengthOf(frame);
  channel_->send(vehicle_, now_s, frame, settings_);
  until_s_ = now_s + length_s;
  sent_bytes_ = frame.data.size;
  ++totals_.sent;
  totals_.on_air_s += length_s;
  totals_.sent_J += frame.is_mini ? settings_.send_mini_J : settings_.send_J;
  news_.push_back({EventId::MessageSent,
                   {sizeText(frame), frame.destination == micro_modem::kEverybody
                                         ? std::string("all")
                                         : std::to_string(frame.destination)}});
}

void SimulatedModem::followTime(double now_s) {
  if (doing_ == Doing::Listening || now_s < until_s_) {
    return;
  }
  if (doing_ == Doing::Sending) {
    say(micro_modem::TransmitEnds{sent_bytes_});
  } else if (doing_ == Doing::WaitingForData) {
    refuse("DTO", now_s);
  }
  doing_ = Doing::Listening;
}

void SimulatedModem::receive(double now_s) {
  for (Reception reception : channel_->take(vehicle_, now_s)) {
    if (!powered_ || reception.begin_s < on_since_s_) {
      reception.loss = Loss::Off;
    }
    receive(reception);
  }
}

void SimulatedModem::receive(const Reception& reception) {
  const AcousticFrame& frame = reception.frame;
  if (!reception.is_frame) {
    if (reception.loss == Loss::None) {
      say(micro_modem::CycleStarts{frame.source, frame.destination, 0, false, 1});
      totals_.received_J += settings_.receive_J;  // it listens to the frame, for any destination
    }
    return;
  }
  if (frame.destination != micro_modem::kEverybody && frame.destination != address_) {
    return;
  }
  if (reception.loss == Loss::None) {
    ++totals_.received;
    if (frame.is_mini) {
      totals_.received_J += settings_.receive_mini_J;
      say(micro_modem::MiniPacketReceived{frame.source, frame.destination, frame.mini_bits});
    } else {
      say(micro_modem::Received{frame.source, frame.destination, false, 1, frame.data});
    }
    news_.push_back(
        {EventId::MessageReceived, {sizeText(frame), static_cast<double>(frame.source)}});
    return;
  }
  ++totals_.lost;
  news_.push_back({EventId::MessageLost,
                   {static_cast<double>(frame.source), std::string(reasonOf(reception.loss))}});
  if (reception.announced && reception.loss != Loss::Sending && reception.loss != Loss::Off) {
    say(micro_modem::Damaged{1});
  }
}

void SimulatedModem::refuse(const char* why, double now_s) {
  std::string text = std::to_string(1000000 + secondOfDay(now_s) / 3600 * 10000 +
                                    secondOfDay(now_s) / 60 % 60 * 100 + secondOfDay(now_s) % 60);
  text = text.substr(1) + "," + why;
  say(micro_modem::Refusal{{text.data(), static_cast<uint32_t>(text.size())}});
}

template <typename Message>
void SimulatedModem::say(const Message& message) {
  std::array<char, micro_modem::kMostSentence> text;
  const uint32_t size = encode(message, text.data(), static_cast<uint32_t>(text.size()));
  (void)modem_end_.write(modem_end_.self, reinterpret_cast<const uint8_t*>(text.data()), size);
}

}  // namespace glider::simulator
