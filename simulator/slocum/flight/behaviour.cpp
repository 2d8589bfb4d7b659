// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviour.h"

#include "simulator/slocum/flight/behaviours/abend.h"
#include "simulator/slocum/flight/behaviours/depth_behaviour.h"
#include "simulator/slocum/flight/behaviours/drift_at_depth.h"
#include "simulator/slocum/flight/behaviours/goto_list.h"
#include "simulator/slocum/flight/behaviours/goto_wpt.h"
#include "simulator/slocum/flight/behaviours/hookbeh_adapter.h"
#include "simulator/slocum/flight/behaviours/mission_ender.h"
#include "simulator/slocum/flight/behaviours/nop_commands.h"
#include "simulator/slocum/flight/behaviours/prepare_to_dive.h"
#include "simulator/slocum/flight/behaviours/sample.h"
#include "simulator/slocum/flight/behaviours/set_heading.h"
#include "simulator/slocum/flight/behaviours/surface.h"
#include "simulator/slocum/flight/behaviours/yo.h"

#include <algorithm>
#include <string_view>

namespace glider::simulator {

std::string Behaviour::label() const {
  return place_ == 0 ? name_ : name_ + "_" + std::to_string(place_);
}

void Behaviour::run(const Situation& situation, Commands& commands) {
  if (state_ == State::Waiting && starts(situation, commands)) {
    state_ = State::Active;
    why_started_ = whyStarts(commands);
    begin(situation);
  }
  if (state_ == State::Active && fly(situation, commands) == Outcome::Done) {
    state_ = resumes() ? State::Waiting : State::Complete;
    ended(situation);
  }
}

namespace {

template <typename Made>
std::unique_ptr<Behaviour> make(const BehaviourSource& source) {
  return std::make_unique<Made>(source);
}

struct Kind {
  std::string_view name;
  std::unique_ptr<Behaviour> (*make)(const BehaviourSource& source);
};

constexpr Kind kKinds[] = {
    {"abend", make<Abend>},
    {"climb_to", make<DepthBehaviour>},
    {"dive_to", make<DepthBehaviour>},
    {"drift_at_depth", make<DriftAtDepth>},
    {"goto_list", make<GotoList>},
    {"goto_wpt", make<GotoWpt>},
    {"hookbeh", make<HookbehAdapter>},
    {"mission_ender", make<MissionEnder>},
    {"nop_cmds", make<NopCommands>},
    {"oob_abort", make<OutOfBandAbort>},
    {"prepare_to_dive", make<PrepareToDive>},
    {"sample", make<Sample>},
    {"set_heading", make<SetHeading>},
    {"surface", make<Surface>},
    {"yo", make<Yo>},
};

}  // namespace

std::unique_ptr<Behaviour> makeBehaviour(const BehaviourSource& source) {
  const auto* const kind = std::ranges::find(kKinds, source.block.name, &Kind::name);
  return kind == std::end(kKinds) ? nullptr : kind->make(source);
}

}  // namespace glider::simulator
