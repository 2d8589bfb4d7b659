// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/runtime/bench_mission.h"

#include <gtest/gtest.h>
