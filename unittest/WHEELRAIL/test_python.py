# SPDX-License-Identifier: GPL-2.0-or-later
"""The Python module wheelrail gives what wr_creep and wr_fit write, with the same faults."""

import ast
import csv
import inspect
import json
import os
import pathlib
import re
import signal
import subprocess
import threading
import time

import friction_logs
import numpy as np
import pytest
import wheelrail

SOURCE = pathlib.Path(os.environ["PROJECT_SOURCE"])
BIN = pathlib.Path(os.environ["WHEELRAIL_BIN"])

PATCH = {
    "contact": {
        "load": "100 kN",
        "radii": {"wheel_rolling": "0.5 m", "rail_profile": "0.3 m"},
        "youngs_modulus": "210 GPa",
        "poissons_ratio": 0.3,
    },
    "friction": {"law": "constant", "mu": 0.3},
    "thermal": "off",
    "speed": "20 m/s",
    "creep": [0.0005, 0.001, 0.002],
    "cells": [32, 30],
}
LINE = {
    "contact": {
        "load_per_length": "4000 N/mm",
        "radius": "0.5 m",
        "youngs_modulus": "206 GPa",
        "poissons_ratio": 0.3,
    },
    "friction": {"law": "constant", "mu": 0.3},
    "thermal": "off",
    "speed": "20 m/s",
    "creep": [0.001, 0.002],
    "cells": 256,
}
MM = {"mm": 1e-3, "N mm": 1e-3, "N/mm": 1e3, "MPa": 1e6, "mm2": 1e-6, "1/mm": 1e3}


def program(name, *words, code=0):
    done = subprocess.run([BIN / name, *map(str, words)], capture_output=True, text=True)
    assert done.returncode == code, done.stderr
    return done


def written(path):
    """Columns of a table in SI units, with the units as its head says them."""
    text = path.read_text()
    head = [line for line in text.splitlines() if line.startswith("#")][-1][1:]
    rows = list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))
    unit = {}
    for names, one in re.findall(r"([\w, ]+): ([\w/ ]+)(?:;|$)", head):
        unit.update({name.strip(): one for name in names.split(",")})
    return {
        name: np.array([float(row[name]) for row in rows]) * MM.get(unit.get(name), 1.0)
        for name in rows[0]
    }


def test_results_are_those_of_wr_creep(tmp_path):
    """Every example that a second is enough for, all columns to the digits of the file."""
    for name in ("patch", "table2", "static", "cattaneo"):
        case = SOURCE / f"examples/wheelrail/{name}.yaml"
        if not case.exists():
            continue
        program("wr_creep", case, "-o", tmp_path / name)
        result = wheelrail.Case(case).solve()
        (path,) = [p for p in (tmp_path / name).glob("*.csv") if p.stem in ("creep", "static")]
        columns = written(path)
        assert len(columns) > 4 and len(result) == len(columns["traction_ratio"])
        for column, values in columns.items():
            # the fewest digits that a column has
            assert result[column] == pytest.approx(values, rel=1e-5), f"{name}: {column}"
        summary = json.loads((tmp_path / name / "summary.json").read_text())
        assert result.summary["case"] == summary["case"]
        assert result.warnings == summary["warnings"]


def test_units_say_what_the_numbers_are_in():
    units = wheelrail.Case(PATCH).solve().units
    assert units["moment_z"] == "N m" and units["approach"] == "m" and units["spin"] == "1/m"
    assert units["peak_pressure"] == "Pa" and units["creep"] == "1" and units["load"] == "N"
    assert wheelrail.Case(LINE).solve().units["traction"] == "N/m"


def test_a_dict_is_a_case_file(tmp_path):
    file = tmp_path / "case.yaml"
    file.write_text(json.dumps(PATCH))
    case = wheelrail.Case(PATCH)
    assert case.text == wheelrail.Case(file).text == wheelrail.Case(str(file)).text
    numpy = {**PATCH, "creep": np.array(PATCH["creep"]), "cells": (np.int64(32), 30)}
    assert wheelrail.Case(numpy).text == case.text
    flat = wheelrail.Case(file, {"creep": [0.01], "friction.mu": np.float64(0.2)})
    assert "creep: [0.01]" in flat.text and "mu: 0.2" in flat.text
    again = wheelrail.Case(PATCH, {"contact.load": "50 kN", "sensitivities": False})
    assert "load: 50 kN" in again.text and "sensitivities: false" in again.text
    file.write_text(case.text)
    assert wheelrail.Case(file).text == case.text


def test_numbers_of_numpy_keep_their_digits():
    creep = np.geomspace(1e-4, 1e-2, 5)
    result = wheelrail.Case(PATCH, {"creep": creep, "sensitivities": False}).solve()
    assert np.array_equal(result["creep"], creep)


def test_files_are_looked_for_beside_the_case(tmp_path, monkeypatch):
    (tmp_path / "there").mkdir()
    (tmp_path / "there/mu.csv").write_text((SOURCE / "examples/wheelrail/friction.csv").read_text())
    (tmp_path / "there/case.yaml").write_text(json.dumps({**PATCH, "friction": {"law": "mu.csv"}}))
    monkeypatch.chdir(tmp_path)
    case = wheelrail.Case("there/case.yaml")
    assert case.files == ["there/mu.csv"] and case.law.description


def test_fields_carry_the_load():
    case = wheelrail.Case(PATCH, {"fields": "all"})
    result = case.solve()
    assert sorted(result.fields) == [1, 2, 3]
    for number, fields in result.fields.items():
        assert fields["pressure"].shape == (30, 32) == (len(fields["y"]), len(fields["x"]))
        cell = np.diff(fields["x"])[0] * np.diff(fields["y"])[0]
        assert fields["pressure"].sum() * cell == pytest.approx(100e3)
        assert fields["traction_x"].sum() * cell == pytest.approx(result["force_x"][number - 1])
        bound = fields["mu"] * fields["pressure"]
        size = np.hypot(fields["traction_x"], fields["traction_y"])
        assert (size <= bound * (1 + 1e-4)).all()
        assert size[fields["state"] == 2] == pytest.approx(bound[fields["state"] == 2], rel=1e-3)
    line = wheelrail.Case(LINE).solve()
    (fields,) = line.fields.values()
    assert fields["pressure"].sum() * np.diff(fields["x"])[0] == pytest.approx(4e6)
    assert wheelrail.Case(PATCH, {"fields": "none"}).solve().fields == {}


def test_series_of_mode_moving():
    changes = {"mode": "moving", "creep": 0.001, "moving.passes": 4, "cells": [24, 24]}
    result = wheelrail.Case(PATCH, changes).solve()
    series = result.series[1]
    half = len(series["force_x"]) // 2
    assert series["force_x"][half:].mean() == pytest.approx(result["force_x"][0])
    assert (np.diff(series["distance"]) > 0).all()
    assert np.isfinite(result["force_x_se"]).all()


def test_columns_are_those_of_the_files(tmp_path):
    """Wear where it is asked for; no columns of other modes."""
    wear = {"wear": {"law": "t_gamma"}}
    case = wheelrail.Case(PATCH, wear)
    result, contact = case.solve(), wheelrail.Contact(case)
    contact.step(0.001)
    (tmp_path / "case.yaml").write_text(case.text)
    program("wr_creep", tmp_path / "case.yaml", "-o", tmp_path)
    head = next(
        line for line in (tmp_path / "creep.csv").read_text().splitlines() if line[0] != "#"
    )
    assert "wear_volume" in head
    assert set(head.split(",")) == set(result.columns) - {"surface"} == set(contact.values())
    moving = {"mode": "moving", "moving.passes": 2, "cells": [24, 24], "creep": 0.001}
    series = wheelrail.Case(PATCH, moving).solve().series[1]
    assert "distance" in series and not {"shift_x", "wear_volume"} & set(series)


def test_sequence():
    """Instants of a sequence have fields of their own; stages of mode static are a series, too."""
    case = {key: value for key, value in PATCH.items() if key != "creep"}
    times = {"time": ["0 s", "0.5 ms"], "creep": [0.0, 0.001], "fields": ["0.2 ms", "0.4 ms"]}
    result = wheelrail.Case(case, {"mode": "moving", "sequence": times, "cells": [24, 24]}).solve()
    assert set(result.fields) == {1, (1, 1), (1, 2)}
    at = np.searchsorted(result.series[1]["time"], 0.4e-3 - 1e-9)
    fields = result.fields[1, 2]
    cell = np.diff(fields["x"])[0] * np.diff(fields["y"])[0]
    steps = result.series[1]["force_x"]
    nearest = np.abs(steps - fields["traction_x"].sum() * cell).argmin()
    assert abs(nearest - at) <= 1
    assert steps[nearest] == pytest.approx(fields["traction_x"].sum() * cell)


def test_law_is_eq2():
    law = wheelrail.Case(PATCH, {"friction": {"law": "bucher2006", "local": True}}).law
    assert law.description
    pressure = np.array([[100e6, 500e6], [1e9, 2e9]])
    speed, E, rho, strength = 0.4, 206e9, 7800.0, 1e9
    kappa1, kappa2 = rho * E * speed**2 / strength**2, pressure * E / strength**2
    assert law.mu(pressure, speed) == pytest.approx(friction_logs.eq2(kappa1, kappa2), rel=1e-12)
    warm = law.mu(1e9, speed, temperature=[0.0, 300.0])
    assert warm.shape == (2,) and warm[0] != warm[1]
    with pytest.raises(
        wheelrail.UsageError, match="pressure: '-1' is not allowed, must be a number >="
    ):
        law.mu(-1.0, speed)


def test_law_refuses_what_is_no_state():
    """Nothing is asked for, or what is asked for is said to be wrong."""
    laws = [{"law": "bucher2006", "local": True}, {"law": "bucher2006"}]
    laws += [{"law": str(SOURCE / "examples/wheelrail/friction.csv")}]
    for friction in [*laws, {"law": "constant", "mu": 0.3}]:
        law = wheelrail.Case(PATCH, {"friction": friction}).law
        assert law.mu([], 0.2).shape == (0,) and law.mu(np.empty((2, 0)), 0.2).shape == (2, 0)
        for arguments, words in {
            ((1e9, np.nan), 0.2): "pressure: 'nan' is not allowed, must be a number >= 0",
            ((np.nan, 1e9), 0.2): "pressure: 'nan' is not allowed",
            (np.inf, 0.2): "pressure: 'inf' is not allowed",
            (1e9, np.nan): "speed: 'nan' is not allowed, must be a number >= 0",
            (1e9, np.inf): "speed: 'inf' is not allowed",
            (1e9, 0.2, np.nan): "temperature: 'nan' is not allowed, must be a number",
            (1e9, 0.2, (0.0, np.inf)): "temperature: 'inf' is not allowed",
        }.items():
            with pytest.raises(wheelrail.UsageError, match=words):
                law.mu(*arguments)
        with pytest.raises(ValueError, match="could not convert string to float: 'a'"):
            law.mu("a", 0.2)
    law = wheelrail.Case(PATCH, {"friction": {"law": "bucher2006"}}).law
    assert law.mu(1e9, 0.2, 1200.0) > 0.0
    with pytest.raises(wheelrail.UsageError, match="temperature: '2000' is not allowed, .*1250 K"):
        law.mu(1e9, 0.2, [0.0, 2000.0])


def test_polach(tmp_path):
    creeps = list(np.geomspace(2e-4, 2e-2, 8))
    changes = {"creep": creeps, "sensitivities": False}
    fitted = wheelrail.Case(PATCH, changes).solve().polach()
    (tmp_path / "case.yaml").write_text(wheelrail.Case(PATCH, changes).text)
    program("wr_creep", tmp_path / "case.yaml", "-o", tmp_path, "--polach", tmp_path / "p.json")
    assert fitted == json.loads((tmp_path / "p.json").read_text())
    with pytest.raises(wheelrail.UsageError):
        wheelrail.Case(LINE).solve().polach()


def test_fit_measured(tmp_path):
    changes = {"creep": [1e-3, 1e-2], "cells": 16, "sensitivities": False, "thermal": "off"}
    curve = tmp_path / "curve.csv"
    rows = [(2e-4, 0.02), (5e-4, 0.05), (1e-3, 0.09), (2e-3, 0.15), (5e-3, 0.23), (0.01, 0.26),
            (0.03, 0.268), (0.1, 0.235), (0.2, 0.2)]  # fmt: skip
    text = "creep,traction_ratio\n" + "".join(f"{creep},{ratio}\n" for creep, ratio in rows)
    curve.write_text(text)
    case = wheelrail.Case(PATCH, changes)
    fitted = case.solve().fit_measured(str(curve))
    (tmp_path / "case.yaml").write_text(case.text)
    program("wr_creep", tmp_path / "case.yaml", "-o", tmp_path, "--fit-measured", curve)
    assert fitted == json.loads((tmp_path / "measured_fit.json").read_text())
    assert 0 < fitted["layer"]["share_of_initial_slope"] < 1
    with pytest.raises(wheelrail.BadInput, match="no such file"):
        case.solve().fit_measured(str(tmp_path / "none.csv"))
    with pytest.raises(wheelrail.UsageError, match="fit_measured"):
        wheelrail.Case(LINE).solve().fit_measured(str(curve))


# what is wrong


def test_faults_are_those_of_the_program(tmp_path):
    file = tmp_path / "case.yaml"
    file.write_text("# a comment\ncontact:\n  load: -3 kN\n")
    with pytest.raises(wheelrail.BadInput) as fault:
        wheelrail.Case(file)
    said = program("wr_creep", file, code=3).stderr.strip()
    assert said == f"wr_creep: {fault.value}"
    error = fault.value
    assert (error.code, error.file, error.line, error.keyword) == (3, str(file), 3, "contact.load")
    assert isinstance(error, ValueError) and isinstance(error, wheelrail.Error)
    with pytest.raises(wheelrail.BadInput, match="no such file"):
        wheelrail.Case(tmp_path / "no such file.yaml")


def test_a_fault_of_a_log_has_its_place(campaign, tmp_path):
    log = tmp_path / "bad.friction"
    text = next(campaign.rglob("*.friction")).read_text()
    log.write_text(re.sub("pressure: [0-9.]*", "pressure: -15", text, count=1))
    with pytest.raises(wheelrail.BadInput) as fault:
        wheelrail.read_logs(log)
    error = fault.value
    assert error.file == str(log) and error.line > 0 and "pressure" in f"{error}"


@pytest.mark.parametrize(
    "source, changes, error, words",
    [
        ({"creeep": 1}, None, wheelrail.BadInput, "case: creeep: unknown keyword"),
        (PATCH, {"creep": "fast"}, wheelrail.UsageError, "^creep: .*fast"),
        (PATCH, {"creep": float("nan")}, wheelrail.UsageError, "^creep: "),
        (PATCH, {"contact.radius": 1}, Exception, "contact.radius"),
        ({**PATCH, "creep": []}, None, wheelrail.BadInput, "creep: the list is empty"),
        ({**PATCH, "creep": None}, None, TypeError, "NoneType"),
        (PATCH, {"speed": object()}, TypeError, "object"),
        (3, None, TypeError, ""),
    ],
)
def test_bad_cases(source, changes, error, words):
    with pytest.raises(error, match=words):
        wheelrail.Case(source, changes)


def test_points_that_fail_are_nan():
    """A force beyond friction ends that point alone; alone it is an error."""
    changes = {"force": {"longitudinal": ["-10 kN", "-40 kN"]}}
    case = {key: value for key, value in PATCH.items() if key != "creep"}
    result = wheelrail.Case(case, changes).solve()
    assert result.converged.tolist() == [True, False]
    assert np.isnan(result["force_x"]).tolist() == [False, True]
    assert len(result.failures) == 1 and "40 kN cannot be carried" in result.failures[0]
    with pytest.raises(wheelrail.BadInput, match="40 kN cannot be carried"):
        wheelrail.Case(case, {"force": {"longitudinal": "-40 kN"}}).solve()
    with pytest.raises(KeyError):
        result["force"]
    with pytest.raises(wheelrail.UsageError, match="threads: '-1'"):
        wheelrail.Case(PATCH).solve(threads=-1)


def test_progress_and_threads():
    seen = []
    case = wheelrail.Case(PATCH, {"speed": ["10 m/s", "20 m/s"]})
    result = case.solve(threads=2, progress=lambda done, total: seen.append((done, total)))
    assert seen == [(3, 6), (6, 6)]
    assert np.array_equal(result["force_x"], case.solve(threads=1)["force_x"])

    def stop(done, total):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        case.solve(progress=stop)


def test_ctrl_c_ends_a_sweep():
    case = wheelrail.Case(PATCH, {"creep": list(np.linspace(1e-4, 1e-2, 4000)), "cells": [96, 96]})
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        case.solve(threads=1)
    timer.join()
    assert time.monotonic() - start < 15.0


def test_ctrl_c_ends_a_fit(tmp_path):
    curve = tmp_path / "curve.csv"
    curve.write_text("creep,traction_ratio\n0.001,0.1\n0.002,0.15\n0.01,0.3\n0.1,0.2\n0.2,0.19\n")
    result = wheelrail.Case(PATCH, {"creep": 1e-3, "cells": [256, 256]}).solve()
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        result.fit_measured(str(curve))
    timer.join()
    assert time.monotonic() - start < 15.0


# step by step


def test_contact_gives_what_a_case_gives():
    contact = wheelrail.Contact(wheelrail.Case(PATCH, {"lateral": 0.0002}))
    assert (contact.creep, contact.lateral, contact.load) == (0.0005, 0.0002, 100e3)
    with pytest.raises(wheelrail.UsageError, match="there is no result"):
        contact.values()
    result = wheelrail.Case(PATCH, {"lateral": 0.0002}).solve()
    for k, creep in enumerate(PATCH["creep"]):
        forces = contact.step(creep)
        assert forces.force_x == pytest.approx(result["force_x"][k], abs=0.1)
        assert forces == pytest.approx(
            [result[name][k] for name in ("force_x", "force_y", "moment_z")], abs=0.1
        )
    values = contact.values()
    assert values["approach"] == pytest.approx(result["approach"][-1], rel=1e-6)
    assert values["force_x"] == forces.force_x
    fields = contact.fields()
    assert fields["pressure"] == pytest.approx(result.fields[3]["pressure"], rel=1e-6, abs=1e3)
    contact.step(spin=0.1, load=80e3, speed=30.0)
    assert (contact.creep, contact.spin, contact.load, contact.speed) == (0.002, 0.1, 80e3, 30.0)
    assert contact.values()["load"] == 80e3


def test_contact_refuses():
    contact = wheelrail.Contact(wheelrail.Case(PATCH))
    with pytest.raises(wheelrail.UsageError, match=r"spin: 'nan' is not in the allowed range"):
        contact.step(spin=float("nan"))
    with pytest.raises(wheelrail.BadInput, match="contact.domain"):
        contact.step(load=300e3)
    assert contact.step(load=100e3).force_x < 0.0
    for error, change in ((wheelrail.UsageError, {"load": -1}), (wheelrail.BadInput, {"load": 8})):
        with pytest.raises(error, match="contact.load"):
            contact.step(creep=0.05, **change)
        assert (contact.creep, contact.load) == (0.0005, 100e3)
    with pytest.raises(wheelrail.BadInput, match="point contact"):
        wheelrail.Contact(wheelrail.Case(LINE))


def test_contacts_on_threads():
    """Each thread has its own contact, and its results are those that it has alone."""

    def drive(sign):
        contact = wheelrail.Contact(wheelrail.Case(PATCH))
        return [contact.step(sign * 1e-4 * k).force_x for k in range(1, 30)]

    alone = [drive(1), drive(-1)]
    found = {}
    threads = [
        threading.Thread(target=lambda sign=sign: found.update({sign: drive(sign)}))
        for sign in (1, -1)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [found[1], found[-1]] == alone


def test_one_contact_for_one_thread():
    case = wheelrail.Case(PATCH, {"cells": [256, 256], "sensitivities": False})
    contact = wheelrail.Contact(case)
    faults = []

    def step():
        try:
            for k in range(4):
                contact.step(1e-3 + 1e-4 * k)
        except wheelrail.UsageError as error:
            faults.append(str(error))

    threads = [threading.Thread(target=step) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert faults and all("is at work on another thread" in fault for fault in faults)


# wr_fit


@pytest.fixture(scope="module")
def campaign(tmp_path_factory):
    folder = tmp_path_factory.mktemp("campaign")
    friction_logs.campaign(folder)
    return folder


def test_fit_is_that_of_wr_fit(campaign, tmp_path):
    build = program("wr_fit", "--version").stdout
    assert wheelrail.__version__ in build, "wr_fit and the module were built at different commits"
    fitted = wheelrail.fit(campaign)
    fitted.save(tmp_path / "python.json")
    table = tmp_path / "runs.csv"
    done = program("wr_fit", campaign, "-o", tmp_path / "program.json", "--runs", table)
    shown = done.stdout
    said = [f"wr_fit: warning: {warning}" for warning in fitted.warnings]
    assert done.stderr.splitlines() == said and said
    assert (tmp_path / "python.json").read_bytes() == (tmp_path / "program.json").read_bytes()
    assert fitted.text == shown and fitted.why_not == ""
    assert fitted.report == json.loads((tmp_path / "program.json").read_text())
    assert fitted.parameters["mu0"] == fitted.report["mu0"]
    rows = [line for line in table.read_text().splitlines() if not line.startswith("#")]
    first = next(csv.DictReader(rows))
    for name, value in first.items():
        if name == "file":
            assert fitted.runs["file"][0] == value
        else:
            assert fitted.runs[name][0] == pytest.approx(float(value), rel=1e-4, nan_ok=True)
    # the law that was saved is one for a case
    law = wheelrail.Case(PATCH, {"friction": {"law": str(tmp_path / "python.json")}}).law
    assert law.mu(1e9, 0.4) > 0.0


def test_logs(campaign):
    logs = wheelrail.read_logs([campaign])
    assert len(logs) == len(list(campaign.rglob("*.friction")))
    log = logs[0]
    assert log.columns["mu"] == pytest.approx(log.columns["shear_stress"] / log.head["pressure"])
    assert log.head["strength"] * log.kappa3 == pytest.approx(log.head["youngs_modulus"])
    assert log.made_by["program.lammps"] == "20250204" and log.condition and log.note == ""
    text = wheelrail.fit(campaign, "velocity").text
    paths = sorted(campaign.rglob("*.friction"))
    for given in (logs, tuple(logs), iter(logs), tuple(paths), (str(path) for path in paths)):
        assert wheelrail.fit(given, "velocity").text == text
    for log in (logs[0], [paths[0], paths[0]]):
        assert wheelrail.fit(log).runs["file"] == [str(paths[0])]
    both = wheelrail.fit([paths[0], logs[1], paths[0], logs[2], paths[3]], "velocity")
    assert both.runs["file"] == [str(paths[k]) for k in (1, 2, 0, 3)]  # logs first


def test_fit_refuses(campaign, tmp_path):
    for words, options in {
        "model: 'eq7' is not allowed; constant, ": {"model": "eq7"},
        "level: '2' is not allowed, must be a number from 0.5": {"level": 2.0},
        "kappa3: goes with velocity_kappa3": {"kappa3": 100.0},
        "ductility: goes with eq2_ductility": {"ductility": 90.0},
        "grinding_in: '0' is not allowed": {"grinding_in": 0.0},
        "level: goes with a fitted law": {"level": 0.9, "model": "table"},
    }.items():
        with pytest.raises(wheelrail.UsageError, match=re.escape(words)):
            wheelrail.fit(campaign, **options)
    for nothing in ([], (), iter([])):
        with pytest.raises(wheelrail.UsageError, match="logs: at least one log is needed"):
            wheelrail.fit(nothing)
    with pytest.raises(TypeError, match="expected str, bytes or os.PathLike object, not int"):
        wheelrail.fit([3])
    for name in ("a", "b"):
        (tmp_path / f"{name}.friction").write_text("no log\n")
    with pytest.raises(wheelrail.BadInput, match=r"a\.friction.*; .*b\.friction"):
        wheelrail.fit(tmp_path)
    with pytest.raises(wheelrail.BadInput, match=r"a\.friction.*; .*b\.friction"):
        wheelrail.read_logs(tmp_path)
    one = wheelrail.fit(next(campaign.rglob("*.friction")))
    assert one.why_not
    with pytest.raises(wheelrail.NotConverged, match="cannot be fitted"):
        one.parameters
    with pytest.raises(wheelrail.OutputError):
        one.save(tmp_path / "no folder" / "law.json")


# the face of the module


def stub():
    tree = ast.parse((pathlib.Path(wheelrail.__file__).parent / "__init__.pyi").read_text())
    imported = {a.asname for n in tree.body if isinstance(n, ast.ImportFrom) for a in n.names}
    functions = {n.name: n for n in tree.body if isinstance(n, ast.FunctionDef)}
    classes = {n.name: n for n in tree.body if isinstance(n, ast.ClassDef)}
    return imported, functions, classes


def arguments_of(node):
    """[(name, default)] as pybind11 writes them in its docstrings."""
    a = node.args
    names = [one.arg for one in a.args]
    defaults = [None] * (len(names) - len(a.defaults)) + [ast.unparse(one) for one in a.defaults]
    names += [one.arg for one in a.kwonlyargs]
    defaults += [ast.unparse(one) if one else None for one in a.kw_defaults]
    return [(n, d) for n, d in zip(names, defaults) if n != "self"]


def arguments_said(function):
    first = inspect.getdoc(function).splitlines()[0]
    inside = first[first.index("(") + 1 : first.rindex(") ->")]
    found = re.findall(r"(\w+): [^=]+?(?: = ('[^']*'|[^,]+))?(?:, (?=\w+:|\*)|$)", inside)
    return [(name, default or None) for name, default in found if name != "self"]


def test_stubs_name_what_the_module_has():
    imported, functions, classes = stub()
    public = set(wheelrail.__all__) - {"__version__"}
    assert public == {*functions, *classes} | (imported - {None}) & public
    for name, node in functions.items():
        assert arguments_of(node) == arguments_said(getattr(wheelrail, name)), name
    for name, node in classes.items():
        real = getattr(wheelrail, name)
        members = {n.name: n for n in node.body if isinstance(n, ast.FunctionDef)}
        own = {m for m in vars(real) if m[0] != "_" or m in ("__getitem__", "__len__")}
        assert own | {"__init__"} == set(members) | {"__init__"}, name
        for member, one in members.items():
            is_property = any(getattr(d, "id", "") == "property" for d in one.decorator_list)
            assert is_property == isinstance(vars(real).get(member), property), f"{name}.{member}"
            if not is_property:
                said = arguments_said(getattr(real, member))
                assert arguments_of(one) == said, f"{name}.{member}"


def test_everything_has_words():
    for name in wheelrail.__all__:
        thing = getattr(wheelrail, name)
        if name == "__version__":
            assert re.match(r"\d+\.\d+\.\d+", thing)
            continue
        assert inspect.getdoc(thing), name
        for member, value in vars(thing).items() if inspect.isclass(thing) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert len(inspect.getdoc(value).strip()) > 10, f"{name}.{member}"
    assert wheelrail.__doc__
