/** The report of a quote (`kerfway.quote/1`): see `quote.schema.json`. Lengths mm, areas mm2, times s, weights g. */

import type { FindingCode, MachineProfile, Severity, Unit } from './protocol.js';

/** The material of the sheet. */
export interface Material {
  /** A name, which is only shown. */
  name?: string;
  /** The thickness in mm. */
  thickness?: number;
  /** The density in g/cm3: mild steel 7.85, aluminium 2.70, acrylic 1.19. */
  density?: number;
}

/** What a price depends on. docs/quote.md describes every field. */
export interface Quote {
  schema: 'kerfway.quote/1';
  /**
   * SHA-256 of the whole report with this field empty. The same drawing, options, seed and moves give the same hash
   * natively, in Node and in every browser. A server that plans again with `moves` can confirm the report of a browser.
   */
  hash: string;
  input: { sha256: string; name: string; units: Unit; units_source: 'header' | 'guessed' | 'given' };
  machine: MachineProfile;
  /** How the drawing was read and arranged, as in the plan document. */
  options: Record<string, unknown>;
  method: string;
  parameters: string | null;
  seed: number;
  /** The number of moves that the search made. */
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
  /** Groups of equal parts, the largest part first. Mirrored parts are equal. The figures are those of one part. */
  parts: { count: number; net_area: number; cut_length: number; holes: number; contours: number[] }[];
  /** xmin, ymin, xmax, ymax of everything that is cut or marked. */
  bounds: [number, number, number, number];
  net_area: number;
  box_area: number;
  /** The weight of the parts in g, if thickness and density are given. */
  weight: number | null;
  /** The narrowest hole: a circle's diameter, a slot's width. */
  smallest_hole: { contour: number; width: number; over_thickness: number | null } | null;
  /** The narrowest web: where two cuts of one part are closest to each other. */
  narrowest_web: { contours: [number, number]; width: number; at: [number, number]; over_thickness: number | null } | null;
  defects: { code: FindingCode; severity: Severity; count: number }[];
  confidence: { level: 'high' | 'medium' | 'low'; reasons: string[] };
}
