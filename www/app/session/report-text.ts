/** The report of a job, and how it is written: in the language and the unit of lengths of the page. Loaded when somebody asks for a report. */

import { ENGLISH_REPORT, type ReportText } from 'kerfway';
import { area, extent, metres, millimetres, seconds, upTo } from '../core/format.js';
import { lengthUnit, shownIn } from '../core/lengths.js';
import { sentenceOf } from '../core/strings.js';
import { language, words } from '../core/words/index.js';

export { jobReport } from 'kerfway';

export function reportText(): ReportText {
  const { unit, factor } = shownIn('mm');
  const own = words.report ?? ENGLISH_REPORT.words;
  if (language === 'en' && lengthUnit === 'mm') return ENGLISH_REPORT;
  return {
    lang: words.numbers.locale, words: { ...own, entry: own.entry.replace('mm', unit) },
    number: (value) => upTo(value / factor, unit === 'mm' ? 2 : 3), length: millimetres, size: extent, far: metres, area, duration: (s) => seconds(s),
    finding: (finding) => sentenceOf(finding).text,
  };
}
