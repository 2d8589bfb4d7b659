// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What proofs assume about restarts (rules P3 to P6 of ir/README.md) is what the runtime does.

#include "ir/worlds/start_depth.h"
#include "runtime/core/continuation.h"
#include "tests/containment/rule.h"

#include <limits>

namespace glider::containment {
namespace {

using namespace ir;
using namespace ir::prove;
using runtime::Continuation;

/// A mission continues only after a gap that its proofs allow, and a mission of the same deployment
/// that has not ended never begins again.
class Continues : public Rule {
 public:
  explicit Continues(const ProofContext& context) : context_(context), dice_(1) {}
  void tick(const Flight&) override {
    const double limit = context_.mission.resume_within_s;
    const double scale = dice_.chance(0.5) ? 2 * limit : 2 * runtime::kAnotherFlight;
    runtime::Outage outage;
    outage.restarted = dice_.chance(0.5);
    outage.length = dice_.chance(0.1)   ? std::numeric_limits<double>::quiet_NaN()
                    : dice_.chance(0.1) ? limit
                                        : dice_.within(-0.2 * scale, scale);
    outage.resume_within = limit;
    outage.never_after_restart = dice_.chance(0.5);
    const Continuation then = runtime::continuationAfter(outage);
    ++steps;
    if (then == Continuation::GoesOn) {
      EXPECT_LE(outage.length, context_.tick_gap_s);
      EXPECT_GE(outage.length, 0);
      EXPECT_FALSE(outage.restarted && outage.never_after_restart);
    } else if (then == Continuation::Begins) {
      EXPECT_TRUE(outage.restarted);
      EXPECT_GE(outage.length, 12 * 3600);
    } else {
      EXPECT_FALSE(outage.length >= 0 && outage.length <= limit && !outage.never_after_restart);
    }
  }

 private:
  const ProofContext& context_;
  Rng dice_;
};

TEST(Containment, AfterARestartTheMissionContinuesAsProofsAssume) {
  holds<Continues>();
}

/// A reading with which the mission may begin is of a depth at which proofs let it begin.
class BeginsNearTheSurface : public Rule {
 public:
  explicit BeginsNearTheSurface(const ProofContext& context)
      : context_(context), limit_(startReading(context.mission, context.platform)), dice_(2) {}
  void tick(const Flight&) override {
    ++steps;
    RandomVehicle vehicle(deep_, dice_);
    if (vehicle.reading() <= limit_) {
      EXPECT_LE(vehicle.depth(), context_.platform.world.start_depth_m);
      ++begun_;
    }
  }
  ~BeginsNearTheSurface() override { EXPECT_GT(begun_, 0U); }

 private:
  /// A vehicle that may be anywhere near the surface.
  static platforms::Platform deep(platforms::Platform platform) {
    platform.world.start_depth_m *= 3;
    return platform;
  }
  const ProofContext& context_;
  platforms::Platform deep_ = deep(context_.platform);
  double limit_;
  Rng dice_;
  size_t begun_ = 0;
};

TEST(Containment, AMissionBeginsNoDeeperThanProofsAssume) {
  holds<BeginsNearTheSurface>();
}

}  // namespace
}  // namespace glider::containment
