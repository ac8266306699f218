#!/usr/bin/python3
"""usage: read_back.py python|meshio|gmsh|calculix LPQUAD DOMAINS FOLDER
Writes meshes with LPQUAD in every format that the reader knows and compares what it reads. Prints
"SKIPPED: ..." and exits with 77 where the reader is not installed."""
import importlib
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from mesh import Case, Skip  # noqa: E402

DOMAINS = [("square", []), ("two_materials", []), ("plate_with_hole", []), ("annulus", []),
           ("hostile_names", []),
           # triangles beside quads
           ("gear", ["--keep-boundary", "--elements=quad-dominant"]),
           ("hostile_names", ["--keep-boundary", "--elements=quad-dominant"])]


def main():
    reader, program, domains, folder = sys.argv[1:]
    try:
        check = importlib.import_module("reader_" + reader).check
        for name, options in DOMAINS:
            case = Case(program, pathlib.Path(domains) / (name + ".json"), options,
                        pathlib.Path(folder))
            print(f"{case.name}: {len(case.points)} points, {len(case.faces)} faces, "
                  f"{len(case.edges)} edges", flush=True)
            for what in check(case):
                print("  " + what, flush=True)
    except (Skip, ImportError) as reason:
        print(f"SKIPPED: {reader} cannot read anything here because {reason}")
        return 77
    return 0


sys.exit(main())
