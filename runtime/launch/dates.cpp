// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/launch/dates.h"

namespace glider::runtime {
namespace {

constexpr uint32_t kFirstYear = 1970;
constexpr uint32_t kDay_s = 86400;
constexpr double kEnd_s = 253402300800.0;  // the year 10000
constexpr char kForm[] = "0000-00-00T00:00:00Z";
constexpr uint32_t kWithSeconds = sizeof kForm - 1;
constexpr uint32_t kWithoutSeconds = kWithSeconds - 3;

bool isLeap(uint32_t year) {
  return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
}

uint32_t daysOf(uint32_t year) {
  return isLeap(year) ? 366 : 365;
}

/// Of month 1 to 12.
uint32_t daysOf(uint32_t year, uint32_t month) {
  if (month == 2) {
    return isLeap(year) ? 29 : 28;
  }
  return month == 4 || month == 6 || month == 9 || month == 11 ? 30 : 31;
}

uint32_t numberAt(const Piece& text, uint32_t at, uint32_t count) {
  uint32_t value = 0;
  for (uint32_t i = at; i < at + count; ++i) {
    value = value * 10U + static_cast<uint32_t>(text.begin[i] - '0');
  }
  return value;
}

/// Whether digits and signs are where the form has them.
bool hasForm(const Piece& text) {
  const bool seconds = text.size() == kWithSeconds;
  if (!seconds && text.size() != kWithoutSeconds) {
    return false;
  }
  for (uint32_t i = 0; i < text.size(); ++i) {
    const char form = kForm[!seconds && i + 1 == text.size() ? kWithSeconds - 1 : i];
    const char c = text.begin[i];
    if (form == '0' ? c < '0' || c > '9' : c != form) {
      return false;
    }
  }
  return true;
}

void putTwo(Text& text, uint32_t value) {
  text.put(static_cast<char>('0' + value / 10U)).put(static_cast<char>('0' + value % 10U));
}

}  // namespace

bool readDate(const GliderParameterInfo& parameter, const Piece& text, double& value) {
  const Piece date = text.trimmed();
  if (!isDate(parameter) || !hasForm(date)) {
    return false;
  }
  const uint32_t year = numberAt(date, 0, 4);
  const uint32_t month = numberAt(date, 5, 2);
  const uint32_t day = numberAt(date, 8, 2);
  const uint32_t hour = numberAt(date, 11, 2);
  const uint32_t minute = numberAt(date, 14, 2);
  const uint32_t second = date.size() == kWithSeconds ? numberAt(date, 17, 2) : 0;
  if (year < kFirstYear || month < 1 || month > 12 || day < 1 || day > daysOf(year, month) ||
      hour > 23 || minute > 59 || second > 59) {
    return false;
  }
  uint32_t days = day - 1;
  for (uint32_t y = kFirstYear; y < year; ++y) {
    days += daysOf(y);
  }
  for (uint32_t m = 1; m < month; ++m) {
    days += daysOf(year, m);
  }
  value = static_cast<double>(days) * kDay_s +
          static_cast<double>(hour * 3600U + minute * 60U + second);
  return true;
}

bool writeDate(const GliderParameterInfo& parameter, double value, Text& text) {
  if (!isDate(parameter) || !(value >= 0.0 && value < kEnd_s)) {
    return false;
  }
  auto days = static_cast<uint32_t>(value / kDay_s);
  const auto second = static_cast<uint32_t>(value - static_cast<double>(days) * kDay_s);
  uint32_t year = kFirstYear;
  while (days >= daysOf(year)) {
    days -= daysOf(year++);
  }
  uint32_t month = 1;
  while (days >= daysOf(year, month)) {
    days -= daysOf(year, month++);
  }
  text.putCount(year).put('-');
  putTwo(text, month);
  putTwo(text.put('-'), days + 1);
  putTwo(text.put('T'), second / 3600U);
  putTwo(text.put(':'), second / 60U % 60U);
  if (second % 60U != 0) {
    putTwo(text.put(':'), second % 60U);
  }
  text.put('Z');
  return true;
}

bool putDateForm(const GliderParameterInfo& parameter, Text& text) {
  if (!isDate(parameter)) {
    return false;
  }
  text.put(": write a time such as `2027-03-01T00:00Z`, or seconds since 1970");
  return true;
}

}  // namespace glider::runtime
