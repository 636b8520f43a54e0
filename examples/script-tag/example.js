// Plans the chosen drawing for at most five seconds and shows how the job time gets shorter.

const told = document.querySelector('#told');
const stop = document.querySelector('#stop');

document.querySelector('#file').addEventListener('change', async ({ target }) => {
  const [file] = target.files;
  // The lower left corner of the job lies at x 10, y 10 of the bed, wherever the drawing lies.
  const place = { at: [10, 10] };
  const run = Kerfway.plan(await file.arrayBuffer(), { name: file.name, seconds: 5, place, outputs: ['gcode'] });
  stop.disabled = false;
  stop.onclick = () => run.stop();
  try {
    for await (const { summary } of run) told.textContent = `${summary.total_time.toFixed(1)} s so far`;
    const { summary, outputs } = await run;
    told.textContent = `${summary.total_time.toFixed(1)} s, ${outputs.gcode.split('\n').length} lines of G-code`;
  } catch (error) {
    told.textContent = error.message;
  }
  stop.disabled = true;
});
