# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/campaign: what its folder says of the runs, damaged or not; packing."""

import ctypes
import json
import math
import re
import shutil
import subprocess

import friction_logs
import pytest

from campaign_calls import (
    CAMPAIGN,
    FAKE,
    HEAD,
    PLAN,
    ROOT,
    campaign,
    edit,
    environment,
    logs,
    one_line,
)
from campaign_parts import folder, pack, plan as plans
from mcawr import archive


def test_a_plan_in_the_folder_is_never_overwritten(plan, tmp_path):
    out = tmp_path / "out"
    one_line(
        campaign("run", plan, "-o", out, env=environment(MCAWR_LMP="/nonexistent/lmp")),
        5,
        "lmp is not there",
    )
    assert not out.exists()
    campaign("run", plan, "-o", out)
    other = tmp_path / "other.yaml"
    other.write_text(PLAN.replace("seed: 7", "seed: 8"))
    one_line(campaign("run", other, "-o", out), 3, "was begun with seed = 7")
    assert [p.name for p in out.glob("plan*")] == ["plan.yaml"]
    other.write_text(HEAD + "runs: [{name: more, ns: 1}]\n")
    for _ in range(2):
        assert campaign("run", other, "-o", out).returncode == 0
        assert (out / "plan.yaml").read_text() == PLAN
        assert (out / "plan.2.yaml").read_text() == other.read_text()
    assert len(list(out.glob("plan*"))) == 2
    assert campaign("run", other, "-o", tmp_path).returncode == 0
    assert plan.read_text() == PLAN and (tmp_path / "plan.2.yaml").exists()


def test_a_plan_of_utf_16_runs_and_is_kept(tmp_path):
    path, out = tmp_path / "plan.yaml", tmp_path / "out"
    path.write_bytes((HEAD + "title: µ\nruns: [{name: a, ns: 1}]\n").encode("utf-16"))
    assert campaign("run", path, "-o", out).returncode == 0
    assert (out / "plan.yaml").read_bytes() == path.read_bytes()


def test_the_exit_code_does_not_depend_on_the_folders_name(plan, tmp_path):
    out = tmp_path / "mylmp_written"
    campaign("run", plan, "-o", out)
    plan.write_text(PLAN.replace("seed: 7", "seed: 8"))
    for words in (["run"], ["status"], ["pack", "--to", tmp_path / "packed.tar.xz"]):
        one_line(campaign(*words, plan, "-o", out), 3, "was begun with seed = 7, the plan says 8")
    assert not (tmp_path / "packed.tar.xz").exists()


def test_a_folder_that_is_not_there(plan, tmp_path):
    for words in (["status"], ["pack", "--to", tmp_path / "packed.tar.xz"]):
        one_line(campaign(*words, plan, "-o", tmp_path / "missing"), 3, "missing: no such folder")
    assert [p.name for p in tmp_path.iterdir()] == ["plan.yaml"]


DAMAGES = [
    (
        lambda a: (a / "run.json").write_text("[]"),
        ("status", "run", "pack"),
        "run.json: is damaged",
    ),
    (lambda a: (a / "run.json").write_text("{"), ("status", "run", "pack"), "run.json: is damaged"),
    (
        lambda a: edit(a / "run.json", '"ns"', '"nn"'),
        ("status", "run", "pack"),
        "run.json: is damaged",
    ),
    (
        lambda a: edit(a / "run.json", '"attempts"', '"a"'),
        ("status", "run", "pack"),
        "run.json: is damaged",
    ),
    *(
        (damage, ("status", "run", "pack"), "run.json: is damaged, or was edited")
        for damage in (
            lambda a: edit(a / "run.json", "-in", "in"),
            lambda a: edit(a / "run.json", '"p": 15.0', '"p": 25.0'),
            lambda a: edit(a / "run.json", '"outcome": "finished"', '"outcome": "failed"'),
            lambda a: edit(a / "run.json", '"checksum": "', '"checksum": "0'),
            lambda a: edit(a / "run.json", '"run.friction": "', '"run.frictio": "'),
            lambda a: (a / "run.json").write_text('{"checksum": 5}'),
        )
    ),
    *(
        (damage, ("status", "run", "pack"), "run.friction: is damaged, or was changed")
        for damage in (
            lambda a: edit(a / "run.friction", "\n3000 0.15 ", "\n3000 much "),
            lambda a: edit(a / "run.friction", r" 15 (\S+) 3456", " 15 0.25 3456"),
            lambda a: edit(a / "run.friction", "\nstep [^\n]*", ""),
            lambda a: edit(a / "run.friction", r"\n4000 [^\n]*", ""),
            lambda a: edit(a / "run.friction", r"(?s)\n16000 .*", "\n"),
            lambda a: (a / "run.friction").write_text(""),
            lambda a: (a / "run.friction").write_bytes(b"\xff\n"),
        )
    ),
    (
        lambda a: (a / "run.restart").write_bytes(b"40000LammpS Restart_\0"),
        ("status", "run", "pack"),
        "run.restart: is damaged",
    ),
    (lambda a: (a / "run.restart").unlink(), ("status", "run"), "run.restart: is damaged"),
    (
        lambda a: (a / "run.json").unlink(),
        ("status", "run", "pack"),
        "run.json: is missing beside run.friction",
    ),
]
QUICK = (0, 5, 11, 17, 19)  # one or two of a file, the others are long


@pytest.mark.parametrize(
    "damage, commands, part",
    [
        pytest.param(*row, marks=[] if k in QUICK else [pytest.mark.long])
        for k, row in enumerate(DAMAGES)
    ],
)
def test_damaged_folder_is_one_clear_line(finished, tmp_path, damage, commands, part):
    shutil.copytree(finished / "out", tmp_path / "out")
    damage(tmp_path / "out" / "a")
    for command in commands:
        more = ["--to", tmp_path / "packed.tar.xz"] if command == "pack" else []
        result = campaign(command, finished / "plan.yaml", "-o", tmp_path / "out", *more)
        one_line(result, 3, str(tmp_path / "out" / "a"), part)
    assert not (tmp_path / "packed.tar.xz").exists()


def test_pack_of_too_many_rows_in_one(finished, tmp_path):
    result = campaign(
        "pack",
        finished / "plan.yaml",
        "-o",
        finished / "out",
        "--to",
        tmp_path / "packed.tar.xz",
        "--rows",
        41,
    )
    one_line(result, 2, "--rows 41", "has fewer rows")
    assert not (tmp_path / "packed.tar.xz").exists()


def test_status_of_a_folder_that_cannot_be_written(finished, tmp_path):
    shutil.copytree(finished / "out", tmp_path / "out")
    folder = tmp_path / "out" / "a"
    (folder / "run.friction").rename(folder / "run.friction.part")
    (folder / "lock").chmod(0o444)
    folder.chmod(0o555)

    def obey_modes():  # as root too: prctl takes CAP_DAC_OVERRIDE from what is executed
        ctypes.CDLL(None).prctl(24, 1, 0, 0, 0)

    result = subprocess.run(
        [CAMPAIGN, "status", finished / "plan.yaml", "-o", tmp_path / "out"],
        capture_output=True,
        text=True,
        env=environment(),
        preexec_fn=obey_modes,
        check=False,
    )
    assert result.returncode == 0, result.stderr
    assert re.search("^a +interrupted +2 ", result.stdout, re.MULTILINE)


def test_pack_averages_rows_and_keeps_the_command(plan, tmp_path):
    out = tmp_path / "out"
    campaign("run", plan, "-o", out)
    result = campaign("pack", plan, "-o", out, "--to", tmp_path / "packed.tar.xz", "--rows", 4)
    assert result.returncode == 0, result.stderr
    whole = [line.split() for line in logs(out)["v2"].split("\n") if line[:1].isdigit()]
    assert result.stdout.endswith(f"3 logs in {tmp_path / 'packed.tar.xz'}\n")
    members = archive.unpack("packed", (tmp_path / "packed.tar.xz").read_bytes())
    assert list(members) == sorted(f"{name}.friction" for name in logs(out))
    text = members["v2.friction"].decode()
    rows = [line.split() for line in text.split("\n") if line[:1].isdigit()]
    assert len(rows) == 10
    assert rows[0][0] == whole[3][0]
    assert math.isclose(float(rows[0][5]), sum(float(r[5]) for r in whole[:4]) / 4, rel_tol=1e-6)
    assert float(rows[0][7]) == 8
    assert '"command": "lmp -in examples/friction/in.friction' in text
    assert str(tmp_path) not in text


def test_equal_runs_make_equal_archives(finished, tmp_path):
    """Archives hold logs and profiles in order of names; an old one is replaced whole, or stays."""
    shutil.copytree(finished / "out", tmp_path / "out")
    (tmp_path / "out" / "a" / "run.profile").write_text("# profile\n")
    made = []
    for target in ("one.tar.xz", "two.tar.xz"):
        (tmp_path / target).write_bytes(b"old")
        words = ("pack", finished / "plan.yaml", "-o", tmp_path / "out", "--to", tmp_path / target)
        one_line(campaign(*words, "--rows", 41), 2, "has fewer rows")
        assert (tmp_path / target).read_bytes() == b"old"
        assert campaign(*words).returncode == 0
        made.append((tmp_path / target).read_bytes())
    assert made[0] == made[1]
    members = archive.unpack("one", made[0])
    assert list(members) == ["a.friction", "a.profile"]
    assert members["a.profile"] == b"# profile\n"
    target = tmp_path / "no" / "a.tar.xz"
    one_line(campaign(*words[:-1], target), 5, f"{target}: cannot be written")


def test_a_campaign_goes_on_from_an_archive(plan, tmp_path):
    """What is packed is neither made nor lost; what was made with other values is refused."""
    first, more, all_of_them = (tmp_path / f"{name}.tar.xz" for name in ("one", "more", "all"))
    campaign("one", plan, "-o", tmp_path / "out", "--index", 0)
    campaign("pack", plan, "-o", tmp_path / "out", "--to", first)
    result = campaign("run", plan, "-o", tmp_path / "rest", "--packed", first)
    assert result.returncode == 0 and f"1 of the runs are in {first}, left out" in result.stdout
    assert len(logs(tmp_path / "rest")) == 2
    words = ("pack", plan, "-o", tmp_path / "rest", "--to")
    assert campaign(*words, more, "--packed", first).returncode == 0
    campaign("run", plan, "-o", tmp_path / "whole")
    campaign("pack", plan, "-o", tmp_path / "whole", "--to", all_of_them)
    assert more.read_bytes() == all_of_them.read_bytes()
    result = campaign("run", plan, "-o", tmp_path / "none", "--packed", more)
    assert result.returncode == 0 and not (tmp_path / "none").exists()

    other = tmp_path / "other.yaml"
    other.write_text(PLAN.replace("seed: 7", "seed: 8"))
    words = ("run", other, "-o", tmp_path / "no", "--packed", first)
    one_line(campaign(*words), 3, "made with seed '7', the plan's run has '8'")
    one_line(campaign("run", plan, "-o", tmp_path / "no", "--packed", other), 2, "must be the name")
    names = archive.unpack("one", first.read_bytes())
    (tmp_path / "bad.tar.xz").write_bytes(archive.pack(dict.fromkeys(names, "# no\n")))
    one_line(
        campaign("run", plan, "-o", tmp_path / "no", "--packed", tmp_path / "bad.tar.xz"),
        3,
        "not a packed log",
    )


def test_an_archive_of_a_damaged_log(finished, tmp_path):
    """One that was cut, emptied or changed is refused, and named."""
    whole, bad = tmp_path / "whole.tar.xz", tmp_path / "bad.tar.xz"
    words = (finished / "plan.yaml", "-o", finished / "out")
    for rows in (1, 3):  # of its 40 rows the last does not fit
        assert campaign("pack", *words, "--to", whole, "--rows", rows).returncode == 0
        assert campaign("run", *words, "--packed", whole).returncode == 0
    text = archive.unpack("whole", whole.read_bytes())["a.friction"].decode()
    lines = text.splitlines(keepends=True)
    head = next(k for k, line in enumerate(lines) if line[:1].isdigit())
    changed = re.sub(r"0\.4\d*", "0.41", lines[head + 2], count=1)
    for damaged, part in (
        (lines[:-1], "ends at step 36000 of 39000: rows are missing"),
        (lines[:head], "ends at step 0 of 39000: rows are missing"),
        ([*lines[: head + 2], changed, *lines[head + 3 :]], f":{head + 3}: check: "),
    ):
        bad.write_bytes(archive.pack({"a.friction": "".join(damaged)}))
        for command in (["run"], ["pack", "--to", tmp_path / "new.tar.xz"]):
            one_line(
                campaign(*command, words[0], "-o", tmp_path, "--packed", bad),
                3,
                f"{bad}/a.friction:",
                part,
            )
    assert not (tmp_path / "new.tar.xz").exists()


@pytest.mark.parametrize(
    "old, new, part",
    [
        ("defaults: {", "defaults: {upper_material: own.mca, ", "made with upper_values "),
        ("title:", "input: mine/in.friction\ntitle:", "made with input "),
    ],
)
def test_an_archive_of_another_upper_block_or_script(plan, tmp_path, old, new, part):
    """Neither is taken for the plan's run, whichever of both has it; plan and script may move."""
    here, there = tmp_path / "here", tmp_path / "there"
    (here / "mine").mkdir(parents=True)
    shutil.copy(ROOT / "examples" / "campaign" / "aluminium.mca", here / "own.mca")
    shutil.copy(ROOT / "examples" / "friction" / "in.friction", here / "mine")
    other = here / "other.yaml"
    other.write_text(PLAN.replace(old, new))
    for made in (plan, other):
        campaign("one", made, "-o", tmp_path / made.stem, "--index", 0)
        target = tmp_path / f"{made.stem}.tar.xz"
        assert campaign("pack", made, "-o", tmp_path / made.stem, "--to", target).returncode == 0
    one = ("-o", tmp_path / "no", "--index", 0, "--packed")
    one_line(campaign("one", other, *one, tmp_path / "plan.tar.xz"), 3, "v2.friction: " + part)
    one_line(campaign("one", plan, *one, tmp_path / "other.tar.xz"), 3, "v2.friction: " + part)
    here.rename(there)
    result = campaign("one", there / "other.yaml", *one, tmp_path / "other.tar.xz")
    assert result.returncode == 0 and "1 of the runs are in" in result.stdout


def test_an_archive_ends_in_tar_xz(finished, tmp_path):
    for name in ("packed", "packed.tar", "packed.tar.gz", "packed.tar.xz/", "packed.TAR.XZ"):
        words = ("pack", finished / "plan.yaml", "-o", finished / "out", "--to")
        said = "is not allowed, must be the name of an archive, like plan.tar.xz"
        one_line(campaign(*words, f"{tmp_path}/{name}"), 2, f"/{name}' {said}")
    assert list(tmp_path.iterdir()) == []


def test_without_a_finished_run_there_is_no_archive(plan, tmp_path):
    (tmp_path / "out").mkdir()
    target = tmp_path / "packed.tar.xz"
    result = campaign("pack", plan, "-o", tmp_path / "out", "--to", target)
    assert result.returncode == 1, result.stderr
    assert result.stdout.endswith(f"{target} is not written: no run is finished\n")
    assert not target.exists()


def test_packed_command_is_of_any_checkout_and_of_the_whole_length():
    begun = (
        "/elsewhere/build/bin/lmp -in /elsewhere/examples/friction/in.friction -var p 2 -var ns 30"
    )
    command = pack.portable(
        [begun, begun.replace("ns 30", "ns 100 -var continue 1 -var restart run.restart")]
    )
    assert command == "lmp -in examples/friction/in.friction -var p 2 -var ns 100"


@pytest.mark.parametrize("modulus, warns", [(206000, True), (2060, False)])
def test_the_softer_block_may_have_less_room(tmp_path, modulus, warns):
    """By p over its bulk modulus, whichever block it is."""
    steel = (ROOT / "potentials" / "steel.mca").read_text()
    text = re.sub(r"(?m)^youngs_modulus .*$", f"youngs_modulus {modulus}", steel)
    text = re.sub(r"(?m)^strength .*$", "strength 9", text)
    (tmp_path / "upper.mca").write_text(text)
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{name: a, p: 8, upper_material: upper.mca}]\n")
    (run,) = plans.read(str(path)).runs
    (tmp_path / "a").mkdir()
    log = friction_logs.friction_log().replace(" gap\n", " gap room\n")
    log = re.sub(r"(?m)^(\d.*)$", r"\1 0.967", log)
    (tmp_path / "a" / "run.friction.part").write_text(log)
    doubt = folder.RunFolder(str(tmp_path), run).doubt()
    assert ("of the solid's room" in (doubt or "")) == warns


def test_what_a_run_cost(plan, tmp_path):
    """Core-seconds of each attempt, on the ranks that lmp names itself, whatever started it; the
    speed of what is finished is that of list -o."""
    lmp = tmp_path / "lmp"
    lmp.write_text(
        f"#!/bin/sh\n{FAKE} \"$@\" && echo '  1 by 4 by 2 MPI processor grid' >> log.1.lammps\n"
    )
    lmp.chmod(0o755)
    env = environment(MCAWR_LMP=str(lmp), FAKE_LMP_ROW="0.01")
    out = tmp_path / "out"
    result = campaign("run", plan, "-o", out, "-j", 1, "--launcher", "env", env=env)
    assert result.returncode == 0, result.stdout + result.stderr
    total = 0.0
    for name in logs(out):
        (attempt,) = json.loads((out / name / "run.json").read_text())["attempts"]
        assert attempt["core_seconds"] == pytest.approx(8 * attempt["seconds"], abs=0.5)
        assert attempt["seconds"] > 0.3
        cost = round(attempt["core_seconds"])
        total += attempt["core_seconds"]
        assert f", {cost} core-seconds in all" in result.stdout
        status = campaign("status", plan, "-o", out).stdout
        assert re.search(rf"^{name} +finished +2 +2 +{cost} ", status, re.MULTILINE)
    work = sum(run.work for run in plans.read(str(plan)).runs)
    listed = campaign("list", plan, "-o", out).stdout
    rate = float(re.search(r"at (\S+) M automaton-steps a second and core, measured", listed)[1])
    assert rate == pytest.approx(work / total / 1e6, rel=0.01)
    plan.write_text(PLAN.replace("ns: 2", "ns: 0.5"))  # the runs were longer
    assert f"core-hours at {rate:.3g} M" in campaign("list", plan, "-o", out).stdout
    one_line(campaign("list", plan, "-o", tmp_path / "no"), 3, "no: no such folder")
    (tmp_path / "empty").mkdir()
    assert "at 9 M automaton-steps" in campaign("list", plan, "-o", tmp_path / "empty").stdout
