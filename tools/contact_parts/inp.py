# SPDX-License-Identifier: GPL-2.0-or-later
"""CONTACT's input files: cases of module 3, read for contact_inp.py."""

import math
from dataclasses import dataclass, field
from typing import Any

from mcawr.errors import BadInput
from mcawr.files import read_text


MOST = 16384  # cells along a side, values of a table


class Refused(Exception):
    """A case that wr_creep cannot do: line and reason."""


@dataclass
class Line:
    number: int
    words: list[str]

    def is_module(self) -> bool:
        return len(self.words) == 2 and self.words[1].upper() == "MODULE"


@dataclass
class Contact:
    """What a case says, or keeps of the one before. mm, N, MPa, degrees as in the input."""

    line: int = 0
    pvtime: str = "2"
    tang: str = "0"
    norm: str = "1"
    force: str = "0"
    drive: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    friction: tuple[float, float] | None = None
    rows: list[float] = field(default_factory=list)  # friction of each row of cells
    falling: tuple[float, ...] | None = None  # FKIN, FEXP1, SABSH1, FEXP2, SABSH2, MEMDST, MEM_S0
    hot: tuple[float, ...] | None = None  # FREF, TREF, DFHEAT, DTHEAT, MEMDST, MEM_S0
    layer: tuple[float, ...] | None = None  # GG3, LAYTHK, TAUCRT, GGPLST
    rolling: tuple[float, float, float] | None = None  # chi, dq, speed
    material: tuple[float, float, float, float] | None = None
    heat: list[tuple[float, ...]] = field(default_factory=list)
    heats: bool = False
    returns: bool = True  # a line MODULE comes before the next case
    grid: tuple[Any, ...] | None = None  # nx, ny, left, bottom, dx, dy
    ellipse: tuple[float, float] | None = None
    curvatures: tuple[float, float] | None = None
    table: tuple[list[float], tuple[float, ...]] | None = None


def number_of(word: str) -> float:
    """Also an angle in degrees, 180d, and what Fortran writes, 1d-3. Raises ValueError."""
    if word[-1:] in "dD":
        return math.radians(float(word[:-1]))
    return float(word.lower().replace("d", "e"))


def is_number(word: str) -> bool:
    try:
        return math.isfinite(number_of(word))
    except ValueError:
        return False


class Reader:
    """Lines of the file without comments, one after the other."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.lines = []
        for number, text in enumerate(read_text(path).split("\n"), 1):
            words = text.split("%")[0].split()
            if words:
                self.lines.append(Line(number, words))
        self.next = 0

    def line(self, what: str) -> Line:
        if self.next >= len(self.lines):
            raise BadInput(f"{self.path}: ends where {what} is expected")
        self.next += 1
        return self.lines[self.next - 1]

    def skip_case(self) -> None:
        """On to the line of the next MODULE."""
        while self.next < len(self.lines) and not self.lines[self.next].is_module():
            self.next += 1

    def skip_points(self) -> None:
        """Blocks of points below the surface, up to the 0 that ends them."""
        while self.line("ISUBS").words[0] != "0":
            pass

    def numbers(self, count: int, what: str) -> tuple[float, ...]:
        """The next numbers, over as many lines as they take; what follows on a line is text."""
        values: list[float] = []
        while len(values) < count:
            line = self.line(what)
            given = line.words[: count - len(values)]
            texts = [k for k, word in enumerate(given) if not is_number(word)]
            first = texts[0] if texts else len(given)
            if first == 0 or any(is_number(word) for word in given[first:]):
                word = given[first if first < len(given) else 0]
                raise BadInput(f"{self.path}:{line.number}: '{word}' is not a number ({what})")
            values += [number_of(word) for word in given[:first]]
        return tuple(values)

    def digits(self, names: str) -> tuple[int, dict[str, str]]:
        """A control word: its line and {name: digit}; shorter ones lack what leads."""
        line = self.line(f"the control word {names}")
        word = line.words[0]
        if not word.isdigit() or len(word) > len(names):
            raise BadInput(f"{self.path}:{line.number}: {names}: '{word}' is not a control word")
        return line.number, dict(zip(names, word.rjust(len(names), "0")))


def refuse_others(digits: dict[str, str], allowed: dict[str, tuple[str, str]], line: int) -> None:
    for name, (good, why) in allowed.items():
        if digits[name] not in good:
            raise Refused(f"{line}: {name} = {digits[name]}: {why}")


def read_case(reader: Reader, former: Contact, line: int) -> tuple[Contact, str]:
    """The next case, and why it is refused, or ""; of a refused one nothing is kept."""
    case = Contact(**vars(former))
    try:
        fill_case(reader, case, line)
    except Refused as error:  # the lines that follow belong to what is not read
        reader.skip_case()
        return Contact(pvtime=case.pvtime), str(error)
    return case, ""


def fill_case(reader: Reader, case: Contact, line: int) -> None:
    """Reads what a case says beyond the former one. Raises Refused."""
    case.line = line
    first, control = reader.digits("CPBTNFS")
    second, physics = reader.digits("VLDCMZE")
    third, flow = reader.digits("XHGIAOWR")
    case.pvtime, case.tang, case.norm, case.force = (control[name] for name in "PTNF")
    refuse_others(
        control,
        {
            "P": ("02", "keeping a part of the former case is not in wr_creep"),
            "B": ("0", "bounds other than mu p are not in wr_creep"),
            "T": ("0123", "an unknown kind of the tangential problem"),
            "N": ("01", "an unknown kind of the normal problem"),
            "F": ("012", "an unknown kind of the tangential forces"),
            "S": ("0123", "an unknown kind of the stresses below the surface"),
        },
        first,
    )
    refuse_others(
        physics,
        {
            "V": ("02", "friction that varies is converted where each row has one coefficient"),
            "L": (
                "0146",
                "friction that is constant, exponential or of the temperature is converted",
            ),
            "D": ("02", "the grid must be read or kept"),
            "C": ("02", "only half-spaces with uniformly loaded cells are in wr_creep"),
            "M": (
                "04",
                "only elastic bodies, without a layer or with an elastic one, are converted",
            ),
            "Z": ("02", "the gap must be read or kept"),
            "E": ("0", "an extra term of the slip is not in wr_creep"),
        },
        second,
    )
    refuse_others(
        flow,
        {
            "X": ("0", "debug output is CONTACT's own"),
            "H": ("013", "an unknown kind of heat"),
            "G": ("012345", "an unknown choice of the solver"),
            "R": ("01", "an unknown way to return"),
        },
        third,
    )
    if flow["G"] != "1":
        reader.line("MAXGS, MAXIN, MAXNR, MAXOUT, EPS")
    if flow["G"] in "2345":  # of CONTACT's solvers, which wr_creep does without
        reader.line("the settings of the solver")
    case.drive = reader.numbers(4, "FN, CKSI, CETA, CPHI")  # type: ignore[assignment]
    if physics["L"] != "1":
        case.friction, case.rows, case.falling, case.hot = None, [], None, None
    if physics["L"] == "0" and physics["V"] == "0":
        case.friction = reader.numbers(2, "FSTAT, FKIN")  # type: ignore[assignment]
    if physics["L"] == "4":
        case.falling = reader.numbers(5, "FKIN, FEXP1, SABSH1, FEXP2, SABSH2")
        case.falling += reader.numbers(2, "MEMDST, MEM_S0")
    if physics["L"] == "6":
        case.hot = reader.numbers(4, "FREF, TREF, DFHEAT, DTHEAT")
        case.hot += reader.numbers(2, "MEMDST, MEM_S0")
    if physics["C"] == "2":
        if control["T"] in "23":
            case.rolling = reader.numbers(3, "CHI, DQ, VELOC")  # type: ignore[assignment]
        case.material = reader.numbers(4, "POISS 1,2, GG 1,2")  # type: ignore[assignment]
        case.layer = None
        if physics["M"] == "4":
            case.layer = reader.numbers(4, "GG3, LAYTHK, TAUCRT, GGPLST")
    case.heats = flow["H"] != "0"
    if flow["H"] == "3":
        case.heat = [reader.numbers(4, "BKTEMP, HEATCP, LAMBDA, DENS") for _ in range(2)]
    hertz = False
    if physics["D"] == "2":
        hertz = read_grid(reader, case)
    if physics["Z"] == "2" and not hertz:
        read_gap(reader, case)
    if physics["V"] == "2":
        if case.grid is None:
            raise Refused(f"{line}: V = 2: the grid of a former case that is not there")
        case.rows = [check_row(reader) for _ in range(case.grid[1])]
    if control["S"] in "23":
        reader.line("MATFIL, OUTPUT")
    if control["S"] == "3":
        reader.skip_points()
    case.returns = flow["R"] == "1"


def check_row(reader: Reader) -> float:
    """The friction of a row of cells. Raises Refused."""
    line = reader.lines[min(reader.next, len(reader.lines) - 1)].number
    static, kinetic = reader.numbers(2, "FSTAT, FKIN of a row")
    if static != kinetic:
        raise Refused(f"{line}: FKIN is not FSTAT: one coefficient is in wr_creep")
    return static


def read_grid(reader: Reader, case: Contact) -> bool:
    """The potential contact; whether it says the gap, too. Raises Refused."""
    line = reader.line("IPOTCN")
    kind = line.words[0]
    names = {"1": "XL,YL,DX,DY", "2": "XL,YL,XH,YH", "3": "XC1,YC1,DX,DY", "4": "XC1,YC1,XCM,YCM"}
    names |= {"-1": "A1,B1,SCALE", "-2": "A1,AOB,SCALE", "-3": "AA,BB,SCALE"}
    if kind not in names:
        raise Refused(f"{line.number}: IPOTCN = {kind}: {', '.join(names)} are read")
    values = reader.numbers(2 + len(names[kind].split(",")), f"MX,MY,{names[kind]}")
    nx, ny = (whole(reader, line, value, "MX, MY", 1) for value in values[:2])
    a, b = values[2], values[3]
    case.ellipse = case.curvatures = case.table = None
    if kind in ("-1", "-2", "-3"):
        case.grid = (nx, ny, values[4])
        if kind == "-3":
            case.ellipse = (a, b)
        else:
            case.curvatures = (a, b if kind == "-1" else a / curvature_ratio(b))
        return True
    c, d = values[4], values[5]
    if kind == "2":
        c, d = (c - a) / nx, (d - b) / ny
    if kind == "4":
        c, d = (c - a) / max(1, nx - 1), (d - b) / max(1, ny - 1)
    if kind in ("3", "4"):
        a, b = a - 0.5 * c, b - 0.5 * d
    if not (c > 0.0 and d > 0.0):
        raise BadInput(f"{reader.path}:{line.number}: IPOTCN = {kind}: cells have no size")
    case.grid = (nx, ny, a, b, c, d)
    return False


def whole(reader: Reader, line: Line, value: float, name: str, least: int) -> int:
    if value != int(value) or not least <= value <= MOST:
        raise BadInput(
            f"{reader.path}:{line.number}: {name}: {value:g} is not allowed, "
            f"must be a whole number from {least} to {MOST}"
        )
    return int(value)


def curvature_ratio(axes: float) -> float:
    """A/B of the gap whose contact is an ellipse with a/b = axes, Hertz."""
    if axes > 1.0:
        return 1.0 / curvature_ratio(1.0 / axes)
    m = 1.0 - axes * axes
    if m < 1e-9:
        return 1.0
    # K(m) and E(m) by the arithmetic-geometric mean
    a, g, power, rest = 1.0, axes, 0.5, 1.0 - 0.5 * m
    while abs(a - g) > 1e-15 * a:
        a, g, c = 0.5 * (a + g), math.sqrt(a * g), 0.5 * (a - g)
        power *= 2.0
        rest -= power * c * c
    first = 0.5 * math.pi / a
    second = first * rest
    return (second / (1.0 - m) - first) / (first - second)


def read_gap(reader: Reader, case: Contact) -> None:
    """Raises Refused."""
    line = reader.line("IBASE, IPLAN")
    base, plan = line.words[:2] if len(line.words) > 1 else (line.words[0], "")
    if plan != "1":
        raise Refused(f"{line.number}: IPLAN = {plan}: 1 is read")
    if case.grid is None or len(case.grid) == 3:
        raise Refused(f"{line.number}: IBASE = {base}: a gap needs a grid of IPOTCN 1 to 4")
    case.ellipse = case.curvatures = case.table = None
    if base == "1":
        b = reader.numbers(6, "B(I), I=1, 6")
        if any(b[k] != 0.0 for k in (1, 3, 4, 5)):
            raise Refused(f"{line.number}: IBASE = 1: a gap B1 x2 + B3 y2 is read, without more")
        case.curvatures = (b[0], b[2])
    elif base == "2":
        values = reader.numbers(5, "NN, XM, RM, Y1, DY1")
        whole(reader, line, values[0], "NN", 2)
        if values[2] == 0.0 or values[4] <= 0.0:
            raise Refused(f"{line.number}: IBASE = 2: RM is not 0, DY1 above 0")
        case.table = (list(reader.numbers(int(values[0]), "the gap across y")), values[1:])
    elif base == "9":
        count = case.grid[0] * case.grid[1]
        case.table = (list(reader.numbers(count, "the gap of each cell")), ())
    else:
        raise Refused(f"{line.number}: IBASE = {base}: 1, 2 and 9 are read")


def groups_of(path: str) -> list[tuple[int, list[Contact], str]]:
    """(number, cases that go on from each other, why they are refused or "")."""
    reader = Reader(path)
    groups: list[tuple[int, list[Contact], str]] = []
    former, number = Contact(), 0
    while reader.next < len(reader.lines):
        at = reader.lines[reader.next].number
        if former.returns:
            word = reader.line("MODULE").words[0]
            if word == "0":
                break
            if word != "3":
                raise BadInput(f"{path}:{at}: MODULE {word}: module 3 is read")
        number += 1
        former, reason = read_case(reader, former, at)
        # steady rolling has no history
        goes_on = former.pvtime == "0" and former.tang != "3" and bool(groups)
        if goes_on and groups[-1][2] and not reason:
            reason = f"{at}: P = 0: it goes on from a case that is refused"
        if goes_on and groups[-1][1][-1].tang == "3" and not reason:
            reason = f"{at}: P = 0: going on from steady rolling, T = 3, is not converted"
        if goes_on and not reason:
            groups[-1] = (groups[-1][0], [*groups[-1][1], former], "")
        else:
            groups.append((number, [former], reason))
    if not groups:
        raise BadInput(f"{path}: no case")
    return groups
