# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep with a sequence: forces, speeds, loads and creepages at instants, in both modes."""

import numpy
import pytest
from patch_runs import CASE, creep_rows, numbers, run, table, wr_creep

from mcawr import fields

MOVING = ("mode=moving", "speed=20 m/s")
LIMIT = 0.3 * 10e3  # mu N


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    text = CASE.replace("creep: [1e-3]\n", "").replace("speed: 20 m/s\n", "")
    path.write_text(text, encoding="utf-8")
    return path


def sequence(**lists):
    text = ", ".join(f"{name}: [{', '.join(values)}]" for name, values in lists.items())
    return f"sequence={{{text}}}"


def test_a_force_that_grows_slowly_finds_the_steady_creep(case, tmp_path):
    """Two seconds for a few contact lengths at 20 mm/s: at the end the creep is that of steady
    rolling under the last force."""
    force = ["0 N", "-1500 N", "-1500 N"]
    slow = sequence(time=["0 s", "1 s", "2 s"], force_longitudinal=force)
    (last,) = creep_rows(case, tmp_path / "slow", slow, "mode=moving", "speed=20 mm/s")
    given = ("force.longitudinal=-1500 N", "speed=20 mm/s")
    (steady,) = creep_rows(case, tmp_path / "steady", *given)
    assert float(last["creep"]) == pytest.approx(float(steady["creep"]), rel=2e-3)
    series = table(tmp_path / "slow/series.csv")
    given = numpy.interp(numbers(series, "time"), [0, 1, 2], [0, -1500, -1500])
    assert numbers(series, "force_x") == pytest.approx(given, abs=2e-5 * LIMIT)


def test_speeds_change_the_time_and_nothing_else(case, tmp_path):
    """Friction that knows no speed: the same way at the same creep, whatever the time."""
    even = sequence(time=["0 s", "1 ms"], creep=["1e-3", "1e-3"])
    run(case, tmp_path / "even", even, *MOVING, "moving.start=rest")
    uneven = sequence(time=["0 s", "2 ms"], creep=["1e-3", "1e-3"], speed=["0 m/s", "20 m/s"])
    run(case, tmp_path / "uneven", uneven, "mode=moving", "moving.start=rest")
    a, b = (table(tmp_path / name / "series.csv") for name in ("even", "uneven"))
    a = a[: len(b)]  # a wheel at rest begins a step and does not end it
    assert len(a) == len(b) > 20
    for column in ("distance", "force_x", "stick_fraction"):
        assert (numbers(a, column) == numbers(b, column)).all()
    way = numbers(b, "distance") * 1e-3
    assert numbers(b, "time") == pytest.approx(numpy.sqrt(way / 5e3), rel=1e-6)
    assert numbers(b, "speed")[-1] == pytest.approx(20, rel=0.03)


def test_held_or_linear(case, tmp_path):
    steps = {}
    for between in ("linear", "held"):
        lists = sequence(time=["0 s", "0.5 ms", "1 ms"], creep=["0", "1e-3", "1e-3"])
        run(case, tmp_path / between, lists, f"sequence.between={between}", *MOVING)
        steps[between] = table(tmp_path / between / "series.csv")
    early = numbers(steps["held"], "time") < 0.5e-3
    assert (numbers(steps["held"], "creep")[early] == 0).all()
    assert (numbers(steps["held"], "creep")[~early] == 1e-3).all()
    wanted = numpy.minimum(1e-3, 2 * numbers(steps["linear"], "time"))
    assert numbers(steps["linear"], "creep") == pytest.approx(wanted, rel=1e-6)


@pytest.mark.parametrize("cells", [32, 34])
def test_held_the_last_instant_only_ends_it(cells, case, tmp_path):
    """The last step is under the value of the instant before, whatever the cells: the last instant
    may lie just before the end of a step or just after it."""
    force = sequence(time=["0 s", "1 ms", "2 ms"], force_longitudinal=["0 N", "1 kN", "0 N"])
    changes = ("sequence.between=held", "moving.start=rest", f"cells={cells}")
    (last,) = creep_rows(case, tmp_path / "out", force, *MOVING, *changes)
    assert float(last["force_x"]) == pytest.approx(1e3, abs=1)
    assert float(last["creep"]) < 0


@pytest.mark.parametrize("start", ["steady", "shift", "rest"])
def test_the_start_is_under_the_load_of_the_first_instant(start, case, tmp_path):
    """Whatever contact.load, which decides on the box: here the box is given."""
    text = case.read_text(encoding="utf-8")
    case.write_text(text.replace("semi_axes: [3 mm, 4 mm]", "curvatures: [1.5 1/m, 1 1/m]"))
    drive, found = ("creep=1e-3", "force_x")
    if start == "shift":
        drive, found = ("force.longitudinal=-1 kN", "creep")
    lists = sequence(time=["0 s", "0.2 ms"], load=["8 kN", "8 kN"])
    rows = []
    for load in ("8 kN", "10 kN"):
        changes = (f"contact.load={load}", f"moving.start={start}", "contact.box=[6 mm, 8 mm]")
        run(case, tmp_path / load, lists, drive, *MOVING, *changes)
        rows.append(numbers(table(tmp_path / load / "series.csv"), found))
    assert rows[0] == pytest.approx(rows[1], rel=1e-4)


def test_an_impossible_force_ends_its_point_alone(case, tmp_path):
    """The rows until then are there, and the other operating point."""
    ramp = sequence(time=["0 s", "1 ms"], force_longitudinal=["0 N", f"{1.25 * LIMIT} N"])
    done = run(case, tmp_path / "out", ramp, *MOVING, code=4)
    assert "sequence.force_longitudinal: 3." in done.stderr and "of the sequence)" in done.stderr
    series = table(tmp_path / "out/series.csv")
    assert not table(tmp_path / "out/creep.csv")
    reached = numbers(series, "force_x")[-1] / LIMIT
    assert 0.97 < reached < 1 and 0.78e-3 < numbers(series, "time")[-1] < 0.81e-3
    both = ("contact.load=[10 kN, 14 kN]", "contact.semi_axes=null")
    text = case.read_text().replace("semi_axes: [3 mm, 4 mm]", "curvatures: [1.5 1/m, 1 1/m]")
    case.write_text(text, encoding="utf-8")
    run(case, tmp_path / "two", ramp, *MOVING, both[0], code=4)
    (row,) = table(tmp_path / "two/creep.csv")
    assert float(row["load"]) == 14e3
    assert set(numbers(table(tmp_path / "two/series.csv"), "point")) == {1, 2}
    still = sequence(time=["0 s", "1 s"], force_longitudinal=["0 N", "9 kN"])
    done = run(case, tmp_path / "still", still, "mode=static", "contact.load=10 kN", code=4)
    assert "point 1 (load 10000 N): sequence.force_longitudinal: 9 kN" in done.stderr


def test_stages_at_rest_keep_what_slipped(case, tmp_path):
    """Unloading from Q1 to Q2 shifts back by twice the shift of (Q1 - Q2)/2 (Mindlin, Deresiewicz
    1953), for nu = 0 on the cells, too (Ciavarella, Jaeger)."""
    text = case.read_text().replace("209.92 GPa", "164 GPa").replace("0.28", "0")
    case.write_text(text, encoding="utf-8")
    stages = sequence(
        time=["0 s", "1 s", "2 s"],
        force_longitudinal=["0.4 kN", "2.4 kN", "-1.2 kN"],
        fields=["1 s"],
    )
    run(case, tmp_path / "out", "mode=static", stages, "fields=last")
    series = table(tmp_path / "out/series.csv")
    assert list(numbers(series, "time")) == [0, 1, 2]
    assert numbers(series, "force_x") == pytest.approx([400, 2400, -1200])
    (still,) = table(tmp_path / "out/static.csv")
    assert still["shift_x"] == series[2]["shift_x"]
    run(case, tmp_path / "half", "mode=static", "force.longitudinal=1.8 kN")
    (half,) = table(tmp_path / "half/static.csv")
    back = float(series[2]["shift_x"]) - float(series[1]["shift_x"])
    assert back == pytest.approx(-2 * float(half["shift_x"]), rel=1e-5)
    kept = fields.read_vti(tmp_path / "out/fields_0001_0001.vti")
    assert kept.title.startswith("point 1 at 1 s: load 10000 N")
    force = kept.arrays["traction"][..., 0].sum() * kept.dx * kept.dy
    assert force == pytest.approx(2400, rel=1e-6)


def test_fields_of_instants_of_a_rolling_wheel(case, tmp_path):
    lists = sequence(time=["0 s", "1 ms"], creep=["0", "2e-3"], fields=["0.25 ms", "0.75 ms"])
    run(case, tmp_path / "out", lists, *MOVING, "fields=all")
    names = sorted(path.name for path in (tmp_path / "out").glob("*.vti"))
    assert names == ["fields_0001.vti", "fields_0001_0001.vti", "fields_0001_0002.vti"]
    series = table(tmp_path / "out/series.csv")
    for name, time in zip(names[1:], (0.25e-3, 0.75e-3), strict=True):
        kept = fields.read_vti(tmp_path / "out" / name)
        row = series[int(abs(numbers(series, "time") - time).argmin())]
        force = kept.arrays["traction"][..., 0].sum() * kept.dx * kept.dy
        assert force == pytest.approx(float(row["force_x"]), rel=1e-6)


@pytest.mark.parametrize(
    "changes,words",
    [
        ((sequence(time=["0 s", "1 s"], speed=["0 m/s", "0 m/s"]),), "would not roll"),
        ((sequence(time=["0 s", "1 s"], speed=["1 m/s"]),), "1 values; one for each of the 2"),
        (
            (sequence(time=["0 s", "1 s"], fields=["2 s"]), "fields=all"),
            "up to the last of sequence.time, 1 s",
        ),
        (
            (sequence(time=["0 s", "1 s"], force_longitudinal=["0 N", "1 N"]), "creep=1e-3"),
            "the creep is found",
        ),
        (
            (sequence(time=["0 s", "1 s"], speed=["1 m/s", "2 m/s"]), "thermal={model: local}"),
            "does not go with thermal.model local",
        ),
        ((sequence(time=["0 s", "1 s"], speed=["1 m/s", "2 m/s"]), "speed=1 m/s"), "go with"),
    ],
)
def test_what_does_not_fit_is_named(changes, words, case, tmp_path):
    done = wr_creep(
        case, "-o", tmp_path, "--set", "mode=moving",
        *(part for change in changes for part in ("--set", change)),
    )  # fmt: skip
    assert done.returncode == 3 and done.stderr.count("\n") == 1, done.stderr
    assert words in done.stderr


@pytest.mark.parametrize("model", ["averaged", "averaged_power"])
def test_the_heat_is_that_of_the_step_s_load(model, case, tmp_path):
    """In full sliding power over load is mu v_s, and p0 sqrt(a) of Eq. 11 goes with the root of the
    load. A mean of nominal cells, as all of them have one temperature."""
    heats = (f"thermal={{model: {model}}}", "creep=0.05", "cells=24")
    rises = {}
    for load in ("10 kN", "5 kN"):
        lists = sequence(time=["0 s", "1.5 ms"], load=[load, load])
        (last,) = creep_rows(case, tmp_path / load, lists, *heats, *MOVING)
        rises[load] = float(last["temperature_rise"])
    assert rises["10 kN"] > 10
    assert rises["5 kN"] / rises["10 kN"] == pytest.approx(0.5**0.5, rel=1e-3)


WHOLE = ("contact.cell=[1 mm, 1 mm]", "cells=16", "moving.start=rest")


def test_fields_of_the_last_instant_are_written(case, tmp_path):
    """Between two steps, with speeds as without: the nearest step stands for it, and there is one
    for every instant, though a wheel that stops ends its last step before."""
    lists = {"time": ["0 s", "5.9 ms"], "fields": ["1 ms", "5.9 ms"]}
    even = ("mode=moving", "creep=1e-3", "fields=last", *WHOLE)
    run(case, tmp_path / "even", sequence(**lists), "speed=1 m/s", *even)
    run(case, tmp_path / "listed", sequence(**lists, speed=["1 m/s", "1 m/s"]), *even)
    run(case, tmp_path / "stops", sequence(**lists, speed=["2 m/s", "0 m/s"]), *even)
    for name, steps in (("even", 6), ("listed", 6), ("stops", 5)):
        assert len(table(tmp_path / name / "series.csv")) == steps
        assert (tmp_path / name / "fields_0001_0002.vti").exists()


def test_held_a_step_until_an_instant_is_under_the_value_before_it(case, tmp_path):
    """Steps of 1 ms and an instant at 5 ms: five of them have the first creep."""
    lists = sequence(time=["0 s", "5 ms", "10 ms"], creep=["1e-3", "-1e-3", "0.5"])
    held = ("sequence.between=held", "mode=moving", "speed=1 m/s", *WHOLE)
    run(case, tmp_path / "out", lists, *held)
    creeps = numbers(table(tmp_path / "out/series.csv"), "creep")
    assert list(creeps) == 5 * [1e-3] + 5 * [-1e-3]


def test_a_steady_start_is_as_hot_as_steady_rolling(case, tmp_path):
    """Where friction falls with heat, the first step has the traction of the last, of the steady
    state, but for what friction makes of a cell behind: it began cold, with mu of the cold."""
    hot = ("friction={law: constant, mu: 0.4, hot_factor: 0.4, hot_end: 50 K}", "creep=0.05")
    for model in ("averaged", "local"):
        heats = (f"thermal={{model: {model}}}", *hot, "cells=24")
        (steady,) = creep_rows(case, tmp_path / "steady", *heats, "speed=20 m/s")
        run(case, tmp_path / "out", *heats, *MOVING, "moving.passes=2")
        forces = numbers(table(tmp_path / "out/series.csv"), "force_x")
        assert float(steady["traction_ratio"]) < 0.35
        assert forces == pytest.approx(float(steady["force_x"]), rel=0.05)
        rises = numbers(table(tmp_path / "out/series.csv"), "temperature_rise")
        assert rises == pytest.approx(float(steady["temperature_rise"]), rel=0.1)
