/** Files in and out: opening drawings and samples, several at once, and downloading the outputs of the plan. */

import { isProject, KerfwayError, type LoadOptions, type OutputKind, type Project, readProject, tooLarge, writeProject } from 'kerfway';
import { acceptDrops, choose, save } from '../core/files.js';
import { Latest } from '../core/latest.js';
import { baseName, downloadName, messageOf } from '../core/strings.js';
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
  remainder: { suffix: '-remainder.dxf', type: 'image/vnd.dxf' },
};

export class Files {
  readonly queue: Queue;
  /** What is being fetched or opened. */
  private readonly latest = new Latest();

  /** `shared`: the options of the address. `hideHint` hides the line that invites to drop a file. */
  constructor(private readonly session: Session, private readonly notices: Notices, private readonly shared: LoadOptions, private readonly hideHint: () => void) {
    this.queue = new Queue(session, (file, load) => this.open(file, load));
    acceptDrops((files) => this.queue.take(files), (over) => document.body.classList.toggle('dropping', over));
  }

  /** Opens the file dialog. */
  choose(): void {
    choose((files) => this.queue.take(files), { multiple: true });
  }

  /** Opens a sample that somebody has chosen. */
  chooseSample(sample: Sample): void {
    void this.openSample(sample, fetchSample(sample));
  }

  /** Opens a sample as soon as its bytes arrive. */
  async openSample(sample: Sample, bytes: Promise<ArrayBuffer>): Promise<void> {
    this.queue.leave();
    const isLatest = this.latest.begin();
    try {
      const content = await bytes;
      // A file that was dropped meanwhile is what the person wants.
      if (isLatest()) await this.session.openSample(sample, content, { ...sample.options, ...this.shared });
    } catch (error) {
      if (isLatest()) this.session.drawing.refuse(sample.file, error);
    }
  }

  /** Brings back the job that this browser has kept. Resolves to whether that was possible. */
  async bringBack(project: Project, forget: () => void): Promise<boolean> {
    this.hideHint();
    if ((await this.session.openProject(project)) !== null) return false;
    this.notices.show(words.page.back(project.name), { label: words.page.forget, act: forget });
    return true;
  }

  /** Downloads one of the outputs of the best plan. */
  async download(kind: OutputKind): Promise<void> {
    try {
      const data = await this.session.output(kind, kind === 'png' ? PICTURE : undefined);
      save(data, downloadName(this.session.state, DOWNLOADS[kind].suffix), DOWNLOADS[kind].type);
    } catch (error) {
      this.notices.show(messageOf(error));
    }
  }

  /** Copies the G-code to the clipboard. */
  async copyProgram(): Promise<void> {
    try {
      await navigator.clipboard.writeText((await this.session.output('gcode')) as string);
      this.notices.show(words.page.copied);
    } catch (error) {
      this.notices.show(error instanceof DOMException ? words.page.notCopied : messageOf(error));
    }
  }

  /** Downloads the report of the job, for the operator. */
  async saveReport(): Promise<void> {
    try {
      const report = await this.session.report();
      if (report !== null) save(report, downloadName(this.session.state, '-report.html'), 'text/html');
    } catch (error) {
      this.notices.show(messageOf(error));
    }
  }

  /** Downloads the job as a project file. */
  async saveProject(): Promise<void> {
    const { project } = this.session;
    if (project === null) return;
    save(await writeProject(project), `${baseName(project.name)}.kerfway`, 'application/json');
  }

  private async open(file: File, load: LoadOptions | null): Promise<string | null> {
    this.hideHint();
    this.latest.begin();
    const { session } = this;
    const refusal = tooLarge(file.size);
    if (refusal !== null) return session.drawing.refuse(file.name, new KerfwayError('too-large', refusal));
    let bytes: ArrayBuffer;
    try {
      bytes = await file.arrayBuffer();
    } catch {
      return session.drawing.refuse(file.name, words.page.unreadable(file.name));
    }
    if (!isProject(bytes)) return session.open({ bytes, name: file.name }, load ?? this.shared);
    try {
      return await session.openProject(await readProject(bytes));
    } catch (error) {
      return session.drawing.refuse(file.name, error);
    }
  }
}
