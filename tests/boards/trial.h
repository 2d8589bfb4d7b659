// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#ifdef __cplusplus
extern "C" {
#endif

/// The mean depth in metres of `count` depths; 0 of none. C++ behind a C face, as in the runtime.
double trialMeanDepth(const double* depths, unsigned count);

#ifdef __cplusplus
}
#endif
