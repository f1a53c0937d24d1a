# SPDX-License-Identifier: GPL-2.0-or-later
"""Which tests of a file run: all of them, or those of one part. CTest runs the parts apart."""


def pytest_addoption(parser):
    parser.addoption("--part", choices=("quick", "long"), help="without the mark long, or with it")


def pytest_collection_modifyitems(config, items):
    part = config.getoption("part")
    if part:
        items[:] = [item for item in items if ("long" in item.keywords) == (part == "long")]
