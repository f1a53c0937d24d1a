# SPDX-License-Identifier: GPL-2.0-or-later
"""Finished friction logs in compact form, one archive a plan: fewer rows, the exact command in the
head; profiles as they are."""

import json
import os
import shlex

from mcawr import archive, friction_log
from mcawr.errors import BadInput, Exit, say
from mcawr.files import is_there, read_text, write

from . import folder as folders
from .plan import ROOT, Plan


def packed(text: str, rows: int, command: str, temperature: float | None = None) -> str:
    """A whole log whose rows are the means over `rows` rows of another; rows left over at the end
    are dropped."""
    log = friction_log.Text.of(text)
    names = [name for name in log.names if name != friction_log.CHECK]
    table = [[float(word) for word in line.split()[: len(names)]] for line in log.rows]
    made: dict[str, object] = {"command": command, "rows_averaged": rows}
    if temperature is not None:
        made["temperature"] = temperature  # the command has the material's numbers alone
    result = [
        *log.head,
        friction_log.CAMPAIGN + json.dumps(made),
        " ".join([*names, friction_log.CHECK]),
    ]
    checks = friction_log.Checks(result)
    for begin in range(0, len(table) - rows + 1, rows):
        block = table[begin : begin + rows]
        row = []
        for column, name in enumerate(names):
            values = [line[column] for line in block]
            if name in friction_log.SUMS:
                row.append(f"{sum(values):.10g}")
            elif name in friction_log.MEANS:
                row.append(f"{sum(values) / rows:.7g}")
            else:
                row.append(f"{values[-1]:.10g}")
        result.append(checks.of(" ".join(row)))
    return "\n".join(result) + "\n"


def portable(commands: list[str]) -> str:
    """The first of a run's commands, as long as the last one went, with lmp and the input script
    named as from the checkout, wherever both were."""
    words, last = (shlex.split(command) for command in (commands[0], commands[-1]))
    start = words.index("-in")
    words[start - 1] = "lmp"
    parts = words[start + 1].split(os.sep)
    tails = (os.path.join(*parts[k:]) for k in range(1, len(parts)))
    words[start + 1] = next(
        (tail for tail in tails if os.path.exists(os.path.join(ROOT, tail))), words[start + 1]
    )
    words[words.index("ns") + 1] = last[last.index("ns") + 1]
    return shlex.join(words)


def _made_with(path: str) -> dict[str, str]:
    """{name: value} of the input script's variables in the command of a packed log. Raises
    BadInput."""
    for line in friction_log.Text.of(read_text(path)).head:
        if line.startswith(friction_log.CAMPAIGN):
            try:
                made = json.loads(line.removeprefix(friction_log.CAMPAIGN))
                words = shlex.split(made["command"])
                at = [k for k, word in enumerate(words[:-2]) if word == "-var"]
                return {words[k + 1]: words[k + 2] for k in at}
            except (ValueError, RecursionError, LookupError, TypeError, AttributeError):
                break
    raise BadInput(f"{path}: not a packed log: its head has no command")


def members_of(plan: Plan, path: str | None) -> dict[str, dict[str, str]]:
    """{run's name: {member: text}} of the plan's runs whose logs stand in an archive. Raises
    BadInput: it cannot be read, or one of them was made with other values than the plan's."""
    if path is None:
        return {}
    found = {}
    for run in plan.runs:
        names = [f"{run.name}.{end}" for end in ("friction", "profile")]
        texts = {name: read_text(f"{path}/{name}") for name in names if is_there(f"{path}/{name}")}
        if names[0] not in texts:
            continue
        made = _made_with(f"{path}/{names[0]}")
        for name, value in run.variables().items():
            if made.get(name, value) != value:
                raise BadInput(
                    f"{path}/{names[0]}: made with {name} '{made[name]}', the plan's run has "
                    f"'{value}'"
                )
        found[run.name] = texts
    return found


def pack(plan: Plan, top: str, target: str, rows: int, earlier: str | None) -> int:
    """Packs every finished run as NAME.friction, and its profile as NAME.profile, into the archive
    target: all of them, or none if one cannot be packed; no archive without a finished run.

    earlier: an archive from which the plan's other runs are taken over, or None. Returns 1 without
    an archive, or where a failed run is left out, else 0.
    """
    members: dict[str, str] = {}
    before, count, failed = members_of(plan, earlier), 0, False
    for run in plan.runs:
        folder = folders.RunFolder(top, run)
        folder.check_same()
        if not folder.is_finished() and run.name in before:
            members |= before[run.name]
            count += 1
            continue
        if not folder.is_finished():
            say(f"{run.name}: {folder.state()}, left out")
            failed = failed or folder.failure() is not None
            continue
        command = portable([attempt["command"] for attempt in folder.record()["attempts"]])
        text = packed(read_text(folder.file(folders.LOG)), rows, command, run.values["temperature"])
        if not text.split("\n")[-2][:1].isdigit():
            raise folders.FolderError(
                f"--rows {rows}: {folder.file(folders.LOG)} has fewer rows", Exit.USAGE
            )
        members[run.name + ".friction"] = text
        if profile := folder.text("run.profile"):
            members[run.name + ".profile"] = profile
        count += 1
    if not members:
        say(f"{target} is not written: no run is finished")
        return 1
    write(target, archive.pack(members))
    say(f"{count} logs in {target}")
    return 1 if failed else 0
