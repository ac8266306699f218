// A STEP file made from scratch: boxes as solids with plane faces (ISO 10303-21, AP214).

/** @param {{name: string, at: number[], size: number[]}[]} boxes  one product each, in millimetres */
export function stepBoxes(boxes) {
  const lines = [];
  const add = (text) => `#${lines.push(text)}`;
  const list = (items) => `(${items.join(',')})`;
  const triple = ([x, y, z]) => list([x, y, z].map((c) => (Number.isInteger(c) ? `${c}.` : `${c}`)));
  const point = (p) => add(`CARTESIAN_POINT('',${triple(p)})`);
  const direction = (d) => add(`DIRECTION('',${triple(d)})`);
  const placement = (p, z, x) => add(`AXIS2_PLACEMENT_3D('',${point(p)},${direction(z)},${direction(x)})`);

  const application = add("APPLICATION_CONTEXT('automotive design')");
  add(`APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,${application})`);
  const length = add('(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))');
  const angle = add('(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))');
  const solidAngle = add('(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())');
  const uncertainty = add(`UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),${length},'distance','')`);
  const context = add('(GEOMETRIC_REPRESENTATION_CONTEXT(3)' +
    `GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((${uncertainty}))` +
    `GLOBAL_UNIT_ASSIGNED_CONTEXT((${length},${angle},${solidAngle}))REPRESENTATION_CONTEXT('',''))`);

  function solid({ at, size }) {
    // Corner number: bit k set where coordinate k is at its end.
    const corner = (n) => at.map((c, k) => c + (n & (1 << k) ? size[k] : 0));
    const vertices = Array.from({ length: 8 }, (_, n) => add(`VERTEX_POINT('',${point(corner(n))})`));
    const edges = new Map();
    function edge(from, to) {
      const [a, b] = [Math.min(from, to), Math.max(from, to)];
      if (!edges.has(`${a} ${b}`)) {
        const along = corner(b).map((c, k) => Math.sign(c - corner(a)[k]));
        const line = add(`LINE('',${point(corner(a))},${add(`VECTOR('',${direction(along)},1.)`)})`);
        edges.set(`${a} ${b}`, add(`EDGE_CURVE('',${vertices[a]},${vertices[b]},${line},.T.)`));
      }
      return add(`ORIENTED_EDGE('',*,*,${edges.get(`${a} ${b}`)},${from < to ? '.T.' : '.F.'})`);
    }
    const face = (ring, normal, along) => {
      const loop = add(`EDGE_LOOP('',${list(ring.map((n, k) => edge(n, ring[(k + 1) % 4])))})`);
      const plane = add(`PLANE('',${placement(corner(ring[0]), normal, along)})`);
      return add(`ADVANCED_FACE('',(${add(`FACE_OUTER_BOUND('',${loop},.T.)`)}),${plane},.T.)`);
    };
    const faces = [
      face([0, 2, 3, 1], [0, 0, -1], [1, 0, 0]), face([4, 5, 7, 6], [0, 0, 1], [1, 0, 0]),
      face([0, 1, 5, 4], [0, -1, 0], [1, 0, 0]), face([2, 6, 7, 3], [0, 1, 0], [1, 0, 0]),
      face([0, 4, 6, 2], [-1, 0, 0], [0, 1, 0]), face([1, 3, 7, 5], [1, 0, 0], [0, 1, 0]),
    ];
    return add(`MANIFOLD_SOLID_BREP('',${add(`CLOSED_SHELL('',${list(faces)})`)})`);
  }

  for (const box of boxes) {
    const origin = placement([0, 0, 0], [0, 0, 1], [1, 0, 0]);
    const shape = add(`ADVANCED_BREP_SHAPE_REPRESENTATION('',(${origin},${solid(box)}),${context})`);
    const productContext = add(`PRODUCT_CONTEXT('',${application},'mechanical')`);
    const product = add(`PRODUCT('${box.name}','${box.name}','',(${productContext}))`);
    const formation = add(`PRODUCT_DEFINITION_FORMATION('','',${product})`);
    const definitionContext = add(`PRODUCT_DEFINITION_CONTEXT('part definition',${application},'design')`);
    const definition = add(`PRODUCT_DEFINITION('design','',${formation},${definitionContext})`);
    add(`SHAPE_DEFINITION_REPRESENTATION(${add(`PRODUCT_DEFINITION_SHAPE('','',${definition})`)},${shape})`);
  }
  const data = lines.map((text, k) => `#${k + 1}=${text};`).join('\n');
  return `ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('boxes','2024-01-01T00:00:00',(''),(''),'','','');\n` +
    `FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n${data}\nENDSEC;\nEND-ISO-10303-21;\n`;
}
