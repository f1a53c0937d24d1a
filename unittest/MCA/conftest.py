# SPDX-License-Identifier: GPL-2.0-or-later
"""Samples that several tests start from; made once a test file."""

import math

import pytest

from lmp_run import lmp


def write_fragments(path, length=1.0):
    """Data file of two hexagonal fragments, types 1 and 2, 16 x 5 automata each, the upper one a
    little above and beside; `length` is what a nanometre is in the units of the run."""
    d, h = 2.5, 2.5 * math.sqrt(3) / 2
    atoms = []
    for k in range(160):
        row, upper = k // 16, k // 16 > 4
        x = d * (k % 16 + 0.5 * (row % 2) + 0.16 * upper)
        y = h * row + 0.052 * d * upper
        atoms.append(f"{k + 1} {1 + upper} {d * length!r} 1 {x * length!r} {y * length!r} 0")
    path.write_text(
        f"""two fragments

160 atoms
2 atom types
{-1 * length!r} {41 * length!r} xlo xhi
{-1 * length!r} {11 * h * length!r} ylo yhi
{-2.5 * length!r} {2.5 * length!r} zlo zhi

Atoms # sphere

"""
        + "\n".join(atoms)
        + "\n"
    )
    return path


@pytest.fixture(scope="session")
def fragments(tmp_path_factory):
    return write_fragments(tmp_path_factory.mktemp("fragments") / "fragments.data")


@pytest.fixture(scope="session")
def rough_data(tmp_path_factory):
    """Data file of two rough blocks; ids of create_atoms depend on the ranks, those of a file
    not."""
    folder = tmp_path_factory.mktemp("sample")
    lmp("in.make_rough", folder)
    return folder / "rough.data"
