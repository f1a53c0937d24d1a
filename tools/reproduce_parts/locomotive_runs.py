# SPDX-License-Identifier: GPL-2.0-or-later
"""The measured locomotive: laws of the rail steel from the friction logs of plan `rail`, and the
runs of wr_creep with them."""

import os
import subprocess
from collections.abc import Iterator, Sequence
from typing import Any

from mcawr import tables
from mcawr.archive import ENDING
from mcawr.errors import built, fail_as, say
from mcawr.files import make_folder, write_all

from . import patch_runs
from .patch_runs import Run

PLAN, LOGS_PLAN = "locomotive", "rail"
CASE = os.path.join(patch_runs.ROOT, "examples", "wheelrail", "eurosprinter.yaml")
MEASURED = os.path.join(patch_runs.ROOT, "examples", "wheelrail", "eurosprinter.csv")
LOGS = os.path.join(patch_runs.ROOT, "examples", "campaign", "logs", LOGS_PLAN + ENDING)
STEEL = os.path.join(patch_runs.ROOT, "potentials", "rail_steel.mca")
MODELS = ("bounded_rate", "table")  # of wr_fit; the first is `ours`, that of the smallest AICc
START_DISTANCE = 250  # nm, from which the logs are averaged
FIT = ["--material", STEEL, "--solid-only", "--start-distance", str(START_DISTANCE)]
PAPER = "paper"
AXES = (6.276252, 12.552426)  # mm, of the ellipse
SPEED = 10  # m/s
CREEPS = (1e-3, 2e-3, 3.5e-3, 5.4e-3, 7e-3, 9e-3, 0.011, 0.016, 0.025, 0.044, 0.066, 0.085, 0.107,
          0.13, 0.16, 0.2)  # fmt: skip
BAND = (1e-3, 2e-3, 3.5e-3, 5.4e-3, 0.011, 0.044, 0.107, 0.2)  # where the law's errors are drawn
SAMPLES = 100  # laws of a band
ROLLED = (1e-3, 5.4e-3, 0.025, 0.107, 0.2)  # of moving roughness
PASSES = 6  # of them; wr_creep leaves out the first two
SLOPES, SEEDS, ROLLED_SEEDS = (0.01, 0.02, 0.04), (1, 2, 3, 4, 5), (1, 2)
ONE_SLOPE = 0.01  # of what is shown for one roughness only


def run(
    law: str,
    words: str,
    mode: str,
    creeps: Sequence[float],
    *,
    slope: float = 0.0,
    seed: int = 0,
    band: bool = False,
) -> Run:
    """A run of one law and one surface. words: what friction={} says of the law; slope 0: smooth,
    else the rms slope of the profile along x; band: T/N with its limits by the law's errors."""
    rough = "none"
    if slope:
        rough = f"{{hurst: {patch_runs.HURST}, rms_slope: {slope * 2**0.5:.6g}, seed: {seed}, "
        rough += f"wavelength_min: {patch_runs.WAVE:g} mm, "
        rough += f"wavelength_max: {patch_runs.LONGEST:g} mm}}"
    changes = [
        f"friction={{{words}}}",
        f"roughness={rough}",
        "contact.hardness_limit=true",
        f"mode={'moving' if mode == 'moving' else 'frozen'}",
        f"contact.domain={patch_runs.BOX:g}",
        f"cells={patch_runs.cells_of(patch_runs.WAVE / patch_runs.CELLS, AXES)}",
        f"creep=[{', '.join(f'{xi:g}' for xi in creeps)}]",
        f"speed={SPEED:g} m/s",
        "sensitivities=false",
        "fields=none",
    ]
    if mode == "moving":
        changes += [f"moving.passes={PASSES}", "moving.start=steady"]
    if band:
        changes += ["uncertainty.method=sampled", f"uncertainty.samples={SAMPLES}"]
    labels = {"law": law, "mode": mode, "slope": slope, "seed": seed}
    name = f"{law}-{mode}-slope{slope:g}-seed{seed}" + ("-band" if band else "")
    name += f"-creep{creeps[0]:g}" if mode == "moving" else ""
    return Run(name, labels, tuple(changes), case=CASE, band=band)


def runs(laws: dict[str, str]) -> Iterator[Run]:
    """All of them. laws: files of MODELS' laws."""
    words = {law: f"law: {path}" for law, path in laws.items()}
    words[PAPER] = "law: bucher2006, local: true"
    ours = MODELS[0]
    for law, said in words.items():
        yield run(law, said, "smooth", CREEPS)
        for slope in SLOPES:
            for seed in SEEDS:
                yield run(law, said, "frozen", CREEPS, slope=slope, seed=seed)
    yield run(ours, words[ours], "smooth", BAND, band=True)
    yield run(ours, words[ours], "frozen", BAND, slope=ONE_SLOPE, seed=1, band=True)
    for seed in ROLLED_SEEDS:
        for creep in ROLLED:  # each by itself: they take the longest
            yield run(ours, words[ours], "moving", (creep,), slope=ONE_SLOPE, seed=seed)


def fit(model: str, logs: str, folder: str) -> tuple[str, dict[str, Any]]:
    """The law of wr_fit, in a file that is named after its checksum, so that runs with another law
    are others; (file, law)."""
    program = built("wr_fit")
    path = os.path.join(folder, f"{model}.json")
    words = [program, logs, *FIT, "--model", model, "-q", "-o", path]
    done = subprocess.run(words, capture_output=True, text=True, errors="replace", check=False)
    if done.returncode:
        fail_as(program, done)
    law = tables.read_json(path, "a law of wr_fit", patch_runs.record_of)
    named = os.path.join(folder, f"{model}-{law['checksum']}.json")
    os.replace(path, named)
    return named, law


def told(law: dict[str, Any]) -> str:
    """The parameters of a fitted law with their standard errors, in a line."""
    found = law["report"]["fit"]["parameters"]
    numbers = (
        f"{name} = {p['value']:.3g} "
        + ("at its bound" if p["at_bound"] else f"+- {p['standard_error']:.2g}")
        for name, p in found.items()
    )
    return f"{', '.join(numbers)}; {law['n']} conditions, rms {100 * law['rms_relative']:.1f} %"


def logs_in(top: str) -> str:
    """Where the friction logs of the laws are: TOP/rail, or else the shipped ones."""
    made = os.path.join(top, LOGS_PLAN)
    return made if os.path.isdir(made) else LOGS


def make(_plan: str, top: str, jobs: int) -> None:
    """The laws, the runs in TOP/locomotive and their table TOP/locomotive.csv."""
    folder = os.path.join(top, PLAN)
    make_folder(folder)
    logs = logs_in(top)
    say(f"laws of the rail steel from {logs}")
    fits = {model: fit(model, logs, folder) for model in MODELS}
    every = list(runs({model: path for model, (path, _) in fits.items()}))
    patch_runs.compute(every, folder, jobs)
    law = fits[MODELS[0]][1]
    note = f"# law {MODELS[0]}: {told(law)}\n"
    found, _ = patch_runs.table(every, folder, HEAD + note)
    write_all({folder + ".csv": found})


HEAD = (
    "# A measured locomotive (examples/wheelrail/eurosprinter.yaml), by tools/reproduce locomotive "
    "--run\n"
    "# law: bounded and table: of the rail steel; mode: surface; slope: rms of the profile along "
    "x; law_low, law_high: 95 % limits by the law's errors; temperature: K; peak_pressure: MPa; "
    "real_area: mm2; a point without traction_ratio has no solution (the strength ends)\n"
)
