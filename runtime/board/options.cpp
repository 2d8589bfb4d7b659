// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/options.h"

#include <string.h>

namespace glider::runtime {
namespace {

bool readCount(const char* text, uint32_t& count) {
  uint32_t value = 0;
  for (const char* c = text; *c != '\0'; ++c) {
    if (*c < '0' || *c > '9' || value > 400000000U) {
      return false;
    }
    value = value * 10U + static_cast<uint32_t>(*c - '0');
  }
  count = value;
  return value > 0;
}

bool is(const char* argument, const char* name) {
  return strcmp(argument, name) == 0;
}

/// True if `argument` is an option that takes `value` and the value is good.
bool withValue(const char* argument, const char* value, Options& options) {
  if (is(argument, "--port")) {
    options.port = value;
    return true;
  }
  if (is(argument, "--log")) {
    options.log = value;
    return true;
  }
  if (is(argument, "--checkpoint")) {
    options.checkpoints = value;
    return true;
  }
  if (is(argument, "--parameters")) {
    options.parameters = value;
    return true;
  }
  if (is(argument, "--sleep")) {
    options.sleep = value;
    return true;
  }
  if (is(argument, "--set") && options.setting_count < Options::kMostSettings) {
    options.settings[options.setting_count++] = value;
    return true;
  }
  if (is(argument, "--log-limit")) {
    return readCount(value, options.log_limit) && options.log_limit >= Options::kLeastLogLimit;
  }
  return is(argument, "--baud") && readCount(value, options.baud);
}

bool withoutValue(const char* argument, Options& options) {
  if (is(argument, "--stdio")) {
    options.stdio = true;
    return true;
  }
  if (is(argument, "--help") || is(argument, "-h")) {
    options.wish = Options::Wish::Help;
    return true;
  }
  if (is(argument, "--version")) {
    options.wish = Options::Wish::Version;
    return true;
  }
  return false;
}

}  // namespace

Options readOptions(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    if (withoutValue(argv[i], options)) {
      continue;
    }
    if (i + 1 < argc && withValue(argv[i], argv[i + 1], options)) {
      ++i;
      continue;
    }
    options.wish = Options::Wish::Wrong;
    options.wrong = argv[i];
    options.wrong_value = argv[i][0] == '-' && i + 1 < argc ? argv[i + 1] : "";
    return options;
  }
  return options;
}

}  // namespace glider::runtime
