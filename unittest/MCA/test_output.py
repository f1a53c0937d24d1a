# SPDX-License-Identifier: GPL-2.0-or-later
"""Output for viewers, and links in data files: what is written is read back."""

import re

import numpy as np
import pytest

from lmp_run import dump, fails, lmp

ATTRIBUTES = "sxx syy sxy szz mean intensity plastic links welds damage energy theta"
LINKS = "id1 id2 kind strain plastic gamma gamma_total sigma tau original"


def named(words, compute):
    return " ".join(f"colname c_{compute}[{k}] {word}" for k, word in enumerate(words.split(), 1))


@pytest.fixture(scope="module")
def written(fragments, tmp_path_factory):
    """A run with fracture and welds; in its middle all links and states go to a file."""
    folder = tmp_path_factory.mktemp("written")
    output = f"""
compute atoms all mca/atom {ATTRIBUTES}
compute links all mca/link/local {LINKS}
dump atoms all custom 100 atoms.dump id type x y z radius c_atoms[*]
dump_modify atoms sort id {named(ATTRIBUTES, "atoms")}
dump links all local 100 links.dump index c_links[*]
dump_modify links {named(LINKS, "links")}
run 300
mca_links write middle.data
"""
    lmp(
        "in.fragments",
        folder,
        data=fragments,
        style="mca preset b",
        fall=50,
        steps=100,
        every=100,
        extra=output,
    )
    return folder


def test_dump_custom_has_named_columns(written):
    """OVITO and ParaView take the columns of ITEM: ATOMS by their names."""
    text = (written / "atoms.dump").read_text()
    header = next(line for line in text.splitlines() if line.startswith("ITEM: ATOMS"))
    assert header == "ITEM: ATOMS id type x y z radius " + ATTRIBUTES
    frames = dump(written / "atoms.dump")
    assert [step for step, _ in frames] == [0, 100, 200, 300, 400]
    for _, frame in frames:
        assert all(np.isfinite(frame[name]).all() and len(frame[name]) == 160 for name in frame)
        assert frame["radius"] == pytest.approx(1.25)
    first, last = frames[0][1], frames[-1][1]
    assert first["damage"].max() == 0 and first["links"].sum() == 2 * 2 * 199
    assert 0 < last["damage"].max() <= 1 and last["plastic"].max() > 1e-3
    assert frames[3][1]["welds"].max() > 0


def test_dump_local_has_named_columns(written):
    text = (written / "links.dump").read_text()
    assert f"ITEM: ENTRIES index {LINKS}\n" in text and "ITEM: NUMBER OF ENTRIES\n" in text
    atoms = dict(dump(written / "atoms.dump"))
    for step, frame in dump(written / "links.dump"):
        ends = np.concatenate([frame["id1"], frame["id2"]]).astype(int)
        assert (np.bincount(ends, minlength=161)[1:] == atoms[step]["links"]).all()
        assert set(frame["kind"]) <= {1, 2} and set(frame["original"]) <= {0, 1}


@pytest.mark.parametrize("ranks", [1, 2])
def test_damage_counts_original_links(written, fragments, tmp_path, ranks):
    """1 - (original links that are left)/(links made), whatever has formed since."""
    frame = dict(dump(written / "atoms.dump"))[400]
    links = dict(dump(written / "links.dump"))[400]
    made = dict(dump(written / "atoms.dump"))[0]["links"]
    whole = links["original"] > 0
    left = np.bincount(
        np.concatenate([links["id1"][whole], links["id2"][whole]]).astype(int), minlength=161
    )[1:]
    assert frame["damage"] == pytest.approx(1 - left / made, abs=1e-5)
    assert (~whole).sum() > 5
    more = dict(style="mca preset b", fall=50, steps=400, every=400, ranks=ranks)
    lmp("in.fragments", tmp_path, data=fragments, **more)
    again = dump(tmp_path / "state.dump")[-1][1]
    assert again["c_state[9]"] == pytest.approx(frame["damage"], abs=1e-5)


# ---- links in a data file

READ = """
units nano
dimension 2
boundary s s p
newton {newton} on
atom_style {style}
timestep 5e-5
read_data {data}
{bonds}
pair_style mca preset b
pair_coeff * * steel.mca
pair_coeff 2 2 steel.mca strength 138 youngs_modulus 150000
neighbor 0.4 bin
neigh_modify every 10 delay 0 check yes
comm_modify cutoff 6
mca_links read {links}
fix integrate all nve/mca
compute state all mca/atom sxx syy sxy mean plastic links welds theta damage energy
reset_timestep 300
dump state all custom 100 state.dump id type x y vx vy omegaz fx fy tqz c_state[*]
dump_modify state sort id format float %.17g
run 100
mca_links write again.data
"""
BONDS = "mass * 1\nspecial_bonds lj 1 1 1\nbond_style zero\nbond_coeff * 2.5\n"


@pytest.mark.parametrize("ranks,newton", [(1, "on"), (2, "on"), (2, "off")])
def test_sample_survives_in_a_data_file(written, tmp_path, ranks, newton):
    """Read as a data file with bonds and its comments, the run goes on as if it had not stopped."""
    data = written / "middle.data"
    script = READ.format(
        style="hybrid sphere bond", data=data, links=data, bonds=BONDS, newton=newton
    )
    result = lmp(script, tmp_path, ranks=ranks)
    frames, expected = dict(dump(tmp_path / "state.dump")), dict(dump(written / "state.dump"))
    bonds = int(
        next(line for line in data.read_text().splitlines() if line.endswith(" bonds")).split()[0]
    )
    assert f"Read {bonds} links" in result.out and 2 * bonds == expected[300]["c_state[6]"].sum()
    worst = {}
    for step in (300, 400):
        a, b = frames[step], expected[step]
        for name, scale in (
            ("x", 40),
            ("y", 40),
            ("vx", 5140),
            ("vy", 5140),
            ("c_state[1]", 206000),
            ("c_state[3]", 206000),
            ("c_state[5]", 1),
            ("c_state[8]", 1),
            ("c_state[9]", 1),
        ):
            worst[name] = max(worst.get(name, 0), np.abs(a[name] - b[name]).max() / scale)
        assert (a["c_state[6]"] == b["c_state[6]"]).all() and (
            a["c_state[7]"] == b["c_state[7]"]
        ).all()
    print(ranks, newton, worst)
    assert max(worst.values()) < 1e-12, worst


def test_viewers_find_a_data_file(written):
    """The sections that LAMMPS and OVITO read, with the numbers that the header says."""
    sections, name = {}, None
    for line in (written / "middle.data").read_text().splitlines()[1:]:
        words = line.split("#")[0].split()
        if words and words[0][0].isupper():
            name = words[0]
        elif words and name:
            sections.setdefault(name, []).append(words)
    head = (written / "middle.data").read_text().splitlines()
    assert (
        "160 atoms" in head and f"{len(sections['Bonds'])} bonds" in head and "2 bond types" in head
    )
    assert len(sections["Atoms"]) == len(sections["Velocities"]) == 160
    assert {len(row) for row in sections["Atoms"]} == {11} and {
        len(row) for row in sections["Bonds"]
    } == {4}
    assert {row[1] for row in sections["Bonds"]} == {"1", "2"}


def test_bonds_of_any_data_file(fragments, written, tmp_path):
    """A section Bonds alone makes links without shear; atoms may come from another file."""
    text = (written / "middle.data").read_text()
    (tmp_path / "bonds.data").write_text(
        "\n".join(s for s in text.splitlines() if not s.startswith("#")) + "\n"
    )
    script = READ.format(style="sphere", data=fragments, links="bonds.data", bonds="", newton="on")
    bonds = int(next(line for line in text.splitlines() if line.endswith(" bonds")).split()[0])
    assert f"Read {bonds} links" in lmp(script, tmp_path).out


@pytest.mark.parametrize(
    "old, new",
    [
        (r"(\nAtoms # hybrid\n\n\d+ \d+ \S+)", r"\g<1>1"),  # a place
        (r"\n# pair .*", ""),
        (r"\n# automaton (\d+) kappa ", r"\n# automaton \1 theta "),
        (r"\n\S+ \S+ \S+ \S+\n$", "\n"),  # cut
        (r"# mca-links 2", "# mca-links 1"),
        (r"# mca-links 2", "# mca-linkz 2"),
        (r"# checksum", "# checksun"),
        (r"# checksum .*\n", ""),
        (r"# checksum .", "# checksum g"),
    ],
)
def test_a_changed_links_file_is_refused(fragments, written, tmp_path, old, new):
    text = (written / "middle.data").read_text()
    changed = re.sub(old, new, text, count=1)
    assert changed != text
    (tmp_path / "bad.data").write_text(changed)
    fails(
        READ.format(style="sphere", data=fragments, links="bad.data", bonds="", newton="on"),
        tmp_path,
        "bad.data",
        "checksum",
    )


@pytest.mark.parametrize(
    "text,parts",
    [
        ("", ["neither comments of mca_links write nor a section Bonds"]),
        ("x\n\nBonds\n\n1 4 1 2\n", ["line 5", "allowed in Bonds"]),
        ("x\n\nBonds\n\n1 1 1 150\n", ["1 of 1 pairs", "are not neighbors here"]),
        ("x\n# mca-links 2\n# pair 1 2 1\n", ["line 3", "allowed: # pair"]),
    ],
)
def test_bad_links_file(fragments, tmp_path, text, parts):
    (tmp_path / "bad.data").write_text(text)
    fails(
        READ.format(style="sphere", data=fragments, links="bad.data", bonds="", newton="on"),
        tmp_path,
        "bad.data",
        *parts,
    )


def test_missing_links_file(fragments, tmp_path):
    fails(
        READ.format(style="sphere", data=fragments, links="no.data", bonds="", newton="on"),
        tmp_path,
        "no.data",
    )
