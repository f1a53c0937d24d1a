"""tools/reproduce: the paper's numbers beside those of logs whose answers are known."""
import dataclasses
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy
import pytest

from test_plot_layer import HEAD, frame

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "unittest" / "WHEELRAIL"), str(ROOT / "tools")]
from campaign_parts import plan as plans  # noqa: E402
from friction_logs import friction_log  # noqa: E402

BUILD = Path(os.environ["MCAWR_TEST_LMP"]).parents[1] if "MCAWR_TEST_LMP" in os.environ else ROOT / "build"
pytestmark = pytest.mark.skipif(not (BUILD / "bin" / "wr_fit").exists(), reason="wr_fit is not built")


def reproduce(tmp_path, *figures):
    return subprocess.run([ROOT / "tools" / "reproduce", *figures, "--logs", tmp_path / "logs", "-o", tmp_path / "out"],
                          env={**os.environ, "MCAWR_BUILD": str(BUILD)}, text=True, capture_output=True, timeout=120,
                          check=False)


def logs(tmp_path, name, factor=lambda run: 1.0, ns=300):
    """Logs of a shipped plan that follow Eq. 2 with Eq. 3's numbers, times a factor, with some noise."""
    folder = tmp_path / "logs" / name
    folder.mkdir(parents=True)
    runs = plans.read(plans.find(name)).runs
    for number, run in enumerate(runs):
        v = run.values
        (folder / f"{run.name}.friction").write_text(friction_log(
            p=v["p"], v=v["v"], strength=v["strength"], E=v["E"], rho=v["rho"], seed=number + 1, ns=ns,
            factor=factor(run), noise=0.01, phi=0, grinding_in=0.5))
    return folder, runs


def made(tmp_path, name, done):
    """The comparison, once the picture and the files are there."""
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / f"{name}.png").read_bytes()[:4] == b"\x89PNG"
    assert (tmp_path / "out" / f"{name}.csv").exists() and (tmp_path / "out" / f"{name}.json").exists()
    text = (tmp_path / "out" / f"{name}.txt").read_text()
    assert text.strip() == done.stdout.strip()
    return text


def line(text, begin):
    """Numbers of the line that begins so."""
    found = [row for row in text.splitlines() if row.strip().startswith(begin)]
    assert len(found) == 1, text
    return [float(word) for word in re.findall(r"[-+]?\d+\.?\d*", found[0].strip()[len(begin):])]


def test_collapse_tells_the_scatter(tmp_path):
    _, runs = logs(tmp_path, "collapse10", lambda run: 1.1 if int(run.name[1:]) % 2 else 0.9)
    text = made(tmp_path, "collapse", reproduce(tmp_path, "collapse"))
    paper, ours = line(text, "scatter of mu (standard deviation)")
    assert paper == 3.5 and ours == pytest.approx(100 * 0.1 * (10 / 9) ** 0.5, abs=0.2)
    assert line(text, "mean mu")[1] == pytest.approx(0.442, abs=0.002)


def test_law_is_the_papers(tmp_path):
    logs(tmp_path, "paper36")
    text = made(tmp_path, "fig7", reproduce(tmp_path, "fig7"))
    assert len([row for row in text.splitlines() if row.endswith(" inside")]) >= 4
    assert line(text, "RMS of our points against the paper's law:")[0] < 0.5
    assert abs(line(text, "kappa2 = 150")[-1]) < 1.0


def test_law_with_a_third_number(tmp_path):
    for plan in ("paper36", "velocity", "pressure"):
        logs(tmp_path, plan, lambda run: (run.values["E"] / run.values["strength"] / 2239) ** 0.25)
    text = made(tmp_path, "steel", reproduce(tmp_path, "steel"))
    assert line(text, "RMS of our points against the paper's law:")[0] < 0.5
    assert all(abs(line(text, f"kappa2 = {kappa2}")[-1]) < 1 for kappa2 in (2, 150, 633))
    text = made(tmp_path, "kappa3", reproduce(tmp_path, "kappa3"))
    assert all(abs(line(text, f"kappa2 = {kappa2}")[-1]) < 1 for kappa2 in (2, 150, 633))
    assert line(text, "n")[1] == pytest.approx(0.25, abs=0.01)
    assert "at kappa3 = 2239" in text
    factor, _, n, _ = line(text, "mu/mu(Eq. 2) = A (kappa3/2239)^n: A =")[:4]
    assert factor == pytest.approx(1, abs=0.01) and n == pytest.approx(0.25, abs=0.01)


def test_pressure_and_velocity(tmp_path):
    logs(tmp_path, "pressure", lambda run: 1.2)
    logs(tmp_path, "velocity", lambda run: 0.8)
    done = reproduce(tmp_path, "fig4", "fig6")
    assert done.returncode == 0, done.stderr
    fig4, fig6 = ((tmp_path / "out" / f"{name}.txt").read_text() for name in ("fig4", "fig6"))
    for p in (0.5, 15, 26):
        assert line(fig4, f"p = {p:g} MPa")[3] == pytest.approx(20, abs=1)
    ours, _, _, paper, _ = line(fig4, "stress ~ p^n: n =")
    assert ours == pytest.approx(paper, abs=0.01) and 0.85 < paper < 0.95
    for v in (1, 10):
        assert line(fig6, f"v = {v:g} m/s")[3] == pytest.approx(-20, abs=1)


ROWS = {0.1: (4, 5), 0.205: (4, 6), 0.41: (3, 6), 0.82: (3, 7), 1.64: (2, 7)}  # of the layer, by viscosity


def test_layers_of_known_depth(tmp_path):
    for name in ("roughness", "viscosity"):
        folder, runs = logs(tmp_path, name)
        for run in runs:
            low, high = ROWS[run.values["eta"]]
            (folder / f"{run.name}.profile").write_text(HEAD + "".join(frame(1500000 * k, low, high) for k in (1, 2, 3, 4)))
            if name == "viscosity":  # the synthetic head has one viscosity
                log = folder / f"{run.name}.friction"
                log.write_text(log.read_text().replace("viscosity: 0.41", f"viscosity: {run.values['eta']}"))
    folder, runs = logs(tmp_path, "growth", ns=100)
    for run in runs:  # depth ~ sqrt(t), up to 8 rows
        half = [(k, 4 * (k / 40) ** 0.5 / 0.8) for k in range(1, 41)]
        (folder / f"{run.name}.profile").write_text(HEAD + "".join(frame(50000 * k, 4.5 - h, 4.5 + h) for k, h in half))
    text = made(tmp_path, "fig3", reproduce(tmp_path, "fig3"))
    depth, mu = line(text, "exponent of depth ~ t^n")
    assert depth == pytest.approx(0.5, abs=0.1) and mu == pytest.approx(0, abs=0.02)
    assert line(text, "33.3 to 66.7 ns")[0] == pytest.approx(8 * 0.5**0.5, rel=0.05)
    for amplitude in ("1.4", "3.25", "6.5"):
        assert line(text, f"roughness {amplitude} nm")[1] == pytest.approx(2.4)
    depths = {eta: line(text, f"viscosity {eta:g} Pa s")[1] for eta in ROWS}
    assert depths == pytest.approx({eta: 0.8 * (high - low) for eta, (low, high) in ROWS.items()})
    slope = numpy.polyfit(numpy.log(list(depths)), numpy.log(list(depths.values())), 1)[0]
    assert line(text, "exponent of depth ~ eta^n")[1] == pytest.approx(slope, abs=0.006)


def test_sensitivity_and_convergence(tmp_path):
    logs(tmp_path, "variants", lambda run: (1.4 if "second" in run.name else 1.2) if "heal" in run.name else 1.0)
    logs(tmp_path, "convergence", lambda run: 1.1 if "wide-columns20" in run.name else 1.0)
    done = reproduce(tmp_path, "sensitivity", "convergence")
    assert done.returncode == 0, done.stderr
    laws = (tmp_path / "out" / "sensitivity.txt").read_text()
    assert line(laws, "preset b heal 2.35")[-2] == pytest.approx(30, abs=1)
    sizes = (tmp_path / "out" / "convergence.txt").read_text()
    assert line(sizes, "92 MPa: wide-columns20")[3] == pytest.approx(10, abs=1)


def test_step_extrapolated_to_none(tmp_path):
    """mu that grows by a fifth up to the usual step."""
    def usual(run):
        return dataclasses.replace(run, values={**run.values, "dt": None}).dt
    folder, runs = logs(tmp_path, "timestep", lambda run: 1 + 0.2 * run.dt / usual(run))
    for run in runs:
        log = folder / f"{run.name}.friction"
        log.write_text(re.sub("timestep: [^,]*,", f"timestep: {run.dt},", log.read_text()))
    text = made(tmp_path, "timestep", reproduce(tmp_path, "timestep"))
    for case in ("v1", "v5", "v10"):
        _, paper, _, _, _, _, _, _, difference, none, _ = line(text, case + " ")
        assert none == pytest.approx(paper, rel=0.02)
        assert difference == pytest.approx(100 * (1.05 / 1.2 - 1), abs=2)
    for case in ("p26", "c04"):
        assert line(text, case + " ")[-1] == pytest.approx(100 * (1.05 / 1.2 - 1), abs=2)


def test_plain_and_corrected_steps(tmp_path):
    """Corrected ones do not depend on the step, and lie a tenth below the plain ones at the usual one."""
    for name in ("timestep", "corrected"):
        plain = name != "corrected"
        folder, runs = logs(tmp_path, name, lambda run, plain=plain: 1 + 0.1 * run.dt / 5e-5 if plain else 1.0)
        for run in runs:
            log = folder / f"{run.name}.friction"
            text = re.sub("timestep: [^,]*,", f"timestep: {run.dt},", log.read_text())
            log.write_text(text if plain else text.replace("laws: {preset: B", "laws: {preset: B, steps: corrected"))
    text = made(tmp_path, "corrected", reproduce(tmp_path, "corrected"))
    _, quarter = line(text, "5 m/s, plain")[-2:]
    at = line(text, "5 m/s, corrected")[::2]
    assert len(at) == 4 and at == pytest.approx([at[0]] * 4, rel=0.02)
    assert line(text, "5 m/s, plain")[0] == pytest.approx(1.1 * at[1], rel=0.02) and quarter < 0.02
    for v in (1, 2, 3, 4, 6, 8, 10):
        paper, plain, _, ours, _, difference = line(text, f"{v} m/s  ")
        assert ours == pytest.approx(paper, rel=0.02) and plain == pytest.approx(1.1 * paper, rel=0.02)
        assert difference == pytest.approx(-9.1, abs=2)
    for log in (tmp_path / "logs" / "corrected").glob("*.friction"):
        log.write_text(log.read_text().replace(", steps: corrected", ""))
    done = reproduce(tmp_path, "corrected")
    assert done.returncode == 3 and "steps corrected" in done.stderr


def test_missing_logs_are_one_clear_line(tmp_path):
    (tmp_path / "logs").mkdir()
    done = reproduce(tmp_path, "fig4")
    assert done.returncode == 3 and done.stderr.count("\n") == 1 and "pressure" in done.stderr
    logs(tmp_path, "roughness")
    logs(tmp_path, "viscosity")
    logs(tmp_path, "growth")
    done = reproduce(tmp_path, "fig3")
    assert done.returncode == 3 and done.stderr.count("\n") == 1 and "profile" in done.stderr
    assert not (tmp_path / "out" / "fig3.png").exists()


def shipped():
    """Figures whose logs are all in the project."""
    from reproduce_parts import figures
    folder = ROOT / "examples" / "campaign" / "logs"
    return [name for name, figure in figures.FIGURES.items() if all((folder / plan).is_dir() for plan in figure.plans)]


@pytest.mark.parametrize("name", shipped())
def test_page_tells_what_the_shipped_logs_tell(name, tmp_path):
    done = subprocess.run([ROOT / "tools" / "reproduce", name, "-o", tmp_path],
                          env={**os.environ, "MCAWR_BUILD": str(BUILD)}, text=True, capture_output=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    page = (ROOT / "doc" / "how_close.md").read_text()
    assert done.stdout.strip() in page, f"doc/how_close.md does not hold this:\n{done.stdout}"
    assert f"pictures/close_{name}.png" in page
