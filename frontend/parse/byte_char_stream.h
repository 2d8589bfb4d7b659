// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <antlr4-runtime.h>

#include <string>
#include <string_view>

namespace glider::frontend {

/// A text for ANTLR's lexer, with one symbol for each byte, so that a token's place is a byte
/// offset in the source file.
class ByteCharStream final : public antlr4::CharStream {
 public:
  /// `text` must outlive the stream; reading begins at byte `start`.
  ByteCharStream(std::string_view text, size_t start) : text_(text), at_(start) {}

  void consume() override { ++at_; }
  size_t LA(ssize_t i) override {
    const size_t index = i > 0 ? at_ + static_cast<size_t>(i) - 1 : at_ - static_cast<size_t>(-i);
    return index < text_.size() ? static_cast<unsigned char>(text_[index]) : EOF;
  }
  ssize_t mark() override { return -1; }
  void release(ssize_t) override {}
  size_t index() override { return at_; }
  void seek(size_t index) override { at_ = index; }
  size_t size() override { return text_.size(); }
  std::string getSourceName() const override { return "mission"; }
  std::string getText(const antlr4::misc::Interval& interval) override {
    return std::string(text_.substr(static_cast<size_t>(interval.a),
                                    static_cast<size_t>(interval.b - interval.a + 1)));
  }
  std::string toString() const override { return std::string(text_); }

 private:
  std::string_view text_;
  size_t at_;
};

}  // namespace glider::frontend
