// All texts of the page are in www/app/core/words, so that another language is another file there.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { it } from 'node:test';
import { createPlanner, ENGLISH_REPORT } from 'kerfway';
import { APP, bundled, WORDS, wordsOf } from './page-words.mjs';
import { ROOT } from './support.mjs';

const sources = readdirSync(APP, { recursive: true })
  .map((file) => join(APP, file))
  .filter((file) => /\.ts$/.test(file) && !/core\/words\/|offline\/|vite\.config/.test(file));

/** Literals of a source without its comments and imports. */
function literals(text) {
  const code = text.replace(/\/\*[\s\S]*?\*\//g, '').replace(/(^|\s)\/\/.*$/gm, '').replace(/^import [^;]*;$/gm, '').replace(/^} from .*$/gm, '');
  return [...code.matchAll(/'((?:[^'\\\n]|\\.)*)'|"((?:[^"\\\n]|\\.)*)"|`((?:[^`\\]|\\.)*)`/g)].map(([, ...m]) => m.find((x) => x !== undefined).replace(/\$\{[^}]*\}/g, '…'));
}

/** Names of keys and of things of the browser, classes (so all in small letters), selectors, style: nobody reads them. */
const NOT_READ = /^(button, |…px |Arrow|Ctrl\+|Shift\+|Enter$|Escape$|Home$|End$|Files$|Kerfway$|AC10|R1[234]$|R20|[a-z-]+( [a-z-]+)*$|.*[{}[\]#>=;(]|\d|[a-z]+\/[a-z])/;

it('texts of the page are in the word files only', () => {
  const found = sources.flatMap((file) =>
    literals(readFileSync(file, 'utf8'))
      // Two words, or one that begins like a sentence or a label.
      .filter((text) => /[A-Za-z]{2,}[.,:]? [A-Za-z]{2,}|^[A-Z][a-z]{2,}/.test(text) && !NOT_READ.test(text))
      .map((text) => `${relative(APP, file)}: ${text}`));
  assert.deepEqual(found, []);
});

it('every entry of the word files is used', () => {
  const all = sources.map((file) => readFileSync(file, 'utf8')).join('\n');
  const en = readFileSync(join(APP, 'core', 'words', 'en.ts'), 'utf8');
  const sections = [...en.matchAll(/^ {2}(\w+): \{([\s\S]*?)^ {2}\},$|^ {2}(\w+): \{(.*)\},$/gm)];
  assert.ok(sections.length > 12);
  for (const [, long, body, short, line] of sections) {
    const [name, text] = [long ?? short, body ?? line];
    for (const [, key] of text.matchAll(/(?:^|[,{\n]) *(\w+): (?:['"{[]|\()/g)) {
      const nested = new RegExp(`words\\.\\w+\\.\\w+(\\.${key}\\b|\\[)`);
      assert.ok(all.includes(`words.${name}.${key}`) || nested.test(all) || new RegExp(`words\\.${name}\\[`).test(all), `${name}.${key}`);
    }
  }
});

const SENTENCES_FILE = join(WORDS, 'sentences.ts');
const OTHERS = readdirSync(WORDS).map((file) => file.replace('.ts', '')).filter((name) => !['en', 'index', 'sentences'].includes(name));

/** Every text and function of a language with its place. */
function entries(value, at = '') {
  if (value !== null && typeof value === 'object') return Object.entries(value).flatMap(([key, inner]) => entries(inner, at === '' ? key : `${at}.${key}`));
  return [[at, value]];
}

/** What goes into a sentence, marked so that it can be found in it, and for one thing and for several. */
function sayings(at, say) {
  if (at.startsWith('numbers.')) return [say(20, () => '<number>')];
  if (at === 'drawing.preview.sentence') return [say(['<0>', '<1>'])];
  // The first of two is the number that chooses the form, the second how it is written.
  return [1, 2, 5].map((n) => {
    const args = Array.from({ length: Math.max(say.length, 3) }, (_, i) => `<${i}>`);
    if (/\(_?n, /.test(say.toString()) && /^\(_?n, (w|written)/.test(say.toString())) args[0] = n;
    if (at === 'quote.part') args[1] = n;
    return say(...args);
  });
}

const marks = (text) => [...new Set(text.match(/<[^>]+>/g) ?? [])].sort();

it('every language says everything that English says, with the same values in it', async () => {
  const [en, reference] = [await wordsOf('en'), await wordsOf('de')];
  assert.deepEqual(OTHERS, ['de', 'es', 'ja', 'zh'], 'another language is listed here and in index.ts');
  const index = readFileSync(join(WORDS, 'index.ts'), 'utf8');
  for (const language of OTHERS) {
    assert.match(index, new RegExp(`\\b${language}: '`), `${language} can be chosen`);
    const { errors, sentences: _sentences, ...words } = await wordsOf(language);
    const other = new Map(entries(words));
    // The words of a report in English are those of the package.
    const own = entries({ ...en, report: ENGLISH_REPORT.words });
    // English shows the planner's own sentences about errors; the other languages name the same values.
    assert.deepEqual(Object.keys(errors).sort(), Object.keys(reference.errors).sort(), `${language} has a sentence for each error`);
    for (const [code, say] of Object.entries(errors)) assert.deepEqual(marks(say((name) => `<${name}>`)), marks(reference.errors[code]((name) => `<${name}>`)), `${language} ${code}`);
    assert.deepEqual([...other.keys()].sort(), own.map(([at]) => at).sort(), `${language} has the entries of English`);
    const same = [];
    for (const [at, english] of own) {
      const translated = other.get(at);
      assert.equal(typeof translated, typeof english, `${language} ${at}`);
      if (typeof english === 'function') {
        const [theirs, ours] = [sayings(at, translated), sayings(at, english)];
        theirs.forEach((text, k) => {
          assert.notEqual(text.trim(), '', `${language} ${at}`);
          assert.deepEqual(marks(text), marks(ours[k % ours.length]), `${language} ${at}: ${text}`);
        });
      } else if (english !== '' || at === 'settings.draft') {
        assert.notEqual(String(translated).trim(), '', `${language} ${at}`);
        if (translated === english && /[A-Za-z]{4}/.test(english)) same.push(at);
      }
    }
    // Names, and a few words that are the same: the rest is translated.
    assert.ok(same.length < 0.08 * own.length, `${language} leaves in English: ${same.join(', ')}`);
  }
});

/** The text literals of the planner's sources, with broken lines joined and values as `{}`. */
function planner() {
  const folder = join(ROOT, 'src');
  const files = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith('.rs'));
  const joined = files.map((file) => readFileSync(join(folder, file), 'utf8')).join('\n').replace(/\\\n\s*/g, '');
  return joined.replace(/\{[^{}"\n]*\}/g, '{}').replaceAll('\\"', '"');
}

const VALUE = /\{(?:unit|numbers)?\}/g;

it('the patterns of sentences are what the planner says, and every language has each of them with its values', async () => {
  const { SENTENCES, translated } = await bundled(SENTENCES_FILE);
  const source = planner();
  for (const [key, pattern] of Object.entries(SENTENCES)) {
    // What is counted, "1 place" and "3 places", is put in as one value; so are the verb after a number of pieces, the handle of another contour, and why something is hidden.
    const uncounted = pattern
      .replace(/\b1 ((?:shape|object) (?:is|has)|entity is|copy|bridge|open (?:line leads|contour keeps its)|shape|contour|place|part(?= lies)|piece|move crosses|pair of cuts)\b|\{\} ((?:shapes|objects) (?:are|have)|entities are|copies|bridges|small strokes|open (?:lines lead|contours keep their)|shapes|parts(?= lie)|contours(?= left)|places|gaps|pieces|moves cross|pairs of cuts)\b/g, '{}')
      .replace(/\blies?(?= on top of other)|\)(?=: both)| (?=and not cut)/, '{}');
    for (const piece of uncounted.split(VALUE).map((text) => text.trim()).filter((text) => text.length > 8)) assert.ok(source.includes(piece.replace(/[.:]$/, '')), `${key}: ${piece}`);
  }
  for (const language of OTHERS) {
    const own = await wordsOf(language);
    assert.deepEqual(Object.keys(own.sentences), ['and', ...Object.keys(SENTENCES)], language);
    for (const [key, pattern] of Object.entries(SENTENCES)) {
      let n = 0;
      const values = pattern.replace(VALUE, () => `<${(n += 1)}>`);
      const said = translated(own, values);
      assert.ok(said !== null && said !== values, `${language} ${key}`);
      assert.deepEqual(marks(said), marks(values), `${language} ${key}: ${said}`);
    }
    // A value that is a phrase itself is translated, too.
    const nested = translated(own, 'The border around everything is taken for the sheet and ignored: it is alone on layer SHEET. Keep it if it is a cut.');
    assert.ok(nested.includes(own.sentences.aloneOnLayer.replace('{0}', 'SHEET')), nested);
    // Reasons that the planner joins are translated one by one, and joined as the language joins them.
    const reasons = ['it is alone on layer SHEET', '3 parts lie inside it', 'sheets of 1000 x 500 mm are sold'];
    const joined = translated(own, `The rectangle around everything may be the sheet and not a cut: ${reasons.join(', and ')}. It is currently cut: keep it, or ignore it.`);
    for (const [key, values] of [['aloneOnLayer', ['SHEET']], ['partsInside', ['3']], ['sold', ['1000', '500']]]) assert.ok(joined.includes(own.sentences[key].replace(/\{(\d)\}/g, (_all, k) => values[k])), joined);
    assert.doesNotMatch(joined, /, and |inside/);
    assert.equal(translated(own, 'Something else.'), null);
  }
});

/** A square with a hole; `header`: groups of the header. */
function plate(size, hole, layer, ...header) {
  const line = (x0, y0, x1, y1) => [[0, 'LINE'], [8, layer], [10, x0], [20, y0], [11, x1], [21, y1]];
  const sides = [line(0, 0, size, 0), line(size, 0, size, size), line(size, size, 0, size), line(0, size, 0, 0)].flat();
  const circle = [[0, 'CIRCLE'], [8, layer], [10, size / 2], [20, size / 2], [40, hole / 2]];
  const groups = [[0, 'SECTION'], [2, 'HEADER'], ...header, [0, 'ENDSEC'], [0, 'SECTION'], [2, 'ENTITIES'], ...sides, ...circle, [0, 'ENDSEC'], [0, 'EOF']];
  return new TextEncoder().encode(groups.map(([code, value]) => `${code}\n${value}\n`).join(''));
}

it('why a drawing has its unit is said in every language, with the units of the language', async (t) => {
  const { translated } = await bundled(SENTENCES_FILE);
  const planner = await createPlanner();
  t.after(() => planner.close());
  const inUnit = (code) => [[9, '$INSUNITS'], [70, code]];
  const svg = (attributes, before = '') => new TextEncoder().encode(`${before}<svg xmlns="http://www.w3.org/2000/svg" ${attributes}><rect x="1" y="1" width="80" height="80"/></svg>`);
  const drawings = [
    ['guessed millimetres', plate(300, 6.5, 'PARTS'), {}, ['millimetres']],
    ['guessed inches, a layer with a name like a unit', plate(12.5, 0.257, 'inches'), {}, ['inches']],
    ['in doubt', plate(100, 30, 'PARTS', [9, '$MEASUREMENT'], [70, 0]), {}, ['millimetres', 'inches']],
    ['a code without a use', plate(300, 6.5, 'PARTS', ...inUnit(3)), {}, ['millimetres']],
    ['of the file', plate(300, 6.5, 'PARTS', ...inUnit(4)), {}, ['millimetres']],
    ['of the file, much too large', plate(2000, 30, 'PARTS', ...inUnit(1)), {}, ['inches', 'millimetres']],
    ['of the file, and nothing fits', plate(3e5, 30, 'PARTS', ...inUnit(4)), {}, ['millimetres']],
    ['of the file, but likely another', plate(12.5, 0.257, 'PARTS', ...inUnit(4)), {}, ['millimetres', 'inches']],
    ['chosen', plate(300, 6.5, 'PARTS'), { units: 'in' }, ['inches']],
    ['pixels chosen', svg('width="90" height="90"'), { dpi: 72 }, []],
    ['pixels', svg('width="90" height="90"'), {}, []],
    ['pixels of a program', svg('width="90" height="90"', '<!-- Generator: Adobe Illustrator 24 -->'), {}, []],
    ['a page without a viewBox', svg('width="90mm" height="90mm"'), {}, []],
    ['a page in a unit', svg('width="90mm" height="90mm" viewBox="0 0 90 90"'), {}, []],
  ];
  const NAMES = { millimetres: 'mm', inches: 'in' };
  for (const [what, file, options, units] of drawings) {
    const { units: { reason }, findings } = await planner.load(file, 'plate', options);
    for (const unit of units) assert.ok(reason.includes(unit), `${what}: ${reason}`);
    const said = [reason, ...findings.filter((f) => f.code.startsWith('units-')).map((f) => f.message)];
    for (const language of OTHERS) {
      const own = await wordsOf(language);
      for (const sentence of said) {
        const text = translated(own, sentence);
        assert.ok(text !== null, `${language}, ${what}: ${sentence}`);
        assert.doesNotMatch(text, /\b(the|is|are|in the|because|taken|its?|of|to|millimetres|check)\b/i, `${language}, ${what}: ${text}`);
        for (const unit of units) assert.ok(text.includes(own.unitNames[NAMES[unit]]), `${language}, ${what}: ${text}`);
      }
    }
  }
});

it('in inches, every length of a sentence is in inches, in every language', async () => {
  globalThis.localStorage = { getItem: () => 'in' };
  const { inChosenUnit } = await bundled(join(APP, 'core', 'lengths.ts'));
  delete globalThis.localStorage;
  const { translated } = await bundled(SENTENCES_FILE);
  const offBed = 'The job reaches from x -12.7 to 90 and y 0 to 40 mm, beyond the bed (x 0 to 400, y 0 to 300 mm). Place it on the bed, for example with its middle at that of the bed.';
  assert.equal(inChosenUnit(offBed), 'The job reaches from x -0.5 to 3.54 and y 0 to 1.57 in, beyond the bed (x 0 to 15.7, y 0 to 11.8 in). Place it on the bed, for example with its middle at that of the bed.');
  assert.equal(inChosenUnit("The head starts and ends beyond the bed, at x -5, y 0 mm. Correct the machine's home or its bed."), "The head starts and ends beyond the bed, at x -0.197, y 0 in. Correct the machine's home or its bed.");
  assert.equal(inChosenUnit('The job of 254 x 127 mm is larger than the bed of 1,270 x 25.4 mm.'), 'The job of 10 x 5 in is larger than the bed of 50 x 1 in.');
  assert.equal(inChosenUnit('Contour 12 has a lead-in of 2.54 mm, 5 cuts and 3 mm² at 10 mm/s.'), 'Contour 12 has a lead-in of 0.1 in, 5 cuts and 3 mm² at 10 mm/s.');
  for (const language of OTHERS) {
    const own = inChosenUnit(translated(await wordsOf(language), offBed));
    assert.deepEqual(own.match(/-?\d+(\.\d+)?/g), ['-0.5', '3.54', '0', '1.57', '0', '15.7', '0', '11.8'], `${language}: ${own}`);
  }
});

it('what is found in a careless drawing and in a broken file is said in every language', async (t) => {
  const { translated } = await bundled(SENTENCES_FILE);
  const planner = await createPlanner();
  t.after(() => planner.close());
  const careless = readFileSync(join(APP, 'public', 'samples', 'gaps-and-copies.dxf'));
  // A line of the file is missing within an entity.
  const broken = Buffer.from(careless.toString().replace(/(LWPOLYLINE\r?\n(?:.*\r?\n){30}).*\r?\n/, '$1'));
  for (const [what, file, options, codes] of [
    ['careless', careless, {}, ['duplicate-removed', 'gap-closed', 'open-contour', 'crossing']],
    ['broken', broken, {}, ['damaged-entity']],
    ['broken, kept', broken, { keepDamaged: true }, ['damaged-entity']],
  ]) {
    const { findings } = await planner.load(file, 'plate', options);
    for (const code of codes) {
      const said = findings.filter((f) => f.code === code).map((f) => f.message);
      assert.ok(said.length > 0, `${what}: ${code}`);
      for (const language of OTHERS) {
        const own = await wordsOf(language);
        for (const sentence of said) assert.notEqual(translated(own, sentence), null, `${language} ${what}: ${sentence}`);
      }
    }
  }
});

it('a file of another format is explained in every language, without a sentence in English', async (t) => {
  const { translated } = await bundled(SENTENCES_FILE);
  const planner = await createPlanner();
  t.after(() => planner.close());
  for (const [name, text] of [['dwg', 'AC1032\0\0'], ['pdf', '%PDF-1.7'], ['png', '\x89PNG\r\n'], ['jpg', '\xff\xd8\xff'], ['zip', 'PK\x03\x04'], ['step', 'ISO-10303-21;'], ['gcode', 'G21\nG90\nG0 X1 Y1\nM3 S100\nG1 X2 Y2\n'], ['txt', 'hello']]) {
    const { message } = await planner.load(Buffer.from(text, 'latin1'), `plate.${name}`).then(() => assert.fail(name), (error) => error);
    for (const language of OTHERS) assert.notEqual(translated(await wordsOf(language), message), null, `${language} ${name}: ${message}`);
  }
});

it('what an SVG hides, masks or lacks is said in every language', async (t) => {
  const { translated } = await bundled(SENTENCES_FILE);
  const planner = await createPlanner();
  t.after(() => planner.close());
  const svg = new TextEncoder().encode(`<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">
    <defs><pattern id="p" width="4" height="4"><path d="M0 0h4"/></pattern><mask id="m"/><clipPath id="c"><circle r="9"/></clipPath><marker id="a"/></defs>
    <rect x="5" y="5" width="180" height="80" fill="none" stroke="red"/>
    <circle cx="20" cy="20" r="5" fill="url(#p)" stroke="red"/>
    <circle cx="40" cy="20" r="5" fill="none" stroke="red" mask="url(#m)"/><circle cx="60" cy="20" r="5" fill="none" stroke="red" mask="url(#m)"/>
    <circle cx="80" cy="20" r="5" fill="none" stroke="red" clip-path="url(#c)"/>
    <path d="M20 60h40" fill="none" stroke="red" marker-end="url(#a)"/>
    <path d="M20 70h40" fill="none" stroke="red" stroke-dasharray="2"/>
    <circle cx="100" cy="20" r="5" fill="none" stroke="red" stroke-width="3"/>
    <circle cx="120" cy="20" r="5"/>
    <circle cx="140" cy="20" r="5" fill="none" stroke="red" display="none"/><circle cx="140" cy="60" r="5" fill="none" stroke="red" visibility="hidden"/><circle cx="140" cy="40" r="5" fill="none"/>
    <use href="#lost"/></svg>`);
  const { findings } = await planner.load(svg, 'plate.svg');
  const count = (code) => findings.filter((f) => f.code === code).length;
  assert.deepEqual(['unsupported-entity', 'outline-taken', 'hidden-entity', 'missing-block'].map(count), [4, 3, 3, 1], findings.map((f) => f.message).join(' '));
  for (const language of OTHERS) {
    const own = await wordsOf(language);
    assert.deepEqual(findings.map((f) => f.message).filter((sentence) => translated(own, sentence) === null), [], language);
  }
  assert.equal(translated(await wordsOf('de'), '2 objects have a mask, which is not applied: cut whole. Apply the mask in the drawing program.'),
    '2 Objekte mit einer Maske, die nicht angewendet wird: ganz geschnitten. Wenden Sie die Maske im Zeichenprogramm an.');
});

it('one thing is said as one', async () => {
  const [en, de, es] = await Promise.all(['en', 'de', 'es'].map(wordsOf));
  const said = (n) => [en, de, es].map(({ dock, quote, drawing: { preview } }) => [dock.moves(n, `${n}`), quote.others(n, `${n}`), preview.contours('9', `${n}`, n)]);
  assert.deepEqual(said(1), [
    ['1 move', '1 other kind of part', '1 contour instead of 9'],
    ['1 Zug', '1 weitere Art von Teilen', '1 Kontur statt 9'],
    ['1 paso', '1 tipo de piezas más', '1 contorno en vez de 9'],
  ]);
  assert.deepEqual(said(3), [
    ['3 moves', '3 other kinds of parts', '3 contours instead of 9'],
    ['3 Züge', '3 weitere Arten von Teilen', '3 Konturen statt 9'],
    ['3 pasos', '3 tipos de piezas más', '3 contornos en vez de 9'],
  ]);
});

it('the report of a job has the words of the page: in four languages it had others', async () => {
  const small = (word) => word.toLowerCase();
  for (const language of ['en', 'de', 'es', 'zh', 'ja']) {
    const { report = ENGLISH_REPORT.words, result, table, machine, findings, quote } = await wordsOf(language);
    const { no, layer, length, begins, order, kerf, air, preCuts, nearest, gap, noBound, nothing, weight, severities } = report;
    const [number, , layers, lengths, from, entry] = table.columns;
    assert.deepEqual(
      { no, layer, length, begins, order, kerf, air, preCuts, nearest, gap, noBound, nothing, weight, entry: report.entry.split(/[,，、]/)[0] },
      { no: number, layer: layers, length: lengths, begins: from, order: table.title, kerf: machine.kerf, air: machine.air, preCuts: result.preCuts, nearest: result.greedy, gap: result.gap, noBound: result.noBound, nothing: result.nothingLeft, weight: quote.weight, entry },
      language,
    );
    assert.deepEqual(Object.values(severities).map(small), [findings.error, findings.warning, findings.info].map(small), language);
    assert.ok(report.pierced('1 s', 1).endsWith(result.piercings(1, '1')), `${language}: one piercing`);
  }
});
