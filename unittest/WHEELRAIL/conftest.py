# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction logs that tests of wr_fit begin with."""

import friction_logs
import pytest


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    return friction_logs.campaign(tmp_path_factory.mktemp("campaign"))


@pytest.fixture
def log(tmp_path):
    path = tmp_path / "run.friction"
    path.write_text(friction_logs.friction_log())
    return path
