"""The mesh a file should hold, and the comparison with what a reader found in it."""
import json
import math
import subprocess


class Skip(Exception):
    pass


class Mesh:
    """points [(x, y)], faces [(point, ..)], edges [(point, point)]; groups {name: number of cells}
    for regions and tags where the reader has them, else None; coordinates good to `digits` parts
    of the mesh's size, 0 = bit for bit."""

    def __init__(self, points, faces, edges=None, regions=None, tags=None, digits=0.0):
        self.points, self.faces, self.edges = [tuple(map(float, p)) for p in points], faces, edges
        self.regions, self.tags, self.digits = regions, tags, digits


class Case:
    """A fixture, the options it is meshed with, and the mesh as our JSON says it."""

    def __init__(self, program, domain, options, folder):
        self.program, self.domain, self.options, self.folder = program, domain, options, folder
        self.name = domain.stem + "".join(options).replace("--", "-")
        self.json = json.loads(self.write("json").read_text(encoding="utf-8"))
        data = self.json
        self.points = [tuple(p) for p in data["points"]]
        self.faces = [tuple(f) for f in data["quads"] + data["triangles"]]
        self.face_region = data["quadRegion"] + data["triangleRegion"]
        self.edges = [tuple(e) for e in data["edges"]]
        self.edge_tag, self.edge_sides = data["edgeTag"], data["edgeRegions"]
        self.regions, self.tags = data["regions"], data["tags"]
        self.tagged_points = data["taggedPoints"]

    def write(self, ending, *more):
        """The mesh in the format of that ending; the same mesh each time, that is promised."""
        self.folder.mkdir(parents=True, exist_ok=True)
        path = self.folder / f"{self.name}.{ending}"
        subprocess.run([self.program, "mesh", self.domain, "-o", path, "--quiet",
                        *self.options, *more], check=True)
        return path

    def region_sizes(self):
        return sorted(self.face_region.count(r) for r in set(self.face_region))

    def tag_sizes(self, edges=None):
        """Edges of every tag, by its name."""
        chosen = range(len(self.edges)) if edges is None else edges
        tags = [self.tags[self.edge_tag[e]] for e in chosen if self.edge_tag[e] >= 0]
        return {name: tags.count(name) for name in set(tags)}


def area(points, face):
    corners = [points[v] for v in face]
    return 0.5 * math.fsum(a[0] * b[1] - b[0] * a[1]
                           for a, b in zip(corners, corners[1:] + corners[:1]))


def turned(face):
    start = face.index(min(face))
    return tuple(face[start:] + face[:start])


def match_points(case, mesh):
    """For each point of the mesh read, the point it was."""
    if mesh.digits == 0:
        number = {p: i for i, p in enumerate(case.points)}
        assert len(number) == len(case.points)
        return [number[p] for p in mesh.points]
    size = max(max(map(abs, p)) for p in case.points)
    match = []
    for p in mesh.points:
        i = min(range(len(case.points)), key=lambda k: math.dist(case.points[k], p))
        assert math.dist(case.points[i], p) <= mesh.digits * size, (p, case.points[i])
        match.append(i)
    return match


def compare(case, mesh):
    """Same points, same faces counter-clockwise, same edges."""
    assert len(mesh.points) == len(case.points), (len(mesh.points), len(case.points))
    match = match_points(case, mesh)
    assert sorted(match) == list(range(len(case.points))), "points"
    assert all(area(mesh.points, f) > 0 for f in mesh.faces), "a face is turned over"
    found = sorted(turned([match[v] for v in f]) for f in mesh.faces)
    assert found == sorted(turned(list(f)) for f in case.faces), "faces"
    if mesh.edges is not None:
        edges = sorted(tuple(sorted((match[a], match[b]))) for a, b in mesh.edges)
        assert edges == sorted(tuple(sorted(e)) for e in case.edges), "edges"
    if mesh.regions is not None:
        assert sorted(mesh.regions.values()) == case.region_sizes(), "regions"
    if mesh.tags is not None:
        sizes = sorted(case.tag_sizes().values())
        for size in sizes:
            assert size in mesh.tags.values(), (sizes, mesh.tags)
