// The structure of an R2000 or later DXF file, checked without any reader: sections, tables, handles, owners, subclass markers.

const SECTIONS = ['HEADER', 'CLASSES', 'TABLES', 'BLOCKS', 'ENTITIES', 'OBJECTS'];
const TABLES = ['VPORT', 'LTYPE', 'LAYER', 'STYLE', 'VIEW', 'UCS', 'APPID', 'DIMSTYLE', 'BLOCK_RECORD'];
/** Records without which programs refuse the file. */
const RECORDS = { VPORT: ['*Active'], LTYPE: ['ByBlock', 'ByLayer', 'Continuous'], LAYER: ['0'], STYLE: ['Standard'], APPID: ['ACAD'], DIMSTYLE: ['Standard'], BLOCK_RECORD: ['*Model_Space', '*Paper_Space'] };
/** Subclass markers of entities, in the order of the DXF reference. */
const MARKERS = {
  LINE: ['AcDbEntity', 'AcDbLine'],
  CIRCLE: ['AcDbEntity', 'AcDbCircle'],
  ARC: ['AcDbEntity', 'AcDbCircle', 'AcDbArc'],
  ELLIPSE: ['AcDbEntity', 'AcDbEllipse'],
  SPLINE: ['AcDbEntity', 'AcDbSpline'],
  LWPOLYLINE: ['AcDbEntity', 'AcDbPolyline'],
  TEXT: ['AcDbEntity', 'AcDbText', 'AcDbText'],
  INSERT: ['AcDbEntity', 'AcDbBlockReference'],
};

/** Objects of a section: what starts with group 0, each with its groups. */
function objects(groups) {
  const all = [];
  for (const group of groups) group[0] === 0 ? all.push({ kind: group[1], groups: [] }) : all.at(-1)?.groups.push(group);
  return all;
}

const valuesOf = ({ groups }, code) => groups.filter(([c]) => c === code).map(([, value]) => value);
const handleOf = (object) => valuesOf(object, object.kind === 'DIMSTYLE' ? 105 : 5)[0];

function sectionsOf(text) {
  const lines = text.split(/\r?\n/);
  const groups = [];
  for (let i = 0; i + 1 < lines.length; i += 2) groups.push([Number(lines[i]), lines[i + 1].trim()]);
  const sections = new Map();
  let open = null;
  for (const [i, [code, value]] of groups.entries()) {
    if (code === 0 && value === 'SECTION') sections.set(groups[i + 1][1], (open = []));
    else if (code === 0 && value === 'ENDSEC') open = null;
    else open?.push([code, value]);
  }
  return { sections, ends: groups.at(-1)?.join() === '0,EOF' };
}

/** Everything that is wrong with the structure of a DXF text, a sentence each. */
export function faults(text) {
  const { sections, ends } = sectionsOf(text);
  const missing = SECTIONS.filter((name) => !sections.has(name));
  if (missing.length > 0) return [`there is no section ${missing.join(', ')}`];
  const found = ends ? [] : ['the file does not end with EOF'];
  const header = sections.get('HEADER');
  const variable = (name) => header[header.findIndex(([, value]) => value === name) + 1][1];
  if (!(variable('$ACADVER') >= 'AC1015')) found.push(`version ${variable('$ACADVER')} is before R2000`);

  const inTables = objects(sections.get('TABLES'));
  for (const name of TABLES) {
    if (!inTables.some((o) => o.kind === 'TABLE' && valuesOf(o, 2)[0] === name)) found.push(`there is no table ${name}`);
    const names = inTables.filter((o) => o.kind === name).map((o) => valuesOf(o, 2)[0]?.toLowerCase());
    found.push(...(RECORDS[name] ?? []).filter((r) => !names.includes(r.toLowerCase())).map((r) => `table ${name} has no ${r}`));
  }
  const entities = objects(sections.get('ENTITIES'));
  const all = [...inTables.filter((o) => o.kind !== 'ENDTAB'), ...objects(sections.get('BLOCKS')), ...entities, ...objects(sections.get('OBJECTS'))];
  found.push(...handleFaults(all, variable('$HANDSEED')));

  const layers = new Set(inTables.filter((o) => o.kind === 'LAYER').map((o) => valuesOf(o, 2)[0]));
  for (const entity of entities) {
    const markers = valuesOf(entity, 100);
    if (markers.join() !== (MARKERS[entity.kind] ?? markers).join()) found.push(`${entity.kind} ${handleOf(entity)} has the markers [${markers}]`);
    if (!layers.has(valuesOf(entity, 8)[0])) found.push(`${entity.kind} ${handleOf(entity)} is on a layer that is not in the table`);
  }
  // The reference gives a placeholder no marker.
  found.push(...all.filter((o) => valuesOf(o, 100).length === 0 && o.kind !== 'ACDBPLACEHOLDER').map((o) => `${o.kind} ${handleOf(o)} has no subclass marker`));
  return found;
}

/** Handles are there, unique and below the seed, and every owner is an object of the file. */
function handleFaults(all, seed) {
  const found = [];
  const handles = new Set();
  for (const object of all) {
    const handle = handleOf(object);
    if (!/^[0-9A-F]+$/i.test(handle ?? '')) found.push(`${object.kind} has no handle`);
    else if (handles.has(handle)) found.push(`handle ${handle} is there twice`);
    else if (!(parseInt(handle, 16) < parseInt(seed, 16))) found.push(`handle ${handle} is not below $HANDSEED ${seed}`);
    handles.add(handle);
  }
  for (const object of all) {
    // The first owner is the object's own; later ones belong to lists of reactors.
    const [owner] = valuesOf(object, 330);
    if (owner !== '0' && !handles.has(owner)) found.push(`${object.kind} ${handleOf(object)} has the owner ${owner}, which is not in the file`);
  }
  return found;
}
