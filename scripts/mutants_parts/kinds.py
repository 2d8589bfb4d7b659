# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""The list of kinds of faults: KINDS, by name. The functions register themselves; the order here is that of the table."""

from mutants_parts import kinds_structure, kinds_guards, kinds_values  # noqa: F401  pylint: disable=unused-import
from mutants_parts.kind import KINDS  # noqa: F401  pylint: disable=unused-import
