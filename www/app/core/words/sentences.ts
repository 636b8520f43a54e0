/**
 * The planner's sentences about a drawing, which it writes in English, as patterns for the other languages: `{}` stands for a value. A value that is
 * such a sentence or phrase itself is translated as well. A sentence without a pattern is shown as it is, beneath the title of its code.
 *
 * `tests/package/words.test.mjs` compares the patterns with the sources of the planner.
 */

export const SENTENCES = {
  gapClosed: 'A gap of {} mm in this contour was closed.',
  gapsClosed: '{} gaps in this contour were closed, the widest {} mm.',
  gapLeft: 'A gap of {} mm is left open: it is wider than the joining tolerance of {} mm. Raise the tolerance to close it.',
  endOpen: 'An end meets two others that fit each other better: it stays open.',
  onTop: 'This {} lies on top of another one: it is cut once.',
  along: 'This {} lies wholly along other lines: it is cut once.',
  partlyAlong: '{} mm of this {} lie along other lines: they are cut once.',
  noLength: 'This {} has no length: there is nothing to cut, it is left out.',
  sliver: 'This closed {} is narrower than the tolerance of {} mm: it is cut once, as a line, and is no part.',
  open: 'This contour of {} mm does not close: it is cut as an open line and frees no part. Close it in the drawing, or raise the joining tolerance.',
  crossesItselfOnce: 'This contour crosses itself in 1 place: what lies inside it is in doubt.',
  crossesItself: 'This contour crosses itself in {} places: what lies inside it is in doubt.',
  crossOnce: 'Two contours cross in 1 place: both are cut as drawn.',
  cross: 'Two contours cross in {} places: both are cut as drawn.',
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
  offBed: 'The job reaches from x {} to {} and y {} to {} mm, beyond the bed (x {} to {}, y {} to {} mm). Place it on the bed, for example with its lower left corner at that of the bed.',
  endsEarly: 'The file ends without its end mark: it may not have been copied whole. Check that nothing is missing.',
  endsInside: 'The file ends in the middle: it was probably not copied whole. What comes after is missing.',
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
  jointLeftOut: 'A micro-joint of contour {} was left out: it is in a corner, at another micro-joint or at another cut. Place it elsewhere.',
} as const;

/** The same in another language, with `{0}`, `{1}`, ... for the values. */
export type Sentences = Record<keyof typeof SENTENCES, string>;

/** Characters that mean something in a regular expression. */
const SPECIAL = /[.*+?^$()|[\]\\]/g;

const PATTERNS = Object.entries(SENTENCES).map(([key, pattern]) => [key as keyof Sentences, new RegExp(`^${pattern.replace(SPECIAL, '\\$&').replaceAll('{}', '(.+?)')}$`)] as const);

/** A sentence of the planner in a language; null where there is none. `locale`: the language's code. */
export function translated(own: Sentences, sentence: string, locale: string): string | null {
  for (const [key, pattern] of PATTERNS) {
    const [, ...values] = pattern.exec(sentence) ?? [];
    if (values.length > 0 || sentence === SENTENCES[key]) return own[key].replace(/\{(\d)\}/g, (_all, k: string) => phrases(own, values[Number(k)] ?? '', locale));
  }
  return null;
}

/** A value of a sentence: phrases of the planner, which it joins by "and", in the language; anything else as it is. */
function phrases(own: Sentences, value: string, locale: string): string {
  const all = value.split(', and ').map((phrase) => translated(own, phrase, locale));
  return all.every((phrase) => phrase !== null) ? new Intl.ListFormat(locale).format(all) : value;
}
