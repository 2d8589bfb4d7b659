// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The scripts of `glidercc completion` in the shells themselves: what each offers.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <sstream>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

bool isHere(const std::string& shell) {
  return runShell("command -v " + shell).status == 0;
}

/// A folder with two missions, a scenario and another file.
struct Files {
  Files() {
    for (const char* name : {"one.mission", "two.mission", "sea.toml", "notes.txt", "own.mi"}) {
      (void)folder.write(name, "");
    }
    (void)runShell("mkdir " + (folder.path() / "sub").string());
  }
  TemporaryFolder folder;
};

/// The lines of a text in order: shells offer files as the folder has them.
std::string sorted(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line + "\n");
  }
  std::ranges::sort(lines);
  std::string all;
  for (const std::string& line : lines) {
    all += line;
  }
  return all;
}

/// What bash offers for the words of a command line, of which the last is completed; one a line.
std::string inBash(const Files& files, const std::string& words, int count) {
  const Outcome outcome =
      runShell("cd " + files.folder.path().string() +
               "; $GLIDERCC completion bash > c && bash -c 'compopt() { :; }; . ./c; complete -p "
               "glidercc > p; COMP_WORDS=(glidercc " +
               words + "); COMP_CWORD=" + std::to_string(count) +
               "; _glidercc; printf \"%s\\n\" \"${COMPREPLY[@]}\"'; grep -q \"_glidercc glidercc\" "
               "p || echo not registered");
  EXPECT_EQ(outcome.err, "") << words;
  return sorted(outcome.out);
}

TEST(Completion, OfBash) {
  if (!isHere("bash")) {
    GTEST_SKIP() << "there is no bash here";
  }
  const Files files;
  EXPECT_EQ(inBash(files, "ch", 1), "check\n");
  EXPECT_EQ(inBash(files, "check --form", 2), "--format\n");
  EXPECT_EQ(inBash(files, "check --format ''", 3), "json\nsarif\ntext\n");
  EXPECT_EQ(inBash(files, "check --format = s", 4), "sarif\n") << "--format=s is three words";
  EXPECT_EQ(inBash(files, "check --format =", 3), "json\nsarif\ntext\n");
  EXPECT_EQ(inBash(files, "check ''", 2), "one.mission\nsub\ntwo.mission\n");
  EXPECT_EQ(inBash(files, "check one.mission --report t", 4), "two.mission\n");
  EXPECT_EQ(inBash(files, "sim one.mission --scenario f", 4),
            "figure5\nfigure6\nfirst_deployment\nfront\n");
  EXPECT_EQ(inBash(files, "sim one.mission --scenario s", 4), "sea.toml\nshelf_slope\nsub\n");
  EXPECT_EQ(inBash(files, "build one.mission --target ''", 4),
            "cm4\nhost\npizero2\nts5500\nts7800\n");
  EXPECT_EQ(inBash(files, "sim one.mission -o ''", 4), "sub\n") << "a folder";
  EXPECT_EQ(inBash(files, "check one.mission --mi ''", 4), "own.mi\nsub\n");
  EXPECT_EQ(inBash(files, "completion ''", 2), "bash\nfish\nzsh\n");
  EXPECT_EQ(inBash(files, "help gra", 2), "graph\n");
  EXPECT_EQ(inBash(files, "new mo", 2), "mooring\n");
  EXPECT_THAT(inBash(files, "sim --colour", 2), Not(HasSubstr("--colour\n"))) << "its old name";
}

TEST(Completion, OfZsh) {
  if (!isHere("zsh")) {
    GTEST_SKIP() << "there is no zsh here";
  }
  const Files files;
  // A terminal in which a person presses Tab.
  const auto in_zsh = [&](const std::string& line) {
    return runShell("cd " + files.folder.path().string() +
                    "; $GLIDERCC completion zsh > _glidercc; cat > drive.zsh <<'END'\n"
                    "zmodload zsh/zpty; zpty z zsh -f -i; zpty -w z 'PS1=; fpath=($PWD $fpath); "
                    "autoload -U compinit; compinit -u -D; "
                    "setopt nolistbeep; LISTMAX=1000; stty columns 300 rows 100'; sleep 2; zpty -w "
                    "-n z $'" +
                    line +
                    "\\t'; sleep 1; zpty -w -n z $'\\t'; sleep 2; zpty -r -t z out '*' ; while "
                    "zpty -r -t z more; do out+=$more; done; print -r -- $out; zpty -d z\nEND\n"
                    "zsh -f drive.zsh | tail -c 3000")
        .out;
  };
  EXPECT_THAT(in_zsh("glidercc che"), HasSubstr("check"));
  const std::string formats = in_zsh("glidercc check --format ");
  EXPECT_THAT(formats, testing::AllOf(HasSubstr("json"), HasSubstr("sarif"), HasSubstr("text")));
  const std::string files_there = in_zsh("glidercc check ");
  EXPECT_THAT(files_there, testing::AllOf(HasSubstr("one.mission"), Not(HasSubstr("notes.txt"))));
  EXPECT_EQ(runShell("$GLIDERCC completion zsh | zsh -n /dev/stdin").err, "");
}

/// What fish offers, one a line, with its description.
std::string inFish(const Files& files, const std::string& line) {
  const Outcome outcome =
      runShell("cd " + files.folder.path().string() +
               "; $GLIDERCC completion fish > c.fish && HOME=$PWD fish -c 'source "
               "c.fish; complete -C \"" +
               line + "\"'");
  EXPECT_EQ(outcome.err, "") << line;
  return outcome.out;
}

TEST(Completion, OfFish) {
  if (!isHere("fish")) {
    GTEST_SKIP() << "there is no fish here";
  }
  const Files files;
  EXPECT_EQ(inFish(files, "glidercc chec"), "check\tCheck missions without building them\n");
  EXPECT_THAT(inFish(files, "glidercc check --form"), testing::StartsWith("--format\t"));
  EXPECT_THAT(inFish(files, "glidercc check --format "),
              testing::AllOf(HasSubstr("json"), HasSubstr("sarif"), Not(HasSubstr("one.mission"))));
  EXPECT_THAT(inFish(files, "glidercc check o"), HasSubstr("one.mission"));
  EXPECT_THAT(inFish(files, "glidercc sim one.mission --scenario s"),
              testing::AllOf(HasSubstr("shelf_slope"), HasSubstr("sea.toml")));
}

TEST(Completion, OfAnotherShellIsRefused) {
  const Outcome outcome = runShell("$GLIDERCC completion tcsh");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("`tcsh` is not one of bash, zsh, fish"));
}

}  // namespace
}  // namespace glider::tests
