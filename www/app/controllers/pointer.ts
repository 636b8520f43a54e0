/** The pointer on the stage: the tooltip, picking contours and findings, and choosing where the head starts. */

import type { Finding } from 'kerfway';
import { words } from '../core/words/index.js';
import { describe, Tooltip } from '../panels/contour.js';
import type { Playback } from '../playback/playback.js';
import type { Session } from '../session/session.js';
import { attachGestures } from '../stage/gestures.js';
import type { Scene } from '../stage/scene.js';
import type { Notices } from './notices.js';
import type { Selection } from './selection.js';

/** CSS pixels around the pointer within which a contour is picked; a finger needs more. */
const REACH = { pointer: 8, touch: 20 };
/** How much farther a finding is picked, as its marker is larger than a line. */
const MARKER = 4;

export class Pointer {
  readonly tooltip = new Tooltip();
  /** The next click on the sheet chooses the start of the job. */
  private choosingHome = false;

  constructor(
    private readonly canvas: HTMLCanvasElement, private readonly scene: Scene, private readonly session: Session, private readonly playback: Playback,
    private readonly selection: Selection, private readonly notices: Notices, private readonly onFinding: (finding: Finding) => void,
  ) {
    attachGestures(canvas, scene.viewport, { hover: (at) => this.hover(at), click: (x, y, by) => this.click(x, y, by) });
  }

  /** Lets the next click on the sheet choose the start of the job. */
  chooseHome(): void {
    this.setChoosing(true);
    this.notices.show(words.page.chooseHome);
  }

  /** Ends choosing the start; returns whether it was going on. */
  cancelHome(): boolean {
    if (!this.choosingHome) return false;
    this.setChoosing(false);
    this.notices.hide();
    return true;
  }

  private setChoosing(on: boolean): void {
    this.choosingHome = on;
    this.canvas.classList.toggle('placing', on);
  }

  private hover(at: { x: number; y: number } | null): void {
    const contour = at && this.scene.pick(at.x, at.y, REACH.pointer);
    this.scene.highlight({ hovered: contour });
    if (at && contour !== null) this.tooltip.show(describe(this.session, this.playback, contour), at.x, at.y);
    else this.tooltip.hide();
    this.canvas.classList.toggle('over', contour !== null);
  }

  private click(x: number, y: number, { touch, shift, alt }: { touch: boolean; shift: boolean; alt: boolean }): void {
    if (this.choosingHome) return this.setHome(x, y);
    const finding = this.scene.pickFinding(x, y, touch ? REACH.touch : REACH.pointer + MARKER);
    this.selection.showFinding(finding);
    if (finding) return this.onFinding(finding);
    const contour = this.scene.pick(x, y, touch ? REACH.touch : REACH.pointer);
    if (shift || alt) this.selection.toggleRule(contour, alt ? 'exclude' : 'first');
    else this.selection.select(contour);
  }

  private setHome(x: number, y: number): void {
    this.cancelHome();
    const { viewport } = this.scene;
    const { machine } = this.session.state;
    const hundredths = (mm: number) => Math.round(mm * 100) / 100;
    if (machine) this.session.setMachine({ ...machine, home: [hundredths(viewport.worldX(x)), hundredths(viewport.worldY(y))] });
  }
}
