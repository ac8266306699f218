"""JSON, GeoJSON and SVG by the parsers of Python's standard library."""
import json
import math
import re
import xml.etree.ElementTree as xml

from mesh import Mesh, area, compare


def loop_area(loop):
    return abs(area(loop, range(len(loop))))


def check_json(case):
    """The mesh covers the domain, and its names are the domain's."""
    domain = json.loads(case.domain.read_text(encoding="utf-8"))
    regions = domain.get("regions", [domain])
    compare(case, Mesh(case.points, case.faces, case.edges))
    for r, region in enumerate(regions):
        loops = sorted(map(loop_area, region["loops"]), reverse=True)
        covered = math.fsum(area(case.points, f)
                            for f, at in zip(case.faces, case.face_region) if at == r)
        wanted = loops[0] - math.fsum(loops[1:])
        assert abs(covered - wanted) <= 1e-12 * loops[0], (covered, wanted)
    if "regions" in domain:
        assert case.regions == [region.get("name", "") for region in regions]
    tags = {tag for region in regions for loop in region.get("tags", []) for tag in loop if tag}
    tags |= {line["tag"] for line in domain.get("polylines", []) if line.get("tag")}
    assert set(case.tag_sizes()) == tags, (case.tag_sizes(), tags)
    points = [p for p in domain.get("points", []) if isinstance(p, dict)]
    assert ({(tuple(p["position"]), p["tag"]) for p in points} ==
            {(case.points[v], case.tags[t]) for v, t in case.tagged_points})


def check_geojson(case):
    data = json.loads(case.write("geojson").read_text(encoding="utf-8"))
    assert data["type"] == "FeatureCollection"
    number = {p: i for i, p in enumerate(case.points)}
    faces, edges, points = [], [], []
    for feature in data["features"]:
        assert feature["type"] == "Feature"
        kind, at = feature["geometry"]["type"], feature["geometry"]["coordinates"]
        own = feature["properties"]
        if kind == "Polygon":
            (ring,) = at
            assert ring[0] == ring[-1] and area(ring, range(len(ring) - 1)) > 0
            assert 0 <= own["eta"] <= 1
            faces.append((tuple(number[tuple(p)] for p in ring[:-1]), own["region"]))
        elif kind == "LineString":
            ids = [number[tuple(p)] for p in at]
            edges += [(a, b, own["tag"], own["left"], own["right"]) for a, b in zip(ids, ids[1:])]
        else:
            assert kind == "Point"
            points.append((number[tuple(at)], own["tag"]))

    def name(names, i):
        return names[i] or None if i >= 0 else None

    assert sorted(map(repr, faces)) == sorted(
        repr((f, name(case.regions, r))) for f, r in zip(case.faces, case.face_region))
    assert sorted(map(repr, edges)) == sorted(
        repr((*e, name(case.tags, t), name(case.regions, s[0]), name(case.regions, s[1])))
        for e, t, s in zip(case.edges, case.edge_tag, case.edge_sides))
    assert sorted(points) == sorted((v, case.tags[t]) for v, t in case.tagged_points)


def check_svg(case):
    root = xml.fromstring(case.write("svg").read_text(encoding="utf-8"))
    tags = {element.tag.rpartition("}")[2] for element in root.iter()}
    assert "script" not in tags, tags
    filled = " ".join(element.get("d", "") for element in root.iter() if element.get("fill"))
    assert len(re.findall("Z", filled)) == len(case.faces)


def check(case):
    check_json(case)
    yield "json: covers the domain, names kept"
    check_geojson(case)
    yield "geojson: faces, edges, points, names"
    check_svg(case)
    yield "svg: well formed, every face drawn"
