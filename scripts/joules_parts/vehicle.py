# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The vehicle file of a logged glider: a copy of the Slocum's with its own trim and the devices that it carried."""

import dataclasses
import re
import tomllib

NAME = "logged"

# The trim that the operator of comet found at sea two weeks before these flights: with the battery still it dives and climbs at 25 degrees.
TRIM = {"trim_pump_per_m3": 2013.03, "trim_battery_per_m": 24.26, "trim_offset": 0.25293}


@dataclasses.dataclass(frozen=True)
class Device:
    """A device without a row in the Slocum's power table, as it draws while it is on."""
    name: str
    watt: float
    spread: float
    source: str


# No public figure was found for these two: so they are what they take beyond others on the same vehicle, and no check of the table.
DEVICES = (
    Device("dvl", 1.95, 0.3, "dives of one flight less its climbs, on which the same devices are on but it does not ping"),
    Device("logger", 0.87, 0.3, "climbs of the flight that has it on, with the DVL that does not ping, less those of one that has not"),
)


def row(device, share):
    """A row of the power table: what the device takes on average, since it is on for this share of the time."""
    return (f'\n[[power.draw]]\ndevice = "{device.name}"\nwhen = "always"\nW = {device.watt * share:.4f}\n'
            f'spread = {device.spread}\nsource = "{device.source}"\n')


def by_the_table(slocum):
    """The devices of the Slocum's table that are on while the mission reads them: no SBC read them on these flights."""
    return [Device(one["device"], one["W"], one["spread"], one["source"])
            for one in tomllib.loads(slocum)["power"]["draw"] if one["when"] == "read"]


def platform_text(slocum, segment):
    """The vehicle file for a segment, from that of the Slocum."""
    text = re.sub(r'^name = "slocum"', f'name = "{NAME}"', slocum, count=1, flags=re.MULTILINE)
    text = re.sub(r"^board = .*\n", "", text, count=1, flags=re.MULTILINE)  # it carried no SBC
    for key, value in TRIM.items():
        text = re.sub(rf"^{key} = .*", f"{key} = {value}", text, count=1, flags=re.MULTILINE)
    rows = [row(device, segment.on[device.name]) for device in (*by_the_table(slocum), *DEVICES) if segment.on.get(device.name)]
    head, mark, tail = text.partition("\n[[power.draw]]")
    return head + "".join(rows) + mark + tail
