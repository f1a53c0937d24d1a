# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_fit: what runs count, and the laws of campaigns."""

import json
import math
import re

import pytest

import friction_logs
from campaign_parts.pack import packed
from wr_fit_run import one_line, read_runs, warnings_of, wr_fit

PAPER = {"mu0": 0.15, "mu1": 0.0442, "mu2": 0.3243, "b": 0.195, "c": 0.00212}  # Eq. 3


def test_single_log_is_a_success(log, tmp_path):
    result = wr_fit(log, "-o", tmp_path / "fit.json", "--runs", tmp_path / "runs.csv")
    one_line(result, 0)
    assert "(100 nm): slid less than 250 nm in all" in warnings_of(result)[0]
    assert (
        "No law fitted: 1 condition for the 5 parameters of eq2, at least 6 are needed."
        in result.stdout
    )
    data = json.loads((tmp_path / "fit.json").read_text())
    assert data["format"] == "mca-friction-report 1" and "mu0" not in data
    point = data["report"]["points"][0]
    row = read_runs(tmp_path / "runs.csv")[0]
    kappa1, kappa2 = friction_logs.kappas(15, 5, 92)
    assert math.isclose(point["kappa1"], kappa1, rel_tol=1e-12)
    assert math.isclose(point["kappa2"], kappa2, rel_tol=1e-12)
    assert math.isclose(point["mu_eq2"], friction_logs.eq2(kappa1, kappa2), rel_tol=1e-12)
    assert abs(point["mu"] - point["mu_eq2"]) < 4 * point["mu_se"]
    assert point["mu_grinding_in"] > point["mu"]
    condition = {"pressure": 15, "velocity": 5, "strength": 92, "viscosity": 0.41, "seed": 1}
    for key, value in {**condition, "youngs_modulus": 206000}.items():
        assert float(row[key]) == value, key
    for key in ("kappa1", "kappa2", "mu", "mu_se", "t_start", "mu_grinding_in", "mu_eq2"):
        assert math.isclose(float(row[key]), point[key], rel_tol=1e-3), key


def test_campaign_gives_a_law(runs, tmp_path):
    result = wr_fit(runs, "-o", tmp_path / "law.json", "--runs", tmp_path / "runs.csv")
    assert result.returncode == 0, result.stderr
    law = json.loads((tmp_path / "law.json").read_text())
    assert law["format"] == "mca-friction-law 1" and law["n"] == 36
    assert len(read_runs(tmp_path / "runs.csv")) == 36
    assert 0.02 < law["rms_relative"] < 0.08
    truth = {"mu0": 0.15, "mu1": 0.0442, "mu2": 0.3243, "b": 0.195, "c": 0.00212}
    for name, entry in law["report"]["fit"]["parameters"].items():
        low, high = entry["interval"]
        assert low <= truth[name] <= high, name
    assert law["kappa2_range"][0] >= 2
    best = [m["model"] for m in law["report"]["models"] if m.get("delta_aicc") == 0]
    assert best == ["eq2"]
    assert "outlier" in result.stdout and "condition number" in result.stdout


def test_files_and_folder_are_the_same(runs, tmp_path):
    wr_fit(runs, "-o", tmp_path / "a.json")
    wr_fit(*sorted(runs.rglob("*.friction")), "-o", tmp_path / "b.json")
    assert (tmp_path / "a.json").read_bytes() == (tmp_path / "b.json").read_bytes()


def test_low_pressure_is_left_out(tmp_path):
    (tmp_path / "low.friction").write_text(friction_logs.friction_log(p=0.05))
    text = wr_fit(tmp_path).stdout
    assert "[left out: kappa2 = 1.22 < 2]" in text
    assert "left out" not in wr_fit(tmp_path, "--kappa2-min", 0).stdout


def test_drift_is_said_and_left_out(tmp_path):
    (tmp_path / "short.friction").write_text(friction_logs.friction_log(ns=1.5))
    result = wr_fit(tmp_path, "--runs", tmp_path / "runs.csv")
    assert result.returncode == 0
    assert "no stationary part: the log is too short" in result.stdout
    assert math.isnan(float(read_runs(tmp_path / "runs.csv")[0]["t_start"]))
    assert "left out" not in wr_fit(tmp_path, "--include-drifting").stdout


def test_a_run_of_two_logs_counts_once(tmp_path):
    """The longer log is fitted, and logs of other seeds are."""
    for name, seed, ns in (("a", 1, 20), ("b", 1, 30), ("c", 1, 20), ("d", 2, 20)):
        (tmp_path / f"{name}.friction").write_text(friction_logs.friction_log(seed=seed, ns=ns))
    lines = {
        line.split()[0][-10]: line
        for line in wr_fit(tmp_path).stdout.splitlines()
        if line.startswith(str(tmp_path))
    }
    assert {name: "left out" in line for name, line in lines.items()} == {
        "a": True,
        "b": False,
        "c": True,
        "d": False,
    }
    assert (
        f"[left out: the run of {tmp_path / 'b.friction'}]" in lines["a"]
        and "b.friction]" in lines["c"]
    )


def test_two_seeds_that_gave_the_same_blocks_count_once(tmp_path):
    log = friction_logs.friction_log(seed=1, ns=20)
    (tmp_path / "a.friction").write_text(log)
    (tmp_path / "b.friction").write_text(log.replace("seed: 1}", "seed: 2}"))
    text = wr_fit(tmp_path).stdout
    first = tmp_path / "a.friction"
    assert f"[left out: the run of {first}, whose other seed gave the same blocks]" in text


@pytest.mark.parametrize("rows", [1, 4, 6])
def test_a_copy_with_averaged_rows_counts_once(tmp_path, rows):
    """As tools/campaign packs it; another seed with the same head otherwise is another run."""
    whole = friction_logs.friction_log(seed=1, ns=20)
    (tmp_path / "whole.friction").write_text(whole)
    (tmp_path / "packed.friction").write_text(packed(whole, rows, "lmp -in in.friction"))
    (tmp_path / "other.friction").write_text(
        packed(friction_logs.friction_log(seed=2, ns=20), rows, "lmp")
    )
    lines = {
        line.split()[0].split("/")[-1]: line
        for line in wr_fit(tmp_path).stdout.splitlines()
        if ".friction " in line
    }
    out = {name for name, line in lines.items() if "left out: the run of" in line}
    assert len(out) == 1 and "other.friction" not in out


def test_the_longer_copy_counts_even_if_it_drifts(tmp_path):
    """The shorter one does not show the drift yet, and must not be fitted for that."""
    for name, ns in (("short", 12), ("long", 100)):
        (tmp_path / f"{name}.friction").write_text(friction_logs.friction_log(ns=ns, drift=-0.002))
    assert "left out" not in wr_fit(tmp_path / "short.friction").stdout
    text = wr_fit(tmp_path).stdout
    assert (
        "[left out: no stationary part]" in text
        and f"[left out: the run of {tmp_path / 'long.friction'}]" in text
    )


def test_runs_of_other_laws_are_warned_of(tmp_path):
    for name, change in (
        ("a", ("", "")),
        ("b", ("", "")),
        ("c", ("lammps: 20250204", "lammps: 20260701")),
    ):
        text = friction_logs.friction_log(seed=ord(name), preset="A" if name == "c" else "B")
        (tmp_path / f"{name}.friction").write_text(text.replace(*change))
    result = wr_fit(tmp_path, "-o", tmp_path / "fit.json")
    warning = warnings_of(result)[0]
    assert warning.startswith("runs that differ in laws.preset, program.lammps are taken together")
    assert f"{tmp_path}/a.friction and {tmp_path}/c.friction" in warning
    assert json.loads((tmp_path / "fit.json").read_text())["report"]["warning"] == warning
    (tmp_path / "c.friction").unlink()
    result = wr_fit(tmp_path)
    assert "runs that differ" not in result.stderr


def test_a_start_beyond_the_end_is_named_in_its_unit(log):
    one_line(
        wr_fit(log, "--start-distance", 1000), 3, "ends at 100 nm, before the start of 1000 nm"
    )
    one_line(
        wr_fit(log, "--start-distance", 50, "--start", 30),
        3,
        "ends at 20 ns, before the start of 30 ns",
    )


def test_start_and_grinding_in_can_be_given(log, tmp_path):
    wr_fit(log, "--start", 10, "--grinding-in", 5, "--runs", tmp_path / "runs.csv")
    assert float(read_runs(tmp_path / "runs.csv")[0]["t_start"]) == 10
    one_line(wr_fit(log, "--start", 30), 3, "the log ends at 20 ns, before the start of 30 ns")


@pytest.mark.parametrize("start, begin", [(None, 12), (10, 12), (15, 15)])
def test_start_can_be_a_distance(log, tmp_path, start, begin):
    """60 nm at 5 m/s, or a later time."""
    more = [] if start is None else ["--start", start]
    table = tmp_path / "runs.csv"
    assert wr_fit(log, "--start-distance", 60, *more, "--runs", table).returncode == 0
    (of_distance,) = read_runs(table)
    wr_fit(log, "--start", begin, "--runs", table)
    assert of_distance == read_runs(table)[0] and float(of_distance["t_start"]) == begin
    one_line(
        wr_fit(log, "--start-distance", 150, *more),
        3,
        "the log ends at 100 nm, before the start of 150 nm",
    )


def test_a_distance_counts_from_where_sliding_begins(log, tmp_path):
    """A drive that begins at 60 ns: 60 nm at 5 m/s are slid at 72 ns."""
    head, rows = log.read_text().split("gap\n")
    late = [row.split(" ") for row in rows.splitlines()]
    late = [" ".join([row[0], f"{float(row[1]) + 60:.10g}", *row[2:]]) for row in late]
    log.write_text(f"{head}gap\n" + "\n".join(late) + "\n")
    done = wr_fit(log, "--start-distance", 60, "-o", tmp_path / "fit.json")
    assert done.returncode == 0, done.stderr
    (point,) = json.loads((tmp_path / "fit.json").read_text())["report"]["points"]
    assert point["t_start"] == pytest.approx(72)
    assert point["start_distance"] == pytest.approx(60)
    one_line(wr_fit(log, "--start-distance", 150), 3, "ends at 100 nm, before the start of 150 nm")
    one_line(wr_fit(log, "--start", 90), 3, "ends at 80 ns, before the start of 90 ns")


@pytest.mark.parametrize(
    "words, said",
    [
        (("--start", 19.99), "the last row begins at 19.95 ns, before the start of 19.99 ns"),
        (
            ("--start-distance", 99.9),
            "the last row begins at 99.75 nm, before the start of 99.9 nm",
        ),
    ],
)
def test_a_start_within_the_last_row_is_said_truly(log, words, said):
    one_line(wr_fit(log, *words), 3, said)


def test_outlier_is_reported(tmp_path):
    runs = friction_logs.campaign(tmp_path / "c", scatter=0.01)
    (runs / "run15" / "run.friction").write_text(
        friction_logs.friction_log(p=15, v=2.5, factor=1.6, seed=15)
    )
    result = wr_fit(runs, "-o", tmp_path / "law.json")
    assert "outlier: " + str(runs / "run15" / "run.friction") in result.stdout
    report = json.loads((tmp_path / "law.json").read_text())["report"]
    (outlier,) = [c for c in report["conditions"] if c["outlier"]]
    assert [report["points"][k]["file"].split("/")[-2] for k in outlier["runs"]] == ["run15"]


def test_replicas_count_once_in_the_fit(tmp_path):
    """Three seeds of each condition, 10 % apart: one mean each, whose error holds that."""
    number = 0
    for v in (0.5, 2.5, 5, 10):
        for strength, p in ((92, 1), (92, 15), (200, 15)):
            for factor in (0.9, 1.0, 1.1):
                number += 1
                (tmp_path / f"r{number}.friction").write_text(
                    friction_logs.friction_log(
                        p=p, v=v, strength=strength, seed=number, factor=factor
                    )
                )
    done = wr_fit(tmp_path, "-o", tmp_path / "law.json", "--plot", tmp_path / "fit.png")
    assert done.returncode == 0, done.stderr
    assert "36 runs of 12 conditions; those that differ in the seed only" in done.stdout
    law = json.loads((tmp_path / "law.json").read_text())
    report = law["report"]
    assert law["n"] == 12 and len(report["conditions"]) == 12 and len(report["points"]) == 36
    assert "12 conditions from 36 of 36 runs" in law["source"]
    for condition in report["conditions"]:
        runs = [report["points"][k] for k in condition["runs"]]
        assert len(runs) == 3 and len({p["seed"] for p in runs}) == 3
        mu = [p["mu"] for p in runs]
        assert math.isclose(condition["mu"], sum(mu) / 3)
        spread = math.sqrt(sum((x - condition["mu"]) ** 2 for x in mu) / 2 / 3)
        assert math.isclose(condition["scatter"], spread)
        assert condition["mu_se"] == max(condition["own_error"], condition["scatter"])
        assert condition["t95"] == runs[0]["t95"]
        assert all(p["mu_se_own"] < p["mu_se"] for p in runs)
        assert "residual" in condition and "residual" not in runs[0]
    (seeds,) = report["seeds"]
    assert seeds["conditions"] == 12 and seeds["freedom"] == 24
    assert seeds["scatter"] == pytest.approx(0.1, rel=0.1)  # beyond the runs' own 1 %
    assert seeds["runs"] == list(range(36))
    assert report["points"][0]["t95"] == pytest.approx(2.0639, abs=1e-4)  # of 24
    assert f"Seeds differ by {100 * seeds['scatter']:.1f} % of mu beyond" in done.stdout
    assert law["kappa3_range"] == pytest.approx([1030, 206000 / 92])
    assert law["fitted_on"] == {
        "pressure": [1, 15],
        "velocity": [0.5, 10],
        "strength": [92, 200],
        "youngs_modulus": pytest.approx([206000, 206000]),
        "density": [7800, 7800],
        "viscosity": [0.41, 0.41],
    }
    # the same runs under another law of the simulation are other conditions
    text = (tmp_path / "r1.friction").read_text().replace("preset: B", "preset: A")
    (tmp_path / "r1.friction").write_text(text)
    assert "36 runs of 13 conditions" in wr_fit(tmp_path).stdout


def test_scatter_at_equal_kappas(tmp_path):
    for seed, (v, rho) in enumerate(((5, 7800), (2.5, 31200), (10, 1950)), 1):
        (tmp_path / f"c{seed}.friction").write_text(
            friction_logs.friction_log(v=v, rho=rho, seed=seed, factor=1 + 0.1 * (seed - 2))
        )
    text = wr_fit(tmp_path, "-o", tmp_path / "fit.json").stdout
    assert "Equal kappas: kappa1 4.746, kappa2 365.1: 3 runs" in text
    group = json.loads((tmp_path / "fit.json").read_text())["report"]["equal_kappas"][0]
    assert 0.07 < group["scatter"] < 0.13


def test_one_speed_is_not_identifiable(tmp_path):
    runs = friction_logs.campaign(
        tmp_path / "c",
        velocities=(5,),
        strengths_and_pressures=[(92, p) for p in (0.2, 1, 3, 8, 15, 20, 26, 40)],
    )
    result = wr_fit(runs, "-o", tmp_path / "law.json", "--runs", tmp_path / "runs.csv")
    one_line(result, 4, "only 1 different kappa1", "at least 3 are needed")
    assert len(read_runs(tmp_path / "runs.csv")) == 8
    assert json.loads((tmp_path / "law.json").read_text())["format"] == "mca-friction-report 1"
    assert wr_fit(runs, "--model", "eq4", "-o", tmp_path / "law.json").returncode == 0
    law = json.loads((tmp_path / "law.json").read_text())
    assert law["mu1"] == 0 and law["b"] == 0 and law["format"] == "mca-friction-law 1"


def test_power_of_kappa3(tmp_path):
    number = 0
    for E in (103000, 206000, 412000):
        for v in (0.5, 2.5, 5, 10):
            for strength, p in ((92, 1), (92, 26), (200, 15)):
                number += 1
                (tmp_path / f"r{number}.friction").write_text(
                    friction_logs.friction_log(
                        p=p,
                        v=v,
                        strength=strength,
                        E=E,
                        seed=number,
                        factor=(E / strength / 2239) ** 0.3,
                    )
                )
    result = wr_fit(
        tmp_path,
        "--model",
        "eq2_kappa3",
        "--kappa3",
        2239,
        "-o",
        tmp_path / "law.json",
        "--plot",
        tmp_path / "fit.png",
        "--runs",
        tmp_path / "runs.csv",
    )
    assert result.returncode == 0, result.stderr
    assert "] (kappa3/2239)^n, 36 conditions" in result.stdout
    law = json.loads((tmp_path / "law.json").read_text())
    fit = law["report"]["fit"]
    assert law["kappa3"] == 2239 and law["kappa3_range"][0] == pytest.approx(103000 / 200)
    assert fit["kappa3"] == 2239 and law["source"].endswith("model eq2_kappa3 at kappa3 = 2239")
    low, high = fit["parameters"]["n"]["interval"]
    assert low < 0.3 < high and high - low < 0.1
    for name, paper in PAPER.items():
        assert abs(law[name] - paper) < 4 * fit["parameters"][name]["standard_error"], name
    best = min(law["report"]["models"], key=lambda m: m.get("delta_aicc", math.inf))
    assert best["model"] == "eq2_kappa3"
    assert float(read_runs(tmp_path / "runs.csv")[0]["kappa3"]) == pytest.approx(103000 / 92)
    assert (tmp_path / "fit.png").read_bytes()[:4] == b"\x89PNG"
    one_line(wr_fit(tmp_path, "--kappa3", 2239), 2, "--kappa3", "eq2_kappa3")
    one_line(wr_fit(tmp_path, "--model", "eq2_kappa3", "--kappa3", 0), 2, "--kappa3")


def test_text_report_holds_no_nan(runs, log, tmp_path):
    """What is no number is "-": errors of 3 rows, AICc of few conditions, grinding-in before the
    first row."""
    few = tmp_path / "few"
    friction_logs.campaign(
        few, velocities=(0.5, 8), strengths_and_pressures=[(92, 1), (92, 26), (200, 15)]
    )
    for arguments in (
        [log, "--start", "19.85"],
        [log, "--start", "0"],
        [few],
        [few, "--model", "constant"],
        [few / "run01", few / "run02", "--model", "constant"],
    ):
        text = wr_fit(*arguments).stdout
        assert not re.search(r"\b(nan|inf)\b", text), text
        assert re.search(r" - ", text) or re.search(r"AICc +-\n", text), text
    assert " 99.99 % interval " in wr_fit(runs, "--level", "0.9999").stdout


def test_constant_mu_is_stationary(tmp_path):
    (tmp_path / "run.friction").write_text(
        friction_logs.friction_log(noise=0, grinding_in=0, ns=600)
    )
    text = wr_fit(tmp_path).stdout
    assert "drifts" not in text and "left out" not in text and " 0.4418  0.0000 " in text


@pytest.mark.parametrize(
    "model, formula",
    [
        ("constant", "mu = mu0, 36"),
        ("velocity", "mu = mu0 + mu1 kappa1/(1 + b kappa1), 36"),
        ("eq4", "mu = mu0 + mu2/(1 + c kappa2), 36"),
        ("eq2", "mu = mu0 + mu1 kappa1/(1 + b kappa1) + mu2/(1 + c kappa2), 36"),
        ("velocity_kappa3", "mu = [mu0 + mu1 kappa1/(1 + b kappa1)] (kappa3/"),
        (
            "eq2_ductility",
            "mu = [mu0 + mu1 kappa1/(1 + b kappa1) + mu2/(1 + c kappa2)] (ductility/",
        ),
    ],
)
def test_each_model_prints_its_own_formula(runs, model, formula):
    text = wr_fit(runs, "--model", model, "--kappa2-min", 0, "--include-drifting").stdout
    assert f"Fit of {model}: {formula}" in text
