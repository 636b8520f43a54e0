// Files made to hang a reader: each must end within a second, read or refused with a clear sentence.

const group = (...words) => words.map((word) => `${word}\n`).join('');

const line = (x, y, u, v) => group(0, 'LINE', 8, 0, 10, x, 20, y, 11, u, 21, v);
const circle = (x, y, r) => group(0, 'CIRCLE', 8, 0, 10, x, 20, y, 40, r);
const insert = (name, ...more) => group(0, 'INSERT', 8, 0, 2, name, 10, 0, 20, 0, ...more);
const block = (name, body) => group(0, 'BLOCK', 8, 0, 2, name, 70, 0, 10, 0, 20, 0) + body + group(0, 'ENDBLK', 8, 0);
const section = (name, body) => group(0, 'SECTION', 2, name) + body + group(0, 'ENDSEC');
const file = (blocks, entities) =>
  section('HEADER', group(9, '$INSUNITS', 70, 4)) + section('BLOCKS', blocks) + section('ENTITIES', entities) + group(0, 'EOF');

const times = (n, make) => Array.from({ length: n }, (_, i) => make(i)).join('');

/** Ten levels of blocks, each with ten inserts of the one below. */
function laughs(body) {
  const levels = times(10, (i) => block(`B${i + 1}`, insert(`B${i}`).repeat(10)));
  return file(block('B0', body) + levels, insert('B10') + circle(0, 0, 5));
}

/** An array of 32,767 x 32,767 of a block. */
const array = (body) => file(block('B', body), insert('B', 70, 32767, 71, 32767, 44, 1, 45, 1) + circle(0, 0, 5));

/** Name and text of each file. */
export const hostile = {
  'insert array 32,767 x 32,767': () => array(circle(0, 0, 0.4)),
  'the same of an empty block': () => array(''),
  'ten levels of ten inserts': () => laughs(circle(0, 0, 1)),
  'the same of an empty block, ten levels': () => laughs(''),
  'a star of 20,000 lines': () => file('', times(20_000, (i) => line(0, 0, 100 + i, i % 997))),
  '5,000 circles around each other': () => file('', times(5_000, (i) => circle(0, 0, (i + 1) / 10))),
  'a grid of 1,000 x 1,000 lines': () =>
    file('', times(1_000, (i) => line(i / 2, 0, i / 2, 500) + line(0, i / 2, 500, i / 2))),
  '100,000 texts on layers of their own': () =>
    file('', circle(0, 0, 5) + times(100_000, (i) => group(0, 'TEXT', 8, `L${i}`, 10, 0, 20, 0, 40, 1, 1, 'x'))),
};
