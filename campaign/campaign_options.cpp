// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign_options.h"

#include "codegen/digest.h"
#include "compiler/build_id.h"
#include "compiler/compilation.h"
#include "simulator/family/family.h"
#include "support/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <any>
#include <cctype>
#include <set>
#include <string_view>

namespace glider::campaign {

namespace {

/// The own mission of each vehicle with all that was read for it, those that are alike once.
std::string ownMissionsOf(const CampaignPlan& plan) {
  std::set<std::string> texts;
  for (const CampaignMission& mission : plan.missions) {
    const simulator::Family* family = simulator::familyOf(mission.platform);
    const std::any& own = mission.own.has_value() ? mission.own : plan.scenario.own;
    if (family != nullptr && own.has_value()) {
      texts.insert(family->text_of(own));
    }
  }
  return fmt::format("{}", fmt::join(texts, ""));
}

}  // namespace

support::Result<std::string> identityOf(const CampaignPlan& plan, const CampaignOptions& options) {
  std::string all =
      fmt::format("{}\n{} {} {} {}\n{}\n", compiler::buildId(), plan.flights, plan.seed,
                  plan.board_percent, fmt::join(plan.boards, " "), fmt::join(options.faults, ","));
  std::vector<std::string> files;
  for (const CampaignMission& mission : plan.missions) {
    files.push_back(mission.file);
  }
  files.insert(files.end(), options.user_code.begin(), options.user_code.end());
  if (!options.launch.file.empty()) {
    files.push_back(options.launch.file);
  }
  for (const std::string& file : files) {
    const auto content = support::readFile(file);
    if (!content) {
      return std::unexpected(content.error());
    }
    all += fmt::format("{} {}\n", file, codegen::digestOf(*content));
  }
  for (const std::string& setting : options.launch.settings) {
    all += setting + "\n";
  }
  for (const CampaignMission& mission : plan.missions) {
    const auto platform = support::readFile(compiler::platformFile(mission.platform.name));
    if (!platform) {
      return std::unexpected(platform.error());
    }
    all += codegen::digestOf(*platform) + " " + mission.program + "\n";
  }
  const auto skeleton = support::readFile(plan.scenario.skeleton_path);
  const auto world = support::readFile(plan.scenario.path);
  if (!skeleton || !world) {
    return std::unexpected(skeleton ? world.error() : skeleton.error());
  }
  if (options.duration_s) {
    all += fmt::format("lasts {} s\n", *options.duration_s);
  }
  return codegen::digestOf(all + ownMissionsOf(plan) + *skeleton + *world);
}

std::string shellWord(const std::string& text) {
  const bool plain = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_-./=+:,@%").contains(static_cast<char>(c));
  });
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return plain ? text : quoted + "'";
}

std::string commandOf(const CampaignOptions& options) {
  std::string command = "glidercc campaign";
  const auto add = [&](const std::string& option, const std::string& value) {
    command += " " + option + (option.empty() ? "" : " ") + shellWord(value);
  };
  for (const std::string& mission : options.missions) {
    command += " " + shellWord(mission);
  }
  if (options.scenario != CampaignOptions().scenario) {
    add("--scenario", options.scenario);
  }
  if (options.duration_s) {
    add("--duration", fmt::format("{}s", *options.duration_s));
  }
  for (const std::string& setting : options.launch.settings) {
    add("--set", setting);
  }
  if (!options.launch.file.empty()) {
    add("--parameters", options.launch.file);
  }
  for (const std::string& file : options.user_code) {
    add("--link", file);
  }
  if (options.board_percent != CampaignOptions().board_percent) {
    add("--boards", fmt::to_string(options.board_percent));
  }
  for (const std::string& fault : options.faults) {
    add("--fault", fault);
  }
  add("--seed", fmt::to_string(options.seed));
  return command;
}

}  // namespace glider::campaign
