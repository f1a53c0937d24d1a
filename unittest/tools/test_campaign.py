# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/campaign: running, killing and going on, failures, several workers."""

import json
import os
import re
import resource
import shlex
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest

from campaign_calls import (
    CAMPAIGN,
    FAKE,
    HEAD,
    PLAN,
    REAL,
    ROOT,
    campaign,
    environment,
    logs,
    one_line,
    wait_for,
)
from campaign_parts import plan as plans, runner


LONG = pytest.mark.long


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


@pytest.mark.parametrize(
    "order, found",
    [("", "acb"), ("order: plan\n", "abc"), pytest.param("order: cost\n", "acb", marks=LONG)],
)
def test_order_of_the_runs(order, found, tmp_path):
    """The costly ones first, or as the plan says."""
    path = tmp_path / "plan.yaml"
    path.write_text(
        HEAD + order + "runs: [{name: a, ns: 2}, {name: b, ns: 0.5}, {name: c, ns: 1}]\n"
    )
    result = campaign("run", path, "-o", tmp_path / "out", "-j", 1)
    assert "".join(re.findall(r"^(\w): finished", result.stdout, re.MULTILINE)) == found


@LONG
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


@pytest.mark.parametrize("moment", [0.3, *(pytest.param(t, marks=LONG) for t in (0.9, 1.7))])
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


@pytest.mark.parametrize(
    "half",
    [
        pytest.param(b"LammpS Res", marks=LONG),
        b"mca-restart 3:\n\0" + bytes(8) + b"LammpS RestartT\0",
    ],
)
def test_half_written_checkpoint_is_not_used(plan, tmp_path, half):
    """Neither one without its end nor one without the checksum that comes after the end."""
    out = tmp_path / "out"
    campaign("run", plan, "-o", out)
    folder = out / "v2"
    lines = (folder / "run.friction").read_text().split("\n")
    (folder / "run.friction").unlink()
    (folder / "run.restart").unlink()
    (folder / "run.friction.part").write_text("\n".join(lines[:30]) + "\n")
    (folder / "run.a.restart").write_bytes(b"12000" + b"LammpS RestartT\0")
    (folder / "run.b.restart").write_bytes(b"16000" + half)
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
    assert "run the same command again to continue" in output
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


@pytest.mark.parametrize("gone", ["$PWD", pytest.param("run.json", marks=LONG)])
def test_a_folder_that_vanishes_does_not_stop_the_others(tmp_path, gone):
    path, out = tmp_path / "plan.yaml", tmp_path / "out"
    path.write_text(HEAD + "order: plan\nruns: [{v: [12, 5], ns: 1}]\n")
    (tmp_path / "lmp").write_text(
        f'#!/bin/sh\n{FAKE} "$@"\ncase "$*" in *"v 12 "*) rm -r "{gone}"; exit 1;; esac\n'
    )
    (tmp_path / "lmp").chmod(0o755)
    env = environment(MCAWR_LMP=str(tmp_path / "lmp"))
    result = campaign("run", path, "-o", out, "-j", 1, env=env)
    assert result.returncode == 6 and not result.stderr, result.stderr
    assert f"v12: failed: {out}/v12/run.json: is gone" in result.stdout
    assert "v5: finished" in result.stdout and list(logs(out)) == ["v5"]


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


MPIRUN = """#!/bin/sh
shift 2
exec "$@"
"""


@pytest.fixture
def shared(tmp_path, monkeypatch):
    """Runs of a plan that share 4 cores, with a stand-in for mpirun: {run: ranks of each attempt};
    a run is worth more ranks from this many seconds on."""

    def call(runs, worth):
        (tmp_path / "bin").mkdir()
        (tmp_path / "bin" / "mpirun").write_text(MPIRUN)
        (tmp_path / "bin" / "mpirun").chmod(0o755)
        monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}:{os.environ['PATH']}")
        monkeypatch.setenv("MCAWR_LMP", str(FAKE))
        monkeypatch.setenv("FAKE_LMP_ROW", "0.03")
        monkeypatch.setattr(runner, "WORTH", worth)
        path = tmp_path / "plan.yaml"
        path.write_text(HEAD + "defaults: {ns: 2, checkpoint: 0.2, laws: b}\nruns:\n" + runs)
        plan = plans.read(str(path))
        before = [(n, signal.getsignal(n)) for n in (signal.SIGINT, signal.SIGTERM)]
        states = runner.Campaign(str(tmp_path / "out"), plan.runs, 4, shared=True).run()
        for number, handler in before:
            signal.signal(number, handler)
        assert states["finished"] == len(plan.runs)
        commands = {
            run.name: [
                shlex.split(attempt["command"])
                for attempt in json.loads((tmp_path / f"out/{run.name}/run.json").read_text())[
                    "attempts"
                ]
            ]
            for run in plan.runs
        }
        return {
            name: [int(words[2]) if words[0] == "mpirun" else 1 for words in attempts]
            for name, attempts in commands.items()
        }

    return call


@LONG
def test_few_runs_share_the_cores(shared):
    """Two runs have two cores each, a small one no more than its automata are for."""
    assert shared("  - {name: a, columns: 160}\n  - {name: b, columns: 40}\n", 1e9) == {
        "a": [2],
        "b": [1],
    }


@LONG
def test_the_last_run_takes_the_cores_that_get_idle(shared, tmp_path):
    """It goes on from a checkpoint, and its log is whole."""
    runs = "  - {name: long, ns: 6, columns: 160}\n  - {v: [1, 2, 3], columns: 160}\n"
    ranks = shared(runs, 0.5)
    assert ranks["long"] in ([1, 2], [1, 2, 4], [1, 4])  # by when the others end
    assert [ranks[name][0] for name in ("v1", "v2", "v3")] == [1, 1, 1]
    log = (tmp_path / "out" / "long" / "run.friction").read_text()
    assert [line.split()[0] for line in log.split("\n") if line[:1].isdigit()] == [
        str(1000 * k) for k in range(1, 121)
    ]


def test_shared_cores_are_of_one_call(plan, tmp_path):
    words = ("run", plan, "-o", tmp_path / "out", "--ranks", "auto", "--launcher", "srun")
    one_line(campaign(*words), 2, "--ranks auto: runs have a rank each under mpirun and with")
    one_line(campaign(*words[:5], "many"), 2, "'many': a whole number in 1 .. 1000000, or auto")


@LONG
def test_longer_but_not_other(plan, tmp_path):
    out = tmp_path / "out"
    campaign("run", plan, "-o", out)
    plan.write_text(PLAN.replace("ns: 2", "ns: 3"))
    result = campaign("run", plan, "-o", out)
    assert result.returncode == 0
    assert "v2: goes on from 2 ns" in result.stdout
    assert logs(out)["v2"].rstrip("\n").split("\n")[-1].split()[1] == "3"
    plan.write_text(PLAN)
    for words in (["run"], ["status"], ["pack", "--to", out / "packed.tar.xz"]):
        one_line(campaign(*words, plan, "-o", out), 3, "longer, not shorter")
    plan.write_text(PLAN.replace("seed: 7", "seed: 8").replace("ns: 2", "ns: 3"))
    one_line(campaign("run", plan, "-o", out), 3, "was begun with seed = 7, the plan says 8")


def test_a_run_that_went_on_is_not_made_shorter(plan, tmp_path):
    """Neither where it has finished before, nor where it never has."""
    out = tmp_path / "out"
    plan.write_text(PLAN.replace("ns: 2", "ns: 3"))
    campaign("run", plan, "-o", out)
    for folder in out.glob("*/"):
        (folder / "run.friction").rename(folder / "run.friction.part")
    plan.write_text(PLAN)
    one_line(campaign("run", plan, "-o", out), 3, "was run for 3 ns, the plan says 2")


def test_a_run_under_another_name_is_told(plan, tmp_path):
    """A second seed gives all runs new names."""
    out = tmp_path / "out"
    plan.write_text(HEAD + "defaults: {ns: 0.5}\nruns: [{v: [2, 5], seed: [1]}]\n")
    campaign("run", plan, "-o", out)
    plan.write_text(HEAD + "defaults: {ns: 0.5}\nruns: [{v: [2, 5], seed: [1, 2]}]\n")
    said = f"warning: {out}/v2 and 1 more: is the plan's v2-seed1, by its parameters"
    assert said in campaign("status", plan, "-o", out).stdout
    (out / "v2").rename(out / "v2-seed1")
    (out / "v5").rename(out / "v5-seed1")
    result = campaign("run", plan, "-o", out)
    assert "warning" not in result.stdout and result.returncode == 0
    assert "v2-seed1" not in result.stdout  # nothing to do


def test_the_reason_of_an_own_input_script_is_kept(plan, tmp_path):
    """What lmp says before it reads it is no ERROR."""
    script = tmp_path / "lmp"
    script.write_text("#!/bin/sh\necho 'lmp: -var checkpoint: has no such variable'\nexit 2\n")
    script.chmod(0o755)
    env = environment(MCAWR_LMP=str(script))
    assert campaign("run", plan, "-o", tmp_path / "out", env=env).returncode == 1
    failed = (tmp_path / "out" / "v2" / "failed.txt").read_text()
    assert "has no such variable" in failed


def test_input_script_is_not_changed_on_the_way(plan, tmp_path):
    """Neither for another one nor in itself, and no potential file that it names."""
    out, potentials = tmp_path / "out", tmp_path / "potentials"
    script = Path(plans.read(str(plan)).runs[0].input).read_text()
    (tmp_path / "in.mine").write_text(script.replace("steel.mca", "mine.mca"))
    potentials.mkdir()
    (potentials / "mine.mca").write_text("one\n")
    env = environment(LAMMPS_POTENTIALS=str(potentials))
    assert campaign("run", plan, "-o", out, env=env).returncode == 0
    mine = tmp_path / "mine.yaml"
    mine.write_text(PLAN + "input: in.mine\n")
    one_line(
        campaign("run", mine, "-o", out, env=env),
        3,
        "was begun with input = examples/friction/in.friction, the plan says in.mine",
    )
    out = tmp_path / "mine"
    assert campaign("run", mine, "-o", out, env=env).returncode == 0
    assert campaign("status", mine, "-o", out, env=env).returncode == 0
    (potentials / "mine.mca").write_text("two\n")
    for words in (["run"], ["status"], ["pack", "--to", tmp_path / "packed.tar.xz"]):
        line = "was begun with another mine.mca, its content has changed"
        one_line(campaign(*words, mine, "-o", out, env=env), 3, line)
    (potentials / "mine.mca").write_text("one\n")
    (tmp_path / "in.mine").write_text(script.replace("steel.mca", "mine.mca") + "run 1\n")
    one_line(campaign("run", mine, "-o", out, env=env), 3, "with another in.mine")


@pytest.mark.parametrize(
    "damage, why",
    [
        (lambda text: re.sub(r"\n8000 [^\n]*", "", text), "rows are missing"),
        (lambda text: text.replace("strength: 92", "strength: 552"), "strength 552, the plan"),
        pytest.param(
            lambda text: text.replace("\n8000 0.4 ", "\n8000 nan "), ":17: time: 'nan'", marks=LONG
        ),
        pytest.param(
            lambda text: text.replace("\n8000 0.4 ", "\n8000 0x1 "), ":17: time: '0x1'", marks=LONG
        ),
        pytest.param(
            lambda text: text.replace("format: mca-friction 1", "format: x"),
            "format 'x'",
            marks=LONG,
        ),
    ],
)
def test_a_run_does_not_go_on_from_a_damaged_log(tmp_path, damage, why):
    """Said, and made again from its beginning."""
    path, out = tmp_path / "plan.yaml", tmp_path / "out"
    path.write_text(HEAD + "runs: [{name: a, laws: b, ns: 2, checkpoint: 0.2}]\n")
    assert campaign("run", path, "-o", out).returncode == 0
    log, part = out / "a" / "run.friction", out / "a" / "run.friction.part"
    whole = log.read_text()
    log.rename(part)
    part.write_text(damage(whole))
    result = campaign("run", path, "-o", out)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "a: begins anew, its log is damaged: " in result.stdout and why in result.stdout
    assert log.read_text() == whole


@pytest.mark.parametrize("strength", [50, pytest.param(300, marks=LONG)])
def test_a_run_of_two_materials_finishes_and_goes_on(tmp_path, strength):
    """Whichever block is the weaker one, of which the head of the log is."""
    aluminium = (ROOT / "examples" / "campaign" / "aluminium.mca").read_text()
    text = re.sub(r"(?m)^strength .*$", f"strength {strength}", aluminium)
    (tmp_path / "upper.mca").write_text(text)
    path, out = tmp_path / "plan.yaml", tmp_path / "out"
    run = "name: a, ns: 2, dt: 2.0e-5, p: 9, checkpoint: 0.2, upper_material: upper.mca"
    path.write_text(HEAD + "runs: [{" + run + "}]\n")
    result = campaign("run", path, "-o", out)
    assert result.returncode == 0, result.stdout + result.stderr
    log, part = out / "a" / "run.friction", out / "a" / "run.friction.part"
    whole = log.read_text()
    assert f"strength: {min(strength, 92)}" in whole
    lines = whole.split("\n")
    part.write_text("\n".join(lines[:30]) + "\n")
    (out / "a" / "run.a.restart").write_bytes(lines[29].split()[0].encode() + b"LammpS RestartT\0")
    log.unlink()
    (out / "a" / "run.restart").unlink()
    result = campaign("run", path, "-o", out)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "a: goes on from" in result.stdout and log.read_text() == whole


NO_RESULT = [  # what a run of lmp that ends without an error may leave, and why it is no result
    ("printf '# no row\\n' > run.friction.part", "not a friction log"),
    ("edit '/^[0-9]/d'", "the log ends at 0 of 1 ns"),
    ("edit '12,$d'", "the log ends at"),
    ("edit '10,12d'", "the log begins at 0.2 ns: rows are missing"),
    ("edit '12d'", "run.friction.part:12: 2000 steps"),
    ("edit '12s/ 15 / nan /'", ":12: normal_stress: 'nan'"),
    ("edit 's/ 3456 / 0 /'", "no link is left"),
    ("edit 's/ 15 [0-9.]* 3456/ 15 0 3456/'", "mu of its second half is 0"),
    ("edit 's/ 15 [0-9.]* 3456/ 15 -670 3456/'", "mu of its second half is -670, not above 0"),
    ("edit 's/ 15 \\([0-9.]*\\) 3456/ 9 \\1 3456/'", "normal stress of its second half is 9 MPa"),
    ("edit 's/pressure: 15/pressure: 16/'", "its head says pressure 16, the plan p 15"),
    ("printf 40000 > run.restart", "run.restart is incomplete"),
    ("rm run.friction.part", "cannot be read"),
]


@pytest.mark.parametrize(
    "damage, why",
    [
        pytest.param(*row, id=row[1], marks=[LONG] if k % 3 else [])
        for k, row in enumerate(NO_RESULT)
    ],
)
def test_what_is_no_result_is_not_finished(tmp_path, damage, why):
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{name: a, ns: 1, roughness: 0, d: 1.0e-4, dt: 5.0e-5}]\n")
    (tmp_path / "lmp").write_text(
        f'#!/bin/sh\n{FAKE} "$@"\nedit() {{ sed -i "$1" run.friction.part; }}\n{damage}\n'
    )
    (tmp_path / "lmp").chmod(0o755)
    env = environment(MCAWR_LMP=str(tmp_path / "lmp"))
    result = campaign("run", path, "-o", tmp_path / "out", env=env)
    assert result.returncode == 1 and not result.stderr, result.stderr
    assert "a: failed: ended without an error, but " in result.stdout
    assert why in result.stdout, result.stdout
    assert not (tmp_path / "out" / "a" / "run.friction").exists()


WITH_STATE = (  # the log's columns of today, with these numbers in each row
    "sed -i -e 's/ gap$/ gap room lost flow_energy breaking_energy contact_energy/' "
    "-e '/^[0-9]/s/$/ {}/' run.friction.part"
)


@pytest.mark.parametrize(
    "numbers, shown, warned",
    [
        ("1.02 0 0 0 0", "1.020", None),
        ("0.969 0 0 0 0", "0.969", "automata have 0.969 of the solid's room, at least 0.970 is"),
        pytest.param(
            "1.02 2 0 0 0",
            "1.020",
            "2 automata left through the held or the driven rows",
            marks=LONG,
        ),
        pytest.param(
            "1.02 0 -900 5 5", "1.020", "what flow, breaking or contacts dissipate fell", marks=LONG
        ),
    ],
)
def test_report_says_whether_the_layer_is_a_solid(tmp_path, numbers, shown, warned):
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{name: a, ns: 1}]\n")
    (tmp_path / "lmp").write_text(f'#!/bin/sh\n{FAKE} "$@"\n{WITH_STATE.format(numbers)}\n')
    (tmp_path / "lmp").chmod(0o755)
    env = environment(MCAWR_LMP=str(tmp_path / "lmp"))
    result = campaign("run", path, "-o", tmp_path / "out", env=env)
    assert result.returncode == 0, result.stdout + result.stderr
    status = campaign("status", path, "-o", tmp_path / "out", env=env).stdout
    assert f", room {shown}\n" in result.stdout and f" {shown}" in status.splitlines()[1]
    for text in (result.stdout, status):
        assert ("warning: " in text) == (warned is not None)
        assert warned is None or warned in text


@pytest.mark.parametrize(
    "rows, warned", [("$", None), ("1000|2000", None), ("1[0-9]000|20000", "100 % of the second")]
)
def test_report_says_that_a_layer_was_worn_smooth(tmp_path, rows, warned):
    """Where no link broke while it slid by a diameter, the ten rows of its second half."""
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{name: a, ns: 1, laws: b}]\n")
    edit = f"sed -i -E '/^({rows}) /s/ 3456 2 / 3456 0 /' run.friction.part"
    (tmp_path / "lmp").write_text(f'#!/bin/sh\n{FAKE} "$@"\n{edit}\n')
    (tmp_path / "lmp").chmod(0o755)
    env = environment(MCAWR_LMP=str(tmp_path / "lmp"))
    result = campaign("run", path, "-o", tmp_path / "out", env=env)
    assert result.returncode == 0, result.stdout + result.stderr
    assert ("warning: " in result.stdout) == (warned is not None)
    assert warned is None or f"worn smooth for {warned} half: too narrow" in result.stdout


@pytest.mark.parametrize(
    "number, outcome",
    [
        ("KILL", "interrupted"),
        ("SEGV", "failed"),
        pytest.param("HUP", "interrupted", marks=LONG),
        pytest.param("ABRT", "failed", marks=LONG),
    ],
)
def test_faults_are_no_interruptions(tmp_path, number, outcome):
    """A run that crashes is not begun again by each call."""
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{name: a, ns: 1}]\n")
    (tmp_path / "lmp").write_text(f"#!/bin/sh\nulimit -c 0\nkill -{number} $$\n")
    (tmp_path / "lmp").chmod(0o755)
    env = environment(MCAWR_LMP=str(tmp_path / "lmp"))
    result = campaign("run", path, "-o", tmp_path / "out", env=env)
    assert result.returncode == {"failed": 1, "interrupted": 6}[outcome]
    assert f"a: {outcome}: " in result.stdout and f"SIG{number}" in result.stdout


@pytest.mark.parametrize("limit", [2000, *(pytest.param(n, marks=LONG) for n in (0, 300, 20000))])
def test_full_disk(plan, tmp_path, limit):
    """Files of limited size stand for it: the disk is blamed, no run is called failed, and with
    room the same call goes on."""
    out = tmp_path / "out"
    if limit == 20000:
        plan.write_text(PLAN.replace("ns: 2", "ns: 30"))
    result = campaign(
        "run", plan, "-o", out, "-j", 1,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)),
    )  # fmt: skip
    one_line(result, 5, "the disk is full" if out.exists() and limit else "File too large")
    assert not list(out.glob("*/failed.txt")) and not list(out.rglob("*.part[0-9]"))
    assert not [p for p in out.rglob(".*") if p.name != "."]
    result = campaign("run", plan, "-o", out)
    assert result.returncode == 0 and "3 finished" in result.stdout


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


@pytest.mark.skipif(not REAL.exists(), reason="lmp is not built")
def test_real_run_goes_on_after_a_kill(tmp_path):
    path = tmp_path / "plan.yaml"
    path.write_text(
        HEAD
        + "defaults: {laws: b, columns: 12, rows: 12, roughness: 1, row: 0.01, checkpoint: 0.1}\n"
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
