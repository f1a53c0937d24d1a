# SPDX-License-Identifier: GPL-2.0-or-later
"""Whatever is wrong with an input: one clear ERROR line, a non-zero exit, no half-written file."""

import os
import resource

import pytest

from lmp_run import STEEL, fails, lmp, periodic_block

LONG = pytest.mark.long
SAMPLE = periodic_block()
GOOD = SAMPLE + "pair_style mca\npair_coeff * * steel.mca\nfix 1 all nve/mca\n"


def with_file(text, folder, *parts, **more):
    folder.mkdir(exist_ok=True)
    (folder / "bad.mca").write_text(text)
    return fails(SAMPLE + "pair_style mca\npair_coeff * * bad.mca\nrun 0\n", folder, *parts, **more)


def test_missing_file(tmp_path):
    fails(SAMPLE + "pair_style mca\npair_coeff * * nosuch.mca\n", tmp_path, "nosuch.mca")


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=LONG)])
def test_empty_file(tmp_path, ranks):
    with_file("", tmp_path, "bad.mca", "empty", ranks=ranks)


def test_truncated_file(tmp_path):
    text = STEEL.read_text()
    with_file(text[: text.index("viscosity   ")], tmp_path, "bad.mca", "viscosity is missing")
    with_file(
        text[: text.index("yield_strain") + 5], tmp_path, "bad.mca:", "unknown keyword 'yield'"
    )


@pytest.mark.parametrize("value", ["abc", "nan", "inf", "-92", "0", "9e999", "92MPa", "0x10"])
def test_bad_number(tmp_path, value):
    text = STEEL.read_text().replace("strength         92 ", f"strength         {value} ")
    assert text != STEEL.read_text()
    with_file(text, tmp_path, "bad.mca", "strength", value if value != "0" else " 0", "allowed")


def test_unknown_keyword_names_the_nearest(tmp_path):
    text = STEEL.read_text().replace("viscosity   ", "viscocity   ")
    with_file(text, tmp_path, "bad.mca:", "viscocity", "nearest known one is 'viscosity'")


@pytest.mark.parametrize("units", ["lj", "electron"])
def test_units_without_conversion(tmp_path, units):
    fails(
        SAMPLE.replace("units nano", f"units {units}")
        + "pair_style mca\npair_coeff * * steel.mca\n",
        tmp_path,
        "steel.mca:1",
        "nano",
        f"units {units}",
        "allowed",
    )


@pytest.mark.parametrize("words", ["", "temperature 292", "temperature 1073.1"])
def test_temperature_that_the_file_has_not(tmp_path, words):
    fails(
        SAMPLE + f"pair_style mca\npair_coeff * * rail_steel.mca {words}\n",
        tmp_path,
        "keyword temperature is",
        "allowed with rail_steel.mca: 293 to 1073",
    )


@pytest.mark.parametrize(
    "words,parts",
    [
        ("strenght 92", ["strenght", "nearest known one is 'strength'"]),
        ("strength", ["strength", "no value"]),
        ("strength -5", ["strength", "-5", "allowed"]),
        ("poissons_ratio 0.5", ["poissons_ratio", "0.5", "allowed"]),
        ("viscosity nan", ["viscosity", "nan", "allowed"]),
        ("temperature 300", ["needs a file with a line temperature, which steel.mca has not"]),
        ("temperature", ["keyword temperature has no value"]),
    ],
)
def test_bad_override(tmp_path, words, parts):
    fails(SAMPLE + f"pair_style mca\npair_coeff * * steel.mca {words}\n", tmp_path, *parts)


@pytest.mark.parametrize(
    "words,parts",
    [
        ("preset e", ["preset", "value e", "allowed: a, b, c, d"]),
        ("fractur none", ["fractur", "nearest known one is 'fracture'"]),
        ("thickness -1", ["thickness", "-1", "allowed"]),
        ("thickness nan", ["Pair style mca thickness is 'nan'", "> 0"]),
        ("thickness", ["thickness", "no value"]),
        ("cutoff 0", ["cutoff", "allowed"]),
        ("link -3", ["link", "-3", "allowed"]),
        ("weld none", ["heal needs welds"]),
    ],
)
def test_bad_pair_style(tmp_path, words, parts):
    fails(SAMPLE + f"pair_style mca {words}\n", tmp_path, *parts)


@pytest.mark.parametrize(
    "laws, what", [("preset c", "breaking distance"), ("", "reach of the room")]
)
def test_cutoff_below_what_pairs_need(laws, what, tmp_path):
    fails(
        SAMPLE + f"pair_style mca cutoff 2.55 {laws}\npair_coeff * * steel.mca\nrun 0\n",
        tmp_path,
        "cutoff 2.55",
        what,
    )


@pytest.mark.parametrize(
    "words,parts",
    [
        ("velocity 5", ["pressure"]),
        ("velocity nan pressure 1", ["velocity is 'nan'", "finite number or v_name"]),
        ("velocity 5 pressure -1", ["pressure", "-1", ">= 0"]),
        ("velocity 5 pressure inf", ["pressure is 'inf'", ">= 0 or v_name"]),
        ("velocity 5 pressur 1", ["pressur", "nearest known one is 'pressure'"]),
        ("velocity 5 pressure 1 every 0", ["every is '0'", "a whole number from 1 to"]),
        ("velocity 5 pressure 1 every 2.5", ["every is '2.5'", "a whole number from 1 to"]),
        ("velocity 5 pressure 1 every 1e3", ["every is '1e3'"]),
        ("velocity 5 pressure 1 seed 1e3", ["seed is '1e3'", "a whole number from -9"]),
        ("velocity 5 pressure 1 seed 99999999999999999999", ["seed is '9"]),
        ("velocity v_no pressure 1", ["no equal-style variable no"]),
        ("velocity v_ pressure 1", ["velocity is 'v_'", "finite number or v_name"]),
        ("velocity 5 pressure v_", ["pressure is 'v_'", ">= 0 or v_name"]),
        ("velocity 5 pressure", ["pressure", "no value"]),
        ('velocity 5 pressure 1 file ""', ["file is ''", "a file name"]),
    ],
)
def test_bad_drive(tmp_path, words, parts):
    fails(GOOD + f"fix 2 all mca/drive {words}\nrun 1\n", tmp_path, *parts)


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=LONG)])
def test_unwritable_log_folder(tmp_path, ranks):
    fails(
        GOOD + "fix 2 all mca/drive velocity 1 pressure 1 file no/folder/x.friction\nrun 1\n",
        tmp_path,
        "no/folder/x.friction",
        "No such file or directory",
        ranks=ranks,
    )
    assert not (tmp_path / "no").exists()


def test_a_failed_run_leaves_no_half_written_log(tmp_path):
    fails(
        GOOD + "fix 2 all mca/drive velocity 1 pressure 1 file x.friction\ntimestep 1\nrun 1\n",
        tmp_path,
        "Timestep 1",
    )
    assert not list(tmp_path.glob("*.tmp"))


@pytest.mark.parametrize(
    "command,parts",
    [
        ("compute 1 all mca/atom linsk", ["linsk", "nearest known one is 'links'"]),
        ("compute 1 all mca/link/local", ["mca/link/local", "id1"]),
        ("compute 1 all mca/link/local sigmaa", ["sigmaa", "nearest known one is 'sigma'"]),
        ("mca_links make all all", ["make", "create, delete"]),
        ("mca_links create all nobody", ["nobody"]),
        ("mca_links create all all reach nan", ["reach is 'nan'", "> 0"]),
        ("mca_links create all all reach -1", ["reach", "-1"]),
        ("fix 3 all nve/mca now", ["nve/mca", "now"]),
        ("region r mca/rough beside 0 1 1 1", ["beside", "below, above"]),
        ("region r mca/rough below 0 -1 1 1", ["amplitude", "-1"]),
        ("region r mca/rough below 0 1 0 1", ["correlation"]),
        ("region r mca/rough below 0 1 1 0", ["seed"]),
        ("pair_coeff 1 1", ["types types file.mca"]),
    ],
)
def test_bad_commands(tmp_path, command, parts):
    fails(GOOD + command + "\n", tmp_path, *parts)


NO_NUMBERS = ["abc", "0x10", '"1 500"', "nan", "inf", "5nm", '""']


NUMBERS = [
    ("pair_style mca thickness {}", "Pair style mca thickness is"),
    ("pair_style mca cutoff {}", "Pair style mca cutoff is"),
    ("pair_style mca link {}", "keyword link"),
    ("pair_coeff * * steel.mca strength {}", "strength is"),
    ("pair_coeff * * rail_steel.mca temperature {}", "temperature is"),
    ("pair_coeff {} 1 steel.mca", "Pair_coeff of mca: I is"),
    ("pair_coeff 1 {} steel.mca", "Pair_coeff of mca: J is"),
    ("fix 2 all mca/drive velocity {} pressure 1", "Fix mca/drive velocity is"),
    ("fix 2 all mca/drive velocity 1 pressure {}", "Fix mca/drive pressure is"),
    ("fix 2 all mca/drive velocity 1 pressure 1 every {}", "Fix mca/drive every is"),
    ("fix 2 all mca/drive velocity 1 pressure 1 seed {}", "Fix mca/drive seed is"),
    ("fix 2 all mca/events {} step", "Fix mca/events N is"),
    ("fix 2 all mca/events {} 10", "Fix mca/events N is"),
    ("mca_links create all all reach {}", "Command mca_links reach is"),
    ("region r mca/rough below {} 1 1 1", "Region mca/rough height is"),
    ("region r mca/rough below 0 {} 1 1", "Region mca/rough amplitude is"),
    ("region r mca/rough below 0 1 {} 1", "Region mca/rough correlation is"),
    ("region r mca/rough below 0 1 1 {}", "Region mca/rough seed is"),
]


@pytest.mark.parametrize(
    "command, what, word",
    [  # each command and each word once, the others are long
        pytest.param(*number, word, marks=[LONG] if i and k else [])
        for i, number in enumerate(NUMBERS)
        for k, word in enumerate(NO_NUMBERS)
    ],
)
def test_words_that_are_no_number(every_refusal, command, what, word):
    """Ours names style, keyword, value and what is allowed, never LAMMPS's general words."""
    line = every_refusal(command.format(word))
    assert what in line and word.strip('"') in line and "allowed" in line, line


@pytest.fixture(scope="module")
def every_refusal(tmp_path_factory):
    """The ERROR line of a command after a good sample."""
    folder = tmp_path_factory.mktemp("refusals")

    def line(command):
        (answer,) = fails(GOOD + command + "\n", folder, "").error_lines
        return answer

    return line


@pytest.mark.parametrize(
    "correlation, part",
    [("1e-10", "from 1/4000"), ("0.006", "from 1/4000"), ("26", "to that length, 0.00625 to 25")],
)
def test_rough_line_of_too_many_waves(tmp_path, correlation, part):
    fails(
        GOOD + f"region r mca/rough below 0 1 {correlation} 1 units box\n",
        tmp_path,
        f"correlation is '{correlation}'",
        part,
    )


@LONG
def test_rough_line_of_most_waves_is_made_in_time(tmp_path):
    """A line of 5000 waves: its largest height is found among 80000."""
    start = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    lmp(GOOD + "region r mca/rough below 0 1 0.00626 1 units box\n", tmp_path)
    most = 10 * float(os.environ.get("MCAWR_TIME_FACTOR", "1"))  # 1.1 s; with a cosine a wave 20 s
    assert resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - start < most


@pytest.mark.parametrize(
    "line",
    [
        "# pair 1 2 1 1 0 0 nan",
        "# pair 1 2 1 1 0 0 0x1",
        "# pair 1 2 1 1 0 0 0 7",
        "# pair 1 2 4 1 0 0 0",
        "# pair 1 2 1 2 0 0 0",
        "# pair 1 1 1 1 0 0 0",
        "# pair -1 2 1 1 0 0 0",
        "# pair 1 2 1 1 0 0",
        "# automaton 1 kappa inf",
        "# automaton 1.5 kappa 0",
        "# automaton 1 kappa 1e-3 1",
    ],
)
def test_links_of_a_damaged_file(tmp_path, line):
    text = "title\n\n# mca-links 2: pair\n# pair 1 3 1 1 0 0 0\n" + line + "\n"
    (tmp_path / "bad.data").write_text(text)
    fails(GOOD + "mca_links read bad.data\n", tmp_path, f"bad.data: line 5: {line}", "allowed")


def test_wrong_atom_style(tmp_path):
    script = SAMPLE.replace("atom_style sphere", "atom_style atomic")
    fails(
        script + "mass * 1\npair_style mca\npair_coeff * * steel.mca\nrun 0\n",
        tmp_path,
        "atom style sphere",
    )


@pytest.mark.parametrize(
    "laws, named",
    [
        ("thickness 2", "thickness"),
        ("plane stress plasticity none", "plane stress"),
        ("fracture mohr-coulomb compressive_strength 3", "fracture mohr-coulomb"),
    ],
)
def test_laws_of_the_plane_in_three_dimensions(tmp_path, laws, named):
    script = SAMPLE.replace("dimension 2", "dimension 3").replace("hex 2.5", "sc 2.5")
    fails(
        script + f"pair_style mca {laws}\npair_coeff * * steel.mca\nrun 0\n",
        tmp_path,
        f"{named} is for dimension 2 only",
        "principal stresses" if "mohr" in named else "only",
    )


@pytest.mark.parametrize(
    "laws, parts",
    [
        ("plane stress", ("plane", "stress", "needs plasticity none")),
        ("fracture drucker-prager", ("compressive_strength", "need each other")),
        ("fracture drucker-prager compressive_strength 0.9", ("0.9", ">= 1")),
        ("link_work 0", ("link_work", "0", "> 0")),
    ],
)
def test_laws_that_do_not_go_together(tmp_path, laws, parts):
    fails(SAMPLE + f"pair_style mca {laws}\n", tmp_path, *parts)


def test_packing_of_the_other_dimension(tmp_path):
    script = SAMPLE.replace("dimension 2", "dimension 3").replace("hex 2.5", "sc 2.5")
    fails(
        script + "pair_style mca packing hex\npair_coeff * * steel.mca\nrun 0\n",
        tmp_path,
        "packing, value hex, allowed in dimension 3",
    )


def test_links_before_the_pair_style(tmp_path):
    fails(
        SAMPLE + "pair_style zero 3\npair_coeff * *\nmca_links create all all\n",
        tmp_path,
        "requires pair_style mca",
    )


@pytest.mark.parametrize(
    "style",
    [
        "fix 1 all nve/mca",
        "fix 1 all mca/drive velocity 1 pressure 1",
        "compute 1 all mca/atom mean",
        "compute 1 all mca/link/local id1",
    ],
)
def test_styles_that_need_the_pair_style(tmp_path, style):
    fails(
        SAMPLE + f"pair_style zero 3\npair_coeff * *\n{style}\nrun 0\n",
        tmp_path,
        style.split()[3],
        "requires pair_style mca",
    )


def test_second_style_at_a_time(tmp_path):
    fails(
        SAMPLE + "pair_style hybrid/overlay mca mca\npair_coeff * * mca 1 steel.mca\n"
        "pair_coeff * * mca 2 steel.mca\nrun 0\n",
        tmp_path,
        "Only one pair style mca at a time",
    )
