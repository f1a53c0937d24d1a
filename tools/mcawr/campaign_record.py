# SPDX-License-Identifier: GPL-2.0-or-later
"""What tools/campaign knows of a run, for scripts that draw it: run.json beside its files, and the
line of the head of a packed log."""

import json
import os
import shlex
from typing import Any

from .errors import BadInput
from .files import is_there, read_text
from .friction_log import head_of


def _record_beside(path: str) -> dict[str, Any]:
    """run.json in the folder of a file; empty where there is none. Raises BadInput."""
    record = os.path.join(os.path.dirname(path), "run.json")
    if not is_there(record):
        return {}
    try:
        found = json.loads(read_text(record))
        return {"parameters": dict(found["parameters"]), "attempts": list(found["attempts"])}
    except (ValueError, RecursionError, LookupError, TypeError):
        raise BadInput(f"{record}: not the record of a run of tools/campaign") from None


def timestep_of(path: str) -> float | None:
    """The step (ns) of the run that a file is of, from the command in run.json; None without."""
    for attempt in _record_beside(path).get("attempts", []):
        words = shlex.split(attempt["command"])
        for k, word in enumerate(words[:-2]):
            if (word, words[k + 1]) == ("-var", "dt"):
                return float(words[k + 2])
    return None


def temperature_of(path: str) -> float | None:
    """The temperature (K) that the plan of a log's run says; None where it says none."""
    found = _record_beside(path).get("parameters", {}).get("temperature")
    if found is None and is_there(path):
        found = head_of(path).get("campaign", {}).get("temperature")
    return None if found is None else float(found)
