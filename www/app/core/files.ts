/** Choosing files, dropping them anywhere on the page, and saving them. */

/** Opens the file dialog for one kind of file, and calls `onFiles` when at least one file is chosen. */
export function choose(onFiles: (files: File[]) => void, { accept = '.dxf,.DXF,.svg,.SVG,image/svg+xml,.kerfway', multiple = false } = {}): void {
  const input = document.createElement('input');
  Object.assign(input, { type: 'file', accept, multiple });
  input.addEventListener('change', () => {
    const files = [...(input.files ?? [])];
    if (files.length > 0) onFiles(files);
  });
  input.click();
}

/** Accepts files that are dropped anywhere on the page. `hovering` is told whether files are being dragged over it. */
export function acceptDrops(onFiles: (files: File[]) => void, hovering: (over: boolean) => void): void {
  let depth = 0;
  const holdsFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  addEventListener('dragenter', (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    depth += 1;
    if (depth === 1) hovering(true);
  });
  addEventListener('dragover', (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
  });
  addEventListener('dragleave', (event) => {
    if (!holdsFiles(event)) return;
    depth = Math.max(0, depth - 1);
    if (depth === 0) hovering(false);
  });
  addEventListener('drop', (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    depth = 0;
    hovering(false);
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length > 0) onFiles(files);
  });
}

/** Downloads data as a file. */
export function save(data: string | Uint8Array, name: string, type: string): void {
  const url = URL.createObjectURL(new Blob([data as BlobPart], { type }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the data when it handles the click; a minute is enough even for slow disks.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
