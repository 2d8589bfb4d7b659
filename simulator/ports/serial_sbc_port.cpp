// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ports/serial_sbc_port.h"

#include <array>
#include <thread>
#include <utility>

namespace glider::simulator {
namespace {

constexpr auto kPause = std::chrono::milliseconds(1);

}  // namespace

support::Result<std::unique_ptr<SerialSbcPort>> SerialSbcPort::open(
    const std::string& device, Pace pace, uint32_t baud, std::unique_ptr<LineTurns> turns) {
  auto port = hooks::SerialPort::open(device, baud);
  if (!port) {
    return std::unexpected(port.error());
  }
  return std::unique_ptr<SerialSbcPort>(
      new SerialSbcPort(std::move(*port), pace, std::move(turns)));
}

void SerialSbcPort::end(const char* exit_reason) {
  if (alive()) {
    exit_reason_ = exit_reason;
  }
}

double SerialSbcPort::patience() const {
  // In real time, bytes that arrive later are received in the next step of the flight.
  constexpr double kWhileItIsThere = 0.1;
  return pace_ == Pace::RealTime ? kWhileItIsThere : kHangSecs;
}

void SerialSbcPort::waitFor(double now_s) {
  const auto since_start =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(now_s));
  if (!origin_) {
    origin_ = Clock::now() - since_start;
  }
  std::this_thread::sleep_until(*origin_ + since_start);
}

void SerialSbcPort::deliver(std::span<const uint8_t> bytes, double now_s) {
  if (pace_ == Pace::RealTime) {
    waitFor(now_s);
  }
  const GliderByteStream stream = port_.stream();
  const auto start = Clock::now();
  const std::chrono::duration<double> patience(kHangSecs);
  while (alive() && plugged_ && !bytes.empty()) {
    const int32_t taken =
        stream.write(stream.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
    if (taken < 0) {
      end("the serial line is gone");
    } else if (taken > 0) {
      turns_->toSbc(bytes.data(), static_cast<uint32_t>(taken));
      bytes = bytes.subspan(static_cast<size_t>(taken));
    } else if (Clock::now() - start > patience) {
      end("the serial line accepts no data");
    } else {
      std::this_thread::sleep_for(kPause);
    }
  }
}

void SerialSbcPort::read() {
  std::array<uint8_t, 4096> bytes;
  const GliderByteStream stream = port_.stream();
  int32_t count = 0;
  while ((count = stream.read(stream.self, bytes.data(), static_cast<uint32_t>(bytes.size()))) >
         0) {
    turns_->fromSbc(bytes.data(), static_cast<uint32_t>(count));
    received_.insert(received_.end(), bytes.begin(), bytes.begin() + count);
  }
  if (count < 0) {
    end("the serial line is gone");
  }
}

std::vector<uint8_t> SerialSbcPort::collect() {
  const auto start = Clock::now();
  const std::chrono::duration<double> patience(this->patience());
  for (read(); alive() && plugged_ && !turns_->settled(); read()) {
    if (Clock::now() - start > patience) {
      if (pace_ == Pace::Lockstep) {
        end("it no longer answers");
      }
      break;
    }
    std::this_thread::sleep_for(kPause);
  }
  auto heard = std::exchange(received_, {});
  return plugged_ ? std::move(heard) : std::vector<uint8_t>();
}

}  // namespace glider::simulator
