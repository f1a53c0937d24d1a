#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Every argument of every style, program and script with values that it cannot mean.

Each run ends with a valid result (no nan, no inf among the numbers) or with an exit code and one
line of ours: no signal, no traceback, no internal error, no hang, and none of LAMMPS's messages
that name neither the keyword nor what is allowed.

    arguments.py --all --part 2/8     every eighth case, from the second on; 1/8 to 8/8 are all
"""

import re
import shutil

from drill import ENVIRONMENT, TOOLS, Drill, problem, run, writers
from quick import Lammps, Scripts
from writing import inputs_in

BAD = (
    "nan", "-nan", "inf", "-inf", "1e308", "-1e308", "1e309", "1e-308", "5e-324", "1e15", "0", "-1",
    "0.5", "99999999999999999999", "9223372036854775807", "-9223372036854775808", "0x10", "1,5",
    "1 500", "", " ", "abc", "\u00b5\u20ac", "a\nb", "\x1b[31mred", "[]", "{}", "null", "..", "-",
    "--", "%s%n", "$(x)", "x" * 5000,
)  # fmt: skip
GENERIC = re.compile(r"Expected (floating point|integer|boolean|big integer|atom)")
NONE = re.compile(r"(?<![a-z_])-?(nan|inf)(?![a-z_])", re.IGNORECASE)

BLOCK = """units nano
dimension 2
boundary p s p
atom_style sphere
lattice hex 2.5
region box block 0 25 0 17 -0.5 0.5 units box
create_box 1 box
create_atoms 1 box
timestep 5e-5
neighbor 0.4 bin
"""
PAIR = "pair_style mca\npair_coeff * * steel.mca\nfix 1 all nve/mca\n"
TOP = "region top block INF INF 14 INF INF INF units box\ngroup top region top\n"
QUANTITIES = (
    "youngs_modulus poissons_ratio density strength elastic_limit yield_strength yield_strain "
    "breaking_strain viscosity diameter"
).split()
LAWS = (
    "packing thickness cutoff preset plane elasticity plasticity fracture compressive_strength "
    "viscosity steps link link_work weld heal healed_strain"
).split()
DRIVE = {"velocity": "5", "pressure": "1", "file": "a.friction", "every": "10", "seed": "1"}
ROUGH = {"side": "below", "height": "14", "amplitude": "3", "correlation": "5", "seed": "1"}


def words_with(values, name):
    """'key value key value' with a place for the value of one key."""
    return " ".join(f"{key} {'@' if key == name else value}" for key, value in values.items())


def style_lines():
    """(name, commands with @ for the value) of every argument of every style."""
    for law in LAWS:
        yield f"pair_style {law}", f"pair_style mca {law} @\npair_coeff * * steel.mca\n"
    yield "pair_style", "pair_style mca @\npair_coeff * * steel.mca\n"
    yield "pair_coeff types", "pair_style mca\npair_coeff @ @ steel.mca\n"
    yield "pair_coeff file", "pair_style mca\npair_coeff * * @\n"
    for name in QUANTITIES:
        yield f"pair_coeff {name}", f"pair_style mca\npair_coeff * * steel.mca {name} @\n"
    for name in DRIVE:
        line = f"{PAIR}{TOP}fix 2 top mca/drive {words_with(DRIVE, name)}\n"
        yield f"fix mca/drive {name}", line
    yield "fix mca/drive", f"{PAIR}{TOP}fix 2 top mca/drive velocity 5 pressure 1 @ 1\n"
    yield "fix mca/events every", f"{PAIR}fix 2 all mca/events @ step id1\n"
    yield "fix mca/events attribute", f"{PAIR}fix 2 all mca/events 10 @\n"
    yield "fix nve/mca", f"{PAIR}fix 2 all nve/mca @\n"
    for style in ("mca/atom", "mca/link/local", "mca/energy"):
        yield f"compute {style}", f"{PAIR}compute 1 all {style} @\n"
    for name in ROUGH:
        words = " ".join("@" if key == name else value for key, value in ROUGH.items())
        yield f"region mca/rough {name}", f"region r mca/rough {words} units box\n{PAIR}"
    yield "mca_links style", f"{PAIR}mca_links @ all all\n"
    yield "mca_links group", f"{PAIR}mca_links create all @\n"
    yield "mca_links reach", f"{PAIR}mca_links create all all reach @\n"
    for style in ("read", "write"):
        yield f"mca_links {style}", f"{PAIR}mca_links {style} @\n"
    written = f"{PAIR}mca_links write written.links\nmca_links read written.links"
    yield "mca_links replicate", f"{written} replicate @ 1 1\n"
    yield "mca_links read keyword", f"{written} @ 1 1 1\n"


def quoted(value):
    """The value as one word of an input script."""
    if "\n" in value:
        return f'"""{value}"""'
    return f'"{value}"' if not value or re.search(r"[\s#$&]", value) else value


def drill_styles(drill, work):
    """The styles of the plugin, in a run of two steps."""
    cases = [(name, lines, value) for name, lines in style_lines() for value in BAD]
    lammps = Lammps(drill, work)
    for name, lines, value in drill.cases("styles", cases):
        (work / "in.bad").write_text(BLOCK + lines.replace("@", quoted(value)) + "run 2\n")
        done = lammps.run("in.bad")
        what = f"{name} {value[:40]!r}"
        wrong = problem(done)
        error = next((s for s in done.out.splitlines() if s.startswith("ERROR")), "")
        if wrong:
            drill.fault("styles", f"{what}: {wrong}")
        elif done.code != 0 and not error:
            drill.fault("styles", f"{what}: exit code {done.code} without an ERROR")
        elif GENERIC.search(error):
            drill.fault("styles", f"{what}: LAMMPS's words: {error[:120]}")
        elif done.code == 0 and NONE.search(done.out.partition("Step ")[2]):
            drill.fault("styles", f"{what}: exit code 0 with nan or inf")
        else:
            drill.count("styles", "refused" if done.code else "valid")
    lammps.end()


def verdict(drill, kind, what, done, results=()):
    """Counts a run of a program or script."""
    wrong = problem(done)
    if wrong:
        drill.fault(kind, f"{what}: {wrong}")
    elif done.code == 1:
        drill.fault(kind, f"{what}: exit code 1: {done.line[:200]}")
    elif done.code == 0:
        for path in results:
            if path.exists() and NONE.search(path.read_text()):
                drill.fault(kind, f"{what}: exit code 0 with nan or inf in {path.name}")
                return
        drill.count(kind, "valid")
    else:
        drill.count(kind, "refused")


def drill_creep(drill, work):
    """wr_creep: the options, and every keyword of a line contact and a point contact."""
    program = drill.program("wr_creep")
    help_ = run([program, "--help"], work).out
    table = re.findall(r"^  ([a-z][\w.]*) +([\[(].*[\])] ?.*|\S+.*?)(?: \[.*\])?$", help_, re.M)
    keywords = [(name, allowed) for name, allowed in table if len(name) < 40]
    assert len(keywords) > 60, "no table of keywords in wr_creep --help"
    cases = []
    for name, allowed in keywords:
        unit = re.search(r"\] (\S.*)$", allowed)
        for value in BAD:
            with_unit = unit and re.fullmatch(r"-?[0-9][0-9.e+-]*|-?nan|-?inf", value)
            word = f"{name}={value}{' ' + unit.group(1) if with_unit else ''}"
            cases += [(base, ["--set", word]) for base in ("case.yaml", "patch.yaml")]
    for option in ("-o", "--set", "--threads", "--polach", "CASE"):
        for value in BAD:
            words = [] if option == "CASE" else [option]
            cases.append(("" if option == "CASE" else "patch.yaml", [*words, value]))
    for base, words in drill.cases("wr_creep", cases):
        out = work / "out"
        shutil.rmtree(out, ignore_errors=True)
        output = [] if "-o" in words else ["-o", "out"]
        done = run([program, *([base] if base else []), *words, *output, "-q"], work)
        what = " ".join([base, *words])[:80].replace("\n", "\\n")
        verdict(drill, "wr_creep", what, done, [out / n for n in ("creep.csv", "static.csv")])


NOWHERE = "/nowhere"  # where a good value would begin minutes of work
# every program and script but wr_creep: words of a good call, which of them is its input (-1:
# none), and options that are left out
CALLS = [
    ("wr_fit", ["logs"], 0, ()),
    *((script, words[:-1], 0, ()) for script, words in writers().items()),
    ("dump_to_vtk.py", ["atoms.dump"], 0, ()),
    ("plot_patch.py", ["fields", "a.vti"], 0, ()),
    ("plot_patch.py", ["friction", "a.vti"], 1, ()),
    ("plot_patch.py", ["curves", "creep.csv"], 1, ()),
    ("plot_patch.py", ["transient", "series.csv"], 1, ()),
    ("plot_wheelrail.py", ["fig12", "--wr-creep", NOWHERE], 0, ()),
    ("plot_mechanics.py", ["surface", "--build", NOWHERE], 0, ()),
    ("benchmark.py", ["--build", NOWHERE], -1, ()),
    ("reproduce", ["fig4"], 0, ("--run",)),  # which makes runs of hours
    ("campaign", ["list", "plan.yaml"], 1, ()),
    ("campaign", ["status", "-o", "out", "plan.yaml"], 3, ()),
    ("campaign", ["run", "-o", "out", "plan.yaml"], 3, ()),
    ("campaign", ["pack", "-o", "out", "--to", "packed.tar.xz", "plan.yaml"], 5, ()),
    ("gate", ["spdx"], 0, ("--build",)),
    ("campaign_to_creep.sh", ["logs", "-o", "out"], 0, ()),
]


def options_of(command, folder):
    """Options that take a value, from --help."""
    help_ = run([*command, "--help"], folder).out
    return sorted(
        set(re.findall(r"(?m)^ +(?:-\w(?: [\w{},]+)?, ?)?(--[a-z][\w-]+)[ =][A-Z{\"]", help_))
    )


def drill_programs(drill, work):
    """wr_fit and the scripts: every option that takes a value, and the input itself."""
    from test_plot_patch import FILES

    from campaign_calls import FAKE, PLAN

    ENVIRONMENT["MCAWR_LMP"] = str(FAKE)
    (work / "plan.yaml").write_text(PLAN)
    for name, content in FILES.items():
        (work / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    cases = []
    for name, base, place, without in CALLS:
        program = drill.program(name)
        part = base[:1] if name in ("campaign", "plot_patch.py") else []
        options = [o for o in options_of([program, *part], work) if o not in without]
        for value in BAD:
            cases += [(name, [program, *base, option, value]) for option in options]
            if place >= 0:
                cases.append((name, [program, *base[:place], value, *base[place + 1 :]]))
    scripts = Scripts()
    for name, command in drill.cases("programs", cases):
        what = " ".join(map(str, [name, *command[1:]]))[:80].replace("\n", "\\n")
        alone = name == "wr_fit" or name.endswith(".sh")
        done = (run if alone else scripts.run)(command, work)
        verdict(drill, name, what, done)


def drill_plans(drill, work):
    """tools/campaign list: every key of a plan."""
    from campaign_parts.quantities import KEYS

    cases = [(key, value) for key in ("name", "title", "input", *KEYS) for value in BAD]
    scripts = Scripts()
    for key, value in drill.cases("plans", cases):
        text = value if "\n" not in value else '"a\\nb"'
        head = f"title: {text}\n" if key == "title" else ""
        entry = "v: 5" if key == "title" else f"{key}: {text}"
        plan = f"format: mca-campaign 1\n{head}runs:\n  - {{{entry}}}\n"
        (work / "plan.yaml").write_text(plan)
        done = scripts.run([TOOLS / "campaign", "list", "plan.yaml"], work)
        verdict(drill, "plans", f"{key}: {value[:40]!r}", done)


def main():
    """All of them."""
    drill = Drill(__doc__, 40, "cases of each kind at random", parts=True)
    work = drill.new_folder("work")
    inputs_in(work, drill)
    for name, part in (
        ("styles", drill_styles),
        ("wr_creep", drill_creep),
        ("programs", drill_programs),
        ("plans", drill_plans),
    ):
        if drill.wanted(name):
            part(drill, work)
    drill.end()


if __name__ == "__main__":
    main()
