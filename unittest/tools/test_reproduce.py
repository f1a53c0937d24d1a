# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/reproduce: the paper's numbers beside those of logs whose answers are known."""

import os
import re
import shutil
from pathlib import Path

import numpy
import pytest

import forked_scripts

from campaign_parts import plan as plans
from friction_logs import eq2, friction_log
from mcawr import archive
from reproduce_parts import ductility, width
from test_plot_layer import HEAD, frame

ROOT = Path(__file__).resolve().parents[2]
REPRODUCE = ROOT / "tools" / "reproduce"

BUILD = (
    Path(os.environ["MCAWR_TEST_LMP"]).parents[1]
    if "MCAWR_TEST_LMP" in os.environ
    else ROOT / "build"
)
pytestmark = pytest.mark.skipif(
    not (BUILD / "bin" / "wr_fit").exists(), reason="wr_fit is not built"
)


def reproduce(tmp_path, *figures):
    words = [*figures, "--logs", tmp_path / "logs", "-o", tmp_path / "out"]
    return forked_scripts.run([REPRODUCE, *words], tmp_path, MCAWR_BUILD=str(BUILD))


def logs(tmp_path, name, factor=lambda run: 1.0, ns=300):
    """Logs of a shipped plan that follow Eq. 2 with Eq. 3's numbers, times a factor, with some
    noise."""
    folder = tmp_path / "logs" / name
    folder.mkdir(parents=True)
    runs = plans.read(plans.find(name)).runs
    for number, run in enumerate(runs):
        v = run.values
        (folder / f"{run.name}.friction").write_text(
            friction_log(
                p=v["p"],
                v=v["v"],
                strength=v["strength"],
                E=v["E"],
                rho=v["rho"],
                breaking_strain=v["breaking_strain"],
                seed=number + 1,
                ns=ns,
                factor=factor(run),
                noise=0.01,
                phi=0,
                grinding_in=0.5,
                preset=v["laws"].split()[0],
                every=4000,
            )
        )
    return folder, runs


def made(tmp_path, name, done):
    """The comparison, once the picture and the files are there."""
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / f"{name}.png").read_bytes()[:4] == b"\x89PNG"
    assert (tmp_path / "out" / f"{name}.csv").exists() and (
        tmp_path / "out" / f"{name}.json"
    ).exists()
    text = (tmp_path / "out" / f"{name}.txt").read_text()
    assert text.strip() == done.stdout.strip()
    return text


def line(text, begin):
    """Numbers of the line that begins so."""
    found = [row for row in text.splitlines() if row.strip().startswith(begin)]
    assert len(found) == 1, text
    return [float(word) for word in re.findall(r"[-+]?\d+\.?\d*", found[0].strip()[len(begin) :])]


def test_collapse_tells_the_scatter(tmp_path):
    logs(tmp_path, "equal-kappas", lambda run: 1.1 if int(run.name[1:3]) % 2 else 0.9)
    text = made(tmp_path, "collapse", reproduce(tmp_path, "collapse"))
    paper, ours = line(text, "scatter of mu (standard deviation)")
    assert paper == 3.5 and ours == pytest.approx(100 * 0.1 * (10 / 9) ** 0.5, abs=0.2)
    assert line(text, "mean mu")[1] == pytest.approx(0.442, abs=0.002)


def test_similar_takes_those_of_one_diagram(tmp_path):
    """Of equal-kappas four conditions, which have that of c01."""
    logs(tmp_path, "equal-kappas", lambda run: 1.0 if run.values["E"] == 206000 else 2.0)
    logs(tmp_path, "similar", lambda run: 1.1 if run.name.startswith("r") else 1.0)
    logs(tmp_path, "paper36", lambda run: 0.8)
    text = made(tmp_path, "similar", reproduce(tmp_path, "similar"))
    assert "10 conditions" in text
    assert line(text, "scatter of mu (standard deviation)")[1] < 1
    *_, paper, _, _, ours = line(text, "r09")
    assert (paper, ours) == (0.8, 1.1)
    of_paper = line(text, "RMS from Eq. 2, strains of the paper:")
    assert of_paper == pytest.approx([20, 6], abs=0.2)
    assert line(text, "RMS from Eq. 2, similar diagrams:") == pytest.approx([10, 6], abs=0.2)


def test_collapse_tells_what_it_goes_with(tmp_path):
    logs(tmp_path, "equal-kappas", lambda run: (run.values["E"] / run.values["strength"]) ** 0.1)
    text = made(tmp_path, "collapse", reproduce(tmp_path, "collapse"))
    assert line(text, "mu ~ (E/sigma_0)^n: n")[1] == pytest.approx(0.1, abs=0.01)
    assert line(text, "mu ~ (eta v/(d sigma_0))^n: n")[1] == pytest.approx(0, abs=0.01)


def test_law_is_the_papers(tmp_path):
    logs(tmp_path, "paper36", ns=500)
    text = made(tmp_path, "fig7", reproduce(tmp_path, "fig7"))
    assert len([row for row in text.splitlines() if row.endswith(" inside")]) >= 4
    assert line(text, "RMS of our runs against the paper's law:")[0] < 0.5
    assert abs(line(text, "kappa2 = 150")[-1]) < 1.0


def test_law_with_a_third_number(tmp_path):
    for plan in ("velocity", "pressure"):
        logs(tmp_path, plan, ns=500)
    text = made(tmp_path, "steel", reproduce(tmp_path, "steel"))
    assert line(text, "RMS of our runs against the paper's law:")[0] < 0.5
    logs(tmp_path, "paper36", lambda run: (run.values["E"] / run.values["strength"] / 2239) ** 0.25)
    text = made(tmp_path, "kappa3", reproduce(tmp_path, "kappa3"))
    factor, _, n, _ = line(text, "mu/mu(Eq. 2) = A (kappa3/2239)^n: A =")[:4]
    assert factor == pytest.approx(1, abs=0.01) and n == pytest.approx(0.25, abs=0.01)


def test_conditions_of_many_materials_beside_the_papers_law(tmp_path):
    """Those of 4 m/s and more apart from the others; a condition without runs is not missed."""
    folder, _ = logs(tmp_path, "paper36", lambda run: 1.1 if run.values["v"] >= 4 else 0.8)
    for log in folder.glob("r01-seed*"):
        log.unlink()
    text = made(tmp_path, "kappa3", reproduce(tmp_path, "kappa3"))
    assert line(text, "r02 ")[-1] == 1.1 and line(text, "r03 ")[-1] == 0.8
    assert "r01 " not in text
    for part, number, rms, mean in (
        ("all  ", 35, 13, (25 * 1.1 + 10 * 0.8) / 35),
        ("from 4 m/s on", 25, 10, 1.1),
        ("slower", 10, 20, 0.8),
    ):
        assert line(text, part) == pytest.approx([number, rms, mean], rel=0.05)


def test_ductility_is_the_third_number(tmp_path):
    """mu of all plans goes like its power 0.2 and knows nothing else of the material."""

    def factor(run):
        v = run.values
        number = v["breaking_strain"] * v["E"] / v["strength"] / (0.04 * 2239)
        mu = 0.3 + 0.006 * run.kappa1 + 0.2 / (1 + 0.004 * run.kappa2)
        return mu * number**0.2 / eq2(run.kappa1, run.kappa2)

    for plan in ductility.COLORS:
        logs(tmp_path, plan, factor, ns=500)
    text = made(tmp_path, "ductility", reproduce(tmp_path, "ductility"))
    assert line(text, "n    ")[1] == pytest.approx(0.2, abs=0.005)
    assert line(text, "what is left goes like (E/sigma_0)^n: n =")[0] == pytest.approx(0, abs=0.01)
    rows = [row.split() for row in text.split("what is left")[0].splitlines()[3:] if row]
    assert [row[0] for row in rows] == [*ductility.COLORS]
    assert all(float(row[-4]) < 1 for row in rows)  # % from the fit
    assert line(text, "eq2_kappa3")[1] > 100  # AICc over the least


def test_scatter_in_bins_counts_degrees_of_freedom():
    """Of pure noise many small bins leave as much as few large ones."""
    noise = numpy.random.default_rng(1).normal(1, 0.1, 4000)
    few = width.scatter_in_bins([2 ** (k % 4) for k in range(4000)], noise)
    many = width.scatter_in_bins([2 ** (k // 2 % 1000) for k in range(4000)], noise)
    pairs = width.scatter_in_bins([2 ** (k % 2000 // 2) for k in range(2000)], noise[:2000])
    for (scatter, bins), count in ((few, 4), (many, 1000), (pairs, 1000)):
        assert bins == count and scatter == pytest.approx(0.1, rel=0.05)
    assert numpy.isnan(width.scatter_in_bins([1, 2], [1.0, 1.1])[0])


def test_law_of_speed_pressure_and_a_third_number(tmp_path):
    """One material has no term of pressure; many have all terms and a power of kappa3."""

    def factor(run, fall=0.0):
        power = (run.values["E"] / run.values["strength"] / 2239) ** 0.1
        mu = 0.43 + 0.006 * run.kappa1 + fall / (1 + 0.004 * run.kappa2)
        return mu * power / eq2(run.kappa1, run.kappa2)

    for plan in ("velocity", "pressure"):
        logs(tmp_path, plan, factor, ns=500)
    text = made(tmp_path, "steel", reproduce(tmp_path, "steel"))
    assert line(text, "mu0")[1] == pytest.approx(0.43, abs=0.002)
    assert line(text, "kappa2 = 633")[1] == pytest.approx(0.43, abs=0.002)
    logs(tmp_path, "paper36", lambda run: factor(run, 0.15), ns=500)
    text = made(tmp_path, "kappa3", reproduce(tmp_path, "kappa3"))
    for name, value, tolerance in (("mu0", 0.43, 0.01), ("mu1", 0.006, 3e-4), ("mu2", 0.15, 0.01)):
        assert line(text, name)[1] == pytest.approx(value, abs=tolerance)
    assert line(text, "n    ")[1] == pytest.approx(0.1, abs=0.005)
    assert "at kappa3 = 2239" in text


def test_pressure_and_velocity(tmp_path):
    logs(tmp_path, "pressure", lambda run: 1.2)
    logs(tmp_path, "velocity", lambda run: 0.8, ns=500)
    done = reproduce(tmp_path, "fig4", "fig6")
    assert done.returncode == 0, done.stderr
    fig4, fig6 = ((tmp_path / "out" / f"{name}.txt").read_text() for name in ("fig4", "fig6"))
    for p in (0.5, 15, 26):
        assert line(fig4, f"p = {p:g} MPa")[3] == pytest.approx(20, abs=1)
    ours, _, _, paper, _ = line(fig4, "stress ~ p^n: n =")
    assert ours == pytest.approx(paper, abs=0.01) and 0.85 < paper < 0.95
    for v in (1, 10):
        assert line(fig6, f"v = {v:g} m/s")[3] == pytest.approx(-20, abs=1)


ROWS = {0.1: (4, 5), 0.205: (4, 6), 0.41: (3, 6), 0.82: (3, 7)}  # of the layer, by viscosity
DEPTHS = {1.4: 4, 3.25: 8, 6.5: 6}  # nm, of the layer at the end, by roughness


def profiles(folder, runs, layer, frames=40):
    """A profile beside each log; layer(run, part of its time) -> first and last row that slides."""
    for run in runs:
        (folder / f"{run.name}.profile").write_text(
            HEAD
            + "".join(
                frame(6000000 * k // frames, *layer(run, k / frames)) for k in range(1, frames + 1)
            )
        )


def test_layers_of_known_depth(tmp_path):
    for plan in ("viscosity", "equal-kappas"):
        folder, runs = logs(tmp_path, plan)
        profiles(folder, runs, lambda run, part: ROWS[run.values["eta"]], frames=4)
        for run in runs:  # the synthetic head has one viscosity
            log = folder / f"{run.name}.friction"
            log.write_text(
                log.read_text().replace("viscosity: 0.41", f"viscosity: {run.values['eta']}")
            )

    def growing(run, part):  # as sqrt(t); a row is 0.8 nm here
        half = 0.5 * DEPTHS[run.values["roughness"]] * part**0.5 / 0.8
        return 4.5 - half, 4.5 + half

    profiles(*logs(tmp_path, "roughness"), growing)
    text = made(tmp_path, "fig3", reproduce(tmp_path, "fig3"))
    depth, mu = line(text, "exponent of depth ~ t^n to 200 ns")
    assert depth == pytest.approx(0.5, abs=0.1) and mu == pytest.approx(0, abs=0.02)
    assert line(text, "100 to 200 ns")[0] == pytest.approx(DEPTHS[3.25] * 0.5**0.5, rel=0.05)
    later = numpy.mean(numpy.sqrt(numpy.arange(21, 41) / 40))
    for amplitude, depth in DEPTHS.items():
        assert line(text, f"roughness {amplitude:g} nm")[1] == pytest.approx(
            depth * later, rel=0.05
        )
    depths = {eta: line(text, f"viscosity {eta:g} Pa s")[1] for eta in ROWS}
    assert depths == pytest.approx({eta: 0.8 * (high - low) for eta, (low, high) in ROWS.items()})
    slope = numpy.polyfit(numpy.log(list(depths)), numpy.log(list(depths.values())), 1)[0]
    assert line(text, "exponent of depth ~ eta^n")[1] == pytest.approx(slope, abs=0.006)


def aged(log, n):
    """Rewrites a log: mu times s^n, s in nm over 100."""
    head, rows = [], []
    for text in log.read_text().splitlines():
        if text[0] in "#s":
            head.append(text)
            continue
        step, time, way, stress, normal, mu, *rest = text.split()
        factor = (float(way) / 100) ** n
        rows.append(
            " ".join(
                [
                    step,
                    time,
                    way,
                    f"{float(stress) * factor:.8g}",
                    normal,
                    f"{float(mu) * factor:.8g}",
                    *rest,
                ]
            )
        )
    log.write_text("\n".join([*head, *rows]) + "\n")


def test_ageing_is_the_power_of_distance(tmp_path):
    folder, runs = logs(tmp_path, "velocity", ns=500)
    for run in runs:
        aged(folder / f"{run.name}.friction", -0.3 if run.values["v"] >= 4 else 0.0)
    folder, runs = logs(tmp_path, "pressure", ns=100)
    for run in runs:
        aged(folder / f"{run.name}.friction", 0.2 if run.values["p"] == 26 else 0.0)
    text = made(tmp_path, "ageing", reproduce(tmp_path, "ageing"))
    cases, loads = text.strip().split("\n\n")
    n = {}
    for row in cases.splitlines()[2:]:
        case, _, cells = row.partition(" MPa")
        n[case] = float(cells.split()[-3])
        early, late = (float(cells.split()[k].partition("(")[0]) for k in (1, 4))
        middle = (437.5 / 87.5) ** n[case]
        assert late / early == pytest.approx(middle, abs=0.04), case
    for v in (1, 2, 3, 4, 5, 6, 8, 10):
        assert n[f"{v} m/s, 15"] == pytest.approx(-0.3 if v >= 4 else 0, abs=0.04)
    for p in (0.5, 10, 26):
        assert n[f"5 m/s, {p:g}"] == pytest.approx(0.2 if p == 26 else 0, abs=0.03)
    assert line(loads, "0 to 0.05")[1] == pytest.approx(0, abs=0.02)
    assert line(loads, "0.2 to 0.5")[1] == pytest.approx(0.1, abs=0.03)  # 20 and 26 MPa
    assert line(loads, "0 to 0.5")[0] == 32


def test_convergence(tmp_path):
    """Seeds of the strong material differ by 60 %: no error of the weak one."""

    def factor(run):
        if run.values["strength"] == 250:
            return 1.3 if run.values["seed"] % 2 else 0.7
        return 1.1 if run.name.startswith("half-wide") else 1.0

    for plan in ("convergence", "ductility"):
        logs(tmp_path, plan, factor)
    text = made(tmp_path, "convergence", reproduce(tmp_path, "convergence"))
    *_, percent, errors = line(text, "92 MPa, 5 m/s: half as wide")
    assert percent == pytest.approx(10, abs=1) and errors > 5
    assert line(text, "92 MPa, 10 m/s: half the step")[3] == pytest.approx(0, abs=1)


def test_width_tells_what_is_enough(tmp_path):
    """By the columns alone: 40 rub 10 % less than all wider ones, 20 30 % less."""
    factors = {20: 0.7, 40: 0.9}
    logs(tmp_path, "width", lambda run: factors.get(run.values["columns"], 1), ns=500)
    text = made(tmp_path, "width", reproduce(tmp_path, "width"))
    for name in ("light", "hard", "strong", "base", "slow", "heavy"):
        rows = [row for row in text.splitlines() if row.startswith(f"{name}: ")]
        ends = ["no", "no", "yes", "yes", "%"]
        assert [row.split()[-1] for row in rows] == ends, text
        assert line(text, f"{name}: 40 columns")[-2] == pytest.approx(-10, abs=1)
    everywhere = ", ".join(f"{n} 80" for n in ("light", "hard", "strong", "base", "slow", "heavy"))
    assert f"columns by the rule: {everywhere}\n" in text
    by_columns, by_junctions = (line(text, f"by {of}:")[0] for of in ("columns", "junctions"))
    assert by_columns < 1 and 5 < by_junctions < 20


@pytest.mark.parametrize("factor, rule", ((0.98, 80), (0.9, 320)))
def test_width_long_tells_what_is_enough(tmp_path, factor, rule):
    """Below 320 columns mu is this factor of that of 320."""

    def of_run(run):
        return 1.0 if run.values["columns"] == 320 else factor

    logs(tmp_path, "width-long", of_run, ns=1010)
    text = made(tmp_path, "width-long", reproduce(tmp_path, "width-long"))
    enough = "yes" if rule < 320 else "no"
    for name in ("slow: 80 columns", "slow: 160 columns"):
        assert line(text, name)[-1] == pytest.approx(100 * (factor - 1), abs=1)
        assert next(row for row in text.splitlines() if row.startswith(name)).endswith(enough)
    *_, mu, _, eq2 = line(text, "v1: 80 columns")
    assert mu == pytest.approx(factor * eq2, abs=0.002)
    assert f"columns by the rule: slow {rule}\n" in text


def test_light_loads_over_those_of_narrow_blocks(tmp_path):
    for plan, factor in (("light", 1.2), ("pressure", 1.0), ("paper36", 1.0)):
        logs(tmp_path, plan, lambda run, factor=factor: factor)
    text = made(tmp_path, "light", reproduce(tmp_path, "light"))
    _, _, narrow, _, _, wide, *_ = line(text, "r07")  # junctions
    assert wide / narrow == pytest.approx(4, rel=0.1)
    assert line(text, "mean of the ratios:")[0] == pytest.approx(1.2, abs=0.01)


def test_temperature_and_other_widths(tmp_path):
    factors = {"half-wide": 1.1, "wide-seed": 0.9, "widest": 1.2}

    def factor(run):
        return next((f for name, f in factors.items() if run.name.startswith(name)), 1.0)

    logs(tmp_path, "temperature", factor)
    text = made(tmp_path, "temperature", reproduce(tmp_path, "temperature"))
    _, _, _, mu, _, one, two, *_ = line(text, "673 K ")
    assert mu == pytest.approx((one + two) / 2, abs=0.002)
    assert line(text, "673 K, half width")[3] == pytest.approx(1.1 * mu, rel=0.02)
    assert line(text, "673 K, double width")[3] == pytest.approx(1.2 * mu, rel=0.02)
    hot = line(text, "873 K ")[3]
    assert line(text, "873 K, double width")[3] == pytest.approx(0.9 * hot, rel=0.02)


def test_missing_logs_are_one_clear_line(tmp_path):
    (tmp_path / "logs").mkdir()
    done = reproduce(tmp_path, "fig4")
    assert done.returncode == 3 and done.stderr.count("\n") == 1 and "pressure" in done.stderr
    done = reproduce(tmp_path, "fig15")
    assert done.returncode == 3 and done.stderr.count("\n") == 1 and "rail" in done.stderr
    for plan in ("roughness", "viscosity", "equal-kappas"):
        logs(tmp_path, plan)
    done = reproduce(tmp_path, "fig3")
    assert done.returncode == 3 and done.stderr.count("\n") == 1 and "profile" in done.stderr
    assert not (tmp_path / "out" / "fig3.png").exists()
    for plan in ("roughness", "viscosity", "equal-kappas"):
        profiles(*logs(tmp_path / "few", plan), lambda run, part: (4, 6), frames=4)
    shutil.rmtree(tmp_path / "logs")
    shutil.move(tmp_path / "few" / "logs", tmp_path / "logs")
    done = reproduce(tmp_path, "fig3")
    assert done.returncode == 3 and done.stderr.count("\n") == 1 and "more frames" in done.stderr


def test_an_output_that_cannot_be_is_refused_before_the_runs(tmp_path):
    (tmp_path / "file").write_text("")
    words = ["fig4", "--run", tmp_path / "runs", "-o", tmp_path / "file" / "out"]
    done = forked_scripts.run([REPRODUCE, *words], tmp_path, MCAWR_BUILD=str(BUILD))
    assert done.returncode == 5 and done.stderr.count("\n") == 1 and "file" in done.stderr
    assert not (tmp_path / "runs").exists()


def test_archives_tell_what_their_files_tell(tmp_path):
    """Logs and profiles; an archive beside a folder of the same plan is refused."""
    for name in ("roughness", "viscosity", "equal-kappas"):
        profiles(*logs(tmp_path, name), lambda run, part: (4, 6))
    text = made(tmp_path, "fig3", reproduce(tmp_path, "fig3"))
    for folder in sorted((tmp_path / "logs").iterdir()):
        members = {path.name: path.read_text() for path in folder.iterdir()}
        (tmp_path / "logs" / (folder.name + archive.ENDING)).write_bytes(archive.pack(members))
        done = reproduce(tmp_path, "fig3")
        assert done.returncode == 3 and done.stderr.count("\n") == 1
        assert "is there beside" in done.stderr and "only one of them may be" in done.stderr
        shutil.rmtree(folder)
    assert made(tmp_path, "fig3", reproduce(tmp_path, "fig3")) == text
    points = (tmp_path / "out" / "fig3.csv").read_text()
    assert f"{tmp_path}/logs/roughness.tar.xz/roughness1.4-seed1.friction," in points
    (tmp_path / "logs" / "roughness.tar.xz").write_bytes(b"\xfd7zXZ\0")
    done = reproduce(tmp_path, "fig3")
    assert done.returncode == 3 and done.stderr.count("\n") == 1
    assert "roughness.tar.xz: cannot be unpacked: is damaged or cut" in done.stderr


def test_missing_runs_are_one_clear_line(tmp_path):
    def still(run, part):
        return 4, 6

    for name in ("roughness", "viscosity", "equal-kappas"):
        profiles(*logs(tmp_path, name), still)
    for name in ("velocity", "pressure"):
        logs(tmp_path, name)
    for log in (tmp_path / "logs" / "roughness").glob("roughness3.25-*"):
        log.unlink()
    for figure, said in (
        ("fig3", "no run of roughness 3.25 nm"),
        ("ageing", "a run at 1 m/s, 15 MPa ends before 375 nm"),
    ):
        done = reproduce(tmp_path, figure)
        assert done.returncode == 3 and done.stderr.count("\n") == 1 and said in done.stderr


def shipped():
    """Figures whose logs are all in the project."""
    from reproduce_parts import figures

    folder = ROOT / "examples" / "campaign" / "logs"
    return [
        name
        for name, figure in figures.FIGURES.items()
        if all((folder / (plan + archive.ENDING)).is_file() for plan in figure.plans)
    ]


@pytest.mark.parametrize("name", shipped())
def test_few_runs_are_a_figure_or_one_clear_line(name, tmp_path):
    """One log of each plan: what a campaign leaves whose other runs failed."""
    from reproduce_parts import figures

    for plan in figures.FIGURES[name].plans:
        path = ROOT / "examples" / "campaign" / "logs" / (plan + archive.ENDING)
        members = archive.unpack(path, path.read_bytes())
        run = min(name for name in members if name.endswith(".friction")).removesuffix(".friction")
        (tmp_path / "logs" / plan).mkdir(parents=True)
        for ending in (".friction", ".profile"):
            if run + ending in members:
                (tmp_path / "logs" / plan / (run + ending)).write_bytes(members[run + ending])
    done = reproduce(tmp_path, name)
    assert done.returncode in (0, 3) and done.stderr.count("\n") == (
        done.returncode == 3
    ), done.stderr
    assert not re.search("nan|inf\\b", done.stdout), done.stdout


@pytest.mark.parametrize("name", shipped())
def test_pages_tell_what_the_shipped_logs_tell(name, tmp_path):
    command = [REPRODUCE, name, "-o", tmp_path]
    done = forked_scripts.run(command, tmp_path, MCAWR_BUILD=str(BUILD))
    assert done.returncode == 0, done.stderr
    pages = "".join(
        (ROOT / "doc" / page).read_text(encoding="utf-8")
        for page in ("listings.md", "how_close.md", "how_chosen.md")
    )
    assert done.stdout.strip() in pages, f"doc/listings.md does not hold this:\n{done.stdout}"
    assert f"pictures/close_{name}.png" in pages
    assert max(map(len, done.stdout.splitlines())) <= 100
