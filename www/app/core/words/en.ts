/**
 * Every word of the page, in English: plain, short, no blame; what, where, what to do. Another language is another file of this
 * shape, named in `index.ts`. Sentences that hold something are functions of it, as languages put it in different places.
 * What stands on the page before any script runs is in `index.html`; what the planner says of a drawing (findings, reasons, errors) comes from the planner in English.
 */

import type { DoneReason, FindingCode, Operation, Unit, UnitsTaken } from 'kerfway';

/** "1 contour", "3 contours"; the number comes written. */
const counted = (n: number, written: string, one: string, many = `${one}s`) => `${written} ${n === 1 ? one : many}`;

/** A title for the findings of each code. */
const findingTitles: Record<FindingCode, string> = {
  'unsupported-entity': 'Entities without an outline to cut',
  'damaged-entity': 'Damaged entities',
  resynchronised: 'Breaks in the file',
  truncated: 'The file ends too early',
  'bad-number': 'Numbers that cannot be read',
  'invalid-geometry': 'Entities that make no geometry',
  'missing-block': 'Missing blocks',
  'cyclic-block': 'Blocks that contain themselves',
  'hidden-entity': 'Hidden entities, not cut',
  'units-guessed': 'Units guessed',
  'units-doubtful': 'Units in doubt',
  encoding: 'Characters that cannot be read',
  projected: 'Three-dimensional entities laid flat',
  'outline-taken': 'Filled areas and points',
  'gap-closed': 'Gaps closed',
  'gap-left': 'Gaps left open',
  branch: 'More than two ends meet',
  'duplicate-removed': 'Copies removed',
  'overlap-removed': 'Overlapping lines removed',
  'common-cut': 'Contours that share cuts',
  'kerf-not-applied': 'Contours that keep their drawn line',
  'zero-length': 'Elements without length',
  'self-crossing': 'Contours that cross themselves',
  crossing: 'Contours that cross each other',
  'open-contour': 'Open contours',
  'several-layers': 'Contours on several layers',
  'sheet-outline': 'Border of the sheet',
  'layer-suggestion': 'Layers that are probably not cut',
  'layer-ignored': 'Layers left out',
  'contour-excluded': 'Contours left out',
  'layer-unknown': 'Layers that are not in the drawing',
  'far-from-origin': 'Too far from the origin',
  'not-all-checked': 'Checks cut short',
  more: 'More, not listed one by one',
};

const unitNames: Record<Unit, string> = {
  mm: 'millimetres', cm: 'centimetres', m: 'metres', dm: 'decimetres', um: 'micrometres',
  in: 'inches', ft: 'feet', yd: 'yards', mil: 'mils', microinch: 'microinches',
};
const unitSources: Record<UnitsTaken['source'], string> = { header: 'from the file', guessed: 'guessed', given: 'chosen by you' };
const operations: Record<Operation, string> = { cut: 'Cut', mark: 'Mark', ignore: 'Ignore' };

/** Samples by their file: a title, and what it shows. */
const samples: Record<string, readonly [title: string, about: string]> = {
  'sheet_500.dxf': ['Sheet, 500 contours', 'A full sheet with parts inside parts'],
  'sheet_100.dxf': ['Sheet, 100 contours', 'Gears, flanges and brackets on 1000 × 500 mm'],
  'qu_du_43.dxf': ['43 contours by Qu and Du', 'The test sheet of a paper of 2023'],
  'gaps-and-copies.dxf': ['Gaps, copies, crossings', 'What a careless drawing holds, and what is found in it'],
  'layers.dxf': ['Layers', 'Cut, mark and leave out, told by the names of layers'],
  'no-units.dxf': ['Units in doubt', 'A file that does not say how large it is'],
  'parts-in-parts.dxf': ['Parts in parts', 'Rings within rings: what is inside is cut before what is around it'],
  'lumberjack-polaris.dxf': ['Keyboard plate', 'A real drawing, by Paul James (MIT)'],
};

/** A key, and what it does. */
const keys: readonly (readonly [string, string])[] = [
  ['O', 'Open a DXF file'],
  ['S', 'Stop planning, keep the best path'],
  ['P', 'Pause or resume planning'],
  ['K', 'Keep improving'],
  ['Space', 'Play or pause the cut'],
  ['← →', 'Previous or next contour in the order'],
  ['Home End', 'First or last contour'],
  ['+ −', 'Zoom in or out'],
  ['F', 'Fit the sheet'],
  ['Shift with arrows', 'Move the view'],
  ['C', 'Colours by order'],
  ['A', 'Air moves'],
  ['T', 'Table of the cutting order'],
  ['1 0', 'Cut the selected contour first or last'],
  ['X', 'Leave the selected contour out'],
  ['Ctrl Z', 'Undo a choice; with Shift, redo'],
  ['Esc', 'Clear the selection'],
  ['?', 'This list'],
];

export const en = {
  findingTitles, unitNames, unitSources, operations, samples,

  page: {
    somethingElse: 'The drawing could not be worked on. Reload the page and drop it again.',
    unreadable: (file: string) => `${file} could not be read from disk. Choose it again.`,
    noSample: (title: string) => `The sample "${title}" could not be loaded. Reload the page, or drop a DXF of your own.`,
    chooseHome: 'Click on the sheet where the head starts. Esc keeps the start as it is.',
    noCanvas: 'This browser cannot draw on a canvas.',
    best: (time: string) => `Best ${time}.`,
    read: (file: string, contours: string) => `${file}: ${contours} read.`,
    decided: {
      first: (contour: string) => `${contour}: cut first.`, last: (contour: string) => `${contour}: cut last.`, exclude: (contour: string) => `${contour}: left out, not cut.`,
    },
    loosened: (contour: string) => `${contour}: cut whenever it is best.`,
    noPapers: (why: string) => `The methods of papers could not be loaded. ${why}`,
    pinsGone: 'The contours are other ones now: none is pinned or left out by itself any more.',
  },

  top: {
    samples: 'Samples', units: 'Units', unitsAre: 'Units: ', dark: 'Dark theme', light: 'Light theme', undo: 'Undo (Ctrl Z)', redo: 'Redo (Ctrl Shift Z)',
    order: 'Cutting order', panel: 'Panel', open: 'Open', openFile: 'Open a DXF file', help: 'Keys and help',
  },

  files: {
    title: 'Files', all: 'G-code of all', done: (n: string, of: string) => `${n} of ${of}`, label: (n: string, of: string) => `Files: ${n} of ${of} done`,
    waits: 'Waits', working: 'Being planned', asks: 'Has a question for you', failed: 'Cannot be planned', planned: 'Planned',
    plannedIn: (time: string) => `Planned: ${time}`, nothing: 'There is nothing to cut in it.',
  },

  dock: {
    progress: 'Progress', stop: 'Stop', pause: 'Pause', resume: 'Resume', more: 'Keep improving', choose: 'Choose a DXF', sheet: 'Drawing, machine, plan, result',
    starting: 'Starting the planner…', reading: (file: string) => `Reading ${file}…`, question: 'An answer is needed before planning.',
    nothing: 'Nothing to cut: set a layer to cut or mark.', failed: 'This file cannot be used.', optimal: 'Optimal: no better path exists.',
    planning: (best: string | null) => `Planning${best === null ? '' : `, best ${best}`}`, paused: (best: string | null) => `Paused${best === null ? '' : `, best ${best}`}`,
    saved: (time: string) => `${time} saved`, pace: (moves: string) => `${moves} moves/s`, moves: (moves: string) => `${moves} moves`,
    gap: (share: string) => `at most ${share} above the optimum`,
    done: {
      exhausted: 'Done. This method finds nothing better.',
      replaced: 'Stopped: the planner had to be replaced. The best path is kept.',
      stopped: 'Stopped. The best path is kept.',
    } satisfies Partial<Record<DoneReason, string>>,
    improving: 'Time is up, and it was still improving.', quiet: (time: string) => `Done. No better path found for ${time}.`, second: 'a second',
  },

  drawing: {
    title: 'Drawing', none: 'No drawing yet.', outline: 'Leave out the border around everything', tolerances: 'Tolerances',
    join: 'Join ends nearer than', curves: 'Follow curves within', apply: 'Apply', keep: 'Keep as it is', looking: 'Looking what would change…',
    within: (least: number, most: number) => `From ${least} to ${most} mm.`,
    outlook: {
      joins: (n: number, written: string) => `${counted(n, written, 'gap')} would close`, opens: (n: number, written: string) => `${counted(n, written, 'joint')} would open`,
      goes: (n: number, written: string) => `${counted(n, written, 'piece')} would disappear`, contours: (now: string, then: string) => `${then} contours instead of ${now}`,
      open: (now: string, then: string) => `${then} of them open instead of ${now}`, elements: (now: string, then: string) => `${then} lines and arcs instead of ${now}`,
      nothing: 'Nothing would change.', sentence: (parts: readonly string[]) => `${parts.join(', ')}.`,
    },
    contours: (n: number, written: string) => counted(n, written, 'contour'), openContours: (n: number, written: string) => counted(n, written, 'open contour'),
    parts: (n: number, written: string) => counted(n, written, 'part'), toLookAt: (written: string) => `${written} to look at`,
    notes: (n: number, written: string) => counted(n, written, 'note'), nothingToDo: (notes: string) => `${notes}, nothing to do`,
    version: (name: string) => `DXF ${name}`, show: (contour: string) => `Contour ${contour}, show on the sheet`,
    decided: { first: (contours: string) => `Cut first: ${contours}`, last: (contours: string) => `Cut last: ${contours}`, exclude: (contours: string) => `Left out: ${contours}` },
    loosen: { first: 'Loosen', last: 'Loosen', exclude: 'Cut again' }, others: (n: string) => `and ${n} more`,
    loosenWhat: { first: 'Loosen what is cut first', last: 'Loosen what is cut last', exclude: 'Cut again what was left out' },
  },

  layers: {
    title: 'Layers', done: (layer: string) => `What is done with layer ${layer}`, contours: 'Contours', earlier: (layer: string) => `Earlier: ${layer}`, later: (layer: string) => `Later: ${layer}`,
    suggested: {
      cut: (layer: string) => `By its name, “${layer}” is to be cut.`,
      mark: (layer: string) => `By its name, “${layer}” is to be marked, not cut.`,
      ignore: (layer: string) => `By its name, “${layer}” is to be left out.`,
    },
    take: { cut: 'Cut it', mark: 'Mark it', ignore: 'Leave it out' },
  },

  findings: {
    error: 'Error', warning: 'Warning', info: 'Note', layer: (name: string) => `layer ${name}`, entity: (handle: string) => `entity ${handle}`, show: 'show',
    more: (n: string) => `And ${n} more: they are marked on the sheet.`,
  },

  question: {
    size: 'How large is this drawing?', in: (unit: string) => `in ${unit}`,
    damaged: (n: number, written: string) => `${counted(n, written, 'entity', 'entities')} in this file ${n === 1 ? 'is' : 'are'} damaged`,
    about: 'They were read through a break in the file, so their shape may be wrong. Leave them out, or keep them and look at each.',
    leave: 'Leave them out', keep: 'Keep them',
  },

  machine: {
    title: 'Machine', preset: 'Preset', home: 'Return home at the end', leaving: 'Leave contours unfinished where that saves time', pausing: 'Pause in sharp corners', back: 'Back to the preset',
    numbers: 'Numbers', air: 'Air moves', start: 'Choose the start on the sheet', unlimited: 'no limit', whole: 'in one go',
    travel: { straight: 'Straight, axis limits', vector: 'Straight, one speed', 'per-axis': 'Each axis for itself' },
    cutSpeed: 'Cutting speed', cutAccel: 'Cutting acceleration', cutPower: 'Cutting power', markSpeed: 'Marking speed', markPower: 'Marking power',
    rapidX: 'Rapid speed, x', rapidY: 'Rapid speed, y', rapidAccelX: 'Rapid acceleration, x', rapidAccelY: 'Rapid acceleration, y', corners: 'Corner deviation',
    pierce: 'Pierce time', preCut: 'Pre-cut time', preCutLength: 'Pre-cut length', sharpAngle: 'Pause in corners below', sharpTime: 'Pause in a corner', noPauses: 'no pauses', kerf: 'Kerf width', kerfHint: 'Parts come out as drawn: the beam follows outlines half a kerf aside. What lies one kerf apart is cut once. 0: the beam follows the lines drawn.', beamOn: 'Beam on delay', beamOff: 'Beam off delay', homeX: 'Home, x', homeY: 'Home, y', fullPower: 'S word of full power',
    own: 'Your machines', name: 'Name of your machine', keepsNothing: 'This browser keeps nothing: export the machine to a file instead.',
    keep: 'Keep', forget: 'Forget', export: 'Export', import: 'Import',
    noJson: 'This file is no machine profile: it is not JSON.', noSchema: (schema: string) => `This file is no machine profile: its "schema" is not ${schema}.`,
    incomplete: 'This machine profile is incomplete: export one to see what belongs in it.',
  },

  plan: {
    title: 'Plan', method: 'Method', papers: 'From published papers', time: 'Search for', seed: 'Seed', random: 'random', used: (seed: number) => `Seed used: ${seed}`,
    byLayer: 'Order by layer', byPart: 'Part by part', common: 'Cut shared sides as one', parameters: 'Parameters', paperValues: "Back to the paper's values",
    always: 'Always on: cut inner shapes first, reduce travel, choose best starting point, choose best direction, remove overlapping lines.',
    partitions: 'On the sheet every partition has its colour; rings are where a contour is left for one.',
    inside: 'Inside the method', numbers: 'Numbers of the method', round: (n: string) => `round ${n}`,
  },

  result: {
    title: 'Result', none: 'Numbers appear as soon as the first path stands.', compare: 'Before and after', order: 'Order', job: 'Job', air: 'Air', way: 'Way',
    drawing: 'Drawing order', greedy: 'Nearest first', now: 'Now', download: 'Download', downloadKind: (kind: string) => `Download ${kind}`,
    kinds: { gcode: 'G-code', dxf: 'DXF', svg: 'SVG', png: 'PNG', json: 'Plan' },
    saved: (time: string) => `${time} saved`, longer: (time: string) => `${time} longer`, of: (time: string, share: string) => `of ${time} in drawing order, ${share}`,
    cut: 'Cut', pierce: 'Pierce', piercings: (n: string) => `${n} piercings`, preCuts: 'Pre-cuts', corners: 'Corners', gap: 'Gap', atMost: (share: string) => `at most ${share} above the optimum`,
    chart: 'Job time over search time', chartAxis: 'Job over search, s', chartAbove: (time: string) => `drawing order ${time} ↑`, chartNone: 'Job time over search time: nothing yet.',
    chartWords: (first: string, last: string, time: string) => `Job time over search time: from ${first} to ${last} in ${time}.`,
    chartOrders: (drawing: string, greedy: string) => ` Drawing order takes ${drawing}, nearest first ${greedy}.`,
  },

  quote: {
    title: 'Quote', notGiven: 'not given', download: 'Download the report', thickness: 'Thickness', density: 'Density', none: 'Made as soon as the plan is done.',
    confidence: (level: string) => `Confidence ${level}.`, parts: 'Parts', gist: (n: string) => `${n} parts`, different: (n: string, kinds: string) => `${n}, ${kinds} different`, area: 'Their area', weight: 'Weight',
    hole: 'Narrowest hole', web: 'Narrowest web', against: (ratio: string) => ` · ${ratio} × thickness`,
    part: (length: string, holes: number, written: string) => `${length} to cut, ${counted(holes, written, 'hole')}`, and: 'And', others: (n: string) => `${n} other kinds of parts`,
  },

  contour: {
    card: 'Selected contour', numbered: (n: number) => `Contour ${n}`, place: (n: string, of: string) => `No. ${n} of ${of}`, part: (n: string) => `part ${n}`,
    mark: 'mark', open: 'open cut', outer: 'outer', inner: 'inner', begins: (time: string) => `cut begins at ${time}`, fates: { first: 'Cut first', last: 'Cut last', exclude: 'Leave out' }, excluded: 'left out, not cut',
    before: 'The one before (←)', next: 'The next (→)', close: 'Close (Esc)',
  },

  table: {
    title: 'Cutting order', rows: 'Rows of the cutting order', close: 'Close the table', columns: ['No.', 'Layer', 'Length', 'Begins', 'Entry', 'Turn'],
    show: (n: number) => `Contour ${n}, show on the sheet`, reversed: 'reversed', asDrawn: 'as drawn', open: 'open',
  },

  stage: { first: 'first', last: 'last', common: 'cut once for two parts', colours: 'Colours by order (C)', air: 'Air moves (A)', view: 'View', zoomIn: 'Zoom in (+)', zoomOut: 'Zoom out (−)', fit: 'Fit the sheet (F)' },

  playback: {
    play: 'Play', moment: 'Moment of the job', speed: 'Speed', whole: 'Whole job in 20 s', pauseKey: 'Pause the cut (space)', playKey: 'Play the cut (space)',
    at: (time: string, total: string, contour: number, of: number) => `${time} of ${total}, contour ${contour} of ${of}`,
  },

  help: {
    title: 'Keys', close: 'Close', with: 'with', keys,
    more: 'Wheel or pinch zooms about the pointer, drag moves the sheet, a click selects a contour, a click with Shift has it cut first, one with Alt leaves it out. The drawing never leaves this machine.',
  },

  numbers: { locale: 'en', thousand: (n: string) => `${n} thousand`, million: (n: string) => `${n} million` },
};
