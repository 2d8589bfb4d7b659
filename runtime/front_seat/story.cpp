// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/front_seat/story.h"

#include "hooks/protocol/decimal.h"
#include "runtime/log/format.h"

namespace glider::runtime {
namespace {

/// Puts words and numbers, separated by commas, as far as there is room.
class Words {
 public:
  explicit Words(char* text) : text_(text) {}

  Words& word(const char* word) {
    comma();
    for (; *word != '\0' && size_ < kMostStory; ++word) {
      text_[size_++] = *word;
    }
    return *this;
  }
  Words& number(double value) {
    char digits[hooks::kMostDecimal + 1];
    digits[hooks::writeDecimal(value, digits)] = '\0';
    return word(digits);
  }
  Words& whole(uint32_t value) {
    char digits[11];
    digits[formatCount(value, digits)] = '\0';
    return word(digits);
  }
  [[nodiscard]] uint32_t size() const { return size_; }

 private:
  void comma() {
    if (size_ != 0 && size_ < kMostStory) {
      text_[size_++] = ',';
    }
  }
  char* text_;
  uint32_t size_ = 0;
};

}  // namespace

uint32_t storyOf(const hooks::SeatEvent& event, char* text) {
  Words words(text);
  using Kind = hooks::SeatEvent::Kind;
  if (event.kind == Kind::SbcTransition) {
    words.word("transition").number(event.mission_time_s);
    words.whole(event.a).whole(event.b).whole(event.c).whole(event.d).whole(event.e);
  } else if (event.kind == Kind::SbcHello) {
    words.word("mission").word(event.text);
  } else if (event.kind == Kind::SbcNote) {
    words.word("note").number(event.mission_time_s).whole(event.a).word(event.text);
  }
  return words.size();
}

uint32_t stateStory(const hooks::SbcView& view, char* text) {
  const bool flies = view.known && view.phase == hooks::MissionPhase::Flying;
  return Words(text)
      .word("state")
      .whole(flies ? view.state + 1 : 0)
      .number(view.mission_time_s)
      .size();
}

}  // namespace glider::runtime
