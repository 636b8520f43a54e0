"""What ezdxf's audit says of the drawings that we write: the page's samples, and what `kerfway plan --dxf` writes of them.

    node scripts/samples.mjs && npm run build && python tests/oracle/audit.py

writes `tests/fixtures/dxf-audit.json`: the version of ezdxf, the SHA-256 of each sample, and what the audit found in each
file. `tests/package/dxf-structure.test.mjs` fails when a sample is no longer the one that was audited. The file is read by
`ezdxf.readfile`, which repairs nothing; a file it refuses, or one with a finding, ends the script with exit code 1.
Needs `pip install ezdxf` and Node.
"""

import hashlib
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import ezdxf

ROOT = Path(__file__).resolve().parent.parent.parent
SAMPLES = ROOT / "www" / "app" / "public" / "samples"
OUT = ROOT / "tests" / "fixtures" / "dxf-audit.json"
# Drawings of every kind of entity and name of layer, so that what is written of them differs, too.
DRAWINGS = [*sorted(SAMPLES.glob("*.dxf")), *sorted((ROOT / "tests" / "fixtures" / "dxf-dev").glob("*.dxf"))]


def findings(file):
    try:
        auditor = ezdxf.readfile(file).audit()
    except ezdxf.DXFError as error:
        return [str(error)]
    return [entry.message for entry in [*auditor.errors, *auditor.fixes]]


def written(drawing, folder):
    """What the product writes of a drawing; None where there is nothing to plan."""
    out = Path(folder) / drawing.name
    command = ["node", ROOT / "dist" / "sdk" / "cli.js", "plan", drawing, "--units", "mm", "--moves", "1000", "--seed", "1", "--dxf", out]
    done = subprocess.run(command, capture_output=True, text=True)
    return out if done.returncode == 0 else None


def main():
    samples = {f.name: {"sha256": hashlib.sha256(f.read_bytes()).hexdigest(), "findings": findings(f)} for f in sorted(SAMPLES.glob("*.dxf"))}
    with tempfile.TemporaryDirectory() as folder:
        plans = {d.name: findings(out) for d in DRAWINGS if (out := written(d, folder))}
    OUT.write_text(json.dumps({"ezdxf": ezdxf.__version__, "samples": samples, "plans": plans}, indent=2) + "\n")
    bad = [name for name, sample in samples.items() if sample["findings"]] + [name for name, found in plans.items() if found]
    print(f"{len(samples)} samples and {len(plans)} plans audited, {len(bad)} with findings: {bad}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
