# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Which tests can see a fault in which folder: programs of the build, the quick ones first."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Suite:
    program: str  # below the build folder
    only: str = "*"  # as for --gtest_filter
    runs: tuple = ()  # programs of the build that it runs, linked with the fault too: (environment variable, program) each
    itself: bool = True  # it is linked with the fault, and not only what it runs


GLIDERCC = {"runs": (("GLIDERCC", "bin/glidercc"),), "itself": False}

HOOKS = Suite("tests/hooks_test")
IMC = Suite("tests/imc_test")
RECON = Suite("tests/recon_test")
MICRO_MODEM = Suite("tests/micro_modem_test")
SHARE = Suite("tests/share_test")
TALKER = Suite("tests/talker_test")
RECON_SEAT = Suite("tests/recon_backseat_test")
POSIX = Suite("tests/hooks_posix_test")
RUNTIME = Suite("tests/runtime_test")
NUMBERS = Suite("tests/numbers_test")
CARD = Suite("tests/card_test")
C_MISSION = Suite("tests/c_mission_test", runs=(("GLIDER_FIGURE2", "bin/missions/figure2_c"),
                                                ("GLIDER_FIGURE3", "bin/missions/figure3_c")))
IR = Suite("tests/ir_test")
GOLDEN = Suite("tests/golden_test")
RANDOM = Suite("tests/random_missions_test")
OPERATIONS = Suite("tests/operations_judged_test")
JUDGED = Suite("tests/random_missions_judged_test")
PROOFS = Suite("tests/proofs_test")
FRONTEND = Suite("tests/frontend_test")
CODEGEN = Suite("tests/codegen_test")
VALIDATE = Suite("tests/validate_test")
PHYSICS = Suite("tests/simulator_physics_test")
FLIGHT = Suite("tests/simulator_flight_test")
SBC = Suite("tests/simulator_sbc_test")
REPORT = Suite("tests/report_test")
SUPPORT = Suite("tests/support_test")
SLOCUM = Suite("tests/mission_files_test")
JUDGES = Suite("tests/slocum_oracles_test")
RULES = Suite("tests/slocum_rules_test")
COMMAND = Suite("tests/command_test", **GLIDERCC)
DRIVER = Suite("tests/driver_test")
UNIT_FLIGHTS = Suite("tests/flights_unit_test")
CAMPAIGN = Suite("tests/campaign_test")
LOGS = Suite("tests/logs_test")
ANALYSIS = Suite("tests/analysis_test")
SPIN = Suite("tests/spin_test", runs=(("GLIDERCC", "bin/glidercc"),))  # skips where there is no spin
DOCS = Suite("tests/docs_test", **GLIDERCC)
FLIGHTS = Suite("tests/flights_test", **GLIDERCC)
FLOWN_CAMPAIGNS = Suite("tests/flights_test", "Campaign*:*/Campaign*", **GLIDERCC)
FLOWN_LOGS = Suite("tests/flights_test", "MissionLog.*", **GLIDERCC)

# The longest prefix that fits a file has the say.
SUITES = {
    "hooks": (HOOKS, RUNTIME),
    "hooks/imc": (IMC,),
    "hooks/recon": (RECON,),
    "hooks/micro_modem": (MICRO_MODEM,),
    "hooks/share": (SHARE,),
    "hooks/transport": (POSIX, HOOKS, CARD, C_MISSION),
    "runtime": (RUNTIME, CARD, C_MISSION, OPERATIONS, JUDGED),
    "runtime/recon": (RECON_SEAT,),
    "runtime/talk": (TALKER,),
    "runtime/c": (C_MISSION, CARD, RUNTIME),
    "runtime/board": (CARD, C_MISSION),
    "runtime/numbers": (NUMBERS, RUNTIME, OPERATIONS),
    "ir": (IR, RANDOM, GOLDEN, FRONTEND, JUDGED, COMMAND),
    "ir/eval": (IR, OPERATIONS, RANDOM, JUDGED),
    "ir/opt": (IR, RANDOM, GOLDEN, JUDGED),
    "ir/verify": (IR, RANDOM, GOLDEN, FRONTEND, JUDGED, COMMAND, SPIN),
    "ir/prove": (IR, GOLDEN, PROOFS, COMMAND),
    "codegen": (CODEGEN, OPERATIONS, JUDGED, COMMAND),
    "codegen/llvm/validate": (VALIDATE,),
    "frontend": (FRONTEND, GOLDEN, COMMAND, DOCS),
    "simulator": (PHYSICS, FLIGHT, SBC, FLIGHTS),
    "report": (REPORT, COMMAND),
    "support": (SUPPORT, FRONTEND, REPORT, GOLDEN),
    "vehicles/slocum": (SLOCUM, COMMAND),
    "vehicles/slocum/oracles": (JUDGES, FLIGHTS),
    "vehicles/slocum/rules": (RULES, COMMAND),
    "vehicles": (COMMAND, CAMPAIGN),
    "compiler": (COMMAND, GOLDEN),
    "flights": (UNIT_FLIGHTS, COMMAND, FLIGHTS),
    "analysis": (ANALYSIS, COMMAND, FLIGHTS),
    "campaign": (CAMPAIGN, FLOWN_CAMPAIGNS),
    "logs": (LOGS, RUNTIME, FLOWN_LOGS),
    "driver": (DRIVER, COMMAND, FLIGHTS),
}


def suites_of(path):
    """The suites that can see a fault in the file, the quick ones first; none if no test is known to."""
    fitting = [prefix for prefix in SUITES if str(path).startswith(prefix + "/")]
    return SUITES[max(fitting, key=len)] if fitting else ()
