// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/values.h"

bool hookIsState(uint8_t value) {
  return value <= kHookStateComplete;
}

bool hookIsAnswer(uint8_t value) {
  return value <= kHookAnswerBadBattery;
}

uint16_t hookNextSequence(uint16_t sequence) {
  return (uint16_t)(sequence % UINT16_MAX + 1);
}

bool hookIsNewerSequence(uint16_t sequence, uint16_t other) {
  // Serial number arithmetic (RFC 1982) modulo 65535: no number has an opposite.
  const uint32_t ahead = ((uint32_t)sequence + UINT16_MAX - other) % UINT16_MAX;
  return sequence != 0 && (other == 0 || (ahead != 0 && ahead <= UINT16_MAX / 2));
}

uint32_t hookNextSession(uint32_t session) {
  return session >= kHookMostSession ? 1 : session + 1;
}

bool hookIsNewerSession(uint32_t session, uint32_t other) {
  if (other == 0) {
    return session != 0;
  }
  const uint32_t ahead = session >= other ? session - other : session + kHookMostSession - other;
  return ahead != 0 && ahead <= kHookMostSession / 2;
}
