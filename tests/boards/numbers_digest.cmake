# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# What tests/unit/runtime/numbers_samples.h makes of runtime/numbers, on this machine and on every board.
set(GLIDER_NUMBERS_ROUNDS 2000)
set(GLIDER_NUMBERS_DIGEST 14515894867181490061)
set(GLIDER_NUMBERS_DEFINITIONS
  GLIDER_NUMBERS_ROUNDS=${GLIDER_NUMBERS_ROUNDS} GLIDER_NUMBERS_DIGEST=${GLIDER_NUMBERS_DIGEST}ULL)
