# SPDX-License-Identifier: GPL-2.0-or-later
"""Case files of wr_creep that say what cases of CONTACT say, for contact_inp.py."""

import math
import os
from typing import Any

from contact_parts.inp import Contact, Refused

BY = ", by contact_inp.py"  # ends the first line of a case file
DIGITS = 9  # of a number in a case file that was computed from those of the input
CELLS, SCALE = 8, 1.05  # what wr_creep needs: cells along a side, half a box in semi-axes
FEW = 4  # cells along a semi-axis, twice what wr_creep needs


def text(value: float, unit: str = "") -> str:
    return f"{value + 0.0:.{DIGITS}g}" + (f" {unit}" if unit else "")  # no -0


def pair(values: Any, unit: str) -> str:
    return "[" + ", ".join(text(value, unit) for value in values) + "]"


def gap_of(case: Contact) -> list[list[float]]:
    """The gap at the cells' centres, rows from the smallest y on."""
    assert case.table is not None and case.grid is not None
    nx, ny, left, bottom, dx, dy = case.grid
    values, head = case.table
    if not head:
        return [list(values[k * nx : (k + 1) * nx]) for k in range(ny)]
    middle, radius, first, step = head
    rows = []
    for iy in range(ny):
        place = (bottom + (iy + 0.5) * dy - first) / step
        k = min(max(int(math.floor(place + 1e-9)), 0), len(values) - 2)
        part = place - k
        across = values[k] + part * (values[k + 1] - values[k])
        rows.append(
            [(left + (ix + 0.5) * dx - middle) ** 2 / (2.0 * radius) + across for ix in range(nx)]
        )
    return rows


def fitted_curvatures(case: Contact, rows: list[list[float]]) -> tuple[float, float]:
    """A, B > 0 of a gap A x2 + B y2 whose contact, an ellipse around x = y = 0, is about as long
    and as wide as that of a gap of any form.

    A sphere under a load N has a contact of radius r where the gap is h with N = 8/3 E* r h. So the
    cells of the least gaps are taken, until r of their area carries the load; under an approach
    those that are less than half of it above the least. Twice the root mean square of their x and y
    are the semi-axes a, b, and A = h/a2, B = h/b2 with r2 = ab.
    """
    assert case.grid is not None and case.material is not None
    _, _, left, bottom, dx, dy = case.grid
    nu1, nu2, g1, g2 = case.material
    stiffness = 16.0 / 3.0 / ((1.0 - nu1) / g1 + (1.0 - nu2) / g2)  # 8/3 E*
    cells = sorted(
        (gap, left + (ix + 0.5) * dx, bottom + (iy + 0.5) * dy)
        for iy, row in enumerate(rows)
        for ix, gap in enumerate(row)
    )
    least = cells[0][0]
    level = 0.5 * (case.drive[0] - least)  # under an approach
    touching: list[tuple[float, float]] = []
    for gap, x, y in cells:
        height, radius = gap - least, math.sqrt((len(touching) + 1) * dx * dy / math.pi)
        held = stiffness * radius * height > case.drive[0] if case.norm == "1" else height > level
        if touching and held:
            break
        touching.append((x, y))
    x2, y2 = (sum(value * value for value in values) / len(touching) for values in zip(*touching))
    # of points in a cell, and not so small that wr_creep would refuse the ellipse
    a = max(2.0 * math.sqrt(x2 + dx * dx / 12.0), FEW * dx)
    b = max(2.0 * math.sqrt(y2 + dy * dy / 12.0), FEW * dy)
    h = case.drive[0] / (stiffness * math.sqrt(a * b)) if case.norm == "1" else level
    h = max(h, 1e-9)  # mm: where nothing touches
    return float(text(h / (a * a))), float(text(h / (b * b)))  # as the case file has them


def elastic_lines(case: Contact) -> list[str]:
    assert case.material is not None
    nu1, nu2, g1, g2 = case.material
    young = [2.0 * g1 * (1.0 + nu1), 2.0 * g2 * (1.0 + nu2)]
    if young[0] == young[1] and nu1 == nu2:
        return [f"  youngs_modulus: {text(young[0], 'MPa')}", f"  poissons_ratio: {text(nu1)}"]
    return [f"  youngs_modulus: {pair(young, 'MPa')}", f"  poissons_ratio: {pair([nu1, nu2], '')}"]


def contact_group(case: Contact, turned: bool, files: dict[str, str], stem: str) -> list[str]:
    """Lines of the groups contact, points, roughness. Raises Refused."""
    assert case.grid is not None
    first = "contact:"
    load = case.drive[0]
    lines = [first, f"  load: {text(load, 'N')}" if case.norm == "1" else
             f"  approach: {text(load, 'mm')}"]  # fmt: skip
    lines += elastic_lines(case)
    rough: list[str] = []
    if case.table is not None:
        rows = gap_of(case)
        curvatures = fitted_curvatures(case, rows)
        files[f"{stem}.txt"] = map_text(case, rows, curvatures, turned)
        rough = [f"roughness: {{rail: {stem}.txt, sampling: cells, detrend: none}}"]
        lines.append(f"  curvatures: {pair(curvatures, '1/mm')}")
    elif case.ellipse is not None:
        lines.append(f"  semi_axes: {pair(case.ellipse, 'mm')}")
    elif case.curvatures is not None:
        lines.append(f"  curvatures: {pair(case.curvatures, '1/mm')}")
    if len(case.grid) == 3:
        nx, ny, scale = case.grid
        lines.append(f"  domain: {text(2.0 * scale)}")
    else:
        nx, ny, left, bottom, dx, dy = case.grid
        centre = [left + 0.5 * nx * dx, bottom + 0.5 * ny * dy]
        if turned:
            centre = [-value for value in centre]
        lines.append(f"  cell: {pair([dx, dy], 'mm')}")
        if any(abs(value) > 1e-9 * size for value, size in zip(centre, (dx, dy))):
            lines.append(f"  centre: {pair(centre, 'mm')}")
    if case.tang in "23":
        lines.append(f"  spin_point: {text(1.0 / 6.0)}")
    return [*lines, f"cells: [{nx}, {ny}]", *rough]


def map_text(
    case: Contact, rows: list[list[float]], curvatures: tuple[float, float], turned: bool
) -> str:
    """A height map: what the gap A x2 + B y2 has too much, rows from the smallest y on."""
    assert case.grid is not None
    _, _, left, bottom, dx, dy = case.grid
    if abs(dx - dy) > 1e-9 * dx:
        raise Refused(f"{case.line}: a gap of points needs cells as long as wide")
    heights = []
    for iy, row in enumerate(rows):
        y = bottom + (iy + 0.5) * dy
        smooth = [
            curvatures[0] * (left + (ix + 0.5) * dx) ** 2 + curvatures[1] * y * y
            for ix in range(len(row))
        ]
        heights.append([s - gap for s, gap in zip(smooth, row)])
    if turned:
        heights = [row[::-1] for row in reversed(heights)]
    head = ["# height: mm", f"# spacing: {text(dx)} mm", "# rows: upwards"]
    lines = [";".join(f"{height:.12g}" for height in row) for row in heights]
    return "\n".join([*head, *lines]) + "\n"


def thermal_group(case: Contact) -> list[str]:
    if not case.heats:
        return ["thermal: off"]
    bulk, capacity, conductivity, density = zip(*case.heat)
    return [  # mm, N, s, so that W/(mm K), J/(kg K) and kg/mm3
        "thermal:",
        "  model: local",
        f"  bulk: {pair(bulk, 'K')}",
        f"  conductivity: {pair([1e3 * value for value in conductivity], 'W/(m K)')}",
        f"  specific_heat: {pair(capacity, 'J/(kg K)')}",
        f"  density: {pair([1e9 * value for value in density], 'kg/m3')}",
    ]


def force_limit(case: Contact) -> float:
    """What forces are relative to, mu FN; 0 where none is given. Raises Refused."""
    if case.force != "0" and case.friction is None:
        raise Refused(f"{case.line}: F = {case.force}: forces need one coefficient of friction")
    return case.friction[0] * case.drive[0] if case.friction else 0.0


def drive_lines(case: Contact, turned: bool) -> list[str]:
    """Creepages, forces or a shift. Forces of CONTACT are relative to mu FN."""
    load, x, y, spin = case.drive
    sign = -1.0 if turned else 1.0
    if case.tang == "0":
        return ["static: {shift: [0 mm, 0 mm]}"]
    limit = force_limit(case)
    if case.tang == "1" and case.force == "0":
        lines = [f"static: {{shift: {pair([x, y], 'mm')}, twist: {text(spin)}}}"]
        return lines
    if case.force != "0" and case.norm == "0":
        if case.tang != "1" or y or spin or not 0.0 < -sign * x < 1.0:
            raise Refused(
                f"{case.line}: F = {case.force}: with an approach a force of a shift along x is "
                "converted"
            )
        return [f"static: {{force_ratio: {text(-sign * x)}}}"]
    if case.tang == "1" and (spin or (case.force == "1" and y)):
        raise Refused(f"{case.line}: a shift beside a force is not in wr_creep")
    forces = []
    if case.force in "12":
        forces.append(f"longitudinal: {text(sign * x * limit, 'N')}")
    if case.force == "2":
        forces.append(f"lateral: {text(sign * y * limit, 'N')}")
    lines = [f"force: {{{', '.join(forces)}}}"] if forces else []
    if case.tang == "1":
        return lines
    if case.force == "0":
        lines.append(f"creep: {text(sign * x)}")
    if case.force != "2":
        lines.append(f"lateral: {text(sign * y)}")
    return [*lines, f"spin: {text(spin, '1/mm')}"]


def is_turned(case: Contact, staged: bool) -> bool:
    if case.tang == "1" and (case.norm == "0" or staged) and case.force != "0":
        return case.drive[1] > 0.0  # under a positive force ratio the wheel is pushed to -x
    if case.tang not in "23" or case.rolling is None:
        return False
    turn = case.rolling[0]
    if abs(turn - math.pi) < 1e-6:
        return True
    if abs(turn) > 1e-6:
        raise Refused(f"{case.line}: CHI = {math.degrees(turn):g} degrees: 0 and 180 are converted")
    return False


def is_line(case: Contact) -> bool:
    return case.grid is not None and len(case.grid) == 6 and case.grid[1] == 1


def check_grid(case: Contact) -> None:
    """What wr_creep allows. Raises Refused."""
    assert case.grid is not None
    nx, ny, *size = case.grid
    if nx < CELLS or (ny < CELLS and not is_line(case)):
        raise Refused(
            f"{case.line}: MX, MY = {nx}, {ny}: at least {CELLS} cells along a side, or one row "
            "that is given in mm, are in wr_creep"
        )
    if len(size) == 1 and size[0] < SCALE:
        raise Refused(f"{case.line}: SCALE = {size[0]:g}: at least {SCALE} is in wr_creep")
    curved = case.curvatures[: 1 if is_line(case) else 2] if case.curvatures else ()
    if min(curved, default=1.0) <= 0.0:
        raise Refused(f"{case.line}: a gap that closes to the sides, B1 or B3, is not in wr_creep")


def check_hot(case: Contact, hot: tuple[float, ...]) -> None:
    """Friction that changes with the temperature, L = 6. Raises Refused."""
    reference, start, change, width, memory, _ = hot
    if case.tang not in "23":
        raise Refused(f"{case.line}: L = 6: rolling is converted, a shift heats nothing")
    if not case.heats:
        raise Refused(f"{case.line}: L = 6 needs the heat of this case, H above 0")
    if memory > 0.0:
        raise Refused(f"{case.line}: L = 6: MEMDST = {memory:g}: it is converted without a memory")
    if min(reference, reference + change, width) <= 0.0 or start < 0.0:
        raise Refused(
            f"{case.line}: L = 6: FREF, FREF + DFHEAT and DTHEAT above 0 and TREF from 0 on are "
            "converted"
        )


def check_whole(case: Contact) -> None:
    for name in ("grid", "material"):
        if getattr(case, name) is None:
            raise Refused(f"{case.line}: {name} of a former case that is not there")
    if not (case.ellipse or case.curvatures or case.table):
        raise Refused(f"{case.line}: gap of a former case on this grid that is not there")
    if not (case.friction or case.rows or case.falling or case.hot):
        raise Refused(f"{case.line}: friction of a former case that is not there")
    check_grid(case)
    if case.friction and case.friction[0] != case.friction[1]:
        raise Refused(f"{case.line}: FKIN is not FSTAT: one coefficient is in wr_creep")
    if case.falling and (case.tang not in "23" or case.falling[3] or min(case.falling[:3]) <= 0.0):
        raise Refused(f"{case.line}: L = 4: rolling with one falling exponential is converted")
    if case.falling and case.falling[5] <= 0.0:
        raise Refused(
            f"{case.line}: MEMDST = 0: without a memory friction that falls has several solutions"
        )
    if case.hot:
        check_hot(case, case.hot)
    if case.layer and (case.layer[3] or min(case.layer[:2]) <= 0.0):
        raise Refused(f"{case.line}: M = 4: a layer that hardens, GGPLST, is not in wr_creep")


def check_alike(group: list[Contact]) -> None:
    """Cases that go on from each other differ in what drives them only. Raises Refused."""
    names = {
        "friction": ("friction", "rows", "falling", "hot"),
        "material": ("material", "layer"),
        "heat": ("heats", "heat"),
        "grid": ("grid",),
        "gap": ("ellipse", "curvatures", "table"),
    }
    for case in group[1:]:
        for what, parts in names.items():
            if any(getattr(case, part) != getattr(group[0], part) for part in parts):
                raise Refused(
                    f"{case.line}: P = 0: the {what} differs from that of the case it goes on from"
                )


def friction_lines(case: Contact, turned: bool) -> list[str]:
    lines = []
    if case.rows:
        assert case.grid is not None
        if len(case.grid) == 3:
            raise Refused(f"{case.line}: V = 2: rows need a grid that is given in mm")
        _, count, _, bottom, _, dy = case.grid
        places = [bottom + (row + 0.5) * dy for row in range(count)]
        factors = case.rows
        if turned:
            places, factors = [-y for y in reversed(places)], case.rows[::-1]
        lines = [
            "friction:",
            "  law: constant",
            "  mu: 1",
            f"  across_y: {pair(places, 'mm')}",
            f"  across_factor: {pair(factors, '')}",
        ]
    elif case.falling:
        kinetic, more, speed = case.falling[:3]
        lines = [
            "friction:",
            "  law: polach",
            f"  mu0: {text(kinetic + more)}",
            f"  A: {text(kinetic / (kinetic + more))}",
            f"  B: {text(1e3 * math.log(2.0) / speed, 's/m')}",
            f"  memory_length: {text(case.falling[5], 'mm')}",
        ]
    elif case.hot:
        reference, start, change, width = case.hot[:4]
        lines = ["friction:", "  law: constant", f"  mu: {text(reference)}"]
        if change:
            lines += [
                f"  hot_factor: {text(1.0 + change / reference)}",
                f"  hot_start: {text(start, 'K')}",
                f"  hot_end: {text(start + width, 'K')}",
            ]
    elif case.friction:
        lines = [f"friction: {{law: constant, mu: {text(case.friction[0])}}}"]
    if case.layer:
        modulus, thickness, limit = case.layer[:3]
        flow = f", yield_stress: {text(limit, 'MPa')}" if limit > 0.0 else ""
        lines.append(
            f"layer: {{thickness: {text(thickness, 'mm')}, shear_modulus: "
            f"{text(modulus, 'MPa')}{flow}}}"
        )
    return lines


def line_curvature(case: Contact) -> float:
    """B1 of the gap, 1/mm; where the gap lies on the line does not count. Raises Refused."""
    if case.curvatures:
        return case.curvatures[0]
    assert case.table is not None
    if not case.table[1] or case.table[1][1] <= 0.0:
        raise Refused(f"{case.line}: a gap of points, or a hollow one, on a line is not converted")
    return 0.5 / case.table[1][1]


def line_case(case: Contact) -> list[str]:
    """A row of cells, MY = 1, is a line contact of the length DY."""
    assert case.grid is not None and case.material is not None
    nx, _, left, _, dx, dy = case.grid
    nu1, nu2, g1, g2 = case.material
    load, x = case.drive[0] / dy, case.drive[1]
    if case.tang != "3" or case.force == "2" or case.norm != "1":
        raise Refused(
            f"{case.line}: a line contact rolls steadily under a load, without a lateral force"
        )
    curvature = line_curvature(case)
    turn = -1.0 if is_turned(case, False) else 1.0
    drive = f"creep: {text(turn * x)}"
    if case.force == "1":  # on the rail
        drive = f"force: {{per_length: {text(-turn * x * force_limit(case) / dy, 'N/mm')}}}"
    modulus = 2.0 / ((1.0 - nu1) / g1 + (1.0 - nu2) / g2)
    half = math.sqrt(2.0 * load / (math.pi * modulus * curvature))
    return [
        "contact:",
        f"  load_per_length: {text(load, 'N/mm')}",
        f"  radius: {text(0.5 / curvature, 'mm')}",
        *elastic_lines(case),
        f"  domain: {text(nx * dx / half)}",
        f"cells: {nx}",
        drive,
    ]


def case_text(
    group: list[Contact], path: str, numbers: str, files: dict[str, str], stem: str
) -> str:
    """A case file for cases that go on from each other. Raises Refused."""
    case, last = group[0], group[-1]
    for one in group:
        check_whole(one)
    check_alike(group)
    turned = is_turned(last, len(group) > 1)
    head = [f"# {os.path.basename(path)}, {numbers}{BY}"]
    if turned:
        head.append("# turned by half a turn: creepages and forces in the plane change their signs")
    assert case.grid is not None
    along_line = is_line(case)
    if along_line:
        lines = line_case(case)
    else:
        # stages under an approach begin under a load
        pressed = [one for one in group if one.norm == "1"]
        lines = contact_group(pressed[-1] if pressed else last, turned, files, stem)
        if last.tang == "2":
            lines += rolling_steps(group, turned)
        elif len(group) > 1 and last.tang not in "23":
            lines.append(stage_drive(group))
        else:
            lines += drive_lines(last, turned)
    lines += friction_lines(last, turned)
    lines += thermal_group(last)
    rolls = last.tang in "23"
    if rolls:
        assert last.rolling is not None
        lines.append(f"speed: {text(last.rolling[2], 'mm/s')}")
    if not rolls:
        lines.append("mode: static")
        if len(group) > 1:
            lines += stages(group)
    lines.append("fields: last")
    if rolls and not along_line:
        lines.append("sensitivities: false")
    return "\n".join([*head, *lines]) + "\n"


def rolling_steps(group: list[Contact], turned: bool) -> list[str]:
    """A shift, or nothing, and steps of rolling; what differs between them becomes a list."""
    steps = [case for case in group if case.tang == "2"]
    first = steps[0]
    assert first.rolling is not None and first.grid is not None
    for case in group[1:]:
        if case.tang != "2":
            raise Refused(f"{case.line}: T = {case.tang}: a shift after others, before steps of "
                          "rolling, is not converted")  # fmt: skip
    for case in steps:
        if case.norm == "0":
            raise Refused(f"{case.line}: T = 2, N = 0: steps under an approach are not in wr_creep")
        if case.table is not None:
            raise Refused(f"{case.line}: T = 2: a gap of points would travel in steps of rolling")
        if (case.rolling, case.force, case.norm) != (first.rolling, first.force, first.norm):
            raise Refused(f"{case.line}: steps of one length, speed and kind are converted")
    cells = first.rolling[1] / first.grid[4] if len(first.grid) == 6 else 0.0
    if abs(cells - round(cells)) > 1e-6 or cells < 0.5:
        raise Refused(f"{first.line}: DQ = {first.rolling[1]:g} mm is no whole number of cells")
    start = "shift" if group[0].tang == "1" else "rest"
    if start == "shift" and (group[0].force != first.force or first.force == "0"):
        raise Refused(f"{group[0].line}: rolling goes on from a shift under forces only")
    step = f", step: {round(cells)}" if round(cells) > 1 else ""
    # what holds at the end of each step; at the beginning that of the shift
    ends = [group[0] if start == "shift" else first, *steps]
    lists = {name: [drive[name] for drive in (driven(case, turned) for case in ends)]
             for name in driven(first, turned)}  # fmt: skip
    changing = {name: values for name, values in lists.items() if len(set(values)) > 1}
    steady = {name: values[0] for name, values in lists.items() if name not in changing}
    forces = [
        f"{name[len('force_'):]}: {value}" for name, value in steady.items() if "force" in name
    ]
    said = [f"force: {{{', '.join(forces)}}}"] if forces else []
    said += [f"{name}: {steady[name]}" for name in ("creep", "lateral", "spin") if name in steady]
    more = [f", {name}: [{', '.join(values)}]" for name, values in changing.items()]
    count = len(steps) if changing else 1
    whole = len(steps) * first.rolling[1] / first.rolling[2]
    times = ", ".join(text(whole * k / count, "s") for k in range(count + 1))
    return [
        *said,
        "mode: moving",
        f"moving: {{start: {start}{step}}}",
        f"sequence: {{time: [{times}]{''.join(more)}}}",
    ]


def driven(case: Contact, turned: bool) -> dict[str, str]:
    """What drives a step, by the words of group sequence."""
    load, x, y, spin = case.drive
    sign = -1.0 if turned else 1.0
    force = sign * force_limit(case)
    along = {"force_longitudinal": text(x * force, "N")}
    if case.force == "0":
        along = {"creep": text(sign * x)}
    across = {"force_lateral": text(y * force, "N")}
    if case.force != "2":
        across = {"lateral": text(sign * y)}
    return {"load": text(load, "N"), **along, **across, "spin": text(spin, "1/mm")}


def stage_drive(group: list[Contact]) -> str:
    """What shifts stages at rest that go on from each other."""
    first = group[0]
    for case in group:
        shifts = any(case.drive[1:]) if case.force == "0" else any(case.drive[2:])
        if case.drive[1] != first.drive[1] or case.force != first.force or shifts:
            raise Refused(
                f"{case.line}: stages without a shift, or under one force along x, are converted"
            )
        if case.table is not None:
            raise Refused(f"{case.line}: stages on one quadratic gap are converted")
        if case.tang == "2":
            raise Refused(f"{case.line}: T = 2: a shift after steps of rolling is not converted")
    if first.norm != "1":
        raise Refused(f"{first.line}: stages begin under a load")
    if first.force == "0":
        return "force: {longitudinal: 0 N, lateral: 0 N}"  # no shift, by symmetry
    force_limit(first)
    if not 0.0 < abs(first.drive[1]) < 1.0:
        raise Refused(f"{first.line}: FX: stages under a force within (0, 1) are converted")
    return f"static: {{force_ratio: {text(abs(first.drive[1]))}}}"


def stages(group: list[Contact]) -> list[str]:
    """Loads, or approaches in their place, of stages at rest."""
    loads: list[str] = []
    approaches: list[str] = []
    for case in group:
        under_load = case.norm == "1"
        loads.append(text(case.drive[0], "N") if under_load else loads[-1])
        approaches.append("0 mm" if under_load else text(case.drive[0], "mm"))
    times = ", ".join(f"{k} s" for k in range(len(group)))
    given = f", approach: [{', '.join(approaches)}]" if set(approaches) != {"0 mm"} else ""
    return [f"sequence: {{time: [{times}], load: [{', '.join(loads)}]{given}}}"]
