# SPDX-License-Identifier: GPL-2.0-or-later
"""Finished friction logs in compact form, one archive a plan: fewer rows, the exact command in the
head; profiles as they are."""

import json
import os
import shlex
import typing

from mcawr import archive, friction_log
from mcawr.errors import BadInput, Exit, say
from mcawr.files import is_there, read_text, write

from . import folder as folders
from .plan import ROOT, Plan
from .quantities import Run

# variables of a command that do not change what a log says
SAME = ("name", "log", "pictures", "checkpoint", "frames", "profile")
SOMETIMES = ("depth", "upper_values")  # variables that not every run has


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


def _portable_script(path: str) -> str:
    """An input script named as from the checkout, wherever that was; another one as it is."""
    parts = path.split(os.sep)
    tails = (os.path.join(*parts[k:]) for k in range(1, len(parts)))
    return next((tail for tail in tails if os.path.exists(os.path.join(ROOT, tail))), path)


def portable(commands: list[str]) -> str:
    """The first of a run's commands, as long as the last one went, with lmp and the input script
    named as from the checkout, wherever both were."""
    words, last = (shlex.split(command) for command in (commands[0], commands[-1]))
    start = words.index("-in")
    words[start - 1] = "lmp"
    words[start + 1] = _portable_script(words[start + 1])
    words[words.index("ns") + 1] = last[last.index("ns") + 1]
    return shlex.join(words)


class _Made(typing.NamedTuple):
    """How a packed log was made: input script, {name: value} of its variables, rows in one."""

    script: str
    variables: dict[str, str]
    rows: int


def _made_with(path: str, head: list[str]) -> _Made:
    """From the head of a packed log. Raises BadInput."""
    for line in head:
        if line.startswith(friction_log.CAMPAIGN):
            try:
                made = json.loads(line.removeprefix(friction_log.CAMPAIGN))
                words = shlex.split(made["command"])
                at = [k for k, word in enumerate(words[:-2]) if word == "-var"]
                variables = {words[k + 1]: words[k + 2] for k in at}
                script, rows = words[words.index("-in") + 1], int(made["rows_averaged"])
                if rows >= 1:
                    return _Made(script, variables, rows)
            except (ValueError, RecursionError, LookupError, TypeError, AttributeError):
                break
    raise BadInput(f"{path}: not a packed log: its head has no command")


def _script_of(path: str) -> str:
    """What tells input scripts apart: one of the plan's own may have been moved with the plan."""
    return os.path.basename(path) if os.path.isabs(path) else path


def _check_made(path: str, run: Run, made: _Made) -> None:
    """A packed log was made with the run's values and input script. Raises BadInput."""
    none = dict.fromkeys(SOMETIMES, "")
    wanted = {"input": _script_of(_portable_script(run.input)), **none, **run.variables()}
    found = {"input": _script_of(made.script), **none, **made.variables}
    for name in {**wanted, **found}:
        value = wanted.get(name, "")
        had = found.get(name, value)  # an older log's command may lack a name
        if had != value and name not in SAME:
            raise BadInput(f"{path}: made with {name} '{had}', the plan's run has '{value}'")


def _check_whole(path: str, run: Run, made: _Made) -> None:
    """A packed log is as it was written and goes on to the end of the run. Raises BadInput."""
    steps = friction_log.read(path, ["step"]).columns["step"]
    every = int(run.variables()["every"])
    end = run.steps // every // made.rows * made.rows * every
    if not steps or steps[-1] < end:
        raise BadInput(
            f"{path}: ends at step {steps[-1] if steps else 0} of {end}: rows are missing"
        )


def members_of(plan: Plan, path: str | None) -> dict[str, dict[str, str]]:
    """{run's name: {member: text}} of the plan's runs whose logs stand in an archive. Raises
    BadInput: it cannot be read, or one of them was made with other values than the plan's, or with
    another input script, or is not whole."""
    if path is None:
        return {}
    found = {}
    for run in plan.runs:
        names = [f"{run.name}.{end}" for end in ("friction", "profile")]
        texts = {name: read_text(f"{path}/{name}") for name in names if is_there(f"{path}/{name}")}
        if names[0] not in texts:
            continue
        log = f"{path}/{names[0]}"
        made = _made_with(log, friction_log.Text.of(texts[names[0]]).head)
        _check_made(log, run, made)
        _check_whole(log, run, made)
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
