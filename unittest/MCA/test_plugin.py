# SPDX-License-Identifier: GPL-2.0-or-later
"""Loading the plugin: by command, by path, twice, after clear; two runs in one input."""

import os
import pathlib
import shutil
import subprocess

import pytest

from lmp_run import LMP, PLUGIN, STEEL, fails, lmp, periodic_block

BARE = os.environ["MCA_LMP_BARE"]
SAMPLE = (
    periodic_block()
    + """pair_style mca
pair_coeff * * steel.mca
mca_links create all all
velocity all create 1.0 4711
fix 1 all nve/mca
compute links all mca/atom links
compute sum all reduce sum c_links
thermo_style custom step pe c_sum
"""
)


def bare(script, folder, path=None, **more):
    env = {
        "LAMMPS_POTENTIALS": os.path.join(os.environ["PROJECT_SOURCE"], "potentials"),
        "LAMMPS_PLUGIN_PATH": path or "",
    }
    if os.environ.get("MCA_PRELOAD"):  # a plugin with sanitizers needs their libraries first
        env.update(LD_PRELOAD=os.environ["MCA_PRELOAD"], ASAN_OPTIONS="detect_leaks=0")
    return lmp(script, folder, launcher=BARE, env=env, **more)


def test_plugin_load(tmp_path):
    result = bare(f"plugin load {PLUGIN}\n{SAMPLE}\nrun 10\n", tmp_path)
    assert result.thermo[0]["c_sum"][-1] == 6 * 80


def test_plugin_path(tmp_path):
    assert bare(SAMPLE + "run 10\n", tmp_path, path=os.path.dirname(PLUGIN)).rc == 0


@pytest.mark.parametrize("example", ["friction", "space"])
def test_a_variable_that_the_script_does_not_have(tmp_path, example):
    """LAMMPS alone takes any."""
    script = f"{os.environ['PROJECT_SOURCE']}/examples/{example}/in.friction"
    known = ["-var", "ns", "0", "-var", "laws", "c", "weld", "-var", "columns", "8"]
    for words, refused in ((["-var", "strenght", "300"], True), ([], False)):
        done = subprocess.run(
            [LMP, "-in", script, "-log", "none", *known, *words],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            timeout=100,
            check=False,
        )
        named = "lmp: -var strenght: " in done.stderr and "; known: p v strength " in done.stderr
        assert named == refused and (done.returncode == 2) == refused, done.stderr


def test_a_folder_with_a_colon(tmp_path):
    """LAMMPS separates folders by colons; the wrapper of the build hands on any."""
    build = pathlib.Path(PLUGIN).parents[1]
    project = tmp_path / "MCA: 1.0"
    for folder in ("bin", "lib", "potentials"):
        (project / folder).mkdir(parents=True)
    shutil.copy(PLUGIN, project / "lib")
    shutil.copy(STEEL, project / "potentials" / "other_steel.mca")
    wrapper = (build / "bin" / "lmp").read_text(encoding="utf-8")
    wrapper = wrapper.replace(str(STEEL.parent), str(project / "potentials"))
    (project / "bin" / "lmp").write_text(wrapper, encoding="utf-8")
    (project / "bin" / "lmp").chmod(0o755)
    script = SAMPLE.replace("steel.mca", "other_steel.mca") + "run 10\n"
    for ranks in (1, 2):
        result = lmp(script, tmp_path, ranks=ranks, launcher=str(project / "bin" / "lmp"))
        assert result.thermo[0]["c_sum"][-1] == 480


def test_without_the_plugin_the_style_is_unknown(tmp_path):
    result = bare(SAMPLE, tmp_path, check=False)
    assert result.rc != 0 and "Unrecognized pair style 'mca'" in result.out + result.err


def test_loading_twice(tmp_path):
    result = bare(f"plugin load {PLUGIN}\nplugin load {PLUGIN}\n{SAMPLE}\nrun 10\n", tmp_path)
    assert result.thermo[0]["c_sum"][-1] == 480


def test_clear_and_again(tmp_path):
    once = SAMPLE + "run 10\n"
    result = bare(f"{once}clear\n{once}", tmp_path, path=os.path.dirname(PLUGIN))
    first, second = result.thermo
    assert (first["PotEng"] == second["PotEng"]).all()
    result = bare(
        f"plugin load {PLUGIN}\n{once}clear\nplugin load {PLUGIN}\n{once}", tmp_path / "b"
    )
    assert len(result.thermo) == 2


@pytest.mark.parametrize("between", ["", "pair_style mca\npair_coeff * * steel.mca\n"])
def test_two_runs_in_one_input(tmp_path, between):
    result = lmp(SAMPLE + "run 10\n" + between + "run 10\n", tmp_path)
    assert len(result.thermo) == 2
    if not between:
        assert result.thermo[1]["PotEng"][0] == result.thermo[0]["PotEng"][-1]


def test_unload(tmp_path):
    script = (
        f"plugin load {PLUGIN}\n{SAMPLE}\nrun 5\nplugin unload pair mca\npair_style zero 5.0\n"
        "pair_coeff * *\n"
    )
    assert bare(script, tmp_path).rc == 0


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=pytest.mark.long)])
def test_step_above_the_critical_one_is_refused(tmp_path, ranks):
    fails(
        SAMPLE + "timestep 1e-4\nrun 10\n",
        tmp_path,
        "Timestep 0.0001 is longer than the critical",
        "5.77",
        ranks=ranks,
    )
    script = SAMPLE.replace("pair_style mca", "pair_style mca viscosity normal steps plain")
    fails(
        script + "timestep 1e-4\nrun 10\n",
        tmp_path,
        "Timestep 0.0001 is longer than the critical",
        "5.69",
        ranks=ranks,
    )
    script = SAMPLE.replace("pair_style mca", "pair_style mca viscosity none plasticity none")
    fails(script + "timestep 3e-4\nrun 10\n", tmp_path, "0.000277")
    stable = script + "timestep 2.7e-4\nrun 10\n"
    words = "Timestep 0.00027 is 0.97 of the critical one of elasticity, 0.000277"
    assert words in lmp(stable, tmp_path).out  # but not exact where links break
    assert words not in lmp(stable.replace("mca vis", "mca fracture none vis"), tmp_path).out
    assert "of elasticity" not in lmp(script + "timestep 1.3e-4\nrun 10\n", tmp_path).out
    # also when it grows during the input
    fails(script + "run 5\ntimestep 3e-4\nrun 10\n", tmp_path, "0.000277")
    # a link that flows is pressed together until it collapses
    script = SAMPLE.replace("pair_style mca", "pair_style mca viscosity none")
    fails(script + "timestep 3e-4\nrun 10\n", tmp_path, "0.000277", "pressed links 0.000302")
    script = SAMPLE.replace("pair_style mca", "pair_style mca viscosity none plasticity radial")
    fails(
        script + "timestep 1e-4\nrun 10\n",
        tmp_path,
        "pressed links 9.51",
        "longer than the critical one, 9.51",
    )
    lmp(script + "timestep 9.5e-5\nrun 10\n", tmp_path)
    # slip is damped by the small moment of inertia
    fails(SAMPLE + "timestep 5.8e-5\nrun 10\n", tmp_path, "the critical one, 5.7", "viscous 1.48")
    lmp(SAMPLE + "timestep 5.7e-5\nrun 10\n", tmp_path)


def test_mass_is_that_of_the_solid(tmp_path):
    result = lmp(
        SAMPLE + "variable rho equal mass(all)/vol\nthermo_style custom step v_rho\nrun 0\n",
        tmp_path,
    )
    assert result.thermo[0]["v_rho"][0] == pytest.approx(0.0078, rel=1e-6)
