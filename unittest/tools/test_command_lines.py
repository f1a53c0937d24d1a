# SPDX-License-Identifier: GPL-2.0-or-later
"""Command lines of the scripts: every option refuses what it cannot take, in one line, before a
file is read or written."""

import pytest

FEW = ("nan", "-nan", "inf", "-inf", "1e308", "1e999", "0x10", "1 500", "1_000", "", "x", "²")
NUMBER = (*FEW, "0", "-1", "-1e-3", "1e-300")
WHOLE = (*NUMBER, "1.5", "9" * 30)
# script: what it needs; {option: what it refuses}
OPTIONS = {
    "plot_creep.py": (["a.csv"], {"-o": [""]}),
    "plot_fit.py": (["a.json"], {"-o": [""]}),
    "plot_series.py": (
        ["a.json", "--against", "pressure"],
        {"-o": [""], "--against": ["", "time"]},
    ),
    "plot_benchmark.py": (["a.json", "-o", "a.png"], {"-o": [""]}),
    "plot_friction.py": (["a.friction"], {"-o": [""], "--runs": [""], "--window": NUMBER}),
    "plot_fragment.py": (
        ["a.dump"],
        {
            "-o": [""],
            "--frame": [*FEW, "1.5"],
            "--diameter": NUMBER,
            "--timestep": NUMBER,
            "--rate": NUMBER,
            "--dpi": NUMBER,
        },
    ),
    "plot_layer.py": (["a.profile"], {"-o": [""], "--csv": [""], "--step": NUMBER}),
    "plot_patch.py": (["curves", "a.csv"], {"-o": [""], "--polach": [""]}),
    "plot_shakedown.py": (
        ["a.csv", "--shear-yield", "500", "-o", "a.png"],
        {"-o": [""], "--shear-yield": NUMBER},
    ),
    "contact_inp.py": (["a.inp"], {"-o": [""]}),
    "creep_table.py": (
        ["a.yaml", "-o", "a.csv"],
        {
            "-o": [""],
            "--wr-creep": [""],
            "--tolerance": NUMBER,
            "--most": WHOLE,
            "--over": ["", "a", "a=", "a=1,x", "a=2, 1", "a=1 m, 2 mm"],
        },
    ),
    "plot_wheelrail.py": (
        ["fig14"],
        {"-o": [""], "--wr-creep": [""], "--seed": [w for w in WHOLE if w != "0"]},
    ),
    "plot_mechanics.py": (["waves"], {"-o": [""], "--build": [""]}),
    "dump_to_vtk.py": (["a.dump"], {"-o": ["", "a/"], "--links": [""], "--timestep": NUMBER}),
    "benchmark.py": (
        [],
        {
            "-o": [""],
            "--build": [""],
            "--rounds": WHOLE,
            "--scale": NUMBER,
            "--sizes": [*WHOLE, "7"],
            "--ranks": WHOLE,
            "--partitions": [w for w in WHOLE if w != "0"],
            "--against": [""],
            "--laws": ["", "none"],
            "--samples": [""],
            "--compare": [""],
        },
    ),
    "reproduce": (["fig4"], {"-o": [""], "--logs": [""], "--run": [""], "-j": WHOLE}),
    "campaign run": (
        ["smoke", "-o", "out"],
        {"-o": [""], "-j": WHOLE, "--ranks": WHOLE, "--launcher": ["", "a 'b"]},
    ),
    "campaign one": (
        ["smoke", "-o", "out", "--index", "0"],
        {"--index": [w for w in WHOLE if w != "0"]},
    ),
    "campaign pack": (
        ["smoke", "-o", "out", "--to", "to.tar.xz"],
        {"--to": ["", "to"], "--rows": WHOLE},
    ),
}


@pytest.mark.parametrize(
    "script, option", [(script, option) for script, (_, all_) in OPTIONS.items() for option in all_]
)
def test_values(script, option, call, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    needed, options = OPTIONS[script]
    for value in options[option]:
        program, *command = script.split()
        line = call.refused(2, program, *command, *needed, option, value)
        assert option in line and value in line, line
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("script", OPTIONS)
def test_unknown_option_and_too_little(script, call, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    program, *command = script.split()
    needed, _ = OPTIONS[script]
    assert "--nonsense" in call.refused(2, program, *command, *needed, "--nonsense")
    if needed:
        call.refused(2, program, *command)
    assert list(tmp_path.iterdir()) == []
