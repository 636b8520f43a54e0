// The frame of an R2000 drawing (AC1015) around given entities: the least that AutoCAD and ezdxf accept. Every object has a
// handle, an owner and its subclass markers; every entity is on a layer that is in the table.
//
// Source: Autodesk, DXF Reference (R2000); ezdxf, "DXF File Structure", section "Minimal DXF Content".

/** Handles of the frame's objects, which others name as their owners. */
const TABLES = { VPORT: '8', LTYPE: '2', LAYER: '1', STYLE: '5', VIEW: '7', UCS: '6', APPID: '3', DIMSTYLE: '4', BLOCK_RECORD: '9' };
const [MODEL_SPACE, PAPER_SPACE] = ['17', '1B'];
/** The first handle of layers and entities, above those of the frame. */
const FIRST_HANDLE = 0x100;
/** Entities of the samples, and the subclass their own values belong to. A text has the marker a second time, before its vertical alignment. */
const SUBCLASSES = { LINE: ['AcDbLine'], CIRCLE: ['AcDbCircle'], LWPOLYLINE: ['AcDbPolyline'], TEXT: ['AcDbText', 'AcDbText'] };

const table = (name, ...records) => [[0, 'TABLE'], [2, name], [5, TABLES[name]], [330, '0'], [100, 'AcDbSymbolTable'], [70, records.length], ...records.flat(), [0, 'ENDTAB']];
const record = (tableName, subclass, handle, ...values) => [[0, tableName], [tableName === 'DIMSTYLE' ? 105 : 5, handle], [330, TABLES[tableName]], [100, 'AcDbSymbolTableRecord'], [100, subclass], ...values];
const lineType = (handle, name) => record('LTYPE', 'AcDbLinetypeTableRecord', handle, [2, name], [70, 0], [3, ''], [72, 65], [73, 0], [40, 0]);
const section = (name, ...groups) => [[0, 'SECTION'], [2, name], ...groups.flat(), [0, 'ENDSEC']];
const dictionary = (handle, owner, ...entries) => [[0, 'DICTIONARY'], [5, handle], [330, owner], [100, 'AcDbDictionary'], [281, 1], ...entries];

function block(name, [begin, end], owner) {
  const of = (handle) => [[5, handle], [330, owner], [100, 'AcDbEntity'], ...(owner === PAPER_SPACE ? [[67, 1]] : []), [8, '0']];
  return [
    [0, 'BLOCK'], ...of(begin), [100, 'AcDbBlockBegin'], [2, name], [70, 0], [10, 0], [20, 0], [30, 0], [3, name], [1, ''],
    [0, 'ENDBLK'], ...of(end), [100, 'AcDbBlockEnd'],
  ];
}

/** The view a program opens with: all that the entities' coordinates span. */
function view(entities) {
  const along = (code) => entities.flatMap(({ values }) => values.filter(([c]) => c === code || c === code + 1).map(([, v]) => v));
  const [x, y] = [along(10), along(20)].map((all) => [Math.min(...all), Math.max(...all)]);
  const height = Math.max(y[1] - y[0], 1) * 1.2;
  return record('VPORT', 'AcDbViewportTableRecord', '23', [2, '*Active'], [70, 0], [10, 0], [20, 0], [11, 1], [21, 1],
    [12, (x[0] + x[1]) / 2], [22, (y[0] + y[1]) / 2], [13, 0], [23, 0], [14, 10], [24, 10], [15, 10], [25, 10], [16, 0], [26, 0], [36, 1], [17, 0], [27, 0], [37, 0],
    [40, height], [41, Math.max(x[1] - x[0], 1) * 1.2 / height], [42, 50], [43, 0], [44, 0], [50, 0], [51, 0], [71, 0], [72, 1000], [73, 1], [74, 3], [75, 0], [76, 0], [77, 0], [78, 0]);
}

function entityGroups({ kind, layer, values }, handle) {
  const [subclass, ...again] = SUBCLASSES[kind];
  return [[0, kind], [5, handle], [330, MODEL_SPACE], [100, 'AcDbEntity'], [8, layer], [100, subclass], ...values, ...again.map((name) => [100, name])];
}

/**
 * A drawing as the text of a DXF file.
 *
 * `insunits` is the code of its unit, or null to say nothing of it; `entities` are `{ kind, layer, values }`, the values as
 * pairs of group code and value.
 */
export function r2000(insunits, entities) {
  let next = FIRST_HANDLE;
  const handle = () => (next++).toString(16).toUpperCase();
  const layers = ['0', ...new Set(entities.map((e) => e.layer))].map((name) => record('LAYER', 'AcDbLayerTableRecord', handle(), [2, name], [70, 0], [62, 7], [6, 'Continuous']));
  const body = entities.flatMap((e) => entityGroups(e, handle()));
  const units = insunits === null ? [] : [[9, '$INSUNITS'], [70, insunits]];
  const groups = [
    section('HEADER', [[9, '$ACADVER'], [1, 'AC1015'], [9, '$DWGCODEPAGE'], [3, 'ANSI_1252'], ...units, [9, '$HANDSEED'], [5, handle()]]),
    section('CLASSES'),
    section('TABLES',
      table('VPORT', view(entities)),
      table('LTYPE', lineType('24', 'ByBlock'), lineType('25', 'ByLayer'), lineType('26', 'Continuous')),
      table('LAYER', ...layers),
      table('STYLE', record('STYLE', 'AcDbTextStyleTableRecord', '29', [2, 'Standard'], [70, 0], [40, 0], [41, 1], [50, 0], [71, 0], [42, 2.5], [3, 'txt'], [4, ''])),
      table('VIEW'),
      table('UCS'),
      table('APPID', record('APPID', 'AcDbRegAppTableRecord', '2A', [2, 'ACAD'], [70, 0])),
      dimensionStyles(),
      table('BLOCK_RECORD', ...[[MODEL_SPACE, '*Model_Space'], [PAPER_SPACE, '*Paper_Space']].map(([at, name]) => record('BLOCK_RECORD', 'AcDbBlockTableRecord', at, [2, name])))),
    section('BLOCKS', block('*Model_Space', ['18', '19'], MODEL_SPACE), block('*Paper_Space', ['1C', '1D'], PAPER_SPACE)),
    section('ENTITIES', body),
    section('OBJECTS', dictionary('A', '0', [3, 'ACAD_GROUP'], [350, 'B']), dictionary('B', 'A')),
    [[0, 'EOF']],
  ];
  return groups.flat().map(([code, value]) => `${code}\n${value}\n`).join('');
}

/** This table alone has a marker of its own between its head and its records. */
function dimensionStyles() {
  const all = table('DIMSTYLE', record('DIMSTYLE', 'AcDbDimStyleTableRecord', '2B', [2, 'Standard'], [70, 0]));
  const head = all.findIndex(([code]) => code === 70) + 1;
  return [...all.slice(0, head), [100, 'AcDbDimStyleTable'], ...all.slice(head)];
}
