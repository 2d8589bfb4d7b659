// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/findings/against.h"

#include <nlohmann/json_fwd.hpp>

namespace glider::report {

/// The member `against` of a mission in the document of findingsToJson: an item for each vehicle.
nlohmann::ordered_json againstJson(const std::vector<AgainstLogs>& all,
                                   const support::SourceManager& sources);

}  // namespace glider::report
