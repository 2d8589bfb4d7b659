// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_SAMPLING_H
#define GLIDER_HOOKS_PROTOCOL_SAMPLING_H

#include "hooks/protocol/language.h"
#include "hooks/protocol/numbers.h"

/// How often the instruments of the vehicle read: the word `sci_hook_sampling` of an instruction.
/// It has five bits for each of six instruments, in the order of the vehicle's file, the first in
/// the lowest: a code.
GLIDER_HOOKS_BEGIN

enum {
  kHookMostInstruments = 6,
  kHookSamplingBits = 5,
  kHookSamplingCodes = 1 << kHookSamplingBits,
  kHookMostSampling = (1 << (kHookMostInstruments * kHookSamplingBits)) - 1,
  // Codes; those from the last on are the periods of sampling.def.
  kHookSamplingOfVehicle = 0,  ///< as the vehicle's own mission says
  kHookSamplingOff = 1,
  kHookSamplingFastest = 2,
  kHookSamplingPeriods = 0
#define SAMPLING_PERIOD(seconds) +1
#include "hooks/protocol/sampling.def"
};
GLIDER_STATIC_ASSERT(EachPeriodHasACode,
                     kHookSamplingFastest + kHookSamplingPeriods == kHookSamplingCodes);

/// Seconds between two readings: negative for an instrument that is off, NaN where the vehicle's
/// own mission says it.
GLIDER_INLINE double hookSamplingSecs(uint32_t code) {
  static const uint16_t periods[] = {
#define SAMPLING_PERIOD(seconds) seconds,
#include "hooks/protocol/sampling.def"
  };
  if (code < kHookSamplingFastest || code >= kHookSamplingCodes) {
    return code == kHookSamplingOff ? -1 : hookUnknown();
  }
  return periods[code - kHookSamplingFastest];
}

/// The code of the longest period that is at most `seconds`, which is not negative or NaN.
GLIDER_INLINE uint32_t hookSamplingCode(double seconds) {
  uint32_t code = kHookSamplingFastest;
  while (code + 1 < kHookSamplingCodes && seconds >= hookSamplingSecs(code + 1)) {
    ++code;
  }
  return code;
}

/// The code of an instrument, a number below kHookMostInstruments.
GLIDER_INLINE uint32_t hookSamplingOf(uint32_t word, uint32_t instrument) {
  return (word >> (instrument * kHookSamplingBits)) % kHookSamplingCodes;
}

GLIDER_HOOKS_END

#endif
