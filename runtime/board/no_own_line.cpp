// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/own_line.h"

namespace glider::runtime {

int takeOwnLine(int argc, char** /*argv*/) {
  return argc;
}

void tellOwnLine() {}

bool openOwnLine(OpenPort& /*line*/) {
  return false;
}

const int* ownDescriptor() {
  return nullptr;
}

}  // namespace glider::runtime
