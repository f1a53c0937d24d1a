# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/reproduce laws: logs whose mu goes with known powers of eta and E/sigma_0."""

import math

import pytest
from test_reproduce import line, logs, made, profiles, pytestmark, reproduce  # noqa: F401

ETA, RATIO, LEVEL = -0.1, 0.2, 1.1  # powers of eta and E/sigma_0; over Eq. 2


def factor(run):
    """The first set follows Eq. 2 alone, the others the powers too, and the roughness of smooth."""
    v = run.values
    if v["laws"] == "b":
        return LEVEL
    name = run.name.split("-")[0]
    power = {"thin": -ETA, "thick": ETA, "soft": -RATIO, "stiff": RATIO}.get(name, 0.0)
    return 2**power * (0.9 if name == "smooth" else 1.0)


def test_sets_tell_their_invariances(tmp_path):
    folder, runs = logs(tmp_path, "laws", factor, ns=150)
    profiles(folder, runs, lambda run, part: (3, 6), frames=30)
    text = made(tmp_path, "laws", reproduce(tmp_path, "laws"))
    first, second, *_ = text.split("\n\n")
    today = line(first, "b   ")
    assert today[0] < 0.5 and today[6] == pytest.approx(10, abs=0.5)
    away = [math.log(2) * n for n in (0, -ETA, ETA, -RATIO, RATIO)] + [math.log(0.9)]
    mean = sum(away) / 6
    scatter = 100 * math.sqrt(sum((a - mean) ** 2 for a in away) / 6)
    size, _, eta, _, ratio = line(first, "b contacts both")[:5]
    assert size == pytest.approx(scatter, abs=0.3)
    assert (eta, ratio) == pytest.approx((ETA, RATIO), abs=0.011)
    depth, _, power, _, smooth, _ = line(second, "b j2 contacts both")
    assert depth == pytest.approx(0.8 * 3, rel=0.01) and power == 0
    assert smooth == pytest.approx(0.9, abs=0.01)
    for name in {run.name for run in runs if run.name.startswith("soft")}:
        (folder / f"{name}.friction").unlink()
    done = reproduce(tmp_path, "laws")
    assert done.returncode == 3 and "no set of laws has a run of each of base, thin" in done.stderr


def half_more_where_welds_heal(run):
    return 1.5 if "heal" in run.values["laws"] else 1.0


@pytest.mark.long
def test_laws_of_links_stand_beside_the_best_set(tmp_path):
    """Sets of which not all conditions were run are in the tables of mu and of the screening."""
    for plan in ("laws", "laws-links"):
        found = logs(tmp_path, plan, half_more_where_welds_heal, ns=150)
        profiles(*found, lambda run, part: (3, 6), frames=30)
    text = made(tmp_path, "laws-links", reproduce(tmp_path, "laws-links"))
    first, _, third, _, screened = text.split("\n\n")
    for name in ("b contacts both", "b contacts both never", "b contacts both 0.554"):
        assert line(first, f"{name}  ")[0] < 1 and len(line(third, f"{name}  ")) == 9
        assert line(screened, f"{name}  ")[0] < 2
    crossed = "b contacts both 0.554 never  "
    assert crossed not in first and len(line(third, crossed)) == 4
    for more in ("", "0.554 ", "never ", "0.554 never "):
        assert line(screened, f"b contacts both {more}heal 1 ")[0] == pytest.approx(50, abs=2)
    assert len(line(third, "b j2 0.554  ")) == 9 and "b j2  " not in text
