// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "slocum/data_files/records.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace glider::slocum {
namespace {

constexpr char kRecord = 'd';
constexpr char kEnd = 'X';

/// The number of type `Float` whose bytes begin at `bytes`, read as the integer `Bits`.
template <typename Float, typename Bits>
double number(const char* bytes, bool swap) {
  Bits bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return static_cast<double>(std::bit_cast<Float>(swap ? std::byteswap(bits) : bits));
}

/// Decodes records one by one. A record is checked before its first value is taken, so a damaged
/// one leaves nothing behind.
class RecordDecoder {
 public:
  RecordDecoder(std::string_view content, size_t begin, DataFile& file)
      : content_(content), position_(begin), file_(file) {
    const auto native =
        std::endian::native == std::endian::big ? ByteOrder::Big : ByteOrder::Little;
    swap_ = file.order != native;
    for (const Column& column : file.columns) {
      largest_ += column.sensor.width;
    }
    const auto unused =
        static_cast<unsigned>(2U * (4U * file.header.state_bytes - file.columns.size()));
    padding_ = static_cast<uint8_t>((1U << unused) - 1U);
  }

  /// Decodes the record at the current position. False at the end and at damage.
  bool next() {
    if (position_ == content_.size()) {
      return false;
    }
    if (content_[position_] != kRecord) {
      file_.end_mark = content_[position_] == kEnd;
      return file_.end_mark ? false
                            : damaged(fmt::format("expected a record, found byte 0x{:02x}",
                                                  static_cast<uint8_t>(content_[position_])));
    }
    const size_t room = content_.size() - position_ - 1;
    if (room < file_.header.state_bytes) {
      return damaged(kCut);
    }
    const auto* states = reinterpret_cast<const uint8_t*>(content_.data() + position_ + 1);
    if (hasReserved(states)) {
      return damaged("a record has a state that the format does not have");
    }
    const size_t values = room - file_.header.state_bytes;
    if (values < largest_ && values < sizeOfValues(states)) {
      return damaged(kCut);
    }
    take(states);
    return true;
  }

 private:
  static constexpr const char* kCut = "the file ends within a record";

  bool damaged(std::string what) {
    file_.damage.push_back({position_, std::move(what)});
    return false;
  }

  /// The states of the 32 sensors from byte `at` on, the first in the top bits; those after the
  /// last are 0.
  [[nodiscard]] uint64_t statesAt(const uint8_t* states, size_t at) const {
    uint64_t word = 0;
    if (at + sizeof word <= file_.header.state_bytes) {
      std::memcpy(&word, states + at, sizeof word);
    } else {
      std::memcpy(&word, states + at, file_.header.state_bytes - at);
    }
    return std::endian::native == std::endian::little ? std::byteswap(word) : word;
  }

  /// True if two bits are both set: no sensor has such a state; or one of the padding is.
  [[nodiscard]] bool hasReserved(const uint8_t* states) const {
    uint64_t reserved = states[file_.header.state_bytes - 1] & padding_;
    for (size_t at = 0; at < file_.header.state_bytes; at += sizeof reserved) {
      const uint64_t word = statesAt(states, at);
      reserved |= word & word >> 1U & 0x5555555555555555U;
    }
    return reserved != 0;
  }

  /// Calls `take(column)` for each sensor with a new value, in order.
  template <typename Take>
  void forEachNew(const uint8_t* states, Take take) const {
    for (size_t at = 0; at < file_.header.state_bytes; at += sizeof(uint64_t)) {
      uint64_t fresh = statesAt(states, at) & 0xAAAAAAAAAAAAAAAAU;
      while (fresh != 0) {
        const auto zeros = static_cast<unsigned>(std::countl_zero(fresh));
        take(4 * at + zeros / 2);
        fresh &= ~(uint64_t{1} << 63U >> zeros);
      }
    }
  }

  [[nodiscard]] size_t sizeOfValues(const uint8_t* states) const {
    size_t size = 0;
    forEachNew(states, [&](size_t column) { size += file_.columns[column].sensor.width; });
    return size;
  }

  void take(const uint8_t* states) {
    const char* bytes = content_.data() + position_ + 1 + file_.header.state_bytes;
    forEachNew(states, [&](size_t index) {
      Column& column = file_.columns[index];
      column.values.push_back(value(bytes, column.sensor.width));
      bytes += column.sensor.width;
    });
    file_.states.insert(file_.states.end(), states, states + file_.header.state_bytes);
    ++file_.records;
    position_ = static_cast<size_t>(bytes - content_.data());
  }

  [[nodiscard]] double value(const char* bytes, uint8_t width) const {
    switch (width) {
      case 1:
        return number<int8_t, uint8_t>(bytes, false);
      case 2:
        return number<int16_t, uint16_t>(bytes, swap_);
      case 4:
        return number<float, uint32_t>(bytes, swap_);
      default:
        return number<double, uint64_t>(bytes, swap_);
    }
  }

  std::string_view content_;
  size_t position_;
  DataFile& file_;
  bool swap_ = false;
  size_t largest_ = 0;  ///< bytes of the values of a record that has all sensors
  uint8_t padding_ = 0;
};

}  // namespace

void decodeRecords(std::string_view content, size_t begin, DataFile& file) {
  RecordDecoder decoder(content, begin, file);
  while (decoder.next()) {
  }
}

bool DataFile::beginsWithInitialValues() const {
  for (size_t column = 0; records > 0 && column < columns.size(); ++column) {
    if (update(0, column) != Update::New) {
      return false;
    }
  }
  return records > 0;
}

}  // namespace glider::slocum
