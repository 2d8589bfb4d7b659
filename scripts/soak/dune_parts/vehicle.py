# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Runs an unmodified DUNE as the simulated LAUV, and records what it reports."""

import pathlib
import signal
import socket
import subprocess
import threading
import time

from dune_parts import imc

PORT = 6006
# What multicasts, listens for others, or only fills the disk.
OFF = ("Transports.Announce", "Transports.Discovery", "Transports.HTTP", "Transports.FTP", "Transports.UDP",
       "Transports.Logging", "Transports.LogBook", "Transports.CommManager", "Transports.TCPOnDemand",
       "Transports.Fragments", "Transports.Cache", "Simulators.AcousticModem", "Simulators.Gaussian/Temperature")
START = (39.175, -73.8417)  # degrees


def ini(speed):
    """The vehicle's own file: the simulated LAUV at the missions' place, in calm water, at `speed` times real time."""
    lines = ["[Require lauv-simulator-1.ini]"]
    for task in OFF:
        lines += [f"[{task}]", "Enabled = Never"]
    lines += ["[Transports.TCP.Server/BackSeat]", "Transports+ = LogBookEntry",
              "[Simulators.VSIM]", f"Time Multiplier = {speed}", "Initial Heading = 0",
              "[Simulators.GPS]", f"Initial Position = {START[0]}, {START[1]}",
              "[Simulators.CTD]", "Standard Deviation - Temperature = 0", "Standard Deviation - Conductivity = 0"]
    return "\n".join(lines) + "\n"


class Dune:
    """A process of DUNE with a fresh vehicle; `folder` gets its files. To be used in a `with`."""

    def __init__(self, program, etc, folder, speed):
        config = pathlib.Path(folder) / "etc"
        config.mkdir(parents=True)
        for entry in pathlib.Path(etc).iterdir():
            (config / entry.name).symlink_to(entry.resolve())
        (config / "glidercc.ini").write_text(ini(speed), encoding="utf-8")
        self.folder = folder
        self.command = [str(program), "-d", str(config), "-c", "glidercc", "-p", "Simulation"]
        self.process = None
        self.recorder = None

    def __enter__(self):
        with open(self.folder / "dune.out", "wb") as out:
            self.process = subprocess.Popen(self.command, cwd=self.folder, stdout=out, stderr=out)
        try:
            self.recorder = Recorder(self.process)
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.recorder.stop()
        self.stop()

    def stop(self):
        self.process.send_signal(signal.SIGINT)
        try:
            self.process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()


class Recorder:
    """A second client at the vehicle's port, which only listens."""

    def __init__(self, process, patience_s=120):
        end = time.monotonic() + patience_s
        while True:
            try:
                self.line = socket.create_connection(("127.0.0.1", PORT), timeout=5)
                break
            except OSError:
                if process.poll() is not None or time.monotonic() > end:
                    raise RuntimeError("DUNE does not listen at its port for back seats; see dune.out") from None
                time.sleep(0.2)
        self.records = []  # (id, time, source, fields)
        self.problem = None
        self.going = True
        self.thread = threading.Thread(target=self.listen)
        self.thread.start()

    def listen(self):
        reader = imc.Reader()
        while self.going:
            try:
                data = self.line.recv(65536)
            except TimeoutError:
                continue
            except OSError:
                return
            if not data:
                return
            try:
                self.records += reader.push(data)
            except ValueError as error:
                self.problem = str(error)
                return

    def of(self, number):
        """The (time, fields) of all messages with that id so far."""
        return [(when, fields) for which, when, _, fields in list(self.records) if which == number]

    def newest(self, number):
        for which, when, _, fields in reversed(list(self.records)):
            if which == number:
                return when, fields
        return None

    def stop(self):
        self.going = False
        self.line.close()
        self.thread.join()
