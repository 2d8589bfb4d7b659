# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Compiles the file with the fault and links the programs of the tests with it, beside the build and never in it.

The file lies in a tree of its own that the compiler looks at first (-iquote); its object stands before the libraries
when a program is linked, so that the linker takes it and leaves the good one in its archive.
"""

import collections
import functools
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess

from mutants_code_parts.source import ROOT

MOST_OBJECTS = 12  # of a header; one that more include is built with the whole tree, not here


class BrokenError(Exception):
    """The build or the tests do not even work without a fault."""


class Build:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        listing = self.folder / "compile_commands.json"
        if not listing.is_file():
            raise BrokenError(f"no build in {self.folder}; scripts/test makes one")
        self._commands = {}
        for entry in json.loads(listing.read_text()):
            words = shlex.split(entry["command"])
            self._commands[words[words.index("-o") + 1]] = (entry["file"], words)
        self.lld = shutil.which("ld.lld") is not None

    @functools.cached_property
    def users(self):
        """File of the project → the objects of its libraries and programs, tests apart, that are compiled from it."""
        text = self._ninja("-t", "deps")
        users = collections.defaultdict(list)
        current = None
        for line in text.splitlines():
            if line and not line[0].isspace():
                current = line.split(": ")[0]
            elif line.strip() and current in self._commands and not current.startswith(("tests/", "bench/")):
                path = os.path.relpath(os.path.join(self.folder, line.strip()), ROOT)
                if not path.startswith(".."):
                    users[path].append(current)
        return users

    @functools.lru_cache(maxsize=None)
    def link_command(self, program):
        text = self._ninja("-t", "commands", "-s", program).strip()
        words = shlex.split(text)
        if words[:2] == [":", "&&"]:
            words = words[2:]
        return words[:words.index("&&")] if "&&" in words else words

    @functools.lru_cache(maxsize=None)
    def objects_of(self, path, program):
        """Of the objects made from `path` those of its own folder that the program is linked with: an inline function
        that another folder has compiled too stays good there."""
        libraries = {w for w in self.link_command(program) if w.endswith((".a", ".o"))}
        top = str(path).split("/", maxsplit=1)[0] + "/"
        return tuple(o for o in self.users.get(str(path), ())
                     if o.startswith(top) and (o in libraries or self._archive(o) in libraries))

    @staticmethod
    def _archive(object_path):
        """folder/CMakeFiles/name.dir/file.o lies in folder/libname.a"""
        folder, _, rest = object_path.partition("CMakeFiles/")
        return folder + "lib" + rest.split(".dir/")[0] + ".a"

    def compile(self, scratch, objects):
        """Compiles the objects with what lies in scratch/tree; false when the compiler refuses. One after another."""
        for name in objects:
            file, words = self._commands[name]
            planted = scratch / "tree" / os.path.relpath(file, ROOT)
            kept, skip = [], False
            for word in words:
                if skip:
                    skip = False
                elif word in ("-o", "-c"):
                    skip = True
                elif not word.endswith("ccache") and word not in ("-Werror", "-g1", "-g"):
                    kept.append(word)
            made = scratch / "objects" / name.replace("/", "_")
            made.parent.mkdir(exist_ok=True)
            # A switch that lacks an enumerator does not compile in the build either.
            source = planted if planted.exists() else self._united(scratch, pathlib.Path(file), made.with_suffix(pathlib.Path(file).suffix))
            command = kept + ["-Wno-error", "-Werror=switch", "-iquote", str(scratch / "tree"), "-O1", "-o", str(made), "-c", str(source)]
            if subprocess.run(command, cwd=self.folder, capture_output=True, check=False, timeout=300).returncode != 0:
                return False
        return True

    def _united(self, scratch, file, made):
        """The source to compile for `file`: one that includes others by their whole names (UNITY_BUILD) gets those that are planted."""
        if self.folder not in file.resolve().parents:
            return file
        text = file.read_text(encoding="utf-8")
        for whole in re.findall(r'#include "([^"]+)"', text):
            planted = scratch / "tree" / os.path.relpath(whole, ROOT)
            if planted.exists():
                text = text.replace(f'"{whole}"', f'"{planted}"')
        made.write_text(text, encoding="utf-8")
        return made

    def link(self, scratch, program, path):
        """Links the program with the objects in scratch that its libraries have from `path`; where it is, None if the
        linker refuses. The others are of libraries that it is not linked with, and want what it lacks."""
        made = scratch / "bin" / pathlib.Path(program).name
        made.parent.mkdir(exist_ok=True)
        words = list(self.link_command(program))
        mine = [o.replace("/", "_") for o in self.objects_of(path, program)]
        objects = {name: scratch / "objects" / name for name in mine}
        words[words.index("-o") + 1] = str(made)
        for i, word in enumerate(words):
            if word.replace("/", "_") in objects:
                words[i] = str(objects.pop(word.replace("/", "_")))
        wanted = [str(p) for n, p in objects.items()]
        command = words[:1] + (["-fuse-ld=lld"] if self.lld else []) + wanted + words[1:]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, check=False, text=True)
        if done.returncode != 0:
            return None
        share = scratch / "share"
        if not share.exists():
            share.symlink_to(self.folder / "share")
        return made

    def _ninja(self, *arguments):
        done = subprocess.run(["ninja", "-C", str(self.folder), *arguments], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise BrokenError(f"ninja {' '.join(arguments)}: {done.stdout.strip()}{done.stderr.strip()}")
        return "\n".join(line for line in done.stdout.splitlines() if not line.startswith("ninja: Entering"))


def run_tests(program, only, scratch, timeout_s, environment=None):
    """Runs a gtest program, stops at the first failure. "passed", "failed" or "time-out", and the test that failed."""
    place = scratch / "run"
    place.mkdir(exist_ok=True)
    process = subprocess.Popen(
        [str(program), f"--gtest_filter={only}", "--gtest_fail_fast", "--gtest_brief=1"], cwd=place, text=True,
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace",
        start_new_session=True, env={**os.environ, **(environment or {})})
    try:
        out, _ = process.communicate(timeout=timeout_s)
    except subprocess.TimeoutExpired:
        return "time-out", ""
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()
    if process.returncode == 0:
        return "passed", ""
    failed = [line.split("]", 1)[1].split("(")[0].split(",")[0].strip() for line in out.splitlines() if line.startswith("[  FAILED  ]")]
    return "failed", failed[0] if failed else f"exit status {process.returncode}"
