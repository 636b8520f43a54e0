// <kerfway-planner> in a React component (React 19 hands properties and events to elements): what a drawing costs, by a
// price a minute of the machine.

import { useState } from 'react';
import { createRoot } from 'react-dom/client';
import 'kerfway/element/react';
import type { ErrorReport, Summary } from 'kerfway';

const MATERIALS = { plywood: 'co2-100w', 'thin steel': 'fibre-3kw-thin' };
type Material = keyof typeof MATERIALS;

function Quote({ pricePerMinute }: { pricePerMinute: number }) {
  const [material, setMaterial] = useState<Material>('plywood');
  const [summary, setSummary] = useState<Summary | null>(null);
  const [problem, setProblem] = useState<ErrorReport | null>(null);
  const show = (finished: Summary | null, failed: ErrorReport | null) => {
    setSummary(finished);
    setProblem(failed);
  };
  return (
    <form>
      <label>
        Material{' '}
        <select value={material} onChange={(event) => setMaterial(event.target.value as Material)}>
          {Object.keys(MATERIALS).map((name) => <option key={name}>{name}</option>)}
        </select>
      </label>
      <kerfway-planner
        options={{ machine: MATERIALS[material], seconds: 3, seed: 1, allowOffBed: true }} // A price does not depend on where the drawing lies.
        onresult={({ detail }) => show(detail.summary, null)}
        onerror={({ detail }) => show(null, detail)}
      />
      {summary && <output>{((summary.total_time / 60) * pricePerMinute).toFixed(2)} € for {summary.parts} parts</output>}
      {problem && <p role="alert">{problem.message}</p>}
    </form>
  );
}

createRoot(document.querySelector('#app')!).render(<Quote pricePerMinute={1.5} />);
