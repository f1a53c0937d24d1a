# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/campaign as its tests call it: with a stand-in for lmp (fake_lmp.py)."""

import os
import pathlib
import re
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
CAMPAIGN = ROOT / "tools" / "campaign"
FAKE = pathlib.Path(__file__).with_name("fake_lmp.py")
REAL = pathlib.Path(os.environ.get("MCAWR_TEST_LMP", ROOT / "build" / "bin" / "lmp"))


HEAD = "format: mca-campaign 1\n"
PLAN = (
    HEAD
    + """title: three runs
defaults: {laws: b, ns: 2, row: 0.05, checkpoint: 0.2}
runs:
  - {v: [2, 5], seed: 7}
  - {name: soft, strength: 60}
"""
)


def environment(**more):
    inherited = {
        k: v
        for k, v in os.environ.items()
        if not k.startswith(("OMPI_", "PMIX_", "PMI_", "SLURM_"))
    }
    return {**inherited, "MCAWR_LMP": str(FAKE), "PYTHONDONTWRITEBYTECODE": "1", **more}


def campaign(*arguments, env=None, timeout=60, **more):
    return subprocess.run(
        [CAMPAIGN, *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=timeout,
        env=env or environment(),
        check=False,
        **more,
    )


def one_line(result, code, *parts):
    assert result.returncode == code, result.stdout + result.stderr
    assert result.stderr.count("\n") == 1
    for part in parts:
        assert part in result.stderr


def wait_for(condition, seconds=20):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def logs(folder):
    return {p.parent.name: p.read_text() for p in sorted(folder.glob("*/run.friction"))}


def edit(path, pattern, text):
    changed, count = re.subn(pattern, text, path.read_text(), count=1)
    assert count == 1
    path.write_text(changed)
