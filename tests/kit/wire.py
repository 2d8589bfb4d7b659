# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The bytes of the hook protocol, from hooks/protocol/README.md alone: slow, and written unlike the code that flies."""

import math
import struct

VERSION = 6
TYPES = {"Beacon": 0x01, "Welcome": 0x02, "Tick": 0x03, "Hello": 0x11, "Subscribe": 0x12, "Write": 0x13, "Transition": 0x14, "Done": 0x15,
         "Note": 0x16, "Nap": 0x17, "Log": 0x31}
MOST_PAYLOAD = 560
# (steps per unit, most steps) of the real numbers of an instruction, in the order of the check value.
REALS = {"depth": (1000, 3000000), "pitch": (100000, 3000000), "heading": (100000, 3000000), "latitude": (100000, 2000000000),
         "longitude": (100000, 2000000000)}


def reversed_bits(number, width):
    return int(f"{number:0{width}b}"[::-1], 2)


def crc16(given):
    """CRC-16/CCITT-FALSE. A start value of ones is the same as inverting the first bits of the message and its zeros behind."""
    padded = int.from_bytes(given + b"\0\0", "big") ^ 0xFFFF << 8 * len(given)
    for bit in range(padded.bit_length() - 1, 15, -1):
        if padded >> bit & 1:
            padded ^= 0x11021 << (bit - 16)
    return padded


def crc32c(given):
    """CRC-32C: reflected bytes, start and final xor of ones."""
    reflected = bytes(reversed_bits(byte, 8) for byte in given)
    padded = int.from_bytes(reflected + bytes(4), "big") ^ 0xFFFFFFFF << 8 * len(given)
    for bit in range(padded.bit_length() - 1, 31, -1):
        if padded >> bit & 1:
            padded ^= 0x11EDC6F41 << (bit - 32)
    return reversed_bits(padded, 32) ^ 0xFFFFFFFF


def short(kind):
    return kind in (TYPES["Beacon"], TYPES["Hello"])


def check_of(content):
    """The CRC of type, sequence and payload, as bytes."""
    return struct.pack("<H", crc16(content)) if short(content[0]) else struct.pack("<I", crc32c(content))


def frame(kind, sequence, payload):
    """A frame as it goes on the line."""
    content = bytes((kind, sequence)) + payload
    coded = b""
    for run in (content + check_of(content)).split(b"\0"):
        # A full group has no zero behind it: the rest of its run, even an empty one, is a group of its own.
        while len(run) >= 254:
            coded, run = coded + b"\xff" + run[:254], run[254:]
        coded += bytes((len(run) + 1,)) + run
    # At the end nothing needs to follow a full group.
    full = len(content + check_of(content)) - (content + check_of(content)).rfind(b"\0") - 1
    return (coded[:-1] if full and full % 254 == 0 else coded) + b"\0"


def unstuffed(coded):
    """What COBS has coded; None if it is not COBS."""
    plain = b""
    while coded:
        count = coded[0]
        if len(coded) < count:
            return None
        plain += coded[1:count] + (b"\0" if count < 255 else b"")
        last, coded = count, coded[count:]
    return plain[:-1] if last < 255 else plain


def good(coded):
    """(type, sequence, payload) of a whole frame, None if it is not good."""
    plain = unstuffed(coded)
    if plain is None or not plain or plain[0] not in TYPES.values():
        return None
    width = 2 if short(plain[0]) else 4
    if not width + 2 <= len(plain) <= width + 2 + MOST_PAYLOAD or check_of(plain[:-width]) != plain[-width:]:
        return None
    return plain[0], plain[1], plain[2:-width]


def counts(line):
    """How many frames of `line` are good, bad and repeated."""
    found = [good(coded) for coded in line.split(b"\0")[:-1] if coded]
    frames, bad, repeated, before = 0, 0, 0, None
    for one in found:
        if one is None:
            bad += 1
        elif one == before:
            repeated += 1
        else:
            frames, before = frames + 1, one
    return frames, bad, repeated


def f64_bits(value):
    return 0x7FF8000000000000 if math.isnan(value) else struct.unpack("<Q", struct.pack("<d", value))[0]


def as_float32(value):
    """The nearest 4-byte number: beyond the greatest by half a unit it is infinite."""
    try:
        return struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)


def to_wire(width, value):
    if width == 1:
        return 0x80 if math.isnan(value) else int(max(-127, min(127, value))) & 0xFF
    if math.isnan(value):
        return 0x7FC00000 if width == 4 else 0x7FF8000000000000
    return f64_bits(value) if width == 8 else struct.unpack("<I", struct.pack("<f", as_float32(value)))[0]


def from_wire(width, bits):
    return (math.nan if bits == 0x80 else struct.unpack("<b", bytes((bits,)))[0]) if width == 1 else \
        struct.unpack("<f" if width == 4 else "<d", bits.to_bytes(width, "little"))[0]


def steps_of(name, value):
    per_unit, most = REALS[name]
    if math.isnan(value) or value * per_unit <= -most:
        return -most
    return most if value * per_unit >= most else int(value * per_unit + math.copysign(0.5, value))


def in_steps(instruction):
    return dict(instruction, **{name: steps_of(name, instruction[name]) / REALS[name][0] for name in REALS})


def check_value(instruction):
    words = [instruction[name] for name in ("session", "sequence", "control", "vertical", "lateral")]
    checked = struct.pack("<IHBBB5i", *words, *(steps_of(name, instruction[name]) for name in REALS))
    return crc32c(checked + (struct.pack("<I", instruction["sampling"]) if instruction["sampling"] else b""))


def u24(value):
    return struct.pack("<I", value)[:3]


def said(value, most):
    """A text, with its length before it."""
    coded = value.encode()[:most]
    return bytes((len(coded),)) + coded


def number(value):
    return struct.pack("<Q", f64_bits(value))


PAYLOADS = {
    "Beacon": lambda version, offers, needs, dictionary, state: struct.pack("<BHHIB", version, offers, needs, dictionary, state),
    "Welcome": lambda virtual, link, newest: bytes((4 * virtual,)) + u24(link) + u24(newest),
    "Hello": lambda version, offers, needs, dictionary, link, name:
        struct.pack("<BHHI", version, offers, needs, dictionary) + u24(link) + said(name, 47),
    "Transition": lambda time, transition, came, goes, fired, cases: number(time) + struct.pack("<BIIIB", transition, came, goes, fired, cases),
    "Done": lambda answered, session, time, state, stack, phase:
        bytes((answered,)) + u24(session) + number(time) + struct.pack("<IBB", state, stack, phase),
    "Note": lambda time, kind, content: number(time) + bytes((kind,)) + said(content, 60),
}


def subscribe(wanted):
    """Of (sensor number, every, dead band)."""
    return bytes((len(wanted),)) + b"".join(struct.pack("<HBf", *one) for one in wanted)


def write(values):
    """Of (sensor number, width, value)."""
    return bytes((len(values),)) + b"".join(struct.pack("<H", sensor) + to_wire(width, value).to_bytes(width, "little")
                                            for sensor, width, value in values)


def nap(wake, length, conditions):
    """`conditions`: of (sensor number, kind, value)."""
    return struct.pack("<BHB", wake, length, len(conditions)) + b"".join(struct.pack("<HB", sensor, kind) + number(value)
                                                                         for sensor, kind, value in conditions)


def bit_map(bits):
    return bytes(sum(1 << place for place, bit in enumerate(bits[at:at + 8]) if bit) for at in range(0, len(bits), 8))


def tick(head, subscription, reports):
    """`reports`: of each subscribed sensor None (not reported), "same", or (width, value)."""
    link, time, cycle, state, answer, answered, session, clock = head["link"], head["time"], head["cycle"], head["state"], head["answer"], \
        head["answered"], head["session"], head["clock"]
    coded = bytes((4 * head["virtual"] + 8 * head["kept"],)) + u24(link) + struct.pack("<f", time) + u24(cycle)
    coded += struct.pack("<HBBH", crc16(subscription[1:]), state, answer, answered) + u24(session) + struct.pack("<I", clock)
    coded += bit_map([one is not None for one in reports]) + bit_map([isinstance(one, tuple) for one in reports])
    return coded + b"".join(to_wire(*one).to_bytes(one[0], "little") for one in reports if isinstance(one, tuple))
