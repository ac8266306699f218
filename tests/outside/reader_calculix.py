"""CalculiX solves on the .inp mesh: a bar under tension has an exact solution that every convex mesh
must reproduce, and it takes the node sets, the element sets and the surfaces to get there."""
import re
import shutil
import subprocess

from mesh import Skip

HEAD = """*INCLUDE, INPUT={mesh}
*MATERIAL, NAME=STIFF
*ELASTIC
200., 0.
*MATERIAL, NAME=SOFT
*ELASTIC
100., 0.
"""

SECTION = """*SOLID SECTION, ELSET={elset}, MATERIAL={material}
1.
"""

PULL = """*STEP
*STATIC
*BOUNDARY
inlet, 1, 1
bottom, 2, 2
*DSLOAD
outlet, P, -2.
*NODE PRINT, NSET=outlet
U
*END STEP
"""


def hold_everything(text):
    """A step that names every set and every surface of the file."""
    held = [f"{name}, 1, 2\n" for name in re.findall(r"^\*NSET, NSET=(\w+)", text, re.M)]
    pressed = [f"{name}, P, 1.\n" for name in re.findall(r"^\*SURFACE, NAME=(\w+)", text, re.M)]
    return ("*STEP\n*STATIC\n*BOUNDARY\n" + "".join(held) + "*DSLOAD\n" + "".join(pressed) +
            "*END STEP\n")


def solve(path, step):
    """The result file and what was printed; the first element set is stiff, the others are soft."""
    if not shutil.which("ccx"):
        raise Skip("ccx is not installed")
    job = path.with_name(path.stem + "_job.inp")
    sets = re.findall(r"^\*ELSET, ELSET=(\w+)", path.read_text(), re.M)
    sections = [SECTION.format(elset=name, material="SOFT" if i else "STIFF")
                for i, name in enumerate(sets)]
    job.write_text(HEAD.format(mesh=path.name) + "".join(sections) + step)
    run = subprocess.run(["ccx", "-i", job.stem], cwd=path.parent, capture_output=True, text=True,
                         errors="replace", check=False)
    assert run.returncode == 0 and "*ERROR" not in run.stdout, run.stdout[-2000:]
    return job.with_suffix(".dat"), run.stdout


def check(case):
    if case.domain.stem != "two_materials":
        path = case.write("inp")
        _, said = solve(path, hold_everything(path.read_text()))
        assert "*WARNING" not in said, said[-2000:]
        yield "inp: every set and surface is known, no warning"
        return
    for element in ("CPS4", "CPE4"):
        result, _ = solve(case.write("inp", "--inp-element", element), PULL)
        moved = re.findall(r"^ +(\d+) +(\S+) +(\S+) +(\S+)$", result.read_text(), re.M)
        outlet = {v for e, t in zip(case.edges, case.edge_tag)
                  if t >= 0 and case.tags[t] == "outlet" for v in e}
        assert {int(node) - 1 for node, *_ in moved} == outlet
        # u = stress (length / E + length / E) of the two unit squares in a row
        assert all(abs(float(u) - 2 * (1 / 200 + 1 / 100)) < 1e-7 for _, u, _, _ in moved), moved
        yield f"inp {element}: sets and surfaces carry a load, {len(moved)} nodes moved as they should"
