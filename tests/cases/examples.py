"""Every example is a good case, and takes its first steps."""

import pathlib
import shutil
import sys

from program import execute, fresh_folder

EXAMPLES = pathlib.Path(sys.argv[2]) / "examples"


def main():
    cases = sorted(EXAMPLES.glob("*/*.toml"))
    assert cases, EXAMPLES
    folder = fresh_folder({})
    for number, case in enumerate(cases):
        _, out, _ = execute(folder, "check", str(case), check=0)
        assert "the case is good" in out, out
        early = ["--set", "end_time=0.02 ms"]
        if 'start = "spherical"' in case.read_text():  # which begins later than that
            early += ["--set", "gas.start=detonation"]
        execute(folder, "run", str(case), "--out", f"run{number}", "--quiet", *early, check=0)
        assert (folder / f"run{number}/report.html").stat().st_size > 1000
        print(f"{case.relative_to(EXAMPLES)}: as it should be", flush=True)
    shutil.rmtree(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
