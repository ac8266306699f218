"""Every format that meshio reads; names that it drops are looked up in the text."""
import re
import warnings

from mesh import Mesh, Skip, compare

try:
    import meshio
except ImportError as missing:
    raise Skip("python3-meshio is not installed") from missing

FACES, LINES = ("quad", "triangle"), ("line",)


def read(path):
    """Points, cells [(kind, nodes, values of the data asked for)], and the mesh itself."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        mesh = meshio.read(path)
    points = [tuple(map(float, p)) for p in mesh.points]
    assert all(p[2:] in ((), (0.0,)) for p in points)
    return [p[:2] for p in points], mesh


def cells(mesh, kinds, key=None):
    """[(nodes, value of cell data `key`)] in the file's order."""
    found = []
    for i, block in enumerate(mesh.cells):
        if block.type not in kinds:
            continue
        values = mesh.cell_data[key][i] if key else [None] * len(block.data)
        assert len(values) == len(block.data)
        found += [(tuple(map(int, nodes)), value if value is None else int(value))
                  for nodes, value in zip(block.data, values)]
    return found


def sizes(values):
    return {value: values.count(value) for value in set(values)}


def split(mesh, key=None):
    faces, lines = cells(mesh, FACES, key), cells(mesh, LINES, key)
    return ([f for f, _ in faces], [e for e, _ in lines], sizes([v for _, v in faces]),
            sizes([v for _, v in lines]))


def check_msh(case, version):
    path = case.write("msh", "--msh-version", version)
    points, mesh = read(path)
    faces, edges, regions, tags = split(mesh, "gmsh:physical")
    compare(case, Mesh(points, faces, edges, regions, tags))
    names = set(mesh.field_data)
    for name in list(case.tag_sizes()) + [r for r in case.regions if r]:
        plain = name.replace('"', "'").replace("\\", "/").replace("\n", " ").replace("\t", " ")
        if len(plain.encode()) < 127:
            assert plain in names, (plain, names)


def check_vtk(case, ending):
    points, mesh = read(case.write(ending))
    faces, edges, regions, _ = split(mesh, "region")
    tags = split(mesh, "tag")[3]
    compare(case, Mesh(points, faces, edges, regions, tags))

    def names(key):
        data = mesh.field_data.get(key)
        return [] if data is None else bytes(data.astype("u1")).decode().split("\0")[:-1]

    assert names("region_names") == case.regions and names("tag_names") == case.tags
    number = {i: t for i, t in enumerate(case.tags)}
    assert case.tag_sizes() == {number[t]: n for t, n in tags.items() if t >= 0}
    vertices = cells(mesh, ("vertex",), "tag")
    assert sorted((points[v], t) for (v,), t in vertices) == sorted(
        (case.points[v], t) for v, t in case.tagged_points)


def label_ok(labels, longest=80):
    assert len({name.lower() for name in labels}) == len(labels), labels
    assert all(re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name) and len(name) <= longest
               for name in labels), labels


def check_inp(case, element):
    points, mesh = read(case.write("inp", "--inp-element", element))
    faces, _, _, _ = split(mesh)
    regions = {name: sum(len(part) for part in parts) for name, parts in mesh.cell_sets.items()}
    compare(case, Mesh(points, faces, None, regions, digits=1e-16))
    label_ok(list(regions))
    label_ok(list(mesh.point_sets))
    nodes = {}
    for e, t in zip(case.edges, case.edge_tag):
        if t >= 0:
            nodes.setdefault(t, set()).update(e)
    for v, t in case.tagged_points:
        nodes.setdefault(t, set()).add(v)
    sets = [set(map(int, members)) for members in mesh.point_sets.values()]
    assert all(members in sets for members in nodes.values())
    for name in case.tag_sizes():  # a plain name is kept; "Inlet" and "inlet" cannot both be
        if re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name) and name.lower() != "inlet":
            assert name in mesh.point_sets, name


def check_su2(case):
    path = case.write("su2")
    points, mesh = read(path)
    faces, edges, _, tags = split(mesh, "su2:tag")
    compare(case, Mesh(points, faces))
    kept = [i for i, (sides, tag) in enumerate(zip(case.edge_sides, case.edge_tag))
            if -1 in sides or tag >= 0]
    assert sorted(tuple(sorted(e)) for e in edges) == sorted(
        tuple(sorted(case.edges[i])) for i in kept)
    for size in case.tag_sizes(kept).values():
        assert size in tags.values()
    label_ok(re.findall("^MARKER_TAG= (.*)$", path.read_text(), re.M))


def check_bdf(case):
    path = case.write("bdf")
    points, mesh = read(path)
    faces, edges, regions, tags = split(mesh, "nastran:ref")
    compare(case, Mesh(points, faces, edges, regions, tags, digits=1e-13))
    names = dict(re.findall('^\\$ PID (\\d+) = \\w+ "(.*)"$', path.read_text(encoding="ascii"), re.M))
    assert {str(pid) for pid in [*regions, *tags]} == set(names)
    assert all(names[str(pid)] == case.regions[pid - 1] or not case.regions[pid - 1].isalnum()
               for pid in regions)


def check(case):
    for version in ("4.1", "2.2"):
        check_msh(case, version)
        yield f"msh {version}: points bit for bit, faces, edges, groups, names"
    for ending in ("vtu", "vtk"):
        check_vtk(case, ending)
        yield f"{ending}: points bit for bit, faces, edges, vertices, groups, names"
    for element in ("CPS4", "S4"):
        check_inp(case, element)
        yield f"inp {element}: points, faces, element and node sets"
    check_su2(case)
    yield "su2: points bit for bit, faces, markers"
    check_bdf(case)
    yield "bdf: points, faces, edges, properties"
    for ending in ("obj", "ply"):
        points, mesh = read(case.write(ending))
        faces, _, regions, _ = split(mesh, "region" if ending == "ply" else None)
        compare(case, Mesh(points, faces, None, regions if ending == "ply" else None))
        yield f"{ending}: points bit for bit, faces"
