/**
 * The parts of a session that are in wasm files of their own, each loaded when it is first needed: the writers of programs and drawings, which read
 * programs back as well, and what works on finished plans, the PNG renderer and the calibration.
 */

import { KerfwayError } from './errors.js';
import type { Calibration, MachineProfile, MeasuredPlan } from './protocol.js';
import type { WasmBytes, WasmModule } from './wasm-module.js';

type Outputs = typeof import('./pkg/kerfway_outputs.js');
type Png = typeof import('./pkg/kerfway_png.js');

/** How the files are loaded. */
export interface WriterFiles {
  /** Loads the writers of programs and drawings, when one is first used; from `given`, if there is one. */
  outputs(given: WasmModule | WasmBytes | undefined): Promise<Outputs>;
  /** Loads the PNG renderer, when it is first used. */
  png(): Promise<Png>;
}

/** The files of one session, and what they do. */
export class Writers {
  /** The wasm of the writers, where the worker cannot load it itself. */
  given: WasmModule | WasmBytes | undefined;
  /** The files that were loaded. */
  outputs: Outputs | null = null;
  png: Png | null = null;
  /** The writers, once they are being loaded. */
  private loading: Promise<Outputs> | null = null;

  constructor(private readonly files: WriterFiles) {}

  /** The writers. They are loaded once; if that fails, the next call tries again. */
  async loaded(): Promise<Outputs> {
    this.loading ??= this.files.outputs(this.given);
    try {
      return (this.outputs = await this.loading);
    } catch (error) {
      this.loading = null;
      throw error;
    }
  }

  /** A picture of a plan document, as the bytes of a PNG. */
  async picture(plan: string, width: number): Promise<Uint8Array> {
    this.png ??= await this.files.png();
    return this.png.renderPng(plan, width);
  }

  async calibrate(machine: MachineProfile, measured: readonly MeasuredPlan[]): Promise<Calibration> {
    this.png ??= await this.files.png();
    try {
      const fitted = this.png.calibrate(JSON.stringify(machine), measured.map((m) => String(m.plan)), Float64Array.from(measured, (m) => m.seconds));
      return JSON.parse(fitted) as Calibration;
    } catch (error) {
      // All that it refuses are times that cannot be, and jobs that are no plans.
      throw error instanceof WebAssembly.RuntimeError || !(error instanceof Error) ? error : new KerfwayError(error instanceof RangeError ? 'out-of-range' : 'wrong-type', error.message, { field: 'measured' });
    }
  }
}
