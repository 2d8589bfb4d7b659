# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Stands between the SBC's program and the vehicle, and adds bytes that neither has sent."""

import select
import socket
import threading

PORT = 6106
# The header of a packet with big-endian numbers and a long payload: the vehicle takes what follows for that.
TRAP = bytes.fromhex("fe540096ffff") + bytes(14)


class Relay:
    """To be used in a `with`."""

    def __init__(self, to_port):
        self.to_port = to_port
        self.listener = socket.create_server(("127.0.0.1", PORT))
        self.ends = []  # that of the program, that of the vehicle
        self.connections = 0
        self.going = True
        self.thread = threading.Thread(target=self.work)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.going = False
        self.thread.join()
        self.listener.close()

    def inject(self, data):
        """To the vehicle, as if the program had sent it."""
        self.ends[1].sendall(data)

    def work(self):
        while self.going:
            ready, _, _ = select.select([self.listener, *self.ends], [], [], 0.1)
            for end in ready:
                if end is self.listener:
                    self.hang_up()
                    program, _ = self.listener.accept()
                    self.ends = [program, socket.create_connection(("127.0.0.1", self.to_port))]
                    self.connections += 1
                    break
                if not self.pass_on(end):
                    self.hang_up()
                    break
        self.hang_up()

    def pass_on(self, end):
        """False if the connection has ended."""
        try:
            data = end.recv(65536)
            self.ends[self.ends.index(end) - 1].sendall(data)
        except OSError:
            return False
        return bool(data)

    def hang_up(self):
        for end in self.ends:
            end.close()
        self.ends = []
