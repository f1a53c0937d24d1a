# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/plot_patch.py: pictures from fields and tables of a 3D contact, or one clear line."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

import forked_scripts

from mcawr import fields
from mcawr.errors import BadInput
from script_calls import load

TOOLS = Path(__file__).resolve().parents[2] / "tools"

NX, NY = 24, 16


def contact(mu=True):
    """Fields of an ellipse, stick in its leading half."""
    x, y = np.meshgrid((np.arange(NX) + 0.5) / 12 - 1, (np.arange(NY) + 0.5) / 8 - 1)
    pressure = 1000 * np.sqrt(np.maximum(0, 1 - (x / 0.9) ** 2 - (y / 0.9) ** 2))
    inside = pressure > 0
    state = np.where(inside, np.where(x > 0, 1, 2), 0).astype("u1")
    traction = np.stack([-0.3 * pressure, 0.02 * pressure, 0 * pressure], axis=-1)
    arrays = {"state": state, "pressure": pressure, "traction": traction}
    if mu:
        arrays["mu"] = np.where(inside, 0.4 - 1e-4 * pressure, 0)
    return arrays


def vti(arrays):
    """A file as wr_creep writes it."""
    head, blocks = "", b""
    for name, values in arrays.items():
        kind = "UInt8" if values.dtype == "u1" else "Float64"
        parts = 3 if values.ndim == 3 else 1
        head += (
            f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{parts}" '
            f'format="appended" offset="{len(blocks)}"/>\n'
        )
        data = values.astype("u1" if kind == "UInt8" else "<f8").tobytes()
        blocks += len(data).to_bytes(8, "little") + data
    extent = f"0 {NX} 0 {NY} 0 0"
    text = (
        '<?xml version="1.0"?>\n<!-- a title -->\n<VTKFile type="ImageData" version="1.0" '
        'byte_order="LittleEndian" header_type="UInt64">\n'
        f'<ImageData WholeExtent="{extent}" Origin="-6 -4 0" Spacing="0.5 0.5 1">\n'
        f'<Piece Extent="{extent}"><CellData>\n{head}</CellData></Piece></ImageData>\n'
        '<AppendedData encoding="raw">\n_'
    )
    return text.encode() + blocks + b"\n</AppendedData>\n</VTKFile>\n"


POINTS = "# units\nspeed,creep,load,lateral,spin,force_x,force_y,moment_z\n"
CREEP = POINTS + "".join(
    f"10,{xi},1e5,{eta},{phi},{-1e7 * xi},{-9e6 * eta - 3e7 * phi},{-2e8 * phi}\n"
    for xi, eta, phi in [
        (1e-3, 0, 0),
        (2e-3, 0, 0),
        (3e-3, 0, 0),
        (1e-3, 1e-3, 0),
        (1e-3, 2e-3, 0),
        (1e-3, 0, 1e-4),
        (1e-3, 0, 2e-4),
    ]
)
POLACH = "# units\ncreep,lateral,spin,speed,load,force_x,force_y,polach_x,polach_y\n" + "".join(
    f"{xi},0,0,10,1e5,{-1e7 * xi},0,{-0.9e7 * xi},0\n" for xi in (1e-3, 2e-3, 3e-3)
)
SERIES = "# units\npoint,distance,time,load,creep,force_x,force_y,stick_fraction\n" + "".join(
    f"{p},{0.1 * k},{1e-5 * k},{1e5 + k},1e-3,{-100 * k * p},0,{1 - 0.05 * k}\n"
    for p in (1, 2)
    for k in range(10)
)
FILES = {"a.vti": vti(contact()), "b.vti": vti(contact()), "creep.csv": CREEP, "p.csv": POLACH}
STAGES = "# units\npoint,time,load,force_x,force_y,stick_fraction\n" + "".join(
    f"1,{k},{1e5 + 1e4 * k},{-1e3 * k},0,{1 - 0.1 * k}\n" for k in range(4)
)
FILES |= {"series.csv": SERIES, "stages.csv": STAGES}


def plot(tmp_path, *arguments, **changed):
    for name, content in {**FILES, **{k.replace("_", "."): v for k, v in changed.items()}}.items():
        (tmp_path / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    picture = tmp_path / "picture.png"
    command = [TOOLS / "plot_patch.py", *arguments, "-o", picture]
    return forked_scripts.run(command, tmp_path), picture


@pytest.mark.parametrize(
    "arguments",
    [
        ("fields", "a.vti", "b.vti", "--label", "smooth"),
        ("curves", "creep.csv", "--polach", "p.csv"),
        ("transient", "series.csv"),
        *(
            pytest.param(words, marks=pytest.mark.long)
            for words in (
                ("friction", "a.vti"),
                ("curves", "creep.csv", "--log"),
                ("transient", "series.csv", "--against", "time"),
            )
        ),
        ("transient", "stages.csv", "--against", "time"),
    ],
    ids=" ".join,
)
def test_picture(tmp_path, arguments):
    done, picture = plot(tmp_path, *arguments)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert picture.read_bytes()[:4] == b"\x89PNG"


def test_film(tmp_path):
    """One frame a file; the name says that it is a film."""
    image = pytest.importorskip("PIL.Image")
    film = tmp_path / "film.gif"
    arrays = contact()
    arrays["pressure"] = 0.5 * arrays["pressure"]
    other = {"b_vti": vti(arrays)}
    done, picture = plot(tmp_path, "fields", "a.vti", "b.vti", "--animate", **other)
    assert done.returncode == 2 and "film" in done.stderr and not picture.exists()
    command = [TOOLS / "plot_patch.py", "fields", "a.vti", "b.vti", "--animate", "-o", film]
    subprocess.run(command, check=True, cwd=tmp_path)
    with image.open(film) as frames:
        assert (frames.format, frames.n_frames) == ("GIF", 2)


@pytest.mark.parametrize(
    "arguments,changed,words",
    [
        (("fields", "c.vti"), {}, "c.vti"),
        (("fields", "a.vti"), {"a_vti": b"no image"}, "not VTK image data"),
        (("fields", "a.vti"), {"a_vti": FILES["a.vti"][:2000]}, "need"),
        (("fields", "a.vti"), {"a_vti": FILES["a.vti"].replace(b"0 24 0", b"0 99 0")}, "99 x 16"),
        (
            ("fields", "a.vti"),
            {"a_vti": FILES["a.vti"].replace(b'offset="0"', b"")},
            "whole number",
        ),
        (("friction", "a.vti"), {"a_vti": vti(contact(mu=False))}, "holds no mu"),
        (("fields", "a.vti"), {"a_vti": vti({**contact(), "pressure": np.zeros((NY, NX))})}, "con"),
        (("curves", "creep.csv"), {"creep_csv": POINTS}, "no points"),
        (("curves", "creep.csv"), {"creep_csv": POINTS + CREEP.split("\n")[2]}, "no curve"),
        (("curves", "creep.csv"), {"creep_csv": "# u\nspeed,creep\n1,2\n"}, "is missing"),
        (("transient", "series.csv"), {"series_csv": SERIES + "3,x,1,1,1,1,1,1\n"}, "series.csv"),
        (("transient", "stages.csv"), {}, "stages at rest have no distance: --against time"),
    ],
)
def test_bad_files(tmp_path, arguments, changed, words):
    done, picture = plot(tmp_path, *arguments, **changed)
    assert done.returncode == 3, done.stderr
    assert done.stderr.count("\n") == 1 and words in done.stderr
    assert not picture.exists()


def test_a_curve_for_each_measured_map():
    """Its column is named surface."""
    module = load("plot_patch.py")
    module.np = np
    assert "surface" in module.creep_columns([{"surface": "1"}])
    points = {
        name: np.array(values)
        for name, values in {
            "speed": [20.0] * 4,
            "load": [1e5] * 4,
            "creep": [1e-3, 1e-2] * 2,
            "surface": [1.0, 1.0, 2.0, 2.0],
        }.items()
    }
    curves = module.curves_over(points, "creep")
    assert [rows.tolist() for _, rows in curves] == [[0, 1], [2, 3]]
    names = [module.curve_name("", key, points) for key, _ in curves]
    assert names == ["surface 1", "surface 2"]


def test_fields_are_read_to_the_last_bit(tmp_path):
    path, arrays = tmp_path / "a.vti", contact()
    path.write_bytes(vti(arrays))
    data = fields.read_vti(path)
    assert (data.nx, data.ny, data.extent) == (NX, NY, (-6, 6, -4, 4))
    assert data.title == "a title"
    for name, values in arrays.items():
        assert (data.arrays[name] == values).all()
    assert np.allclose(data.size_of("traction"), np.hypot(0.3, 0.02) * arrays["pressure"])


def test_cut_fields_are_refused(tmp_path):
    path, whole = tmp_path / "a.vti", vti(contact())
    for length in range(0, len(whole) - 40, 97):
        path.write_bytes(whole[:length])
        with pytest.raises(BadInput):
            fields.read_vti(path)
