// A seeded drawing like those of large cutting jobs, written as an R2000 file: entities of every usual kind in the shares
// of the audit (lines, circles, arcs, polylines, a few splines), with the handles, owners and subclass markers that make
// real files as large as they are.

/** mulberry32: a small generator of numbers in [0, 1), the same everywhere. */
function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t = (t + Math.imul(t ^ (t >>> 7), t | 61)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const LAYERS = ['CUT', 'HOLES', 'MARK'];

/** Of a hundred entities, how many are of each kind; most polylines of real jobs have some dozen vertices. */
const SHARES = [
  ['LINE', 48],
  ['CIRCLE', 14],
  ['ARC', 16],
  ['LWPOLYLINE', 20],
  ['SPLINE', 2],
];

/** The text of a drawing with `entities` entities on a 3 m x 1.5 m sheet, ids and coordinates decided by `seed`. */
export function drawing(entities, seed) {
  const next = random(seed);
  const between = (a, b) => a + (b - a) * next();
  const out = [];
  const group = (code, value) => out.push(`${String(code).padStart(3)}\n${value}\n`);
  const real = (code, value) => group(code, value.toFixed(12).replace(/0+$/, '0'));
  let handle = 0x100;

  const head = (kind, marker) => {
    group(0, kind);
    group(5, (handle++).toString(16).toUpperCase());
    group(330, '1F');
    group(100, 'AcDbEntity');
    group(8, LAYERS[Math.floor(next() * LAYERS.length)]);
    group(62, 256);
    group(6, 'ByLayer');
    group(370, -1);
    group(100, marker);
  };
  const point = (code, x, y) => {
    real(code, x);
    real(code + 10, y);
    real(code + 20, 0);
  };

  const write = {
    LINE() {
      head('LINE', 'AcDbLine');
      const [x, y] = [between(0, 3000), between(0, 1500)];
      point(10, x, y);
      point(11, x + between(-40, 40), y + between(-40, 40));
    },
    CIRCLE() {
      head('CIRCLE', 'AcDbCircle');
      point(10, between(0, 3000), between(0, 1500));
      real(40, between(1, 12));
    },
    ARC() {
      head('ARC', 'AcDbCircle');
      point(10, between(0, 3000), between(0, 1500));
      real(40, between(1, 30));
      group(100, 'AcDbArc');
      real(50, between(0, 360));
      real(51, between(0, 360));
    },
    LWPOLYLINE() {
      head('LWPOLYLINE', 'AcDbPolyline');
      const [x, y, n] = [between(50, 2950), between(50, 1450), 6 + Math.floor(next() * 18)];
      group(90, n);
      group(70, 1);
      real(43, 0);
      for (let i = 0; i < n; i++) {
        const [a, r] = [(2 * Math.PI * i) / n, between(6, 12)];
        real(10, x + r * Math.cos(a));
        real(20, y + r * Math.sin(a));
        if (next() < 0.25) real(42, between(-0.4, 0.4));
      }
    },
    /** A closed outline like those of exported logos: control points around a circle, the first three repeated. */
    SPLINE() {
      head('SPLINE', 'AcDbSpline');
      const [x, y, n] = [between(50, 2950), between(50, 1450), 8 + Math.floor(next() * 10)];
      const control = Array.from({ length: n }, (_, i) => {
        const [a, r] = [(2 * Math.PI * i) / n, between(18, 22)];
        return [x + r * Math.cos(a), y + r * Math.sin(a)];
      });
      control.push(...control.slice(0, 3));
      group(70, 11);
      group(71, 3);
      group(72, control.length + 4);
      group(73, control.length);
      group(74, 0);
      for (let i = 0; i < control.length + 4; i++) real(40, i);
      for (const [px, py] of control) point(10, px, py);
    },
  };

  group(0, 'SECTION');
  group(2, 'HEADER');
  group(9, '$ACADVER');
  group(1, 'AC1015');
  group(9, '$INSUNITS');
  group(70, 4);
  group(0, 'ENDSEC');
  group(0, 'SECTION');
  group(2, 'TABLES');
  group(0, 'TABLE');
  group(2, 'LAYER');
  group(70, LAYERS.length);
  for (const name of LAYERS) {
    group(0, 'LAYER');
    group(2, name);
    group(70, 0);
    group(62, 7);
    group(6, 'CONTINUOUS');
  }
  group(0, 'ENDTAB');
  group(0, 'ENDSEC');
  group(0, 'SECTION');
  group(2, 'ENTITIES');
  for (let i = 0; i < entities; i++) {
    let share = next() * 100;
    const kind = SHARES.find(([, of]) => (share -= of) < 0)?.[0] ?? 'LINE';
    write[kind]();
  }
  group(0, 'ENDSEC');
  group(0, 'EOF');
  return out.join('');
}
