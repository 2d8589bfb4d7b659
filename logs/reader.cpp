// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "logs/reader.h"

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/frame.h"
#include "hooks/protocol/notices.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/log/check_text.h"

#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace glider::logs {

using hooks::ByteReader;
using runtime::LogNamed;
using runtime::LogRecord;

namespace {

/// What an event is called, and its value as people read it.
struct EventWords {
  std::string name, value;
};

EventWords wordsOf(uint8_t event) {
  switch (event) {
#define LOG_EVENT(name, number, text, value) \
  case number:                               \
    return {text, value};
#include "runtime/log/records.def"
    default:
      return {"event " + std::to_string(event), "{}"};
  }
}

std::string detailText(uint8_t number) {
  switch (number) {
#define LOG_DETAIL(name, value, text) \
  case value:                         \
    return text;
#include "runtime/log/records.def"
    default:
      break;
  }
  const char* check = runtime::checkText(number);
  return check != nullptr ? check : "detail " + std::to_string(number);
}

std::string transitionText(uint8_t transition, bool always) {
  const char* word = hooks::transitionWord(transition);
  const std::string name = word != nullptr ? word : "?";
  return always ? "always " + name : name;
}

class Reader {
 public:
  explicit Reader(const std::function<void(const LogEntry&)>& take) : take_(take) {}

  LogDamage run(std::string_view bytes) {
    for (const char byte : bytes) {
      if (decoder_.push(static_cast<uint8_t>(byte))) {
        frame(decoder_.frame());
      }
    }
    // Bytes after the last zero, if any, are an incomplete record.
    const bool torn = !bytes.empty() && bytes.back() != '\0';
    damage_.bad = decoder_.badFrames() + (torn ? 1 : 0);
    return damage_;
  }

 private:
  void frame(const hooks::Frame& frame) {
    if (frame.type != hooks::MessageType::Log) {
      ++damage_.unreadable;
      return;
    }
    ByteReader in(frame.payload, frame.size);
    entry_ = {};
    entry_.kind = static_cast<LogRecord>(in.u8());
    countMissing(frame.sequence);
    const bool known = entry_.kind == LogRecord::Start || version_ == runtime::kLogVersion;
    const bool good = known && read(in, frame) && in.good();
    good ? ++damage_.records : ++damage_.unreadable;
    if (good && entry_.kind != LogRecord::Name) {
      take_(entry_);
    }
  }

  void countMissing(uint8_t sequence) {
    if (entry_.kind != LogRecord::Start && sequence_) {
      damage_.missing += static_cast<uint8_t>(sequence - *sequence_ - 1);
    }
    sequence_ = sequence;
  }

  bool read(ByteReader& in, const hooks::Frame& frame) {
    switch (entry_.kind) {
      case LogRecord::Start:
        ++damage_.starts;
        names_.clear();
        version_ = in.u8();
        entry_.name = text(frame, 2);
        return version_ == runtime::kLogVersion;
      case LogRecord::Name:
        return name(in, frame);
      case LogRecord::Begin:
        return numbers(in, (frame.size - 1U) / 8, LogNamed::Parameter);
      case LogRecord::Values:
        return items(in, frame);
      case LogRecord::Transition:
        return transition(in, frame);
      case LogRecord::Note:
        return note(in, frame);
      case LogRecord::Event:
        entry_.time = in.f64();
        event(in.u8());
        entry_.detail = detailText(in.u8());
        entry_.value = in.f64();
        return in.exact();
    }
    return false;
  }

  void event(uint8_t number) {
    EventWords words = wordsOf(number);
    entry_.name = std::move(words.name);
    entry_.value_words = std::move(words.value);
  }

  bool name(ByteReader& in, const hooks::Frame& frame) {
    const uint8_t what = in.u8();
    const uint32_t number = in.u16();
    const uint32_t item = in.u16();
    names_[{what, number, item}] = text(frame, 6);
    return in.good();
  }

  bool items(ByteReader& in, const hooks::Frame& frame) {
    entry_.time = in.f64();
    const uint32_t state = in.u16();
    for (uint32_t at = 11; at + 9 <= frame.size; at += 9) {
      const uint32_t item = in.u8();
      entry_.values.emplace_back(nameOf(LogNamed::Item, state, item), in.f64());
    }
    return in.exact();
  }

  bool transition(ByteReader& in, const hooks::Frame& frame) {
    entry_.time = in.f64();
    entry_.values.emplace_back("statetime", in.f64());
    entry_.values.emplace_back("resumetime", in.f64());
    const uint8_t transition = in.u8();
    entry_.name = transitionText(transition, in.u8() == kGliderListAlways);
    entry_.number = in.u16() + 1U;
    entry_.detail = nameOf(LogNamed::State, in.u16(), 0);
    const uint32_t to = in.u16();
    entry_.to = transition == kGliderExit ? "" : nameOf(LogNamed::State, to, 0);
    return in.good() && numbers(in, (frame.size - 33U) / 8, LogNamed::Sensor);
  }

  bool note(ByteReader& in, const hooks::Frame& frame) {
    entry_.time = in.f64();
    entry_.unknown_set = in.u8() == kGliderNoteUnknownSet;
    const uint32_t count = in.u8();
    for (uint32_t i = 0; i < count && in.good(); ++i) {
      entry_.values.emplace_back("", in.f64());
    }
    entry_.name = text(frame, 11 + 8 * count);
    return in.good();
  }

  bool numbers(ByteReader& in, uint32_t count, LogNamed what) {
    for (uint32_t i = 0; i < count; ++i) {
      entry_.values.emplace_back(nameOf(what, i, 0), in.f64());
    }
    return in.exact();
  }

  /// The text in the payload from `from` on.
  static std::string text(const hooks::Frame& frame, uint32_t from) {
    return from < frame.size ? std::string(frame.payload + from, frame.payload + frame.size) : "";
  }

  [[nodiscard]] std::string nameOf(LogNamed what, uint32_t number, uint32_t item) const {
    const auto found = names_.find({static_cast<uint8_t>(what), number, item});
    return found != names_.end() ? found->second
                                 : "?" + std::to_string(what == LogNamed::Item ? item : number);
  }

  const std::function<void(const LogEntry&)>& take_;
  hooks::FrameDecoder decoder_;
  LogDamage damage_;
  LogEntry entry_;
  uint8_t version_ = 0;
  std::optional<uint8_t> sequence_;
  std::map<std::tuple<uint8_t, uint32_t, uint32_t>, std::string> names_;
};

}  // namespace

LogDamage readLog(std::string_view bytes, const std::function<void(const LogEntry&)>& take) {
  return Reader(take).run(bytes);
}

}  // namespace glider::logs
