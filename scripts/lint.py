# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What the check_* scripts share: the project's files, and how findings are reported."""

import pathlib
import re
import subprocess
import sys

# The opening mark of an #include, < or ", and the path.
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)
ROOT = pathlib.Path(__file__).resolve().parent.parent


def files(*suffixes):
    """The project's files (tracked, or new and not ignored) as paths from the root; all without suffixes."""
    command = ["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listing = subprocess.run(command, stdout=subprocess.PIPE, check=False)
    if listing.returncode != 0:
        print("error: git cannot list the project's files (its words are above)", file=sys.stderr)
        sys.exit(2)
    names = sorted(set(listing.stdout.decode().split("\0")) - {""})
    return [
        pathlib.PurePosixPath(name)
        for name in names
        if (not suffixes or name.endswith(suffixes)) and (ROOT / name).is_file()
    ]


def read(path):
    """The text of a file of the project; bytes that are not valid UTF-8 become U+FFFD."""
    return (ROOT / path).read_text(encoding="utf-8", errors="replace")


def main(documentation, check):
    """Runs `check()`, a generator of findings; prints them, and ends with 1 if there was one."""
    if sys.argv[1:] in (["-h"], ["--help"]):
        print(documentation.strip())
        sys.exit(0)
    if sys.argv[1:]:
        print(f"error: unknown argument '{sys.argv[1]}'; see --help", file=sys.stderr)
        sys.exit(2)
    findings = list(check())
    for finding in findings:
        print(finding)
    name = pathlib.Path(sys.argv[0]).name
    print(f"{name}: {len(findings) or 'no'} finding{'' if len(findings) == 1 else 's'}")
    sys.exit(1 if findings else 0)
