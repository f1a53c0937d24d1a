# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs lmp with our plugin for the tests, and reads what it writes."""

import os
import pathlib
import re
import shutil
import subprocess

import numpy as np
from single_rank import alone

HERE = pathlib.Path(__file__).resolve().parent
INPUTS = HERE / "inputs"
LMP = os.environ["MCA_LMP"]
PLUGIN = os.environ["MCA_PLUGIN"]
MPIRUN = os.environ.get("MCA_MPIRUN") or shutil.which("mpirun")
TIMEOUT = 0.5 * float(os.environ.get("MCA_TIMEOUT", 600))  # of a run, seconds
STEEL = pathlib.Path(os.environ["PROJECT_SOURCE"]) / "potentials" / "steel.mca"


def periodic_block(columns=10):
    """Commands that make a periodic hexagonal block of 8 rows, without a pair style."""
    return f"""
units nano
dimension 2
atom_style sphere
boundary p p p
lattice hex 2.5
region box block 0 $({columns}*2.5) 0 $(8*2.5*sqrt(3)/2) -0.5 0.5 units box
create_box 1 box
create_atoms 1 box
timestep 5e-5
"""


ENVIRONMENT = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    OMPI_MCA_rmaps_base_oversubscribe="1",
    OMPI_MCA_mpi_yield_when_idle="1",
    OMPI_MCA_pml="ob1",  # ranks of one machine: no network is looked for
    OMPI_MCA_btl="self,vader",
    OMP_NUM_THREADS="1",
)


class Result:
    """What a run left: exit status, screen, and the thermo tables of its log as columns."""

    def __init__(self, done, folder):
        self.rc, self.out, self.err = done.returncode, done.stdout, done.stderr
        self.folder = folder

    @property
    def thermo(self):
        """List of {column: array}, one a run command."""
        tables, columns = [], None
        for line in self.out.splitlines():
            words = line.split()
            if words[:1] == ["Step"]:
                columns, rows = words, []
            elif columns and line.startswith("Loop time"):
                data = np.array(rows)
                tables.append({name: data[:, k] for k, name in enumerate(columns)})
                columns = None
            elif columns:
                try:
                    row = [float(w) for w in words]
                except ValueError:
                    continue
                if len(row) == len(columns):
                    rows.append(row)
        return tables

    @property
    def error_lines(self):
        return [s for s in (self.out + self.err).splitlines() if s.startswith("ERROR")]


def lmp(script, folder, ranks=1, env=None, check=True, launcher=LMP, **variables):
    """Runs an input: the name of a file in inputs/, or the text itself. Variables become -var;
    the commands `before` (the box), `extra` (before the run) and `after` go by files."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    path = INPUTS / script if "\n" not in script else folder / "in.test"
    if "\n" in script:
        path.write_text(script)
    for name in ("before", "extra", "after"):
        if name in variables:
            commands = folder / f"{name}.txt"
            commands.write_text(variables[name] + "\n")
            variables[name] = commands
    command = [launcher, "-in", str(path), "-log", "none"]
    for name, value in variables.items():
        command += [
            "-var",
            name,
            *(map(str, value) if isinstance(value, (list, tuple)) else [str(value)]),
        ]
    if ranks > 1:
        command = [MPIRUN, "--oversubscribe", "--bind-to", "none", "-np", str(ranks)] + command
    done = subprocess.run(
        command,
        cwd=folder,
        env=ENVIRONMENT | (alone(folder) if ranks == 1 else {}) | (env or {}),
        text=True,
        capture_output=True,
        timeout=TIMEOUT,
    )
    result = Result(done, folder)
    if check:
        assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-2000:]
    return result


def fails(script, folder, *parts, **more):
    """The run must end with a non-zero status and say all parts in one ERROR line."""
    result = lmp(script, folder, check=False, **more)
    assert result.rc != 0, "the run went through:\n" + result.out[-2000:]
    lines = result.error_lines
    assert lines, result.out[-2000:] + result.err[-2000:]
    assert any(all(part in line for part in parts) for line in lines), (parts, lines)
    return result


def dump(path):
    """Frames of a custom or local dump: [(step, {column: array})], atoms in the order of their
    id."""
    frames, lines, k = [], pathlib.Path(path).read_text().splitlines(), 0
    while k < len(lines):
        assert lines[k] == "ITEM: TIMESTEP"
        step, n = int(lines[k + 1]), int(lines[k + 3])
        k += 8
        columns = lines[k].split()[2:]
        data = np.array([s.split() for s in lines[k + 1 : k + 1 + n]], dtype=float).reshape(
            n, len(columns)
        )
        k += 1 + n
        if columns and columns[0] == "id":
            data = data[np.argsort(data[:, 0])]
        frames.append((step, {c: data[:, m] for m, c in enumerate(columns)}))
    return frames


def friction_log(path):
    """(header text of the YAML lines, {column: array}) of a friction log."""
    head, rows, columns = [], [], None
    for line in pathlib.Path(path).read_text().splitlines():
        if line.startswith("#"):
            head.append(line[2:])
        elif re.match(r"[a-z]", line):
            columns = line.split()
        else:
            rows.append([float(w) for w in line.split()])
    data = np.array(rows).reshape(len(rows), -1)
    return "\n".join(head), {c: data[:, k] for k, c in enumerate(columns)} if rows else {}


def largest_difference(a, b, columns, scale=None):
    """Largest difference of both frames' columns over the largest value of the second."""
    worst = 0.0
    for c in columns:
        size = scale or max(np.abs(b[c]).max(), 1e-300)
        worst = max(worst, np.abs(a[c] - b[c]).max() / size)
    return worst
