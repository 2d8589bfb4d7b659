// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/sampling.h"

#include "runtime/abi/glider_abi.h"

extern "C" void gliderSample(GliderContext* context, double word) {
  if (word >= 0.0 && word <= static_cast<double>(kHookMostSampling)) {
    context->sampling = static_cast<uint32_t>(word);
  } else {
    ++context->refused_commands;
  }
}
