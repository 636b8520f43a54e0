/**
 * The planner's sentences about a drawing, which it writes in English, as patterns for the other languages: `{}` stands for a value, `{unit}` for the
 * name of a unit, `{numbers}` for numbers without one. A value that is such a sentence or phrase itself is translated as well, so an outer sentence comes before those it may hold. A sentence without a
 * pattern is shown as it is, beneath the title of its code.
 *
 * `tests/package/words.test.mjs` compares the patterns with the sources of the planner.
 */

import type { Unit } from 'kerfway';
import type { Words } from './index.js';

export const SENTENCES = {
  checkUnits: '{} Check the units.',
  unitsMayBe: '{} It may also be in {unit} ({}), because {}.',
  unitsWouldBe: '{} In {unit} it would be {}.',
  unitsTaken: '{}: taken as {unit} ({}), because {}.',
  pixelsTaken: '{}: {} to the inch are taken, because {}.',
  unitsUnusual: 'The file says {unit}, but then the drawing is {} large.',
  unitsLikely: 'The file says {unit} ({}), but {unit} ({}) are likely as well, because {}.',
  unitsOfFile: 'The file says {unit}.',
  pixelsChosen: 'Chosen: pixels, {} to the inch.',
  unitsChosen: 'Chosen: {unit}.',
  pageInUnits: 'The page says its size in a unit of length.',
  noUnits: 'The file names no units',
  uselessUnits: 'The file names units that no cutting drawing is in (code {})',
  sizeInPixels: 'The size of the SVG is in pixels',
  noViewBox: 'The page has a size but no viewBox, so what is drawn on it is in pixels',
  oldInkscape: 'Inkscape before 0.92 made them so',
  inkscape: 'Inkscape makes them so',
  illustrator: 'Illustrator makes them so',
  browsers: 'browsers show them so; Illustrator means 72 to the inch, Inkscape before 0.92 meant 90',
  mostlyMm: 'most cutting drawings are in millimetres',
  usualInMm: 'only in millimetres the size is usual',
  usualInInches: 'only in inches the size is usual',
  drills: 'holes of {numbers} are drill sizes in inches',
  holesTooSmall: 'its holes would be too small in millimetres',
  holesRoundIfInches: 'its holes are usual in millimetres when it is read in inches',
  holesInMm: 'holes of {numbers} are usual in millimetres',
  drillsIfMm: 'its holes are inch drill sizes when it is read in millimetres',
  layerCalled: 'a layer is called {}',
  fitsSheet: 'it fits the sheet of layer {}',
  textsTooSmall: 'its texts would be too small in millimetres',
  textsInMm: 'its texts have heights that are usual in millimetres',
  settingsInches: 'its settings are for inches',
  settingsMetric: 'its settings are metric',
  feetAndInches: 'it shows lengths in feet and inches',
  inFractions: 'it shows lengths as fractions',
  dimensionsInches: 'its dimension style is that of a drawing in inches',
  dimensionsMetric: 'its dimension style is metric',
  roundInMm: 'its lengths are round in millimetres',
  fractionsOfInch: 'its lengths are fractions of an inch',
  roundMmIfInches: 'its lengths are round in millimetres if it is in inches',
  roundInchesIfMm: 'its lengths are round in inches if it is in millimetres',
  overKilometre: 'over 1 km',
  gapClosed: 'A gap of {} mm in this contour was closed.',
  gapsClosed: '{} gaps in this contour were closed, the widest {} mm.',
  gapLeft: 'A gap of {} mm is left open: it is wider than the joining tolerance of {} mm. Raise the tolerance to close it.',
  endOpen: 'An end meets two others that fit each other better: it stays open.',
  onTop: 'This {} lies on top of another one: it is cut once.',
  along: 'This {} lies wholly along other lines: it is cut once.',
  partlyAlong: '{} mm of this {} lie along other lines: they are cut once.',
  noLength: 'This {} has no length: there is nothing to cut, it is left out.',
  sliver: 'This closed {} is narrower than the tolerance of {} mm: it is cut once, as a line, and is no part.',
  nearCopy: '1 contour lies within {} mm of another one and would be cut twice. If it is a copy, raise the {} to {} mm.',
  nearCopies: '{} contours lie within {} mm of another one and would be cut twice. If they are copies, raise the {} to {} mm.',
  copyTolerance: 'copy tolerance',
  bothTolerances: 'copy tolerance and the joining tolerance',
  open: 'This contour of {} mm does not close: it is cut as an open line and frees no part. Close it in the drawing, or raise the joining tolerance.',
  crossesItselfOnce: 'This contour crosses itself in 1 place: what lies inside it is in doubt.',
  crossesItself: 'This contour crosses itself in {} places: what lies inside it is in doubt.',
  crossOnce: 'Two contours cross in 1 place: both are cut as drawn.',
  cross: 'Two contours cross in {} places: both are cut as drawn.',
  tooDense: 'More than {} pairs of lines lie over each other, around here and elsewhere: the areas they enclose together were not searched for, and what is open is cut open, as drawn. Draw the parts as closed outlines, or divide the drawing.',
  severalLayers: 'This contour lies on {} layers: {}. It is taken to be on {}, where most of it lies.',
  mayMarkOne: '1 shape is on layer {}, whose name suggests marking: currently cut. Choose mark or ignore.',
  mayMark: '{} shapes are on layer {}, whose name suggests marking: currently cut. Choose mark or ignore.',
  mayIgnoreOne: '1 shape is on layer {}, whose name suggests that it is not cut: currently cut. Choose ignore to skip it.',
  mayIgnore: '{} shapes are on layer {}, whose name suggests that it is not cut: currently cut. Choose ignore to skip it.',
  ignoredOne: '1 shape on layer {} left out.',
  ignored: '{} shapes on layer {} left out.',
  skippedOne: '1 contour left out by choice.',
  skipped: '{} contours left out by choice.',
  borderIgnored: 'The border around everything is taken for the sheet and ignored: {}. Keep it if it is a cut.',
  borderCut: 'The border around everything is cut, as you chose, although {}.',
  borderDoubt: 'The rectangle around everything may be the sheet and not a cut: {}. It is currently cut: keep it, or ignore it.',
  aloneOnLayer: 'it is alone on layer {}',
  partInside: '1 part lies inside it',
  partsInside: '{} parts lie inside it',
  sold: 'sheets of {} x {} mm are sold',
  nothingElse: 'nothing else is on layer {}',
  leftOut: '{} {} left out: {}.',
  adviceText: 'text has no outline to cut; turn it into curves in the drawing program if it is to be cut or marked',
  adviceNotes: 'dimensions and notes are not cut',
  advicePoint: 'a point has no length to cut',
  adviceExplode: 'explode it into lines in the drawing program if it is to be cut',
  nothingWritten: '{} Nothing was written: a program that leaves the bed has to be allowed.',
  offBed: 'The job reaches from x {} to {} and y {} to {} mm, beyond the bed (x {} to {}, y {} to {} mm). Place it on the bed, for example with its middle at that of the bed.',
  layerTooFast: 'Layer {} is worked at {} mm/s, but the machine moves with at most {} mm/s: it takes longer than planned, and is not written as G-code. Lower the speed of the layer, or raise the rapids of the machine.',
  endsBefore: 'The file ends before anything to cut: it was probably not copied whole. Save or download it again.',
  emptyFile: 'The file is empty. Save the drawing again as DXF or SVG.',
  emptyDrawing: 'The drawing holds nothing to cut. Check that the outlines were exported.',
  emptySvg: 'The SVG holds nothing to cut. Check that the outlines were exported.',
  endsEarly: 'The file ends without its end mark: it may not have been copied whole. Check that nothing is missing.',
  endsInside: 'The file ends in the middle: it was probably not copied whole. What comes after is missing.',
  tooLargeForInsertion: 'The insertion heuristic takes at most {} cuts between the corners of contours that share cuts, and these have {}: their path is the best that the search finds.',
  asOne: '{} contours share cuts and are cut as one, with 1 piercing instead of {}: {} m are cut once instead of twice.',
  oneKerf: 'Parts one kerf apart: {} mm between them are cut once instead of twice.',
  narrowerThanKerf: 'This contour is narrower here than the kerf of {} mm: it keeps its drawn line, which is off by half a kerf. Widen it, or cut it with a finer beam.',
  noLeadIn: 'Contour {} has no lead-in: there is no room for one, so it is pierced on its outline. Move the parts apart, or allow shorter leads or less clearance.',
  leadTurned: 'Contour {} has its lead-in turned, because the wanted one does not fit.',
  leadMoved: 'Contour {} has its lead-in at another position, because the wanted one has no room for it.',
  leadShorter: 'Contour {} has a lead-in of {} mm instead of {} mm, because that does not fit.',
  leadLine: 'Contour {} has a line of {} mm as its lead-in, because the wanted arc does not fit.',
  jointsFewer: 'Contour {} has {} of {} micro-joints: there is no room for more. Allow narrower joints or less distance from corners.',
  jointMoved: 'A micro-joint of contour {} was moved by {} mm, because it was in a corner or too near to another cut.',
  noSetting: 'The machine has no setting for {}: its times are those of "{}".',
  unitInDoubt: 'The unit is in doubt. {}',
  unitNotSaid: 'The file does not say its units; they were guessed from what it shows.',
  openCut: '1 contour that is cut is open: it encloses no part.',
  openCuts: '{} contours that are cut are open: they enclose no part.',
  jointLeftOut: 'A micro-joint of contour {} was left out: it is in a corner, at another micro-joint or at another cut. Place it elsewhere.',
  damaged: '{} was read where the file is broken and may be wrong. {}.',
  damagedKept: 'It is cut nevertheless, as requested',
  damagedLeftOut: 'It is left out; compare it with the original',
  crossOnceOther: 'Two contours cross in 1 place, the other one (handle {}): both are cut as drawn.',
  crossOther: 'Two contours cross in {} places, the other one (handle {}): both are cut as drawn.',
  pieceOnTop: '1 piece of this {} lies on top of other lines: cut once.',
  piecesOnTop: '{} pieces of this {} lie on top of other lines: cut once.',
  tooSmall: 'This contour is {} mm wide at its widest place, {}. Widen it, or remove it from the cut.',
  underBeam: 'less than {} mm: it is too small for any common laser beam',
  underKerf: 'less than the kerf of {} mm: it is too small for this beam',
  crossesNoKerf: 'This contour crosses itself, so it is unclear which side is the part: it keeps its drawn line.',
  leadsWhole: 'With leads, contours are not left unfinished for others: each is cut in one go.',
  passesNoLeads: 'Contours that are cut in several passes have no leads: they are pierced on their outline.',
  crossesNoLead: 'A contour that crosses itself has no lead, because its scrap side is in doubt.',
  passesNoJoints: 'Contours that are cut in several passes have no micro-joints.',
  openNoJoints: 'Contours that are open, or share sides with others, have no micro-joints.',
  crossesNoJoints: 'A contour that crosses itself has no micro-joints.',
  longStretch: 'Contour {} has a stretch of {} mm without a micro-joint instead of at most {} mm, because there is no room for one.',
  leastPower: 'Layer {} has a least power, for which G-code has no word: only LightBurn projects and Ruida files carry it.',
  riskyMove: '1 move crosses a piece that may have tipped up, with the head down. Let the machine avoid them, or hold the pieces with micro-joints.',
  riskyMoves: '{} moves cross a piece that may have tipped up, with the head down. Let the machine avoid them, or hold the pieces with micro-joints.',
  hotPair: '1 pair of cuts nearer to each other than {} mm follow each other within {} s. Raise the charge, or let the machine wait.',
  hotPairs: '{} pairs of cuts nearer to each other than {} mm follow each other within {} s. Raise the charge, or let the machine wait.',
  missingBlock: 'The block "{}" is inserted ({}) but not in the file: its content is missing.',
  externalBlock: 'The block "{}" ({}) refers to another drawing file and is missing here. Bind it in the drawing program and save again.',
  clippedBlock: 'The block "{}" is clipped where it is inserted ({}; XCLIP), but cut whole. Explode it there and trim it in the drawing program.',
  cyclicBlock: 'The block "{}" contains itself; the inner insert ({}) is left out.',
  hiddenOne: '1 entity is {} and not cut.',
  hiddenMany: '{} entities are {} and not cut.',
  onPaper: 'on a paper layout',
  onFrozen: 'on a frozen layer',
  onOff: 'on a layer that is switched off',
  invisible: 'switched invisible',
  outline: 'The outline of {} {} is taken as lines to cut; the filling is not. Where it lies on other lines it is cut once.',
  drawnWide: '{} {} drawn with a width: cut along the middle line, once.',
  tilted: '{} {} tilted against the sheet or at changing height: cut as seen from above, which may be shorter than it is.',
  objectIs: '1 object is',
  objectsAre: '{} objects are',
  objectHas: '1 object has',
  objectsHave: '{} objects have',
  shapeIs: '1 shape is',
  shapesAre: '{} shapes are',
  shapeHas: '1 shape has',
  shapesHave: '{} shapes have',
  notShown: '{} not displayed (display: none, opacity 0, or a hidden layer) and not cut.',
  shapeInvisible: '{} switched invisible and not cut.',
  unpainted: '{} without stroke and fill, so not visible, and not cut.',
  filled: 'The outline of {} filled {} without a stroke is taken as lines to cut; the filling is not. Choose mark or ignore for its layer if it is an engraving.',
  wideStroke: '{} a stroke wider than 1 mm: cut along its middle line, once.',
  dashed: '{} a dashed stroke: cut as a whole line, without gaps.',
  clipped: '{} clipped in the drawing, but cut whole. Apply the clip (intersection) in the drawing program.',
  masked: '{} a mask, which is not applied: cut whole. Apply the mask in the drawing program.',
  markers: '{} arrowheads or other markers, which are not cut. Convert them to paths in the drawing program.',
  patterned: '{} filled with a pattern, whose lines are not cut. Convert the pattern to objects in the drawing program.',
  missingCopy: '1 copy of "{}", which is not in the file: the content is missing.',
  missingCopies: '{} copies of "{}", which is not in the file: the content is missing.',
  sharesSides: 'This contour has sides in common with another one as drawn: both keep their drawn lines, and parts come out smaller by half a kerf there. Lay them out {} mm apart for one cut between them.',
  touches: 'This contour touches another one, with no room for the kerf between them: both keep their drawn lines, and parts come out smaller by half a kerf. Lay them out {} mm apart or more.',
  nearerThanKerf: 'Only {} mm lie between this contour and another one, less than the kerf: both keep their drawn lines, and parts come out smaller by half a kerf. Lay them out {} mm apart or more.',
  openNoKerf: '1 open contour keeps its drawn line: it is unclear on which side the part lies, so the kerf is not compensated.',
  opensNoKerf: '{} open contours keep their drawn line: it is unclear on which side the part lies, so the kerf is not compensated.',
  borderKerf: 'The border around everything looks like the sheet, but is cut as a part: what lies in it counts as its holes, and comes out smaller by a kerf. Choose to leave it out.',
  noLeadOut: 'Contour {} has no lead-out, because there is no room for one.',
  leadOutShorter: 'Contour {} has a shorter lead-out, because the wanted one does not fit.',
  leadOutLine: 'Contour {} has a line as its lead-out, because the wanted arc does not fit.',
  leadOutTurned: 'Contour {} has its lead-out turned, because the wanted one does not fit.',
  commonNoJoints: 'Contours that share cuts are planned together and have no micro-joints. Set common cuts to off to have some.',
  lettering: '{} small strokes of up to {} mm lie close together, like lettering: {}',
  leader: '1 open line leads to lettering: {}',
  leaders: '{} open lines lead to lettering: {}',
  letteringDoubt: 'currently cut. Mark or ignore them.',
  letteringCut: 'cut, as you chose.',
  letteringMarked: 'marked, as you chose.',
  letteringIgnored: 'ignored, as you chose.',
  bridged: '{} parts are connected by 1 bridge to 1 piece, {}.',
  bridgedToOne: '{} parts are connected by {} bridges to 1 piece, {}.',
  bridgedToMany: '{} parts are connected by {} bridges to {} pieces, {}.',
  separatedLater: 'which the machine separates later',
  separatedByHand: 'which a person separates',
  noBridge: 'No bridge saves time: no two parts face each other within reach with room for one, or piercing takes less than its sides.',
  neither: 'This is neither a DXF nor an SVG file, or one damaged beyond reading. Save the drawing as DXF or SVG.',
  isDwg: 'This is a DWG file. In AutoCAD, use Save As and choose DXF (R2000 or later, ASCII); without it, the free ODA File Converter makes a DXF.',
  isPdf: 'This is a PDF file. Open it in Inkscape or Illustrator and save it as SVG or DXF; a CAD program exports DXF directly.',
  isPicture: 'This is a {} picture. A laser needs lines: trace it in a drawing program (Inkscape: Path, Trace Bitmap) and save it as SVG or DXF.',
  isStep: 'This is a STEP file, a solid. In the CAD program (Fusion, SolidWorks, FreeCAD), export its flat pattern or one of its faces as DXF.',
  isZip: 'This is a ZIP archive (or a document made of one). Unpack it and use the DXF or SVG file in it.',
  isGcode: 'This is G-code, a program for a machine. Use the drawing it was made from, as DXF or SVG.',
  searchesAll: 'Order, entry and direction searched together; the path improves at every moment.',
  goesToNearest: 'Goes always to the nearest place where a cut may start next.',
} as const;

/** The same in another language, with `{0}`, `{1}`, ... for the values, and what stands between two reasons. */
export type Sentences = Record<keyof typeof SENTENCES | 'and', string>;

/** Units as the planner's sentences name them. */
const UNITS: Record<string, Unit> = {
  millimetres: 'mm', centimetres: 'cm', metres: 'm', decimetres: 'dm', micrometres: 'um',
  inches: 'in', feet: 'ft', yards: 'yd', mils: 'mil', microinches: 'microinch', pixels: 'px',
};

/** Characters that mean something in a regular expression. */
const SPECIAL = /[.*+?^$()|[\]\\]/g;
const VALUE = /\{(?:unit|numbers)?\}/g;

const PATTERNS = Object.entries(SENTENCES).map(([key, pattern]) => ({
  key: key as keyof typeof SENTENCES,
  matches: new RegExp(`^${pattern.replace(SPECIAL, '\\$&').replace(VALUE, '(.+?)')}$`),
  values: pattern.match(VALUE) ?? [],
}));

/** What a language has for the planner's sentences. */
type Own = Pick<Words, 'sentences' | 'unitNames' | 'numbers'>;

/** A sentence of the planner in a language; null where there is none. */
export function translated(own: Own, sentence: string): string | null {
  for (const { key, matches, values } of PATTERNS) {
    const found = matches.exec(sentence);
    if (found === null) continue;
    const inOwn = values.map((kind, k) => (KINDS[kind] ?? phrases)(own, found[k + 1] ?? ''));
    return own.sentences[key].replace(/\{(\d)\}/g, (_all, k: string) => inOwn[Number(k)] ?? '');
  }
  return null;
}

/** How values that are no sentences are said. */
const KINDS: Record<string, (own: Own, value: string) => string> = {
  '{unit}': ({ unitNames }, name) => unitNames[UNITS[name]!] ?? name,
  '{numbers}': ({ numbers: { locale } }, list) => list.split(', ').map((n) => (Number.isFinite(Number(n)) ? Number(n).toLocaleString(locale, { maximumFractionDigits: 3 }) : n)).join('; '),
};

/** A value of a sentence: phrases of the planner, which it joins by "and", or a sentence, in the language; anything else as it is. */
function phrases(own: Own, value: string): string {
  const all = value.split(', and ').map((phrase) => translated(own, phrase));
  if (all.every((phrase) => phrase !== null)) return all.join(own.sentences.and);
  return translated(own, value) ?? value;
}
