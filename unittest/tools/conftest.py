# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixtures that several tests share."""

import pytest
from script_calls import Caller

from campaign_calls import HEAD, PLAN, campaign


@pytest.fixture
def plan(tmp_path):
    path = tmp_path / "plan.yaml"
    path.write_text(PLAN)
    return path


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A finished run, and its plan; copied before it is damaged."""
    top = tmp_path_factory.mktemp("finished")
    (top / "plan.yaml").write_text(HEAD + "runs: [{name: a, laws: b, ns: 2}]\n")
    assert campaign("run", top / "plan.yaml", "-o", top / "out").returncode == 0
    return top


@pytest.fixture
def call(monkeypatch, capfd):
    """The scripts, called in this process."""
    return Caller(monkeypatch, capfd)
