// The drawings that this project writes (samples of the page, outputs of plans) are valid DXF of version R2000 or later.
// tests/oracle/audit.py has recorded what ezdxf reports about them.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { plan } from 'kerfway';
import { SAMPLES } from '../../scripts/samples.mjs';
import { faults } from './dxf-structure.mjs';
import { circle, dxf, fixture, ROOT } from './support.mjs';

const FOLDER = join(ROOT, 'www', 'app', 'public', 'samples');
const files = readdirSync(FOLDER).filter((file) => file.endsWith('.dxf'));
/** Drawings of other people, served unchanged. This one is in R12, which has no markers. */
const NOT_OURS = ['lumberjack-polaris.dxf'];
/** The sample of a first visit, where every byte counts, has neither handles nor the tables that nothing in it uses: programs give them anew. */
const LEFT_OUT = { 'sheet_500.dxf': / has no handle$|^(there is no table|table) (VPORT|STYLE|VIEW|UCS|APPID|DIMSTYLE)\b/ };
const audit = JSON.parse(readFileSync(fixture('dxf-audit.json'), 'utf8'));

describe('the structure of a DXF', () => {
  it('is refused without sections or markers, with a duplicate handle, or with a missing owner or layer', () => {
    assert.match(faults(new TextDecoder().decode(dxf(circle(0, 0, 1)))).join(), /no section/);
    const good = SAMPLES['layers.dxf'];
    assert.deepEqual(faults(good), []);
    const broken = (from, to) => faults(good.replace(from, to)).join('; ');
    assert.match(broken('100\nAcDbPolyline\n', ''), /LWPOLYLINE 105 has the markers \[AcDbEntity\]/);
    assert.match(broken('\n5\n106\n', '\n5\n105\n'), /handle 105 is there twice/);
    assert.match(broken('\n5\n105\n330\n17\n', '\n5\n105\n330\nFFF\n'), /owner FFF/);
    assert.match(broken('\n8\nSHEET\n', '\n8\nELSEWHERE\n'), /layer that is not in the table/);
    assert.match(broken('\n2\nByBlock\n', '\n2\nOther\n'), /table LTYPE has no ByBlock/);
  });

  it('is valid in every sample of our own', () => {
    const ours = files.filter((file) => !NOT_OURS.includes(file));
    assert.ok(ours.length >= 7);
    for (const file of ours) {
      const found = faults(readFileSync(join(FOLDER, file), 'utf8'));
      assert.deepEqual(found.filter((fault) => !LEFT_OUT[file]?.test(fault)), [], file);
    }
  });

  it('is valid in the DXF output of a plan', async () => {
    for (const file of ['gaps-and-copies.dxf', 'layers.dxf', 'parts-in-parts.dxf']) {
      const { outputs } = await plan(readFileSync(join(FOLDER, file)), { moves: 1000, seed: 1, outputs: ['dxf'] });
      assert.deepEqual(faults(outputs.dxf), [], file);
    }
  });
});

describe('the audit by ezdxf', () => {
  it('was made with these samples, and found no error in them or in outputs', () => {
    const sha256 = (file) => createHash('sha256').update(readFileSync(join(FOLDER, file))).digest('hex');
    assert.deepEqual(audit.samples, Object.fromEntries(files.sort().map((file) => [file, { sha256: sha256(file), findings: [] }])), 'python tests/oracle/audit.py');
    assert.deepEqual(Object.values(audit.plans).flat(), []);
  });

  it('was made with the samples that scripts/samples.mjs writes', () => {
    for (const [file, content] of Object.entries(SAMPLES)) assert.equal(readFileSync(join(FOLDER, file), 'utf8'), content, `${file}: node scripts/samples.mjs`);
  });
});
