# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/campaign: plans, running, killing and going on, failures, several workers, packing."""

import ctypes
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CAMPAIGN = ROOT / "tools" / "campaign"
FAKE = pathlib.Path(__file__).with_name("fake_lmp.py")
REAL = pathlib.Path(os.environ.get("MCAWR_TEST_LMP", ROOT / "build" / "bin" / "lmp"))

sys.path.insert(0, str(ROOT / "tools"))
from campaign_parts import pack, plan as plans, runner  # noqa: E402

HEAD = "format: mca-campaign 1\n"
PLAN = (
    HEAD
    + """title: three runs
defaults: {ns: 2, row: 0.05, checkpoint: 0.2}
runs:
  - {v: [2, 5], seed: 7}
  - {name: soft, strength: 60}
"""
)


def environment(**more):
    inherited = {
        k: v
        for k, v in os.environ.items()
        if not k.startswith(("OMPI_", "PMIX_", "PMI_", "SLURM_"))
    }
    return {**inherited, "MCAWR_LMP": str(FAKE), "PYTHONDONTWRITEBYTECODE": "1", **more}


def campaign(*arguments, env=None, timeout=60):
    return subprocess.run(
        [CAMPAIGN, *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=timeout,
        env=env or environment(),
        check=False,
    )


def one_line(result, code, *parts):
    assert result.returncode == code, result.stdout + result.stderr
    assert result.stderr.count("\n") == 1
    for part in parts:
        assert part in result.stderr


def wait_for(condition, seconds=20):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def logs(folder):
    return {p.parent.name: p.read_text() for p in sorted(folder.glob("*/run.friction"))}


@pytest.fixture
def plan(tmp_path):
    path = tmp_path / "plan.yaml"
    path.write_text(PLAN)
    return path


def test_run_leaves_finished_logs_and_the_exact_commands(plan, tmp_path):
    out = tmp_path / "out"
    result = campaign("run", plan, "-o", out, "-j", 2)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "3 finished" in result.stdout
    assert sorted(logs(out)) == ["soft", "v2", "v5"]
    for name, text in logs(out).items():
        assert len([line for line in text.split("\n") if line[:1].isdigit()]) == 40, name
        record = json.loads((out / name / "run.json").read_text())
        assert record["attempts"][0]["outcome"] == "finished"
        assert (
            "-var strength " + ("60" if name == "soft" else "92")
            in record["attempts"][0]["command"]
        )
        assert not list((out / name).glob("run.[ab].restart"))
    assert (out / "plan.yaml").read_text() == PLAN
    before = {
        p: p.stat().st_mtime_ns for p in out.rglob("*") if p.name != "plan.yaml" and p.is_file()
    }
    again = campaign("run", plan, "-o", out)
    assert again.returncode == 0
    assert before == {
        p: p.stat().st_mtime_ns for p in out.rglob("*") if p.name != "plan.yaml" and p.is_file()
    }


def test_output_that_nobody_takes(plan, tmp_path):
    """`campaign run ... | head -1` does not end as if all was done, leaves no lmp, and goes on."""
    out = tmp_path / "out"
    script = 'set -o pipefail; "$0" run "$1" -o "$2" -j 1 | head -1'
    done = subprocess.run(
        ["bash", "-c", script, CAMPAIGN, plan, out],
        capture_output=True,
        text=True,
        timeout=60,
        env=environment(FAKE_LMP_ROW="0.02"),
        check=False,
    )
    assert done.stdout.startswith("three runs: 3 runs in")
    one_line(done, 5, "standard output", "Broken pipe")
    assert len(logs(out)) < 3
    for record in out.glob("*/run.json"):
        assert json.loads(record.read_text())["attempts"][-1]["outcome"]  # it was ended in order
    assert "running" not in campaign("status", plan, "-o", out).stdout
    again = campaign("run", plan, "-o", out)
    assert again.returncode == 0 and sorted(logs(out)) == ["soft", "v2", "v5"]


@pytest.mark.parametrize("moment", [0.3, 0.9, 1.7])
def test_killed_at_any_moment_it_goes_on(plan, tmp_path, moment):
    campaign("run", plan, "-o", tmp_path / "whole")
    out = tmp_path / "out"
    call = subprocess.Popen(
        [CAMPAIGN, "run", plan, "-o", out, "-j", "2"],
        stdout=subprocess.DEVNULL,
        env=environment(FAKE_LMP_ROW="0.03"),
    )
    wait_for(lambda: (out / "v2" / "run.friction.part").exists())
    time.sleep(moment)
    call.send_signal(signal.SIGKILL)
    call.wait()
    wait_for(
        lambda: "running" not in campaign("status", plan, "-o", out).stdout
    )  # lmp dies with it
    part = out / "v2" / "run.friction.part"
    if part.exists():  # a machine that dies may cut the last line
        part.write_text(part.read_text() + "2000 0.1")
    finished = logs(out)
    result = campaign("run", plan, "-o", out, "-j", 2)
    assert result.returncode == 0, result.stdout + result.stderr
    assert logs(out) == logs(tmp_path / "whole")
    if moment == 0.9:
        assert "goes on from" in result.stdout
    for name in finished:
        assert len(json.loads((out / name / "run.json").read_text())["attempts"]) == 1


def test_half_written_checkpoint_is_not_used(plan, tmp_path):
    out = tmp_path / "out"
    campaign("run", plan, "-o", out)
    folder = out / "v2"
    lines = (folder / "run.friction").read_text().split("\n")
    (folder / "run.friction").unlink()
    (folder / "run.restart").unlink()
    (folder / "run.friction.part").write_text("\n".join(lines[:30]) + "\n")
    (folder / "run.a.restart").write_bytes(b"12000" + b"LammpS RestartT\0")
    (folder / "run.b.restart").write_bytes(b"16000" + b"LammpS Res")
    result = campaign("run", plan, "-o", out)
    assert result.returncode == 0
    assert (
        "run.a.restart" in json.loads((folder / "run.json").read_text())["attempts"][-1]["command"]
    )
    assert (folder / "run.friction").read_text() == "\n".join(lines)


def test_process_left_over_by_a_killed_call_is_ended(plan, tmp_path):
    out = tmp_path / "out"
    (out / "v2").mkdir(parents=True)
    left = subprocess.Popen(["/bin/sh", "-c", "sleep 100; : run.friction.part"], cwd=out / "v2")
    result = campaign("run", plan, "-o", out)
    assert result.returncode == 0, result.stdout + result.stderr
    assert left.wait(timeout=10) == -signal.SIGTERM


def test_interrupt_ends_in_order(plan, tmp_path):
    out = tmp_path / "out"
    call = subprocess.Popen(
        [CAMPAIGN, "run", plan, "-o", out, "-j", "1"],
        stdout=subprocess.PIPE,
        text=True,
        env=environment(FAKE_LMP_ROW="0.05"),
    )
    wait_for(lambda: list(out.glob("*/run.friction.part")))
    call.send_signal(signal.SIGINT)
    output, _ = call.communicate(timeout=20)
    assert call.returncode == 6
    assert "the same call goes on" in output
    assert not logs(out)


def test_failed_run_does_not_stop_the_others(tmp_path):
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{v: [13, 5], ns: 1}]\n")
    result = campaign("run", path, "-o", tmp_path / "out")
    assert result.returncode == 1
    assert "v13: failed: ERROR: Lost atoms" in result.stdout
    assert "1 finished, 1 failed" in result.stdout
    assert list(logs(tmp_path / "out")) == ["v5"]
    assert "Lost atoms" in campaign("status", path, "-o", tmp_path / "out").stdout
    again = campaign("run", path, "-o", tmp_path / "out")
    assert again.returncode == 1

    def attempts():
        return json.loads((tmp_path / "out" / "v13" / "run.json").read_text())["attempts"]

    assert len(attempts()) == 1
    campaign("run", path, "-o", tmp_path / "out", "--retry")
    assert len(attempts()) == 2


def test_one_run_a_job_and_two_calls_at_once(plan, tmp_path):
    out = tmp_path / "out"
    calls = [
        subprocess.Popen(
            [CAMPAIGN, "one", plan, "-o", out, "--index", str(k)],
            stdout=subprocess.DEVNULL,
            env=environment(FAKE_LMP_ROW="0.02"),
        )
        for k in (0, 1, 2, 2)
    ]
    assert sorted(call.wait(timeout=60) for call in calls) in ([0, 0, 0, 0], [0, 0, 0, 6])
    assert len(logs(out)) == 3
    for name in logs(out):
        assert len(json.loads((out / name / "run.json").read_text())["attempts"]) == 1
    one_line(campaign("one", plan, "-o", out, "--index", 3), 2, "--index 3", "0 to 2")


@pytest.mark.skipif(not shutil.which("mpirun"), reason="no mpirun")
def test_under_mpirun_the_ranks_share_the_runs(plan, tmp_path):
    out = tmp_path / "out"
    env = environment(
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        FAKE_LMP_ROW="0.02",
        OMPI_MCA_rmaps_base_oversubscribe="1",
    )
    result = subprocess.run(
        ["mpirun", "-np", "2", CAMPAIGN, "run", plan, "-o", out],
        capture_output=True,
        text=True,
        timeout=60,
        env=env,
        check=False,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    assert result.stdout.count("3 finished") == 1
    assert len(logs(out)) == 3
    for name in logs(out):
        assert len(json.loads((out / name / "run.json").read_text())["attempts"]) == 1


def test_longer_but_not_other(plan, tmp_path):
    out = tmp_path / "out"
    campaign("run", plan, "-o", out)
    plan.write_text(PLAN.replace("ns: 2", "ns: 3"))
    result = campaign("run", plan, "-o", out)
    assert result.returncode == 0
    assert "v2: goes on from 2 ns" in result.stdout
    assert logs(out)["v2"].rstrip("\n").split("\n")[-1].split()[1] == "3"
    plan.write_text(PLAN)
    one_line(campaign("run", plan, "-o", out), 3, "longer, not shorter")
    plan.write_text(PLAN.replace("seed: 7", "seed: 8").replace("ns: 2", "ns: 3"))
    one_line(campaign("run", plan, "-o", out), 3, "was begun with seed = 7, the plan says 8")


def test_input_script_is_not_changed_on_the_way(plan, tmp_path):
    out = tmp_path / "out"
    shutil.copy(plans.read(str(plan)).runs[0].input, tmp_path / "in.mine")
    campaign("run", plan, "-o", out)
    longer = PLAN.replace("ns: 2", "ns: 3")
    plan.write_text(longer + "input: in.mine\n")
    one_line(
        campaign("run", plan, "-o", out),
        3,
        "was begun with input = examples/friction/in.friction, the plan says in.mine",
    )
    for record in out.glob("*/run.json"):  # those of earlier versions do not say which it was
        data = json.loads(record.read_text())
        del data["parameters"]["input"]
        record.write_text(json.dumps(data))
    assert campaign("run", plan, "-o", out).returncode == 0


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


def test_the_exit_code_does_not_depend_on_the_folders_name(plan, tmp_path):
    out = tmp_path / "mylmp_written"
    campaign("run", plan, "-o", out)
    plan.write_text(PLAN.replace("seed: 7", "seed: 8"))
    for words in (["run"], ["status"], ["pack", "--to", tmp_path / "packed"]):
        one_line(campaign(*words, plan, "-o", out), 3, "was begun with seed = 7, the plan says 8")
    assert not (tmp_path / "packed").exists()


def test_a_folder_that_is_not_there(plan, tmp_path):
    for words in (["status"], ["pack", "--to", tmp_path / "packed"]):
        one_line(campaign(*words, plan, "-o", tmp_path / "missing"), 3, "missing: no such folder")
    assert [p.name for p in tmp_path.iterdir()] == ["plan.yaml"]


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A finished run, and its plan; copied before it is damaged."""
    top = tmp_path_factory.mktemp("finished")
    (top / "plan.yaml").write_text(HEAD + "runs: [{name: a, ns: 2}]\n")
    assert campaign("run", top / "plan.yaml", "-o", top / "out").returncode == 0
    return top


@pytest.mark.parametrize(
    "damage, commands, part",
    [
        (
            lambda a: (a / "run.json").write_text("[]"),
            ("status", "run", "pack"),
            "run.json: is damaged",
        ),
        (
            lambda a: (a / "run.json").write_text("{"),
            ("status", "run", "pack"),
            "run.json: is damaged",
        ),
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
        (
            lambda a: edit(a / "run.json", "-in", "in"),
            ("pack",),
            "run.json: a command in it is no command of a run",
        ),
        (
            lambda a: edit(a / "run.friction", "\n3000 0.15 ", "\n3000 much "),
            ("pack",),
            ":12: '3000 much",
        ),
        (
            lambda a: edit(a / "run.friction", r" 15 (\S+) 3456", " 15 rough 3456"),
            ("status", "pack"),
            "rough",
        ),
        (
            lambda a: edit(a / "run.friction", "\nstep [^\n]*", ""),
            ("pack",),
            "the names of the columns are missing",
        ),
        (
            lambda a: edit(a / "run.friction", r"(?s)\n16000 .*", "\n"),
            ("pack",),
            "the log ends at 0.75 of 2 ns",
        ),
        (lambda a: (a / "run.friction").write_text(""), ("pack",), "the log ends at 0 of 2 ns"),
        (
            lambda a: (a / "run.friction").write_bytes(b"\xff\n"),
            ("status",),
            "run.friction: cannot be read",
        ),
    ],
)
def test_damaged_folder_is_one_clear_line(finished, tmp_path, damage, commands, part):
    shutil.copytree(finished / "out", tmp_path / "out")
    damage(tmp_path / "out" / "a")
    for command in commands:
        more = ["--to", tmp_path / "packed"] if command == "pack" else []
        result = campaign(command, finished / "plan.yaml", "-o", tmp_path / "out", *more)
        one_line(result, 3, str(tmp_path / "out" / "a"), part)
    assert not (tmp_path / "packed").exists()


def edit(path, pattern, text):
    changed, count = re.subn(pattern, text, path.read_text(), count=1)
    assert count == 1
    path.write_text(changed)


def test_pack_of_too_many_rows_in_one(finished, tmp_path):
    result = campaign(
        "pack",
        finished / "plan.yaml",
        "-o",
        finished / "out",
        "--to",
        tmp_path / "packed",
        "--rows",
        41,
    )
    one_line(result, 2, "--rows 41", "has fewer rows")
    assert not (tmp_path / "packed").exists()


def test_a_log_without_a_row_is_no_finished_run(tmp_path):
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{name: a, ns: 1, row: 1}]\n")
    (tmp_path / "lmp").write_text("#!/bin/sh\necho '# no row' > run.friction.part\n")
    (tmp_path / "lmp").chmod(0o755)
    result = campaign(
        "run", path, "-o", tmp_path / "out", env=environment(MCAWR_LMP=str(tmp_path / "lmp"))
    )
    assert result.returncode == 1 and not result.stderr
    assert "a: failed: ended without an error, but the log ends at 0 of 1 ns" in result.stdout


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


@pytest.mark.parametrize(
    "variables, place",
    [
        ({}, (0, 1)),
        ({"SLURM_PROCID": "0", "SLURM_NTASKS": "32"}, (0, 1)),  # a batch script
        ({"SLURM_PROCID": "3", "SLURM_NTASKS": "32", "SLURM_STEP_NUM_TASKS": "8"}, (3, 8)),
        ({"SLURM_PROCID": "x", "SLURM_STEP_NUM_TASKS": "8"}, (0, 1)),
        (
            {
                "OMPI_COMM_WORLD_RANK": "1",
                "OMPI_COMM_WORLD_SIZE": "2",
                "SLURM_PROCID": "0",
                "SLURM_STEP_NUM_TASKS": "1",
            },
            (1, 2),
        ),
    ],
)
def test_place_among_the_ranks_of_a_launcher(monkeypatch, variables, place):
    for names in runner.RANKS:
        for name in names:
            monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert runner.place() == place


def test_pack_averages_rows_and_keeps_the_command(plan, tmp_path):
    out = tmp_path / "out"
    campaign("run", plan, "-o", out)
    result = campaign("pack", plan, "-o", out, "--to", tmp_path / "packed", "--rows", 4)
    assert result.returncode == 0, result.stderr
    whole = [line.split() for line in logs(out)["v2"].split("\n") if line[:1].isdigit()]
    text = (tmp_path / "packed" / "v2.friction").read_text()
    rows = [line.split() for line in text.split("\n") if line[:1].isdigit()]
    assert len(rows) == 10
    assert rows[0][0] == whole[3][0]
    assert math.isclose(float(rows[0][5]), sum(float(r[5]) for r in whole[:4]) / 4, rel_tol=1e-6)
    assert float(rows[0][7]) == 8
    assert '"command": "lmp -in examples/friction/in.friction' in text
    assert str(tmp_path) not in text


def test_packed_command_is_of_any_checkout_and_of_the_whole_length():
    begun = (
        "/elsewhere/build/bin/lmp -in /elsewhere/examples/friction/in.friction -var p 2 -var ns 30"
    )
    command = pack.portable(
        [begun, begun.replace("ns 30", "ns 100 -var continue 1 -var restart run.restart")]
    )
    assert command == "lmp -in examples/friction/in.friction -var p 2 -var ns 100"


@pytest.mark.parametrize(
    "text, parts",
    [
        ("", ["is empty"]),
        ("runs: [", ["not YAML"]),
        ("title: x\nruns: [{p: 1}]\n", [":1: no plan"]),
        ("format: mca-campaign 2\nruns: [{p: 1}]\n", ["'mca-campaign 2' cannot be read"]),
        (HEAD + "runs: []\n", ["at least one run"]),
        (
            HEAD + "runs:\n  - {p: 1}\n  - {presure: 1}\n",
            [":4: unknown key 'presure'; the nearest known one is"],
        ),
        (
            HEAD + "defaults: {strenght: 3}\nruns: [{p: 1}]\n",
            [":2: unknown key in defaults 'strenght'", "'strength'"],
        ),
        (HEAD + "run: [{p: 1}]\n", ["unknown key 'run'", "'runs'"]),
        (HEAD + "runs: [{p: -1}]\n", [":2: p: '-1' is not allowed, must be a number > 0 (MPa)"]),
        (HEAD + "runs: [{p: .nan}]\n", ["p: '.nan'"]),
        (HEAD + "runs: [{v: .inf}]\n", ["v: '.inf'"]),
        (HEAD + "runs: [{v: fast}]\n", ["v: 'fast'"]),
        (
            HEAD + "runs: [{columns: 4.5}]\n",
            ["columns: '4.5' is not allowed, must be a whole number >= 4"],
        ),
        (HEAD + "runs: [{p: []}]\n", ["p: an empty list"]),
        (HEAD + "runs: [{p: 1, p: 2}]\n", ["key 'p' stands twice"]),
        (HEAD + "runs: [{p: 1}, {p: 1.0}]\n", ["different names"]),
        (HEAD + "input: absent.in\nruns: [{p: 1}]\n", [":2: input: no such file"]),
        (HEAD + "input: ..\nruns: [{p: 1}]\n", [":2: input: no such file"]),
        (HEAD + "input: 5\nruns: [{p: 1}]\n", [":2: input: '5' is not allowed, must be text"]),
        (HEAD + "input: [a]\nruns: [{p: 1}]\n", [":2: input: '[...]'"]),
        (HEAD + "title: {a: 1}\nruns: [{p: 1}]\n", [":2: title: '{...}'"]),
        # what would be written outside the folder, or over the plan
        (HEAD + "runs: [{name: a/b}]\n", ["name: 'a/b'"]),
        (HEAD + "runs:\n  - p: 1\n    name: ..\n", [":4: name: '..' is not allowed"]),
        (HEAD + "runs: [{laws: [b, ../../esc]}]\n", [":2: name: 'laws../../esc' is not allowed"]),
        (HEAD + "runs: [{name: plan.yaml}]\n", ["name: 'plan.yaml'"]),
        (HEAD + "runs: [{name: [a, b]}]\n", ["name: '[...]'"]),
        # numbers that leave no step, kappa or log
        (
            HEAD + "runs: [{strength: 1e-200}]\n",
            ["strength: '1e-200' is not allowed, must be of a size in 1e-12 .. 1e+12 (MPa)"],
        ),
        (HEAD + "runs: [{v: 1e200}]\n", ["v: '1e+200'"]),
        (HEAD + "runs: [{E: 1e300, rho: 1e-30}]\n", ["E: '1e+300'"]),
        (HEAD + "runs: [{ns: 1e308}]\n", ["ns: '1e+308'"]),
        (HEAD + "runs: [{eta: 1e308}]\n", ["eta: '1e+308'"]),
        (HEAD + f"runs: [{{seed: 1{'0' * 400}}}]\n", ["seed: '1000", "0...' is not allowed"]),
        (HEAD + f"runs: [{{seed: 1{'0' * 5000}}}]\n", ["seed: '1000", "0...' is not allowed"]),
        (
            HEAD + "runs: [{ns: 0.1, row: 10}]\n",
            [":2: row: '10' is not allowed, must be <= ns = 0.1"],
        ),
        (
            HEAD + "runs: [{ns: 1e-6, row: 1e-6}]\n",
            ["ns: '1e-06' is not allowed, must be at least a step, 5e-05 ns"],
        ),
        (
            HEAD + "runs:\n  - rows: 8\n    held: 100\n",
            [":4: held: '100' is not allowed, must be less than half of rows = 8"],
        ),
        # numbers that YAML 1.1 reads in its own way
        (HEAD + "runs: [{p: 010}]\n", ["p: '010' is not allowed", "written like 12 or 1.5e-5"]),
        (HEAD + "runs: [{v: 1:30}]\n", ["v: '1:30'"]),
        (HEAD + "runs: [{p: 1_000}]\n", ["p: '1_000'"]),
        (HEAD + "runs: [{p: !!int x}]\n", ["p: 'x'"]),
        (HEAD + f"runs: {'[' * 3000}\n", ["nested too deep"]),
        (HEAD + "runs: [{p: [[1]]}]\n", [":2: not YAML: nested too deep"]),
        (HEAD + "runs: [{p: &a [*a]}]\n", ["nested too deep"]),
        (HEAD + "runs: [{[1]: 2}]\n", ["a key must be a word"]),
        (HEAD + "title: \0\n", [":2: not YAML"]),
        # the line is that of the key
        (HEAD + "title: x\nruns:\n  - {p: 1}\ndefault: {v: 1}\n", [":5: unknown key 'default'"]),
        (
            HEAD + "defaults:\n  p: 1\n  vv: 2\nruns: [{p: 1}]\n",
            [":4: unknown key in defaults 'vv'"],
        ),
        (HEAD + "defaults:\n  p: 1\n  E: -5\nruns: [{p: 1}]\n", [":4: E: '-5'"]),
        (HEAD + "runs:\n  - p: 1\n    vv: 2\n", [":4: unknown key 'vv'"]),
        (HEAD + "runs:\n  - p:\n    - 1\n    - -1\n", [":5: p: '-1'"]),
        (HEAD + "runs:\n  - {p: 1}\n  -\n", [":4: runs: 'None' is not a run"]),
        (HEAD + "title: x\ndefaults: 5\nruns: [{p: 1}]\n", [":3: defaults: '5' is not allowed"]),
    ],
    ids=lambda value: repr(value).removeprefix(repr(HEAD)[:-1])[:60],
)
def test_bad_plan_is_one_clear_line(tmp_path, text, parts):
    path = tmp_path / "plan.yaml"
    path.write_text(text)
    one_line(campaign("run", path, "-o", tmp_path / "out"), 3, str(path), *parts)
    assert not (tmp_path / "out").exists()


def test_csv_plan(tmp_path):
    path = tmp_path / "plan.csv"
    path.write_text("# made by hand\nname,p,v,seed\none,15,5,1\ntwo,1.5,2,2\n")
    runs = plans.read(str(path)).runs
    assert [(r.name, r.values["p"], r.values["seed"]) for r in runs] == [
        ("one", 15, 1),
        ("two", 1.5, 2),
    ]
    path.write_text("name,p,v\none,15\n")
    one_line(campaign("list", path), 3, ":2: 2 columns, 3 are expected")
    path.write_text("name,p,vv\none,15,3\n")
    one_line(campaign("list", path), 3, ":1: unknown column 'vv'; the nearest known one is 'v'")
    path.write_text("name,p\none,much\n")
    one_line(campaign("list", path), 3, ":2: p: 'much' is not allowed, must be a number > 0 (MPa)")
    path.write_text("name,p,p\none,1,2\n")
    one_line(campaign("list", path), 3, ":1: column 'p' stands twice")
    path.write_text("name,p\none,010\n")
    one_line(campaign("list", path), 3, ":2: p: '010' is not allowed")


def test_plan_without_a_title_and_with_a_date_for_one(tmp_path):
    path = tmp_path / "plan.yaml"
    for given, title in (("", ""), (" 2001-99-99", "2001-99-99")):
        path.write_text(HEAD + f"title:{given}\nruns: [{{p: [1, 1.5e1, .5]}}]\n")
        plan = plans.read(str(path))
        assert plan.title == title
        assert [run.values["p"] for run in plan.runs] == [1, 15.0, 0.5]


def test_bad_surroundings(plan, tmp_path):
    one_line(
        campaign("run", plan, "-o", tmp_path / "o", env=environment(MCAWR_LMP="/nonexistent/lmp")),
        5,
        "lmp is not there",
    )
    (tmp_path / "file").write_text("")
    one_line(campaign("run", plan, "-o", tmp_path / "file" / "o"), 5, "cannot be made")
    one_line(
        campaign("run", plan, "-o", tmp_path / "o", "--launcher", "nosuchlauncher -n 2"),
        5,
        "nosuchlauncher",
    )
    (tmp_path / "lmp").write_text("no program")
    (tmp_path / "lmp").chmod(0o755)
    one_line(
        campaign(
            "run", plan, "-o", tmp_path / "o", env=environment(MCAWR_LMP=str(tmp_path / "lmp"))
        ),
        5,
        "Exec format",
    )
    one_line(campaign("list", "velocty"), 3, "the nearest known one is 'velocity'")
    assert campaign("run", plan).returncode == 2
    assert campaign("--help").returncode == 0


def test_step_follows_the_material():
    def dt(**values):
        return plans.Run(
            "x", {**{k: key.default for k, key in plans.KEYS.items()}, **values}, ""
        ).dt

    assert dt() == 5e-5
    assert dt(E=4 * 206000) == 2.5e-5  # half the time of sound
    assert dt(rho=4 * 7800) == 5e-5  # never longer
    assert dt(eta=0.82) == 2.5e-5  # half the viscous time
    assert dt(rho=1950) == pytest.approx(1.2e-5)
    assert dt(dt=1e-5) == 1e-5


SHIPPED = {
    "paper36": 36,
    "collapse10": 10,
    "velocity": 16,
    "pressure": 16,
    "paper36-rows32": 36,
    "collapse10-rows32": 10,
    "velocity-rows32": 16,
    "pressure-rows32": 16,
    "viscosity": 10,
    "roughness": 6,
    "viscosity-rows32": 10,
    "roughness-rows32": 6,
    "height": 8,
    "smoke": 6,
    "variants": 48,
    "convergence": 24,
    "timestep": 59,
    "corrected": 26,
}


@pytest.mark.parametrize("name, least", SHIPPED.items())
def test_shipped_plans(name, least):
    plan = plans.read(plans.find(name))
    assert len(plan.runs) >= least and plan.title
    assert campaign("list", name).returncode == 0


def test_a_folder_does_not_hide_the_plan_of_its_name(tmp_path, monkeypatch):
    (tmp_path / "paper36").mkdir()
    monkeypatch.chdir(tmp_path)
    assert plans.find("paper36") == os.path.join(plans.SHIPPED, "paper36.yaml")


def test_paper36_covers_the_papers_ranges():
    runs = plans.read(plans.find("paper36")).runs
    assert len(runs) == 36
    kappa1, kappa2 = sorted(r.kappa1 for r in runs), sorted(r.kappa2 for r in runs)
    assert kappa1[0] < 0.1 and kappa1[-1] == pytest.approx(19, rel=0.01)
    assert kappa2[0] == pytest.approx(2, rel=0.05) and kappa2[-1] == pytest.approx(633, rel=0.01)
    for key, low, high in (("p", 0.5, 26), ("v", 1, 10), ("strength", 92, 552)):
        values = [r.values[key] for r in runs]
        assert min(values) == low and max(values) == high
    for key in ("E", "rho", "eta"):
        assert len({r.values[key] for r in runs}) >= 3


def test_collapse10_has_one_kappa():
    runs = plans.read(plans.find("collapse10")).runs
    assert len(runs) == 10
    for run in runs:
        assert run.kappa1 == pytest.approx(runs[0].kappa1, rel=1e-3)
        assert run.kappa2 == pytest.approx(runs[0].kappa2, rel=1e-3)


def test_page_has_every_key_option_and_plan():
    page = (ROOT / "doc" / "campaign.md").read_text()
    keys = dict(
        re.findall(
            r"^\| `(\w+)` \| ([^|]+) \| "
            r"(?:ns|MPa|m/s|kg|Pa|Poisson|automata|rows|nm|of the|preset)[^|]*\|$",
            page,
            re.MULTILINE,
        )
    )
    assert list(keys) == list(plans.KEYS)
    for name, key in plans.KEYS.items():
        if key.default is not None:
            assert keys[name] == (
                key.default if isinstance(key.default, str) else f"{key.default:g}"
            )
    options = set()
    for command in ("list", "run", "one", "status", "pack"):
        options |= set(
            re.findall(
                r"(?<![\w-])(--?[a-z]+)", campaign(command, "--help").stdout.split("options:")[1]
            )
        )
    syntax = page.split("## Examples")[0]
    table = set(re.findall(r"`(--?[a-z]+)`", syntax))
    assert options - {"-h", "--help", "-np"} == table
    shipped = dict(
        re.findall(
            r"^\| `([\w-]+)` \| (\d+) \|",
            page.split("### Shipped plans")[1].split("###")[0],
            re.MULTILINE,
        )
    )
    assert {n: int(k) for n, k in shipped.items()} == {
        n: len(plans.read(plans.find(n)).runs) for n in SHIPPED
    }


@pytest.mark.skipif(not REAL.exists(), reason="lmp is not built")
def test_real_run_goes_on_after_a_kill(tmp_path):
    path = tmp_path / "plan.yaml"
    path.write_text(
        HEAD + "defaults: {columns: 12, rows: 12, roughness: 1, row: 0.01, checkpoint: 0.1}\n"
        "runs: [{name: tiny, ns: 0.6}]\n"
    )
    env = environment(MCAWR_LMP=str(REAL))
    out = tmp_path / "out"
    call = subprocess.Popen([CAMPAIGN, "run", path, "-o", out], stdout=subprocess.DEVNULL, env=env)
    wait_for(lambda: list(out.glob("tiny/run.a.restart")))
    call.send_signal(signal.SIGKILL)
    call.wait()
    wait_for(lambda: "running" not in campaign("status", path, "-o", out).stdout)
    assert not (out / "tiny" / "run.friction").exists()
    result = campaign("run", path, "-o", out, env=env, timeout=120)
    assert result.returncode == 0, result.stdout + result.stderr
    campaign("run", path, "-o", tmp_path / "whole", env=env, timeout=120)

    def rows(folder):
        return [line.split() for line in logs(folder)["tiny"].split("\n") if line[:1].isdigit()]

    assert [int(r[0]) for r in rows(out)] == [200 * i for i in range(1, 61)]
    # rounding errors have no time to grow in 0.6 ns
    for resumed, uninterrupted in zip(rows(out), rows(tmp_path / "whole")):
        assert float(resumed[5]) == pytest.approx(float(uninterrupted[5]), abs=1e-3)
