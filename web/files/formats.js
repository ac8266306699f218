// What each format of the library is good for, in words.
/** @import { MeshFormat } from 'lpquad' */

/** @type {Record<MeshFormat, {title: string, use: string, type?: string}>} */
export const formats = {
  msh: { title: 'Gmsh', use: 'finite elements: Gmsh, FEniCS, deal.II, MFEM; keeps regions and tags' },
  vtu: { title: 'VTK XML', use: 'looking at it in ParaView', type: 'application/xml' },
  vtk: { title: 'VTK legacy', use: 'ParaView and older tools' },
  inp: { title: 'Abaqus, CalculiX', use: 'structural analysis, with element and node sets' },
  su2: { title: 'SU2', use: 'flow, with boundary markers' },
  bdf: { title: 'Nastran', use: 'structural analysis' },
  obj: { title: 'Wavefront', use: 'modelling programs such as Blender' },
  ply: { title: 'PLY', use: 'geometry processing' },
  geojson: { title: 'GeoJSON', use: 'maps: one polygon per quad', type: 'application/geo+json' },
  svg: { title: 'SVG', use: 'the bare lines, one unit of the drawing per unit', type: 'image/svg+xml' },
  json: { title: 'JSON', use: 'your own programs: points, quads, edges, regions, tags', type: 'application/json' },
};
