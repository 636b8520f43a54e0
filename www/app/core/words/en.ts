/**
 * Every word that people read on the page, in English. Sentences are plain and short, blame nobody, and say what happened, where, and what to
 * do about it. Another language is another file of this shape, listed in `index.ts`. A sentence that contains a value is a function, because
 * languages put the value in different places.
 *
 * The planner writes its findings, reasons and errors itself, in English. Other languages have a phrase for each code of a finding or an error, and
 * show the planner's sentence as a detail. `index.html` holds what is visible before any script runs.
 */

import type { Decision } from '../../session/alternatives.js';
import type { Anchor, CornerKind, DoneReason, FindingCode, JointKind, JointSide, LeadKind, LeadPosition, Operation, Quote, RiskyMoves, Unit, UnitsTaken } from 'kerfway';

/** "1 contour", "3 contours". The number `n` chooses the form; `written` is how it is shown. */
const counted = (n: number, written: string, one: string, many = `${one}s`) => `${written} ${n === 1 ? one : many}`;

/** A phrase about `n` things; `written` is how the number is shown. */
export type Counted = (n: number, written: string) => string;

/** What the findings of each code report, `n` of them, as a short phrase. */
const findingTitles: Record<FindingCode, Counted> = {
  'unsupported-entity': (n, w) => counted(n, w, 'object without an outline (text, image, ...) skipped', 'objects without an outline (text, images, ...) skipped'),
  'damaged-entity': (n, w) => counted(n, w, 'damaged entity', 'damaged entities'),
  resynchronised: (n, w) => counted(n, w, 'damaged place in the file', 'damaged places in the file'),
  truncated: () => 'The file ends too early',
  'bad-number': (n, w) => counted(n, w, 'unreadable number'),
  'invalid-geometry': (n, w) => counted(n, w, 'entity without valid geometry', 'entities without valid geometry'),
  'missing-block': (n, w) => counted(n, w, 'missing block'),
  'cyclic-block': (n, w) => counted(n, w, 'block that contains itself', 'blocks that contain themselves'),
  'hidden-entity': (n, w) => counted(n, w, 'hidden entity, not cut', 'hidden entities, not cut'),
  'units-guessed': () => 'Guessed units',
  'units-doubtful': () => 'Uncertain units',
  encoding: (n, w) => counted(n, w, 'unreadable character'),
  projected: (n, w) => counted(n, w, 'three-dimensional entity flattened', 'three-dimensional entities flattened'),
  'outline-taken': (n, w) => counted(n, w, 'filled area or wide line cut as a thin line', 'filled areas or wide lines cut as thin lines'),
  'gap-closed': (n, w) => counted(n, w, 'gap closed', 'gaps closed'),
  'gap-left': (n, w) => counted(n, w, 'open gap'),
  branch: (n, w) => counted(n, w, 'place where more than two ends meet', 'places where more than two ends meet'),
  'duplicate-removed': (n, w) => counted(n, w, 'duplicate removed', 'duplicates removed'),
  'near-copy': (n, w) => counted(n, w, 'contour near another one', 'contours near others'),
  'overlap-removed': (n, w) => counted(n, w, 'overlapping line removed', 'overlapping lines removed'),
  'feature-too-small': (n, w) => counted(n, w, 'contour too small for the beam', 'contours too small for the beam'),
  'common-cut': (n, w) => counted(n, w, 'group of contours with shared cuts', 'groups of contours with shared cuts'),
  bridges: (n, w) => counted(n, w, 'bridge'),
  'part-shift': (n, w) => counted(n, w, 'part could stand one kerf from a neighbour', 'parts could stand one kerf from a neighbour'),
  'kerf-not-applied': (n, w) => counted(n, w, 'contour without kerf compensation', 'contours without kerf compensation'),
  'zero-length': (n, w) => counted(n, w, 'element of zero length removed', 'elements of zero length removed'),
  'sliver-collapsed': (n, w) => counted(n, w, 'sliver cut as one line', 'slivers cut as one line each'),
  lettering: (n, w) => counted(n, w, 'small stroke that looks like lettering', 'small strokes that look like lettering'),
  leaders: (n, w) => counted(n, w, 'line that leads to lettering', 'lines that lead to lettering'),
  'self-crossing': (n, w) => counted(n, w, 'place where a contour crosses itself', 'places where a contour crosses itself'),
  crossing: (n, w) => counted(n, w, 'place where two contours cross', 'places where two contours cross'),
  'open-contour': (n, w) => counted(n, w, 'open contour'),
  'several-layers': (n, w) => counted(n, w, 'contour on several layers', 'contours on several layers'),
  'sheet-outline': () => 'Border of the sheet',
  'layer-suggestion': (n, w) => counted(n, w, 'shape on a layer that should probably not be cut', 'shapes on layers that should probably not be cut'),
  'layer-ignored': (n, w) => counted(n, w, 'shape on an ignored layer', 'shapes on ignored layers'),
  'contour-excluded': (n, w) => counted(n, w, 'contour skipped', 'contours skipped'),
  'layer-unknown': (n, w) => counted(n, w, 'layer that is not in the drawing', 'layers that are not in the drawing'),
  'lead-adjusted': (n, w) => counted(n, w, 'lead changed to fit', 'leads changed to fit'),
  'lead-missing': (n, w) => counted(n, w, 'contour without room for a lead', 'contours without room for leads'),
  'joint-adjusted': (n, w) => counted(n, w, 'contour with other micro-joints than asked for', 'contours with other micro-joints than asked for'),
  'joint-missing': (n, w) => counted(n, w, 'contour without room for a micro-joint', 'contours without room for micro-joints'),
  'far-from-origin': () => 'Too far from the origin',
  'off-bed': () => 'Not on the bed',
  'layer-too-fast': () => 'A layer is faster than the machine',
  'least-power-left-out': () => 'Least power is not part of G-code',
  'risky-moves': () => 'Moves cross pieces that may have tipped',
  'corner-stopped': (n, w) => counted(n, w, 'corner without room for a loop or an arc', 'corners without room for loops or arcs'),
  'hot-pairs': () => 'Cuts near each other follow too soon',
  'not-all-checked': (n, w) => counted(n, w, 'incomplete check'),
  more: (n, w) => counted(n, w, 'further finding, not listed', 'further findings, not listed'),
};

const unitNames: Record<Unit, string> = {
  mm: 'millimetres', cm: 'centimetres', m: 'metres', dm: 'decimetres', um: 'micrometres',
  in: 'inches', ft: 'feet', yd: 'yards', mil: 'mils', microinch: 'microinches', px: 'pixels',
};
const unitSources: Record<UnitsTaken['source'], string> = { header: 'from the file', guessed: 'guessed', given: 'chosen by you' };
const operations: Record<Operation, string> = { cut: 'Cut', mark: 'Mark', ignore: 'Ignore' };
const confidence: Record<Quote['confidence']['level'], string> = { high: 'High confidence.', medium: 'Medium confidence.', low: 'Low confidence.' };

/** The samples by their file: a title, and what the sample shows. */
const samples: Record<string, readonly [title: string, about: string]> = {
  'sheet_500.dxf': ['Sheet, 500 contours', 'A full sheet with parts inside parts'],
  'sheet_100.dxf': ['Sheet, 100 contours', 'Gears, flanges and brackets on 1000 × 500 mm'],
  'qu_du_43.dxf': ['43 contours by Qu and Du', 'The test sheet of a paper from 2023'],
  'gaps-and-copies.dxf': ['Gaps, copies, crossings', 'A careless drawing, and what is found in it'],
  'layers.dxf': ['Layers', 'Cut, mark or ignore, suggested by the names of layers'],
  'no-units.dxf': ['Uncertain units', 'A file that does not say how large it is'],
  'parts-in-parts.dxf': ['Parts in parts', 'Nested rings: inner contours are cut before the ones around them'],
  'perforated.dxf': ['Perforated plate', 'Holes cut on the run by a fibre laser, line by line'],
  'held-plates.dxf': ['Leads and joints', 'Where leads fit, and what micro-joints hold'],
  'tips-and-skeleton.dxf': ['Pieces that tip', 'Ways around and over them; the skeleton is cut up at the end'],
  'luggage-tags.svg': ['Luggage tags, SVG', 'Layers of Inkscape: cut and engrave'],
  'lumberjack-polaris.dxf': ['Keyboard plate', 'A real drawing, by Paul James (MIT)'],
};

/** Each key with its action. */
const keys: readonly (readonly [string, string])[] = [
  ['O', 'Open a DXF or SVG file, or a project'],
  ['G', 'Download the program'],
  ['S', 'Stop planning, keep the best path'],
  ['P', 'Pause or resume planning'],
  ['K', 'Keep improving'],
  ['Space', 'Play or pause the cut'],
  ['← →', 'Previous or next contour in the order'],
  ['Home End', 'First or last contour'],
  ['+ −', 'Zoom in or out'],
  ['F', 'Fit the sheet'],
  ['Shift with arrows', 'Move the view'],
  ['C', 'Colour contours by order'],
  ['V', 'Show the colours of layers as drawn'],
  ['A', 'Show or hide air moves'],
  ['T', 'Table of the cutting order'],
  ['1 0', 'Cut the selected contour first or last'],
  ['M X', 'Mark or skip what is selected'],
  ['W L', 'Select the whole part, or everything like it'],
  ['U', 'Cut what is selected without anything else in between'],
  ['B', 'Select several: clicks and steps add, dragging draws a box'],
  ['Ctrl Z', 'Undo a choice; with Shift, redo it'],
  ['Ctrl S', 'Save the project: drawing, decisions and plan'],
  ['D', 'Measure between two points'],
  ['Esc', 'Leave a field, clear the selection'],
  ['?', 'Show this list'],
];

export const en = {
  findingTitles, unitNames, unitSources, operations, samples,

  /** What `index.html` holds in English, for the other languages. */
  markup: {
    title: 'Kerfway: the path of a laser cutter', heading: 'Kerfway, the path of a laser cutter', canvas: 'The sheet with its cutting path',
    keys: 'Left and right arrows step through the contours in cutting order, plus and minus zoom, F fits the sheet, the question mark lists all keys.',
    hint: 'Drop a DXF or SVG anywhere', drop: 'Drop to open', panel: 'Drawing, machine, plan and result', playback: 'Playback',
  },

  settings: {
    title: 'Settings', language: 'Language', lengths: 'Lengths', units: { mm: 'Millimetres', in: 'Inches' },
    /** Empty in a language that a native reader has reviewed. */
    draft: '', later: 'Several files are open, so this takes effect when you next open the page.', reload: 'Reload now',
  },

  page: {
    somethingElse: 'This drawing could not be processed. Reload the page and drop it again.',
    stillApplying: 'The change is still being applied. Try again in a moment.',
    unreadable: (file: string) => `${file} could not be read from disk. Choose it again.`,
    noSample: (title: string) => `The sample "${title}" could not be loaded. Reload the page, or drop a DXF or SVG of your own.`,
    noPart: 'This part of the page could not be loaded. Check the network and try again.',
    chooseHome: 'Click on the sheet where the head should start. Esc cancels.',
    noCanvas: 'This browser cannot draw on a canvas.',
    best: (time: string) => `Best so far: ${time}.`,
    read: (file: string, contours: string) => `${file}: ${contours}.`,
    decided: {
      first: (contour: string) => `${contour}: cut first.`, last: (contour: string) => `${contour}: cut last.`, mark: (contour: string) => `${contour}: marked, not cut.`, exclude: (contour: string) => `${contour}: skipped, not cut.`,
    },
    unpinned: (contour: string) => `${contour}: no longer pinned or skipped.`,
    noPapers: (why: string) => `The methods from published papers could not be loaded. ${why}`,
    copied: 'The G-code is on the clipboard.', notCopied: 'This browser does not let the page write to the clipboard: download the G-code instead.',
    stays: 'Your current drawing has not changed.', close: 'Close',
    back: (file: string) => `${file} is back, as you left it.`, forget: 'Forget it', forgotten: 'Forgotten: nothing of it is stored in this browser any more.',
    kept: 'Kept in this browser for your next visit.',
    nothingKept: 'This browser stores nothing for this page, so your work is lost when you close it. Save the project to keep it.',
    pinsGone: 'The contours have changed, so pinned and skipped contours were reset.',
  },

  top: {
    samples: 'Samples', units: 'Units', unitsAre: 'Units: ', resolution: (dpi: number) => `${dpi} dpi`, dark: 'Dark theme', light: 'Light theme', undo: 'Undo (Ctrl Z)', redo: 'Redo (Ctrl Shift Z)',
    order: 'Cutting order', panel: 'Panel', open: 'Open', openFile: 'Open a DXF or SVG file', help: 'Keys and help',
  },

  files: {
    none: 'No program is ready yet.', title: 'Files', all: (n: string, of: string) => (n === of ? 'G-code of all files' : `G-code of ${n} of ${of} files`), done: (n: string, of: string) => `${n} of ${of}`, label: (n: string, of: string) => `Files: ${n} of ${of} done`,
    waiting: 'Waiting', planning: 'Planning', question: 'Needs an answer from you', failed: 'Cannot be planned', planned: 'Planned',
    plannedIn: (time: string) => `Planned: ${time}`, nothing: 'There is nothing to cut in this file.',
  },

  dock: {
    progress: 'Progress', stop: 'Stop', pause: 'Pause', resume: 'Resume', more: 'Keep improving', undo: 'Undo', choose: 'Choose a DXF or SVG', sheet: 'Drawing, machine, plan, result',
    starting: 'Starting the planner…', reading: (file: string) => `Reading ${file}…`, question: 'An answer is needed first.', applying: 'Applying the change…',
    offBed: 'Not on the bed, so no program', place: 'Place the job', fails: 'The program fails its check, so no G-code',
    nothing: 'Nothing to cut: set a layer to cut or mark.', failed: 'This file cannot be used.', optimal: 'Optimal: no better path exists.',
    planning: (best: string | null) => (best === null ? 'Planning' : `Planning, best so far ${best}`),
    paused: (best: string | null) => (best === null ? 'Paused' : `Paused, best so far ${best}`),
    saved: (time: string) => `${time} saved`, pace: (moves: string) => `${moves} moves/s`, moves: (n: number, written: string) => counted(n, written, 'move'),
    gap: (time: string) => `at most ${time} left to gain`,
    done: {
      exhausted: 'Done. This method finds nothing better.',
      replaced: 'Stopped: the planner had to be restarted. The best path is kept.',
      stopped: 'Stopped. The best path is kept.',
    } satisfies Partial<Record<DoneReason, string>>,
    improving: 'Time is up. More may be gained.', quiet: (time: string) => `Done. Nothing better in the last ${time}.`, second: 'second',
  },

  drawing: {
    title: 'Drawing', none: 'No drawing yet.', tolerances: 'Tolerances',
    join: 'Join ends closer than', near: 'Cut lines once within', curves: 'Follow curves within', apply: 'Apply', cancel: 'Cancel', checking: 'Checking what would change…',
    within: (least: string, most: string, whole: boolean) => `Enter a ${whole ? 'whole number' : 'value'} from ${least} to ${most}.`,
    preview: {
      joins: (n: number, written: string) => `${counted(n, written, 'gap')} would close`, opens: (n: number, written: string) => `${counted(n, written, 'joint')} would open`,
      removals: (n: number, written: string) => `${counted(n, written, 'piece')} would disappear`, contours: (now: string, then: string, n: number) => `${counted(n, then, 'contour')} instead of ${now}`,
      open: (now: string, then: string) => `${then} of them open instead of ${now}`, elements: (now: string, then: string) => `${then} lines and arcs instead of ${now}`,
      nothing: 'Nothing would change.', sentence: (parts: readonly string[]) => `${parts.join(', ')}.`,
    },
    contours: (n: number, written: string) => counted(n, written, 'contour'), openContours: (n: number, written: string) => counted(n, written, 'open contour'),
    parts: (n: number, written: string) => counted(n, written, 'part'),
    version: (name: string) => (name.startsWith('SVG') ? name : `DXF ${name}`), show: (contour: string) => `Contour ${contour}, show on the sheet`,
    decided: { first: (contours: string) => `Cut first: ${contours}`, last: (contours: string) => `Cut last: ${contours}`, mark: (contours: string) => `Marked: ${contours}`, exclude: (contours: string) => `Skipped: ${contours}` },
    unpin: { first: 'Unpin', last: 'Unpin', mark: 'Cut', exclude: 'Cut again' }, others: (n: string) => `and ${n} more`,
    unpinAll: { first: 'Unpin contours that are cut first', last: 'Unpin contours that are cut last', mark: 'Cut instead of marking', exclude: 'Cut again: skipped contours' },
    inOrder: 'In this order', inOrderHint: 'Cut them in the order of this list; otherwise in the fastest order', sequence: (contours: string) => `In this order: ${contours}`,
    together: (contours: string) => `Together: ${contours}`, ungroup: 'Separate', byRule: 'By rule', own: { joints: (contours: string) => `Own micro-joints: ${contours}`, lead: (contours: string) => `Own leads: ${contours}`, corners: (contours: string) => `Own corners: ${contours}` },
    anyOrder: 'Any order', anyOrderAll: 'Leave the order of this sequence to the search',
    move: (name: string, place: string, of: string) => `Move ${name}, ${place} of ${of}: drag, or arrow keys`, removeOne: (name: string) => `Remove ${name} from this list`,
    kinds: (n: number, written: string) => `, ${counted(n, written, 'shape')}`, copies: (n: string, size: string) => `${n} pcs, ${size}`, copiesHint: 'Select all copies of this part',
  },

  layers: {
    title: 'Layers', operation: (layer: string) => `Operation for layer ${layer}`, contours: 'Contours', earlier: (layer: string) => `Earlier: ${layer}`, later: (layer: string) => `Later: ${layer}`,
    settings: (layer: string) => `Settings of layer ${layer}`, settingOf: (setting: string, layer: string) => `${setting}, layer ${layer}`, speed: 'Speed', power: 'Power', minPower: 'Least power', passes: 'Passes', zStep: 'Lower each pass by', air: 'Air assist', unset: 'auto',
    suggested: {
      cut: (layer: string) => `“${layer}” looks like a layer to cut.`,
      mark: (layer: string) => `“${layer}” looks like a layer to mark, not cut.`,
      ignore: (layer: string) => `“${layer}” does not look like a layer to cut. Ignore it?`,
    },
    take: { cut: 'Cut it', mark: 'Mark it', ignore: 'Ignore it' },
  },

  findings: {
    error: 'Error', warning: 'Warning', info: 'Note', layer: (name: string) => `layer ${name}`, entity: (handle: string) => `entity ${handle}`, show: 'show',
    errors: (n: number, written: string) => counted(n, written, 'error'), warnings: (n: number, written: string) => counted(n, written, 'warning'),
    notes: (n: number, written: string) => counted(n, written, 'note'), nothingToDo: (notes: string) => `${notes}, nothing to do`,
    more: (n: string) => `And ${n} more, marked on the sheet.`,
    actions: { keepBorder: 'Cut the border', ignoreBorder: 'Ignore the border', cut: 'Cut', mark: 'Mark', ignore: 'Ignore' },
    group: { lettering: 'lettering', leaders: 'lines that lead to lettering' }, act: (action: string, group: string) => `${action}: ${group}`,
  },

  question: {
    size: 'How large is this drawing?', in: (unit: string) => `in ${unit}`, dpi: (dpi: number) => `in pixels, ${dpi} to the inch`,
    damaged: (n: number, written: string) => `${counted(n, written, 'entity', 'entities')} in this file ${n === 1 ? 'is' : 'are'} damaged`,
    about: (n: number): string => (n === 1 ? 'It is next to a damaged place in the file, so its shape may be wrong. Skip it, or keep and check it.' : 'They are next to a damaged place in the file, so their shape may be wrong. Skip them, or keep them and check each one.'),
    skip: (n: number): string => (n === 1 ? 'Skip it' : 'Skip them'), keep: (n: number): string => (n === 1 ? 'Keep it' : 'Keep them'),
    border: 'Is the rectangle around everything a cut?', ignoreBorder: 'No, it is the sheet: ignore it', keepBorder: 'Yes, cut it',
  },

  machine: {
    first: (others: string) => `First switch off: ${others}.`, also: (others: string) => `Also changed: ${others}.`, on: 'on', off: 'off',
    title: 'Machine', preset: 'Preset', changed: (title: string) => `${title}, changed`, home: 'Return home at the end', partialCuts: 'Allow partial cuts', pausing: 'Pause in sharp corners', back: 'Back to the preset',
    advanced: 'Advanced settings', air: 'Air moves', start: 'Choose the start on the sheet', unlimited: 'no limit', whole: 'in one go',
    travel: { straight: 'Straight line, per-axis limits', vector: 'Straight line, one speed', 'per-axis': 'Axes move independently' },
    cutSpeed: 'Cutting speed', cutAccel: 'Cutting acceleration', cutPower: 'Cutting power', markSpeed: 'Marking speed', markPower: 'Marking power',
    rapidX: 'Rapid speed, x', rapidY: 'Rapid speed, y', rapidAccelX: 'Rapid acceleration, x', rapidAccelY: 'Rapid acceleration, y', corners: 'Corner deviation',
    pierce: 'Pierce time', preCut: 'Pre-cut time', preCutLength: 'Pre-cut length', sharpAngle: 'Pause in corners below', sharpTime: 'Pause in a corner', noPauses: 'no pauses', kerf: 'Kerf width',
    kerfHint: 'Parts keep their drawn size: the beam is offset by half the kerf. Outlines that are one kerf apart are cut once. 0: the beam follows the drawn lines.',
    beamOn: 'Beam on delay', beamOff: 'Beam off delay', homeX: 'Home, x', homeY: 'Home, y', bedX0: 'Bed from x', bedX1: 'Bed to x', bedY0: 'Bed from y', bedY1: 'Bed to y', noBed: 'not known', fullPower: 'Power value at full power',
    material: 'Material', ownSetting: 'As the machine is set', materialName: 'Name of the material', saveMaterial: 'Save setting', removeMaterial: 'Delete setting', materials: 'Material library', materialsHint: 'Speed, power, passes, pierce time and kerf under a name, saved and exported with the machine.',
    zSpeed: 'Speed of the z axis', noZ: 'no z axis',
    which: 'Which machine cuts?', keep: 'Keep this machine',
    own: 'Your machines', name: 'Name of your machine', notSaved: 'This browser does not store data for this page: export the machine to a file instead.',
    save: 'Save', remove: 'Delete', export: 'Export', import: 'Import',
    noJson: 'This file is not a machine profile: it is not JSON.', noSchema: (schema: string) => `This file is not a machine profile: its "schema" is not ${schema}.`,
    incomplete: 'This machine profile is incomplete. Export a machine to see which fields a profile has.',
  },

  calibration: {
    title: 'Calibrate with a stopwatch', hint: 'Run a job, and type in the seconds that it took. Best is one with many piercings and one with many corners.',
    took: 'This job took', none: 'measured', add: 'Add this job', fit: 'Fit the machine', clear: 'Start again', take: 'Use the fitted values', before: 'Before', after: 'After',
    job: (name: string, measured: string, planned: string) => `${name}: ${measured}, planned ${planned}`, notYet: 'Enter the seconds of the job on screen, once its plan is done.',
  },

  leads: {
    title: 'Leads and overcut', kind: 'Lead-in', out: 'Lead-out', position: 'Position', length: 'Length of the line', radius: 'Radius of the arc', angle: 'Angle',
    clearance: 'Distance from parts', centerBelow: 'From the centre in holes below', overcut: 'Overcut',
    kinds: { none: 'None', line: 'Line', arc: 'Arc', 'line-arc': 'Line and arc', center: 'From the centre' } satisfies Record<LeadKind, string>,
    positions: { any: 'Wherever it is fastest', corner: 'At corners', side: 'In the middle of sides' } satisfies Record<LeadPosition, string>,
    about: 'Leads lie in scrap: inside holes, outside parts. Where one does not fit it is changed or skipped, and listed under Drawing. A negative overcut leaves a gap.',
    custom: 'This machine has lead rules of its own.', replace: 'Replace them by one lead for all', ownRules: 'own rules',
  },

  joints: {
    title: 'Micro-joints', on: 'Hold parts by micro-joints', side: 'On', count: 'At least, per contour', width: 'Width that holds', spacing: 'Longest cut without a joint', cornerClearance: 'Distance from corners',
    least: 'Only contours from', most: 'Only contours up to', any: 'any', kind: 'At a joint',
    sides: { both: 'Parts and holes', outer: 'Parts', hole: 'Holes' } satisfies Record<JointSide, string>,
    kinds: { stop: 'Stop and pierce', flying: 'Keep moving' } satisfies Record<JointKind, string>,
    about: 'Short lengths of a contour stay uncut, so that its piece neither falls nor tips. The kerf is added to the width. Where one does not fit, that is listed under Drawing.',
    custom: 'This machine has joint rules of its own.', replace: 'Replace them by one rule', ownRules: 'own rules',
    place: 'Place by hand', placing: 'Click a contour where it should be held; click a joint to remove it. The button or Esc ends it.', clear: 'Remove all',
    placed: (n: number, written: string) => `${counted(n, written, 'joint')} by hand`,
  },

  levers: {
    moving: 'Begin cuts moving', overcut: 'Cut again at the end',
    lift: 'Lift the head between cuts', height: 'Lift by', stayDown: 'Stay down on moves up to', atRest: 'Lift before moving, lower after it',
    fly: 'Cut rows and grids on the run', reach: 'Longest way between two cuts', flyOvercut: 'Cut each contour again by',
    aboutFly: 'The beam goes on and off as the head runs along a row of holes, or the sides of a grid. For sheet that is cut through at once. What has leads or micro-joints is cut one by one.',
    chains: 'Join contours through waste', chainReach: 'Longest cut through waste', chainClearance: 'Distance from other contours',
    bridges: 'Connect parts by bridges', bridgeWidth: 'Width of a bridge', bridgeReach: 'Longest bridge', bridgeMost: 'Most parts together', cutLater: 'Cut them later',
    aboutBridges: 'Strips hold parts together, whose outlines are pierced once.',
    edgeStarts: 'Begin on kerfs and at the edge of the sheet, too',
    shared: 'Cut shared sides together', shift: 'Say which parts to shift by up to', shiftParts: 'Shift them', aboutShared: 'For parts one kerf apart: pierced once and cut as one.',
    aboutChains: 'From the end of a contour the beam cuts through the waste to the next one, where that is quicker than piercing.',
    aboutLift: 'For parts that may tip up. The head rises and sinks on its way, unless you switch that off. Only G-code has the heights.',
    about: 'For marks and thin sheet: the beam goes on as the head starts, without a wait. Open cuts and cuts in several passes still begin at rest.',
  },

  skeleton: {
    on: 'Cut up the skeleton', x: 'Greatest width of pieces', y: 'Greatest height of pieces', clearance: 'Distance from parts', joints: 'Longest cut without a joint', width: 'Width of joints',
    strip: 'Keep a strip of the sheet in one piece', least: 'At least this wide',
    about: 'Straight cuts through the waste, last of all. The sheet is the outline that is drawn and not cut, or the bed. Empty fields: no cuts that way, no joints.',
  },

  tips: {
    title: 'Mind pieces that tip', riskyMoves: 'Moves over them', moves: { ignore: 'Only mark them', avoid: 'Avoid them' } satisfies Record<RiskyMoves, string>,
    nozzle_radius: 'Nozzle radius', margin: 'Distance to keep', pitch: 'From slat to slat', angle: 'Direction of slats', tips_below: 'Pieces tip below', drops_below: 'Pieces drop below', cross_over: 'Cross holes up to',
    unknown: 'not known', about: 'A piece that is cut free drops, tips up or stays, by its size and the slats. To avoid them, the head goes around or is lifted. Amber: pieces that may tip, and moves with the head lifted. Red: moves over them with the head down.',
    lifts: 'Lifts', detours: 'Detours', crossings: 'Risky moves',
  },

  heat: {
    title: 'Let cuts cool', distance: 'Cuts nearer than', seconds: 'Time between them', charge: 'Charge for a pair', thickness: 'Plate thickness', ratio: 'Small: times thickness',
    noCharge: 'none: wait', noThickness: 'not known', about: 'Cuts near each other do not follow each other at once; where nothing else helps, the head waits. With a charge it never waits, and each pair that follows too soon costs that much. With a plate thickness, small holes are cut first.',
    waits: 'Waits', hotPairs: 'Cuts too soon',
  },

  corners: {
    title: 'Do not stop in corners', outer: 'Corners of parts', hole: 'Corners of holes', kinds: { stop: 'as drawn', loop: 'loop', round: 'rounded' } satisfies Record<CornerKind, string>,
    loop_radius: 'Radius of loops', clearance: 'Distance of loops', round_radius: 'Greatest radius', deviation: 'Greatest deviation', loops: 'Loops', rounded: 'Rounded corners',
    about: 'Where that is quicker. A loop crosses its corner straight, and turns in the waste. A rounded corner is an arc within the deviation.',
  },

  placement: {
    title: 'On the bed', position: 'Position', asDrawn: 'As drawn', atPoint: 'A point of the job at', point: 'Point of the job', x: 'x', y: 'y',
    points: {
      'lower-left': 'Lower left', 'lower-center': 'Lower centre', 'lower-right': 'Lower right', 'center-left': 'Centre left', center: 'Centre',
      'center-right': 'Centre right', 'upper-left': 'Upper left', 'upper-center': 'Upper centre', 'upper-right': 'Upper right',
    } satisfies Record<Anchor, string>,
    turnLeft: 'Turn left', turnRight: 'Turn right', drag: 'Drag the job', show: 'Show the bed', coordinates: 'Coordinates', absolute: 'Of the machine', current: 'From the head',
    allow: 'Write programs that leave the bed', reaches: (x0: string, x1: string, y0: string, y1: string, unit: string) => `x ${x0} to ${x1}, y ${y0} to ${y1} ${unit}`,
    off: 'The job is not on the bed.', corner: 'Move to the corner', noBed: 'This machine has no bed: enter its size under Machine, so that programs are checked against it.',
    drawn: 'as drawn', placed: 'placed', offBed: 'reaches beyond it', turned: (degrees: number) => `turned ${degrees}°`,
    dragging: 'Drag the job on the bed. Esc ends it.',
  },

  plan: {
    title: 'Plan', method: 'Method', papers: 'Research methods, from published papers', more: 'Research methods…', time: 'Search for', seed: 'Seed', random: 'random', used: (seed: number) => `Seed used: ${seed}`,
    bySheet: 'Passes sheet by sheet', byLayer: 'Order by layer', byPart: 'Part by part', common: 'Cut shared sides once', parameters: 'Parameters', paperValues: "Back to the paper's values", noValue: 'none',
    always: 'Always on: cut inner shapes first, reduce travel, choose best starting point, choose best direction, remove overlapping lines.',
    partitions: 'Each partition has its own colour on the sheet; a ring marks where the head leaves a contour for a partition.',
    inside: 'Inside the method', numbers: 'Figures of the method', round: (n: string) => `round ${n}`,
  },

  result: {
    title: 'Result', none: 'Results appear here when the first path is ready.', compare: 'Before and after', order: 'Order', job: 'Job', air: 'Air', travel: 'Travel',
    drawing: 'As drawn', greedy: 'Nearest first', now: 'Now', download: 'Download', downloadKind: (kind: string) => `Download ${kind}`,
    kinds: { gcode: 'G-code', dxf: 'DXF', svg: 'SVG', png: 'PNG', json: 'Plan (JSON)', lbrn2: 'LightBurn', rd: 'Ruida (experimental)', remainder: 'Remainder (DXF)' },
    short: { now: 'Now', greedy: 'Nearest', drawing: 'As drawn' }, beside: 'Show side by side with the plan', copy: 'Copy', copyHint: 'Copy the G-code to the clipboard',
    report: 'Report', reportHint: 'One page for the operator: picture, times, parts, order, findings', project: 'Project', projectHint: 'Save the project: drawing, decisions, machine and plan (Ctrl S)',
    nothing: (searching: boolean): string => (searching ? 'No time saved yet' : 'No time saved'), asLong: (order: string) => `As long as nearest first, the order of most programs; ${order}`, saved: (time: string) => `${time} saved`, longer: (time: string) => `${time} longer`, of: (share: string, order: string) => `${share} of nearest first, the order of most programs; ${order}`,
    same: 'as long as drawn', less: (time: string) => `${time} less than as drawn`, more: (time: string) => `${time} more than as drawn`,
    cut: 'Cut', pierce: 'Pierce', piercings: (n: number, written: string) => counted(n, written, 'piercing'), preCuts: 'Pre-cuts', leads: 'Leads', joints: 'Micro-joints', skeleton: 'Skeleton', skeletonCuts: (n: number, written: string) => counted(n, written, 'cut'), corners: 'Corners', gap: 'Left to gain', atMost: (time: string, share: string) => `at most ${time} (${share})`, noBound: 'no bound yet', nothingLeft: 'nothing: this path is optimal',
    chart: 'Job time while searching', chartAxis: 'Job time while searching', chartAbove: (time: string) => `as drawn ${time} ↑`, chartNone: 'Job time while searching: no values yet.',
    chartWords: (first: string, last: string, time: string) => `Job time while searching: from ${first} to ${last} in ${time}.`,
    chartOrders: (drawing: string, greedy: string) => ` As drawn it takes ${drawing}, nearest first ${greedy}.`,
  },

  savings: {
    notYet: 'The plan has to be done first.', title: 'What saves what', about: 'Each decision is left out once, and the rest is planned again.', ask: 'Work it out', working: 'Working…',
    decisions: { order: 'Order, instead of nearest first', entry: 'Entries, instead of where lines begin', common: 'Cutting shared sides once', partial: 'Leaving contours unfinished', leads: 'Leads', 'moving-pierce': 'Beginning cuts moving', fly: 'Cuts on the run', chains: 'Cuts through waste between contours', 'edge-starts': 'Starts on a kerf', bridges: 'Bridges', 'common-cuts': 'Cutting shared sides together', 'lift-on-the-way': 'Lifting the head on the way', 'stay-down': 'Staying down on short moves', 'avoid-tips': 'Avoiding pieces that tip, instead of always lifting', heat: 'Letting cuts cool', corners: 'Not stopping in corners', 'flying-joints': 'Joints without a stop' } satisfies Record<Decision, string>,
    saves: (time: string) => `saves ${time}`, costs: (time: string) => `costs ${time}`, done: (s: number) => `Plans without a decision were searched for up to ${s} s each.`,
  },

  preflight: {
    title: 'Check of the program', unchecked: 'The program is not checked yet', soon: 'It is checked soon, or when you download it.', again: 'A better path was found. Its program is being checked.',
    passes: 'The program passes its check', fails: 'The program fails its check and is not handed out',
    /** What encloses a part by itself. A part that lies within a cut of its neighbour has no outline of its own. */
    outlines: (n: number, written: string) => counted(n, written, 'closed outline'), once: (n: number, written: string) => `${counted(n, written, 'contour')}, each cut once`,
    times: (n: number, written: string, times: string) => `${counted(n, written, 'contour')}, each cut ${times} times`, uneven: (n: string) => `${n} contours, not all cut equally often`,
    dark: 'beam off on every rapid', lit: 'beam on during a rapid', onBed: 'on the bed', offBed: 'off the bed', read: (dialect: string) => `read back as ${dialect}`,
    more: (message: string, n: string) => `${message} And ${n} more like it.`,
  },

  dialect: {
    same: 'The machine uses this dialect already.', title: 'G-code dialect', own: 'Edit the dialect', document: 'Dialect document (JSON)', preview: 'First lines of a program', take: 'Use this dialect', import: 'Import', export: 'Export',
    hint: 'A dialect says how your controller takes power, waits and units. Change it here, and give it a name of its own.', mine: (title: string) => `${title} (yours)`,
    noJson: (why: string) => `This is not JSON: ${why}.`,
  },

  quote: {
    title: 'Quote', notGiven: 'not given', download: 'Download the report', thickness: 'Thickness', density: 'Density', none: 'The quote appears here when the plan is done.',
    confidence, parts: 'Parts', different: (n: string, kinds: string) => `${n}, ${kinds} different`, area: 'Part area', weight: 'Weight',
    hole: 'Narrowest hole', web: 'Narrowest web', against: (ratio: string) => ` · ${ratio} × thickness`,
    part: (length: string, holes: number, written: string) => `${length} to cut, ${counted(holes, written, 'hole')}`, and: 'And', others: (n: number, written: string) => counted(n, written, 'other kind of part', 'other kinds of parts'),
  },

  contour: {
    card: 'Selected contour', numbered: (n: number) => `Contour ${n}`, place: (n: string, of: string) => `No. ${n} of ${of}`, part: (n: string) => `part ${n}`,
    mark: 'mark', open: 'open', outer: 'outer', inner: 'inner', begins: (time: string) => `cut begins at ${time}`, rules: { first: 'Cut first', last: 'Cut last', mark: 'Mark', exclude: 'Skip' }, more: 'More choices', actions: 'What to do with it',
    wholePart: (n: string) => `Part ${n}`, selected: (n: number, written: string) => (n === 0 ? 'Nothing selected.' : `${counted(n, written, 'contour')} selected.`),
    whole: 'Whole part', wholeKey: 'Select the whole part (W)', like: (n: string) => `All ${n} like this`, likeKey: 'Select everything like this (L)',
    group: 'Keep together', groupKey: 'Cut these without anything else in between (U)', joints: 'Joints', lead: 'Lead', corners: 'Corners', byRule: 'by rule',
    keepOrder: 'Keep this order', keepOrderHint: 'Cut the selected parts in the order in which they are cut now',
    why: {
      first: 'You cut it first.', last: 'You cut it last.', firstInOrder: 'In the order of your list Cut first.', lastInOrder: 'In the order of your list Cut last.',
      together: 'Together with its group.',
      arranged: (after: string) => `After no. ${after}, as you arranged it.`, mark: 'Marks come before cuts.',
      outer: (n: number, written: string) => `After the ${counted(n, written, 'contour')} inside it.`, inner: 'Before the part around it is cut free.',
      layer: (layer: string) => `Layer ${layer} has its turn.`, byPart: 'Its part has its turn.', skeleton: 'Skeleton cuts come after everything else.', begin: 'The job begins here.',
      way: (from: string, way: string, nearest: boolean) => (nearest ? `Nearest to no. ${from}, ${way} away.` : `${way} from no. ${from}.`),
    }, excluded: 'skipped, not cut',
    before: 'Previous contour (←)', next: 'Next contour (→)', close: 'Close (Esc)',
  },

  table: {
    title: 'Cutting order', rows: 'Rows of the cutting order', close: 'Close the table', columns: ['No.', '', 'Layer', 'Length', 'Begins', 'Entry', 'Direction'],
    show: (n: number) => `No. ${n}, show on the sheet`, move: (n: number) => `Move no. ${n} in the order: drag, or arrow keys`, drag: 'Drag rows to fix their order', inside: 'What lies inside a contour is cut before it.',
    reversed: 'reversed', asDrawn: 'as drawn', open: 'open',
  },

  stage: { bed: (size: string) => `bed ${size}`, first: 'first', last: 'last', common: 'shared by two parts', colours: 'Colour by order (C)', layers: 'Colours of layers as drawn (V)', air: 'Air moves (A)', several: 'Select several: clicks add, dragging draws a box (B)', measure: 'Measure between two points (D)', measuring: 'Click two points: they snap to ends and centres. Esc ends it.', view: 'View', zoomIn: 'Zoom in (+)', zoomOut: 'Zoom out (−)', fit: 'Fit the sheet (F)' },

  playback: {
    none: 'There is no plan to play yet.', play: 'Play', moment: 'Time in the job', speed: 'Speed', whole: 'Whole job in 20 s', pauseKey: 'Pause the cut (Space)', playKey: 'Play the cut (Space)',
    at: (time: string, total: string, contour: number, of: number) => `${time} of ${total}, contour ${contour} of ${of}`,
  },

  help: {
    title: 'Keys', close: 'Close', with: 'with', keys,
    more: 'The wheel or a pinch zooms about the pointer, dragging moves the sheet, a click selects a contour. Shift with dragging selects what is in a box, Ctrl with a click adds to the selection. Shift with a click cuts a contour first, Alt with a click skips it. The drawing never leaves this machine.',
  },

  /** `three` writes a number with three digits. Not every language counts in thousands and millions. */
  numbers: {
    locale: 'en', thousand: (n: number, three: (n: number) => string) => `${three(n)} thousand`, million: (n: number, three: (n: number) => string) => `${three(n)} million`,
  },
};
