# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbers as everybody reads them."""

import pytest

from mcawr import numbers, tables
from mcawr.replicas import student95

NONE = ["", "x", "nan", "inf", "-inf", "1e999", "0x10", "1_000", "1 500", "²", "٣", "1,5", "--1"]


def test_decimal_numbers():
    texts = ("12", "-1.5e-3", "+.5", "1.", " 7 ", "010", "1E5")
    assert [numbers.decimal(text) for text in texts] == [12, -1.5e-3, 0.5, 1, 7, 10, 1e5]


@pytest.mark.parametrize("text", NONE)
def test_what_is_no_number(text):
    for read in (numbers.decimal, numbers.whole):
        with pytest.raises(ValueError, match="number"):
            read(text)


def test_whole_numbers():
    assert [numbers.whole(text) for text in ("0", "-3", "+12")] == [0, -3, 12]
    for text in ("1.0", "1e3", "9" * 30):
        with pytest.raises(ValueError, match="not a whole number"):
            numbers.whole(text)


@pytest.mark.parametrize("value", [True, None, "1", [1], 10**400, float("nan")])
def test_values_of_json(value):
    with pytest.raises((TypeError, ValueError)):
        numbers.finite(value)
    assert numbers.finite(3) == 3


@pytest.mark.parametrize(
    "freedom, t", [(1, 12.7062), (2, 4.30265), (5, 2.57058), (30, 2.04227), (1e4, 1.96020)]
)
def test_student95(freedom, t):
    """The tables' two-sided 95 %."""
    assert student95(freedom) == pytest.approx(t, rel=2e-5)


def test_columns_of_a_table(tmp_path):
    """Comments are skipped; what is no number stays a text."""
    path = tmp_path / "a.csv"
    path.write_text("# creep: 1; a, b\nfile,creep,mu\n# more\na.friction,1e-3,nan\nb,2,0.3\n")
    found = tables.columns(str(path))
    assert found["file"] == ["a.friction", "b"] and found["creep"] == [0.001, 2]
    assert found["mu"][0] != found["mu"][0] and found["mu"][1] == 0.3
    path.write_text("# nothing\n")
    assert tables.columns(str(path)) == {}
