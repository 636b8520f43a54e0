/** The report of a quote (`kerfway.quote/1`): see `quote.schema.json`. Lengths mm, areas mm2, times s, weights g. */

import type { FindingCode, MachineProfile, Severity, Unit } from './protocol.js';

/** What the sheet is made of. */
export interface Material {
  /** For people. */
  name?: string;
  /** mm. */
  thickness?: number;
  /** g/cm3: mild steel 7.85, aluminium 2.70, acrylic 1.19. */
  density?: number;
}

/** What a price needs to know of a job; every field is told in docs/quote.md. */
export interface Quote {
  schema: 'kerfway.quote/1';
  /**
   * SHA-256 over the whole report (this field empty): the same for the same drawing, options, seed and moves, natively,
   * under Node and in every browser. A server that plans again with `moves` confirms what a browser said by it.
   */
  hash: string;
  input: { sha256: string; name: string; units: Unit; units_source: 'header' | 'guessed' | 'given' };
  machine: MachineProfile;
  /** How the drawing was read and arranged, as in the plan document. */
  options: Record<string, unknown>;
  method: string;
  parameters: string | null;
  seed: number;
  /** Moves the search did. */
  moves: number;
  workers: number | null;
  material: { name: string | null; thickness: number | null; density: number | null };
  times: { total: number; cut: number; air: number; pierce: number; pre_cut: number; macros: number };
  cut_length: number;
  air_length: number;
  pierces: number;
  pre_cuts: number;
  layers: { layer: string; operation: 'cut' | 'mark'; contours: number; open: number; length: number }[];
  part_count: number;
  /** Same parts together, the largest first; mirrored ones are the same. Figures are those of one. */
  parts: { count: number; net_area: number; cut_length: number; holes: number; contours: number[] }[];
  /** xmin, ymin, xmax, ymax of all that is worked. */
  bounds: [number, number, number, number];
  net_area: number;
  box_area: number;
  /** When thickness and density are given. */
  weight: number | null;
  /** The hole of the least width: a circle's diameter, a slot's width. */
  smallest_hole: { contour: number; width: number; over_thickness: number | null } | null;
  /** Where two cuts of one part come nearest to each other. */
  narrowest_web: { contours: [number, number]; width: number; at: [number, number]; over_thickness: number | null } | null;
  defects: { code: FindingCode; severity: Severity; count: number }[];
  confidence: { level: 'high' | 'medium' | 'low'; reasons: string[] };
}
