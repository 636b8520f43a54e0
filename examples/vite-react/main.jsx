// <kerfway-planner> in a React component (React 19 hands properties and events to elements): what a drawing costs, by a
// price a minute of the machine.

import { useState } from 'react';
import { createRoot } from 'react-dom/client';
import 'kerfway/element';

const MATERIALS = { plywood: 'co2-100w', 'thin steel': 'fibre-3kw-thin' };

function Quote({ pricePerMinute }) {
  const [material, setMaterial] = useState('plywood');
  const [summary, setSummary] = useState(null);
  const [problem, setProblem] = useState(null);
  const took = (what) => {
    setSummary(what.summary ?? null);
    setProblem(what.message ?? null);
  };
  return (
    <form>
      <label>
        Material{' '}
        <select value={material} onChange={(event) => setMaterial(event.target.value)}>
          {Object.keys(MATERIALS).map((name) => <option key={name}>{name}</option>)}
        </select>
      </label>
      <kerfway-planner
        options={{ machine: MATERIALS[material], seconds: 3, seed: 1, allowOffBed: true }} // A price does not depend on where the drawing lies.
        onresult={({ detail }) => took(detail)}
        onerror={({ detail }) => took(detail)}
      />
      {summary && <output>{((summary.total_time / 60) * pricePerMinute).toFixed(2)} € for {summary.parts} parts</output>}
      {problem && <p role="alert">{problem}</p>}
    </form>
  );
}

createRoot(document.querySelector('#app')).render(<Quote pricePerMinute={1.5} />);
