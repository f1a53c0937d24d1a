# SPDX-License-Identifier: GPL-2.0-or-later
"""Fragments by links against union-find over the links' list, and what goes on after a restart."""

import numpy as np
import pytest

from lmp_run import dump, fails, friction_log, lmp

OUTPUT = """
group half id <= 80
compute all all mca/fragment/atom single yes
compute linked all mca/fragment/atom
compute half half mca/fragment/atom single yes
compute links all mca/link/local id1 id2
dump links all local {every} links.dump c_links[*]
dump fragments all custom {every} fragments.dump id type c_all c_linked c_half
dump_modify fragments sort id
"""
FAST = dict(style="mca preset b", fall=50, pull=200, steps=400, every=100)


def lowest_ids(n, pairs):
    """The lowest ID of each automaton's cluster, slowly."""
    found = np.arange(n + 1)
    while True:
        before = found.copy()
        for i, j in pairs:
            found[i] = found[j] = min(found[i], found[j])
        if (before == found).all():
            return found[1:]


@pytest.mark.parametrize("ranks", [1, 3])
@pytest.mark.parametrize("boundary", ["s s", "p p"])
def test_lowest_id_of_what_links_join(fragments, tmp_path, ranks, boundary):
    """Two fragments that are torn, collide and weld; also where links lie over periodic faces and
    a fragment winds through all ranks."""
    extra = OUTPUT.format(every=100)
    if boundary == "p p":
        extra = "change_box all x final 0 40 units box\nmca_links create all all\n" + extra
    if ranks > 1:
        extra += "comm_style tiled\nbalance 1.0 rcb\n" if boundary == "p p" else ""
    lmp(
        "in.fragments",
        tmp_path,
        ranks=ranks,
        data=fragments,
        extra=extra,
        boundary=boundary,
        **FAST,
    )
    numbers = set()
    links = dict(dump(tmp_path / "links.dump"))
    for step, frame in dump(tmp_path / "fragments.dump"):
        pairs = np.column_stack([links[step][f"c_links[{k}]"] for k in (1, 2)]).astype(int)
        expected = lowest_ids(160, pairs)
        assert (frame["c_all"] == expected).all()
        linked = np.isin(np.arange(1, 161), pairs)
        assert (frame["c_linked"] == expected * linked).all()
        half = np.arange(1, 161) <= 80
        inside = lowest_ids(160, [p for p in pairs if max(p) <= 80])
        assert (frame["c_half"] == inside * half).all()
        numbers.add(len(set(expected)))
    assert len(numbers) > 1 and max(numbers) > 10


SNAKE = """
units nano
dimension 2
boundary s s p
atom_style sphere
timestep 5e-5
processors 3 1 1
lattice hex 2.5
region box block 0 100 0 20 -0.5 0.5 units box
create_box 1 box
create_atoms 1 box
variable column atom round(x/2.5)
variable row atom round(y/(1.25*sqrt(3)))
variable gap atom "(v_row%4==1 && v_column<39) || (v_row%4==3 && v_column>1)"
group gap variable gap
delete_atoms group gap compress no
pair_style mca
pair_coeff * * steel.mca
neighbor 0.4 bin
mca_links create all all
fix integrate all nve/mca
compute fragment all mca/fragment/atom
compute links all mca/link/local id1 id2
dump links all local 1 links.dump c_links[*]
dump fragments all custom 1 fragments.dump id c_fragment
run 0
"""


def test_a_fragment_that_winds_through_the_ranks(tmp_path):
    """To and fro in strips that meet at the right and left: each message brings the lowest ID on
    by one rank only."""
    lmp(SNAKE, tmp_path, ranks=3)
    frame, links = (dump(tmp_path / f"{name}.dump")[0][1] for name in ("fragments", "links"))
    pairs = np.column_stack([links[f"c_links[{k}]"] for k in (1, 2)]).astype(int)
    ids = frame["id"].astype(int)
    expected = lowest_ids(ids.max(), pairs)[ids - 1]
    assert (frame["c_fragment"] == expected).all()
    assert len(set(expected)) == 1 and len(ids) > 150


@pytest.mark.parametrize("words", ["single", "single maybe", "double yes"])
def test_what_is_not_allowed(fragments, tmp_path, words):
    fails(
        "in.fragments",
        tmp_path,
        "mca/fragment/atom",
        "single yes|no",
        data=fragments,
        extra=f"compute f all mca/fragment/atom {words}",
    )


EVENTS = """
fix seen all mca/events 300 step id1 id2 type1 type2 before after
dump seen all local 300 seen{tag}.dump f_seen[*]
fix upper upper mca/events 300 step
compute pair all pair mca
thermo 50
thermo_style custom step f_seen[1] f_seen[2] f_seen[3] f_upper[1] c_pair[3] c_pair[4] c_pair[5]
"""
GO_ON = """
read_restart {restart}
neighbor 0.4 bin
neigh_modify every 10 delay 0 check yes
comm_modify cutoff 6
fix integrate all nve/mca
"""


@pytest.mark.parametrize("ranks", [1, 3])
def test_counters_and_rows_go_on_after_a_restart(fragments, tmp_path, ranks):
    """A restart file between two outputs: events, their types and all counters are those of the run
    that did not stop; other ranks read it."""
    run = dict(FAST, steps=300, ranks=ranks, data=fragments)
    extra = EVENTS.format(tag=".whole") + "restart 170 mid.*.restart\n"
    whole = lmp("in.fragments", tmp_path, extra=extra, **run).thermo[-1]
    script = GO_ON.format(restart=tmp_path / "mid.170.restart") + EVENTS.format(tag=".rest")
    rest = lmp(script + "run 130\n", tmp_path, ranks=4 - ranks).thermo[-1]
    for name, values in whole.items():
        if name != "Step":
            assert values[-1] == rest[name][-1], name
    assert whole["c_pair[3]"][-1] == whole["f_seen[1]"][-1] > whole["f_upper[1]"][-1] > 0
    assert whole["f_seen[1]"][3] > 0 and rest["c_pair[3]"][0] > 0
    rows = []
    for tag in ("whole", "rest"):
        frame = dump(tmp_path / f"seen.{tag}.dump")[-1][1]
        rows.append(sorted(zip(*(frame[f"f_seen[{k}]"] for k in range(1, 8)))))
    assert rows[0] == rows[1] and len(rows[0]) == sum(whole[f"f_seen[{k}]"][-1] for k in (1, 2, 3))
    types = dict(zip(range(1, 161), [1] * 80 + [2] * 80))
    assert all((row[3], row[4]) == (types[row[1]], types[row[2]]) for row in rows[0])
    assert {(row[3], row[4]) for row in rows[0]} >= {(1, 1), (2, 2), (1, 2)}


def test_a_log_that_begins_later_counts_its_own_events(rough_data, tmp_path):
    """After a restart, too, where events of before are in the counters."""
    more = dict(data=rough_data, steps=400, every=100, v=20)
    lmp("in.sliding", tmp_path, extra="restart 300 mid.*.restart", **more)
    whole = friction_log(tmp_path / "sliding.friction")[1]
    (tmp_path / "sliding.friction").unlink()
    script = (
        GO_ON.format(restart=tmp_path / "mid.300.restart")
        + """
fix hold bottom freeze
fix another top mca/drive velocity 20 pressure 50 file later.friction every 100
run 100
"""
    )
    lmp(script, tmp_path)
    later = friction_log(tmp_path / "later.friction")[1]
    for column in ("broken", "formed", "links"):
        assert later[column] == whole[column][3:], column
    assert whole["broken"][:3].sum() > 0
