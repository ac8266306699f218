"""The formats that Gmsh reads, seen through the MSH 2.2 file that it writes again."""
import re
import shutil
import subprocess

from mesh import Mesh, Skip, compare

# Gmsh writes 16 digits, one fewer than a double has.
DIGITS = 1e-15


def convert(path):
    if not shutil.which("gmsh"):
        raise Skip("gmsh is not installed")
    out = path.with_name(path.name + ".back.msh")
    run = subprocess.run(["gmsh", "-0", str(path), "-format", "msh22", "-o", str(out)],
                         capture_output=True, text=True, errors="replace", check=True)
    report = run.stdout + run.stderr
    assert not re.search("^(Error|Warning)", report, re.M), report
    return read_msh_2_2(out.read_text(encoding="utf-8"))


def read_msh_2_2(text):
    """Points, {kind: [(physical, entity, nodes)]}, physical names {(dimension, number): name}."""
    lines = iter(text.splitlines())
    number, points, names, elements = {}, [], {}, {}
    for line in lines:
        if line == "$PhysicalNames":
            for _ in range(int(next(lines))):
                dimension, tag, name = next(lines).split(" ", 2)
                names[int(dimension), int(tag)] = name[1:-1]
        elif line == "$Nodes":
            for _ in range(int(next(lines))):
                node, x, y, z = next(lines).split()
                assert float(z) == 0
                number[node] = len(points)
                points.append((float(x), float(y)))
        elif line == "$Elements":
            for _ in range(int(next(lines))):
                _, kind, count, *rest = next(lines).split()
                tags, nodes = rest[:int(count)], rest[int(count):]
                elements.setdefault(int(kind), []).append(
                    (int(tags[0]), int(tags[1]), tuple(number[v] for v in nodes)))
    return points, elements, names


def groups(elements, kinds, which):
    values = [element[which] for kind in kinds for element in elements.get(kind, [])]
    return {value: values.count(value) for value in set(values)}


def check_file(case, path, group, digits=DIGITS):
    """`group`: which of an element's two tags tells regions and tags apart; None: neither."""
    points, elements, names = convert(path)
    faces = [nodes for kind in (2, 3) for _, _, nodes in elements.get(kind, [])]
    edges = [nodes for _, _, nodes in elements.get(1, [])]
    regions = tags = None
    if group is not None:
        regions, tags = groups(elements, (2, 3), group), groups(elements, (1,), group)
    compare(case, Mesh(points, faces, edges, regions, tags, digits))
    return names, elements


def checked(case, path):
    """What `lpquad check` says of a mesh, less its name."""
    run = subprocess.run([case.program, "check", path], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout.splitlines()[1:]


def check_rewritten(case):
    """The other way: what Gmsh writes of our mesh, in bytes and in versions of its own, is the same to us."""
    ours = case.write("msh")
    for options in (["msh22", "-bin"], ["msh41", "-bin"], ["msh40"]):
        out = ours.with_name(ours.name + ".again.msh")
        subprocess.run(["gmsh", "-0", str(ours), "-save_all", "-format", *options, "-o", str(out)],
                       capture_output=True, check=True)
        assert checked(case, out) == checked(case, ours), options


def check(case):
    for version in ("4.1", "2.2"):
        names, elements = check_file(case, case.write("msh", "--msh-version", version), 0)
        assert len(elements.get(15, [])) == len(case.tagged_points)
        for dimension, wanted in ((1, case.tag_sizes()), (2, case.regions)):
            for name in wanted:
                plain = re.sub("[\n\t]", " ", name.replace('"', "'").replace("\\", "/"))
                found = [n for (d, _), n in names.items() if d == dimension]
                assert not name or len(plain.encode()) > 127 or plain in found, (plain, found)
        yield f"msh {version}: points, faces, edges, physical groups with their names"
    check_rewritten(case)
    yield "msh 2.2 and 4.1 in bytes, msh 4.0: written by Gmsh, read by us"
    check_file(case, case.write("vtk"), None)
    yield "vtk: points, faces, edges"
    check_file(case, case.write("bdf"), 1, 1e-13)
    yield "bdf: points, faces, edges, properties"
