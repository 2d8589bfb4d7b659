# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Reads what a vehicle reports over its port for a back seat: packets of IMC, of the messages that the comparison needs."""

import math
import struct

HEADER = struct.Struct("<HHHdHBHB")  # sync, id, size, time, source, entity, destination, entity
SYNC = 0xFE54
LOG_BOOK_ENTRY, ESTIMATED_STATE, FOLLOW_REF_STATE, PLAN_CONTROL_STATE = 103, 350, 480, 560
STATE = struct.Struct("<dd18f")
FOLLOW_TIMEOUT = 6
PLAN_READY, PLAN_EXECUTING = 1, 3
AXIS_M, SQUARED_ECCENTRICITY = 6378137.0, 0.00669437999  # WGS 84


def crc_table():
    table = []
    for byte in range(256):
        for _ in range(8):
            byte = byte >> 1 ^ (0xA001 if byte & 1 else 0)
        table.append(byte)
    return table


TABLE = crc_table()


def crc(data):
    """CRC-16/ARC."""
    value = 0
    for byte in data:
        value = value >> 8 ^ TABLE[(value ^ byte) & 0xFF]
    return value


def text_at(payload, at):
    """A text, and where it ends."""
    size = struct.unpack_from("<H", payload, at)[0]
    return payload[at + 2:at + 2 + size].decode(errors="replace"), at + 2 + size


def radii(lat):
    """Of curvature across and along the meridian, m."""
    across_m = AXIS_M / math.sqrt(1 - SQUARED_ECCENTRICITY * math.sin(lat) ** 2)
    return across_m, across_m ** 3 * (1 - SQUARED_ECCENTRICITY) / AXIS_M ** 2


def decode_state(payload):
    """Where the vehicle takes itself to be, degrees, and its depth, m."""
    lat, lon, _height, north, east, *rest = STATE.unpack(payload)
    across_m, along_m = radii(lat)
    return {"lat": math.degrees(lat + north / along_m), "lon": math.degrees(lon + east / (across_m * math.cos(lat))),
            "depth": rest[-2]}


def decode_entry(payload):
    context, at = text_at(payload, 9)
    return {"context": context, "text": text_at(payload, at)[0]}


DECODERS = {
    ESTIMATED_STATE: decode_state,
    LOG_BOOK_ENTRY: decode_entry,
    FOLLOW_REF_STATE: lambda payload: {"state": payload[-2]},
    PLAN_CONTROL_STATE: lambda payload: {"state": payload[0], "plan": text_at(payload, 1)[0]},
}


class Reader:
    """Takes bytes, gives the messages that DECODERS has as (id, time in s, source, fields)."""

    def __init__(self):
        self.bytes = bytearray()

    def push(self, data):
        self.bytes += data
        found = []
        while len(self.bytes) >= HEADER.size + 2:
            sync, number, size, time, source, *_ = HEADER.unpack_from(self.bytes)
            end = HEADER.size + size
            if sync != SYNC:
                raise ValueError("the vehicle has sent something that is not a packet")
            if len(self.bytes) < end + 2:
                break
            if number in DECODERS:
                if crc(self.bytes[:end]) != struct.unpack_from("<H", self.bytes, end)[0]:
                    raise ValueError("a packet of the vehicle has a wrong CRC")
                found.append((number, time, source, DECODERS[number](bytes(self.bytes[HEADER.size:end]))))
            del self.bytes[:end + 2]
        return found
