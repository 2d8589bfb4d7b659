// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_files/records.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

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

// So many records in a row are not there by chance; fewer where the file then ends as it should.
constexpr int kRecordsInARow = 8, kRecordsToTheEnd = 5;
// A file with more damage is not worth reading on.
constexpr size_t kMostBadRecords = 50;
// Clocks of records that follow each other do not differ by more, s.
constexpr double kFurthestTime = 1e7;

/// The column of the computer's clock; as many as there are columns if there is none.
size_t clockOf(const DataFile& file) {
  const auto isClock = [](const Column& column) {
    return column.sensor.width == 8 && (isSameName(column.sensor.name, "m_present_time") ||
                                        isSameName(column.sensor.name, "sci_m_present_time"));
  };
  return static_cast<size_t>(std::ranges::find_if(file.columns, isClock) - file.columns.begin());
}

/// Decodes records one by one. A record is checked before its first value is taken, so a damaged
/// one leaves nothing behind.
class RecordDecoder {
 public:
  explicit RecordDecoder(DataFile& file) : file_(file), clock_(clockOf(file)) {
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

  /// Decodes the records of `content` from byte `begin` on. `after_hole`: content is missing in
  /// front of it; `hole_after`: behind it.
  void decode(std::string_view content, size_t begin, bool after_hole, bool hole_after) {
    content_ = content;
    position_ = begin;
    hole_after_ = hole_after;
    in_a_row_ = 0;
    if (file_.end_mark || file_.damage.size() >= kMostBadRecords) {
      return;
    }
    if (after_hole) {
      const size_t found = nextRecords(begin);
      if (found == content_.size()) {
        return;
      }
      goOn(found);
    }
    while (next() || readsOn()) {
    }
  }

 private:
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

  static constexpr const char* kCut = "the file ends within a record";

  bool damaged(std::string what) {
    if (!hole_after_ || what != kCut) {  // else it is known why
      file_.damage.push_back({position_, std::move(what)});
      is_damaged_ = true;
    }
    return false;
  }

  /// After damage: goes on where records begin again. What was read before it may be damaged too.
  bool readsOn() {
    if (!std::exchange(is_damaged_, false) || file_.damage.size() >= kMostBadRecords) {
      return false;
    }
    const size_t found = nextRecords(position_ + 1);
    if (found == content_.size()) {
      return false;
    }
    dropDamaged();
    goOn(found);
    file_.damage.back().what += fmt::format("; reading continues at byte {}", position_);
    return true;
  }

  /// The byte from `begin` on at which records begin; the size of the content if there is none.
  [[nodiscard]] size_t nextRecords(size_t begin) const {
    size_t at = content_.find(kRecord, begin);
    while (at != std::string_view::npos && !areRecords(at)) {
      at = content_.find(kRecord, at + 1);
    }
    return std::min(at, content_.size());
  }

  void goOn(size_t at) {
    position_ = at;
    in_a_row_ = 0;
    file_.breaks.push_back(file_.records);
  }

  /// Whether the bytes from `at` on are records.
  [[nodiscard]] bool areRecords(size_t at) const {
    for (int count = 0; count < kRecordsInARow; ++count) {
      if (at == content_.size() || content_[at] == kEnd) {
        return count >= kRecordsToTheEnd;
      }
      const size_t room = content_.size() - at - 1;
      if (content_[at] != kRecord || room < file_.header.state_bytes) {
        return false;
      }
      const auto* states = reinterpret_cast<const uint8_t*>(content_.data() + at + 1);
      const size_t values = sizeOfValues(states);
      if (hasReserved(states) || room - file_.header.state_bytes < values || !isInTime(states) ||
          (count == 0 && !hasTime(states))) {
        return false;
      }
      at += 1 + file_.header.state_bytes + values;
    }
    return true;
  }

  /// Whether the clock of a record agrees with one of those before the damage.
  [[nodiscard]] bool isInTime(const uint8_t* states) const {
    const auto* bytes = reinterpret_cast<const char*>(states) + file_.header.state_bytes;
    bool agrees = true;
    forEachNew(states, [&](size_t index) {
      agrees = agrees && (index != clock_ || isNear(value(bytes, 8)));
      bytes += file_.columns[index].sensor.width;
    });
    return agrees;
  }

  /// Whether a time is near one of the newest that are known; the last may be damaged.
  [[nodiscard]] bool isNear(double time) const {
    constexpr size_t kNewest = 3;
    const std::vector<double>& times = file_.columns[clock_].values;
    const size_t from = times.size() - std::min(times.size(), kNewest);
    return times.empty() ||
           std::any_of(times.begin() + static_cast<ptrdiff_t>(from), times.end(),
                       [&](double known) { return std::fabs(time - known) < kFurthestTime; });
  }

  /// Whether a record has a new time; true if the file has no clock.
  [[nodiscard]] bool hasTime(const uint8_t* states) const {
    const bool is_new =
        clock_ < file_.columns.size() && (states[clock_ / 4] >> (6U - 2U * (clock_ % 4)) & 2U) != 0;
    return is_new || clock_ == file_.columns.size();
  }

  /// Takes back what may be damaged: records without a time of their own, which damage can look
  /// like, and one before them, in which it may have begun.
  void dropDamaged() {
    while (in_a_row_ > 0 && !lastIsInTime()) {
      dropLast();
    }
    if (in_a_row_ > 0) {
      dropLast();
    }
  }

  [[nodiscard]] const uint8_t* lastStates() const {
    return file_.states.data() + file_.states.size() - file_.header.state_bytes;
  }

  /// Whether the last record has a time near those before it.
  [[nodiscard]] bool lastIsInTime() const {
    if (clock_ == file_.columns.size()) {
      return true;
    }
    const std::vector<double>& times = file_.columns[clock_].values;
    return hasTime(lastStates()) &&
           (times.size() < 2 || std::fabs(times.back() - times[times.size() - 2]) < kFurthestTime);
  }

  void dropLast() {
    forEachNew(lastStates(), [&](size_t index) { file_.columns[index].values.pop_back(); });
    file_.states.resize(file_.states.size() - file_.header.state_bytes);
    --file_.records;
    --in_a_row_;
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
    ++in_a_row_;
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
  size_t position_ = 0;
  DataFile& file_;
  size_t clock_;  ///< a column
  bool is_damaged_ = false, hole_after_ = false;
  size_t in_a_row_ = 0;  ///< records since the beginning or the last break
  bool swap_ = false;
  size_t largest_ = 0;  ///< bytes of the values of a record that has all sensors
  uint8_t padding_ = 0;
};

}  // namespace

void decodeRecords(std::string_view content, size_t begin, const std::vector<size_t>& holes,
                   DataFile& file) {
  RecordDecoder decoder(file);
  bool after_hole = false;
  for (const size_t hole : holes) {
    if (hole >= begin) {
      decoder.decode(content.substr(0, hole), begin, after_hole, true);
      begin = hole;
      after_hole = true;
    }
  }
  decoder.decode(content, begin, after_hole, false);
}

bool isSameName(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
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
