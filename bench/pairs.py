# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Times two commands in turn (A B A B ...), so that a machine whose speed drifts does so for both."""

import statistics
import subprocess
import time


def wall(command):
    """Runs `command` (a list of words); seconds of wall time. Ends the program if it fails."""
    begin = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - begin


def timed_pairs(first, second, count):
    """`count` pairs after one warm-up each; the two lists of seconds."""
    wall(first)
    wall(second)
    times = [(wall(first), wall(second)) for _ in range(count)]
    return [a for a, _ in times], [b for _, b in times]


def row(name, seconds):
    """One line: name, least, median and greatest time in ms."""
    ms = [1000 * s for s in seconds]
    return f"  {name:<44} {min(ms):7.1f} {statistics.median(ms):7.1f} {max(ms):7.1f} ms"


def ratio(first, second):
    """The median of A/B, pair by pair."""
    return statistics.median(a / b for a, b in zip(first, second))
