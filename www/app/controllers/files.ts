/** Files in and out: opening drawings and samples, several at once, and downloading the outputs of the plan. */

import { isProject, KerfwayError, type LoadOptions, type OutputKind, type Project, tooLarge } from 'kerfway';
import { acceptDrops, choose, save } from '../core/files.js';
import { Latest } from '../core/latest.js';
import { baseName, downloadName, messageOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import type { Decided } from '../session/kept-sample.js';
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

  /** Begins with the job that this browser has kept, or with a sample; with nothing where somebody has chosen a file by then. `decided`: what was decided about the sample before. */
  async begin(kept: Promise<Project | null>, forget: () => void, sample: Sample, bytes: Promise<ArrayBuffer>, decided?: Decided): Promise<void> {
    const isLatest = this.latest.watch();
    const project = await kept;
    // Without a planner nothing can be opened.
    if (!isLatest() || this.session.state.phase === 'failed') return;
    const isBack = project !== null && (await this.bringBack(project, forget, isLatest));
    if (isLatest() && !isBack) await this.openSample(sample, bytes, decided);
  }

  private async openSample(sample: Sample, bytes: Promise<ArrayBuffer>, decided: Decided = { load: { ...sample.options, ...this.shared }, own: null }): Promise<void> {
    this.queue.leave();
    const isLatest = this.latest.begin();
    try {
      const content = await bytes;
      // A file that was dropped meanwhile is what the person wants.
      if (isLatest()) await this.session.openSample(sample, content, decided, isLatest);
    } catch (error) {
      if (isLatest()) this.session.drawing.refuse(sample.file, error);
    }
  }

  /** Resolves to whether the job can be used. */
  private async bringBack(project: Project, forget: () => void, isLatest: () => boolean): Promise<boolean> {
    this.hideHint();
    if ((await this.session.openProject(project, isLatest)) !== null) return false;
    if (isLatest()) this.notices.show(words.page.back(project.name), { label: words.page.forget, act: forget });
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
    // Without a secure connection, the page has no clipboard.
    const { clipboard } = navigator as { clipboard?: Clipboard };
    if (clipboard === undefined) return this.notices.show(words.page.notCopied);
    try {
      await clipboard.writeText((await this.session.output('gcode')) as string);
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
    try {
      const { writeProject } = await import('../session/project-files.js');
      save(await writeProject(project), `${baseName(project.name)}.kerfway`, 'application/json');
    } catch (error) {
      this.notices.show(messageOf(error));
    }
  }

  /** Resolves to why the file cannot be used, or to null, also where something else was chosen while it was being read. */
  private async open(file: File, load: LoadOptions | null): Promise<string | null> {
    this.hideHint();
    const isLatest = this.latest.begin();
    const { session } = this;
    const refuse = (error: unknown) => (isLatest() ? session.drawing.refuse(file.name, error) : null);
    const refusal = tooLarge(file.size);
    if (refusal !== null) return refuse(new KerfwayError('too-large', refusal));
    let bytes: ArrayBuffer;
    try {
      bytes = await file.arrayBuffer();
    } catch {
      return refuse(words.page.unreadable(file.name));
    }
    // A slow disk or network drive must not replace what was chosen meanwhile.
    if (!isLatest()) return null;
    if (!isProject(bytes)) return session.open({ bytes, name: file.name }, load ?? this.shared);
    try {
      const { readProject } = await import('../session/project-files.js');
      return await session.openProject(await readProject(bytes), isLatest);
    } catch (error) {
      return refuse(error);
    }
  }
}
