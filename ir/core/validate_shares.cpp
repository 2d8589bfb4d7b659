// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/validate_shares.h"

#include "ir/core/share_messages.h"
#include "runtime/abi/talk_mission.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace glider::ir {
namespace {

double highestOf(const Share& share) {
  return share.lowest + (share.values - 1) * share.step;
}

class ShareValidator {
 public:
  ShareValidator(const Mission& mission, Defects& defects) : m_(mission), defects_(defects) {}

  void run() {
    defects_.require(m_.shares.size() <= GLIDER_MOST_SHARES, {}, "there are {} shares",
                     m_.shares.size());
    for (const Share& share : m_.shares) {
      names(share);
      numbers(share);
      told(share);
      received(share);
    }
    periods();
    vehicles();
    clock();
    sensors();
  }

 private:
  template <typename... Args>
  void require(bool holds, const Share& share, std::string_view message, const Args&... args) {
    defects_.require(holds, share.range, message, share.name, args...);
  }

  void names(const Share& share) {
    require(names_.insert(share.name).second, share, "two shares are named `{}`");
  }

  void numbers(const Share& share) {
    require(std::isfinite(share.lowest) && std::isfinite(share.step) && share.step > 0 &&
                share.values >= 1 && share.values < UINT32_MAX && std::isfinite(highestOf(share)),
            share, "share `{}` has {} values from {} in steps of {}", share.values, share.lowest,
            share.step);
    require(std::isfinite(share.period_s) && share.period_s > 0, share,
            "share `{}` is sent every {} s", share.period_s);
  }

  void told(const Share& share) {
    const bool sensor = share.sensor.index < m_.sensors.size() &&
                        !m_.sensors[share.sensor.index].isHeard() && !share.variable.valid();
    const bool variable = !share.sensor.valid() && share.variable.index < m_.variables.size() &&
                          (m_.variables[share.variable.index].kind == VariableKind::Mission ||
                           m_.variables[share.variable.index].kind == VariableKind::Parameter);
    require(sensor || variable, share,
            "share `{}` is neither a sensor of this vehicle nor a variable or parameter of the "
            "mission");
    const bool truth = variable && m_.variables[share.variable.index].type.kind == TypeKind::Bool;
    require(!truth || (share.lowest == 0 && share.step == 1 && share.values == 2), share,
            "share `{}` is a truth value, but is sent as a number");
  }

  void received(const Share& share) {
    if (share.peer.valid()) {
      received(share, share.peer);
    }
    uint32_t before = 0;
    for (const FromVehicle& from : share.named) {
      require(from.address > before && from.address <= m_.vehicles.size(), share,
              "share `{}` is received from vehicle {} after {}, of {}", from.address, before,
              m_.vehicles.size());
      before = from.address;
      received(share, from.sensor);
    }
  }

  void received(const Share& share, SensorId id) {
    const bool exists = id.index < m_.sensors.size();
    require(exists && m_.sensors[id.index].isHeard(), share,
            "what is received of share `{}` is not a sensor of what is received");
    if (exists) {
      require(heard_.insert(id).second, share,
              "what is received of share `{}` is also received of another");
    }
  }

  void vehicles() {
    const std::set<std::string_view> names(m_.vehicles.begin(), m_.vehicles.end());
    defects_.require(names.size() == m_.vehicles.size(), {}, "two vehicles have the same name");
    defects_.require(m_.vehicles.size() <= kMostNamedVehicles, {}, "there are {} named vehicles",
                     m_.vehicles.size());
    defects_.require(heard_.size() <= GLIDER_MOST_NAMED, {}, "{} values are received",
                     heard_.size());
  }

  /// Those of a period are one message, which must fit into a frame.
  void periods() {
    const bool ordered = std::ranges::is_sorted(m_.shares, {}, &Share::period_s);
    defects_.require(ordered, {}, "the shares are not in the order of their periods");
    if (!ordered || m_.shares.size() > GLIDER_MOST_SHARES) {
      return;
    }
    for (const ShareMessage& message : messagesOf(m_)) {
      const Share& first = m_.shares[message.first];
      require(message.bytes != 0, first,
              "share `{}` and the others of its period do not fit into a frame");
    }
  }

  void clock() {
    defects_.require(m_.utc.valid() == !m_.shares.empty(), {},
                     "the vehicle's clock is there if and only if something is shared");
    defects_.require(!m_.utc.valid() || (m_.utc.index < m_.sensors.size() &&
                                         m_.sensors[m_.utc.index].id < kFirstHeardSensor),
                     {}, "the vehicle's clock is not a sensor of the vehicle");
  }

  /// What is received is in SI units: it is sent so.
  void sensors() {
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      const Sensor& s = m_.sensors[i];
      if (s.isHeard()) {
        defects_.require(heard_.contains({i}), {}, "sensor `{}` is received of no share", s.name);
        defects_.require(s.to_si == 1 && s.encoding == Encoding::Linear, {},
                         "sensor `{}` is received, but is not in SI units", s.name);
      }
    }
  }

  const Mission& m_;
  Defects& defects_;
  std::set<std::string_view> names_;
  std::set<SensorId> heard_;
};

}  // namespace

void validateShares(const Mission& mission, Defects& defects) {
  ShareValidator(mission, defects).run();
}

}  // namespace glider::ir
