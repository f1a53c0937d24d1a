# SPDX-License-Identifier: GPL-2.0-or-later
"""Synthetic friction logs for the tests: Eq. 2 plus correlated noise and a grinding-in."""

import random

HEAD = """# format: mca-friction 1
# program: {{name: mca-wheelrail, version: 0.1.0, lammps: 20250204}}
# units: {{time: ns, length: nm, stress: MPa, velocity: m/s, density: kg/m3, viscosity: Pa s}}
# material: {{youngs_modulus: {E}, poissons_ratio: 0.3, density: {rho}, elastic_limit: 50.968, \
yield_strength: 80.04, yield_strain: 0.015, strength: {strength}, \
breaking_strain: {breaking_strain}, viscosity: 0.41}}
# loading: {{pressure: {p}, velocity: {v}}}
# geometry: {{width: 100, thickness: 1, diameter: 2.5, packing: hex, automata: 1280}}
# laws: {{preset: {preset}}}
# run: {{timestep: 5e-05, every: {every}, seed: {seed}}}
step time displacement shear_stress normal_stress mu links broken formed gap
"""


def eq2(kappa1, kappa2):
    """Eq. 2 with Eq. 3's numbers."""
    return 0.15 + 0.0442 * kappa1 / (1 + 0.195 * kappa1) + 0.3243 / (1 + 0.00212 * kappa2)


def kappas(p, v, strength, E=206000.0, rho=7800.0):
    """kappa1, kappa2 from MPa, m/s, MPa, MPa, kg/m3."""
    return rho * v * v * E * 1e6 / (strength * 1e6) ** 2, p * E / strength**2


def friction_log(
    p=15.0,
    v=5.0,
    strength=92.0,
    E=206000.0,
    rho=7800.0,
    seed=1,
    ns=20.0,
    factor=1.0,
    noise=0.05,
    phi=0.8,
    grinding_in=0.3,
    grinding_time=1.0,
    drift=0.0,
    preset="B",
    every=1000,
    breaking_strain=0.04,
):
    """Text of a log: mu is `factor` times Eq. 2, plus AR(1) noise, plus a decaying start, plus a
    drift per ns; a row in `every` steps of 5e-5 ns."""
    generator = random.Random(seed)
    level = factor * eq2(*kappas(p, v, strength, E, rho))
    head = dict(E=E, rho=rho, p=p, v=v, strength=strength, seed=seed, preset=preset, every=every)
    lines = [HEAD.format(**head, breaking_strain=breaking_strain)]
    x, dt = 0.0, every * 1e-3 * 0.05
    for i in range(1, round(ns / dt) + 1):
        x = phi * x + noise * (1 - phi * phi) ** 0.5 * generator.gauss(0, 1)
        mu = level + x + grinding_in * 2.718281828 ** (-dt * i / grinding_time) + drift * dt * i
        lines.append(
            f"{every * i} {dt * i:.10g} {dt * i * v:.10g} {mu * p:.8g} {p} {mu:.8g} 3456 2 1 "
            "-0.013\n"
        )
    return "".join(lines)


def campaign(
    folder,
    strengths_and_pressures=((92, 1), (92, 5), (92, 15), (92, 26), (200, 15), (552, 26)),
    velocities=(0.5, 1, 2.5, 5, 8, 10),
    scatter=0.05,
    **more,
):
    """A folder with one log a run, as tools/campaign leaves it."""
    generator = random.Random(11)
    number = 0
    for v in velocities:
        for strength, p in strengths_and_pressures:
            number += 1
            run = folder / f"run{number:02d}"
            run.mkdir(parents=True)
            (run / "run.friction").write_text(
                friction_log(
                    p=p,
                    v=v,
                    strength=strength,
                    seed=number,
                    factor=1 + scatter * generator.gauss(0, 1),
                    **more,
                )
            )
    return folder
