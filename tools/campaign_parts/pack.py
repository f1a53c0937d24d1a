"""Finished friction logs in compact form: fewer rows, the exact command in the head; profiles as they are."""
import json
import os
import shlex

from . import folder as folders
from .plan import ROOT

SUMS = ("broken", "formed")
MEANS = ("shear_stress", "normal_stress", "mu")  # of the interval; all else is the state at its end


def packed(text, rows, command):
    """A log whose rows are the means over `rows` rows of another; rows left over at the end are dropped."""
    lines = text.split("\n")[:-1]
    head = [line for line in lines if line.startswith("#")]
    names = lines[len(head)].split()
    table = [line.split() for line in lines[len(head) + 1:]]
    result = head + ["# campaign: " + json.dumps({"command": command, "rows_averaged": rows}), " ".join(names)]
    for begin in range(0, len(table) - rows + 1, rows):
        block = table[begin:begin + rows]
        row = []
        for column, name in enumerate(names):
            values = [float(line[column]) for line in block]
            if name in SUMS:
                row.append(f"{sum(values):.10g}")
            elif name in MEANS:
                row.append(f"{sum(values) / rows:.7g}")
            else:
                row.append(f"{float(block[-1][column]):.10g}")
        result.append(" ".join(row))
    return "\n".join(result) + "\n"


def portable(commands):
    """The first of a run's commands, as long as the last one went, with lmp and the input script named as from the
    checkout, wherever both were."""
    words, last = (shlex.split(command) for command in (commands[0], commands[-1]))
    start = words.index("-in")
    words[start - 1] = "lmp"
    parts = words[start + 1].split(os.sep)
    tails = (os.path.join(*parts[k:]) for k in range(1, len(parts)))
    words[start + 1] = next((tail for tail in tails if os.path.exists(os.path.join(ROOT, tail))), words[start + 1])
    words[words.index("ns") + 1] = last[last.index("ns") + 1]
    return shlex.join(words)


def pack(plan, top, target, rows):
    """Packs every finished run into target/NAME.friction."""
    try:
        os.makedirs(target, exist_ok=True)
    except OSError as error:
        raise folders.FolderError(f"{target}: cannot be written: {error.strerror}") from None
    count = 0
    for run in plan.runs:
        folder = folders.RunFolder(top, run)
        if not folder.is_finished():
            print(f"{run.name}: {folder.state()}, left out")
            continue
        with open(folder.file(folders.LOG), encoding="utf-8") as file:
            text = file.read()
        commands = [attempt["command"] for attempt in folder.record()["attempts"]]
        folders.write_whole(os.path.join(target, run.name + ".friction"), packed(text, rows, portable(commands)))
        if os.path.exists(folder.file("run.profile")):
            with open(folder.file("run.profile"), encoding="utf-8") as file:
                folders.write_whole(os.path.join(target, run.name + ".profile"), file.read())
        count += 1
    print(f"{count} logs in {target}")
    return 0
