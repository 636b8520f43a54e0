/** The pointer on the stage: the tooltip, picking contours and findings, and choosing where the head starts. */

import type { Finding } from 'kerfway';
import type { Announcer } from '../core/announce.js';
import { words } from '../core/words/index.js';
import { describe, Tooltip } from '../panels/contour.js';
import type { Playback } from '../playback/playback.js';
import { jointAt, withJoint } from '../session/hand-joints.js';
import { reachOf } from '../session/off-bed.js';
import { bedAround, dragged, fitsBed, hundredths, shiftOf } from '../session/placing.js';
import { isDrawn } from '../session/rules.js';
import type { Session } from '../session/session.js';
import { partsOf } from '../session/parts.js';
import { attachGestures, type Click, type Drag } from '../stage/gestures.js';
import { inWords, type Measured, type Point, snap } from '../stage/measure.js';
import type { Scene } from '../stage/scene.js';
import { chainLength } from '../stage/shapes.js';
import type { Notices } from './notices.js';
import type { Selection } from './selection.js';

/** CSS pixels around the pointer within which a contour is picked; a finger needs more. */
const REACH = { pointer: 8, touch: 20 };
/** How much farther a finding is picked, as its marker is larger than a line. */
const MARKER = 4;
/** Milliseconds within which a second click is a double click. */
const TWICE = 350;

export class Pointer {
  readonly tooltip = new Tooltip();
  /** The next click on the sheet chooses the start of the job. */
  private choosingHome = false;
  /** Dragging moves the job on the bed instead of the view; by how much it has moved since the last drop, mm. */
  private dragged: { x: number; y: number } | null = null;
  private clickedAt = -Infinity;
  /** Clicks place micro-joints. */
  private placingJoints = false;
  /** Shows whether they do, on the button that began it. */
  private showPlacing: (on: boolean) => void = () => undefined;
  /** Clicks measure; the points so far. */
  private measured: { points: Measured } | null = null;

  constructor(
    private readonly canvas: HTMLCanvasElement, private readonly scene: Scene, private readonly session: Session, private readonly playback: Playback,
    private readonly selection: Selection, private readonly notices: Notices, private readonly announcer: Announcer, private readonly onFinding: (finding: Finding) => void,
    private readonly onDragging: (on: boolean) => void,
  ) {
    attachGestures(canvas, scene.viewport, {
      hover: (at) => this.hover(at), click: (x, y, by) => this.click(x, y, by), drag: (by) => this.drag(by), drop: () => this.drop(),
    });
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

  /**
   * Begins or ends the placing of micro-joints: clicks place them on contours and remove them. `show` is called with whether they are being
   * placed, now and whenever that changes.
   */
  togglePlacing(show?: (on: boolean) => void): void {
    if (show) this.showPlacing = show;
    this.placeJoints(!this.placingJoints);
  }

  /** Begins the placing of micro-joints, or ends it. Returns whether they were being placed before. */
  placeJoints(on: boolean): boolean {
    const before = this.placingJoints;
    this.placingJoints = on;
    this.showPlacing(on);
    this.canvas.classList.toggle('placing', on);
    if (on) this.notices.show(words.joints.placing);
    else if (before) this.notices.hide();
    return before;
  }

  private joint(x: number, y: number, reach: number): void {
    const { shapes, viewport: v } = this.scene;
    const contour = this.scene.pick(x, y, reach);
    const { loaded } = this.session.state;
    if (!shapes || !loaded || contour === null || !isDrawn(loaded, contour)) return;
    const joint = jointAt(shapes, contour, v.worldX(x), v.worldY(y));
    this.session.drawing.change(withJoint(this.session.state.load, joint, chainLength(shapes, contour), reach / v.scale));
  }

  /** Lets clicks measure distances, or ends that. Returns whether it was going on. */
  measure(on: boolean): boolean {
    const before = this.measured !== null;
    if (!on && !before) return false;
    this.measured = on ? { points: null } : null;
    this.canvas.classList.toggle('measuring', on);
    this.scene.highlight({ measured: null });
    if (on) this.notices.show(words.stage.measuring);
    return before;
  }

  private pointAt(x: number, y: number, reach: number): Point | null {
    const { shapes, viewport: v } = this.scene;
    return shapes && snap(shapes, v.worldX(x), v.worldY(y), reach / v.scale);
  }

  /** The next point; after two, a new measurement begins. */
  private measureAt(point: Point | null): void {
    if (this.measured === null || point === null) return;
    const { points } = this.measured;
    this.measured.points = points === null || points[1] ? [point] : [points[0], point];
    this.scene.highlight({ measured: this.measured.points });
    const [a, b] = this.measured.points;
    if (!b) return;
    // It is written on the sheet.
    this.notices.hide();
    this.announcer.say(inWords([a, b]));
  }

  /** Lets dragging move the job on the bed, or ends it. Returns whether it was going on. */
  dragJob(on: boolean): boolean {
    const before = this.dragged !== null;
    this.dragged = on ? { x: 0, y: 0 } : null;
    this.canvas.classList.toggle('moving', on);
    this.onDragging(on);
    if (on) this.notices.show(words.placement.dragging);
    else if (before) this.notices.hide();
    return before;
  }

  // The job follows the pointer, and the bed stays: the view moves with the job, and the bed moves back on it.
  private drag({ dx, dy, from, to, shift }: Drag): boolean {
    const { dragged: sum, scene, session: { state } } = this;
    const { placing, machine, loaded } = state;
    if (sum === null && loaded && (shift || this.selection.several || scene.box !== null)) {
      scene.highlight({ box: [from.x, from.y, to.x, to.y] });
      return true;
    }
    if (sum === null || !loaded) return false;
    scene.viewport.pan(dx, dy);
    sum.x += dx / scene.viewport.scale;
    sum.y -= dy / scene.viewport.scale;
    const moved = { ...placing, place: dragged(placing, loaded, sum.x, sum.y) };
    scene.setBed(bedAround(moved, machine, loaded), fitsBed(moved, machine, loaded, reachOf(state)));
    return true;
  }

  private drop(): void {
    const { dragged: sum, session, scene: { box, viewport: v } } = this;
    const { placing, loaded } = session.state;
    if (box !== null) {
      this.scene.highlight({ box: null });
      this.selection.selectBox(v.worldX(box[0]), v.worldY(box[1]), v.worldX(box[2]), v.worldY(box[3]));
      return;
    }
    if (sum === null || !loaded || (sum.x === 0 && sum.y === 0)) return;
    const place = dragged(placing, loaded, sum.x, sum.y);
    [sum.x, sum.y] = [0, 0];
    session.setPlacing({ place });
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

  private click(x: number, y: number, { touch, shift, alt, command }: Click): void {
    if (this.choosingHome) return this.setHome(x, y);
    if (this.placingJoints) return this.joint(x, y, touch ? REACH.touch : REACH.pointer);
    if (this.measured) return this.measureAt(this.pointAt(x, y, touch ? REACH.touch : REACH.pointer));
    const finding = this.scene.pickFinding(x, y, touch ? REACH.touch : REACH.pointer + MARKER);
    this.selection.showFinding(finding);
    if (finding) return this.onFinding(finding);
    const contour = this.scene.pick(x, y, touch ? REACH.touch : REACH.pointer);
    if (shift || alt) {
      if (contour !== null) this.selection.toggleRule([contour], alt ? 'exclude' : 'first');
      return;
    }
    const twice = performance.now() - this.clickedAt < TWICE;
    this.clickedAt = performance.now();
    const found = this.under(contour, x, y, twice);
    if (command || this.selection.several) {
      if (found.length > 0) this.selection.toggle(found);
    } else this.selection.selectAll(found);
  }

  /** The contour under a click; with a second click, or between its contours, the part. */
  private under(contour: number | null, x: number, y: number, twice: boolean): number[] {
    const { scene: { viewport: v }, session: { state: { loaded } } } = this;
    if (!loaded) return [];
    if (contour !== null) return twice ? partsOf(loaded).whole([contour]) : [contour];
    const part = partsOf(loaded).at(v.worldX(x), v.worldY(y));
    return part === null ? [] : partsOf(loaded).contours(part);
  }

  private setHome(x: number, y: number): void {
    this.cancelHome();
    const { viewport } = this.scene;
    const { machine, placing, loaded } = this.session.state;
    const [dx, dy] = shiftOf(placing, loaded);
    if (machine) this.session.setMachine({ ...machine, home: [hundredths(viewport.worldX(x) + dx), hundredths(viewport.worldY(y) + dy)] });
  }
}
