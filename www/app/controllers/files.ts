/** Files in and out: opening drawings and samples, several at once, and downloading the outputs of the plan. */

import { type LoadOptions, type OutputKind, tooLarge } from 'kerfway';
import { acceptDrops, choose, save } from '../core/files.js';
import { baseName, messageOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import { Queue } from '../session/queue.js';
import { fetchSample, type Sample } from '../session/samples.js';
import type { Session } from '../session/session.js';
import type { Notices } from './notices.js';

/** Width of a downloaded picture, pixels. */
const PICTURE = 2400;

const DOWNLOADS: Record<OutputKind, { suffix: string; type: string }> = {
  gcode: { suffix: '.nc', type: 'text/plain' },
  dxf: { suffix: '-ordered.dxf', type: 'image/vnd.dxf' },
  svg: { suffix: '.svg', type: 'image/svg+xml' },
  png: { suffix: '.png', type: 'image/png' },
  json: { suffix: '.plan.json', type: 'application/json' },
  lbrn2: { suffix: '.lbrn2', type: 'application/xml' },
  rd: { suffix: '.rd', type: 'application/octet-stream' },
};

export class Files {
  readonly queue: Queue;

  /** `shared`: the options of the address. `hideHint` hides the line that invites to drop a file. */
  constructor(private readonly session: Session, private readonly notices: Notices, private readonly shared: LoadOptions, private readonly hideHint: () => void) {
    this.queue = new Queue(session, (file, load, begun) => this.open(file, load, begun));
    acceptDrops((files) => this.queue.take(files), (over) => document.body.classList.toggle('dropping', over));
  }

  /** Opens the file dialog. */
  choose(): void {
    choose((files) => this.queue.take(files), { multiple: true });
  }

  /** Opens a sample that somebody has chosen. */
  chooseSample(sample: Sample): void {
    this.hideHint();
    void this.openSample(sample, fetchSample(sample));
  }

  /** Opens a sample as soon as its bytes arrive. */
  async openSample(sample: Sample, bytes: Promise<ArrayBuffer>): Promise<void> {
    this.queue.leave();
    try {
      await this.session.open({ bytes: await bytes, name: sample.file }, true, { ...sample.options, ...this.shared });
    } catch (error) {
      this.session.drawing.refuse(sample.file, error);
    }
  }

  /** Downloads one of the outputs of the best plan. */
  async download(kind: OutputKind): Promise<void> {
    try {
      const data = await this.session.output(kind, kind === 'png' ? PICTURE : undefined);
      save(data, baseName(this.session.state.name) + DOWNLOADS[kind].suffix, DOWNLOADS[kind].type);
    } catch (error) {
      this.notices.show(messageOf(error));
    }
  }

  private async open(file: File, load: LoadOptions | null, begun: () => void): Promise<void> {
    this.hideHint();
    const refusal = tooLarge(file.size);
    if (refusal !== null) {
      begun();
      this.session.drawing.refuse(file.name, refusal);
      return;
    }
    try {
      const bytes = await file.arrayBuffer();
      begun();
      await this.session.open({ bytes, name: file.name }, false, load ?? this.shared);
    } catch {
      begun();
      this.session.drawing.refuse(file.name, words.page.unreadable(file.name));
    }
  }
}
