"""Samples that several tests start from; made once a test file."""

import pytest

from lmp_run import lmp


@pytest.fixture(scope="session")
def rough_data(tmp_path_factory):
    """Data file of two rough blocks; ids of create_atoms depend on the ranks, those of a file not."""
    folder = tmp_path_factory.mktemp("sample")
    lmp("in.make_rough", folder)
    return folder / "rough.data"
