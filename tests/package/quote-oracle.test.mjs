// The figures of quotes against those computed by ezdxf and Shapely (tests/oracle/quotes.py), which share no code with this project.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, describe, it } from 'node:test';
import { createPlanner } from 'kerfway';
import { bytes, fixture } from './support.mjs';

const EXPECTED = JSON.parse(readFileSync(fixture('quotes.json'), 'utf8'));
/** Allowed differences: relative for lengths and areas, relative to the size of the drawing for positions. */
const SHARE = 1e-3;

/** Where the two may differ, and why. */
const EXCEPTIONS = {
  'gdsestimating_dxf-parser__arcs-as-splines.dxf': {
    reason: 'ezdxf refuses or misreads these SPLINE for a subclass marker. They are two circles, one beside the other, and an arc of 52.40 mm',
    cut_length: 2 * Math.PI * (32.3202 + 7.3455) + 52.4,
    net_area: Math.PI * (32.3202 ** 2 + 7.3455 ** 2),
    closed: 2,
    bounds: null,
  },
  'Opentrons_otone_hardware__1011_Baseplate_Rails.dxf': {
    reason: 'three groups of parts share edges, which are cut once: each part has its outline here, there they are no rings',
    net_area: null,
    closed: null,
  },
  'mozman_ezdxf__recover01.dxf': {
    reason: 'seventeen groups of lines branch: here each area that they enclose is a contour, there they are no rings',
    net_area: null,
    closed: null,
  },
  'mozman_ezdxf__POLI-ALL210_12.DXF': {
    reason: 'two open POLYLINE cross twice inside a closed one: the area between the crossings falls out, so it is a hole here, and no ring there',
    net_area: null,
    closed: 14,
  },
};

describe('quotes against ezdxf', () => {
  let planner;
  before(async () => (planner = await createPlanner()));
  after(() => planner.close());

  for (const [file, reckoned] of Object.entries(EXPECTED)) {
    const exception = EXCEPTIONS[file];
    it(`${file}${exception === undefined ? '' : `, but: ${exception.reason}`}`, async () => {
      const expected = { ...reckoned, ...exception };
      const loaded = await planner.load(bytes(`dxf-dev/${file}`), file, { units: reckoned.units });
      const { progress } = await planner.plan({ moves: 100, seed: 1 }).done;
      const quote = await planner.quote({ material: { thickness: 2, density: 7.85 } });

      const near = (what, found, wanted, size = wanted) =>
        assert.ok(Math.abs(found - wanted) <= SHARE * Math.abs(size), `${what}: ${found} here, ${wanted} there`);
      near('cut length', quote.cut_length, expected.cut_length);
      if (expected.closed !== null) assert.equal(loaded.contours.filter((c) => c.closed).length, expected.closed);
      if (expected.net_area !== null) {
        near('net area', quote.net_area, expected.net_area);
        near('weight', quote.weight, expected.net_area * 0.2 * 0.0785);
      }
      if (expected.bounds !== null) {
        const [x0, y0, x1, y1] = expected.bounds;
        expected.bounds.forEach((place, k) => near('box', quote.bounds[k], place, Math.max(x1 - x0, y1 - y0)));
        near('area of the box', quote.box_area, (x1 - x0) * (y1 - y0));
      }

      // And with the plan it is made of.
      assert.equal(quote.cut_length, progress.summary.cut_length);
      assert.equal(quote.times.total, progress.summary.total_time);
      near('layers', quote.layers.reduce((sum, l) => sum + l.length, 0), quote.cut_length);
      near('parts', quote.parts.reduce((sum, p) => sum + p.count * p.net_area, 0), quote.net_area, Math.max(quote.net_area, 1));
      assert.equal(quote.parts.reduce((sum, p) => sum + p.count, 0), quote.part_count);
    });
  }

  it('has no exception for a drawing that is not there', () => {
    assert.deepEqual(Object.keys(EXCEPTIONS).filter((file) => EXPECTED[file] === undefined), []);
  });
});
