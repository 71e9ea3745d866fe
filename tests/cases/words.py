"""The commands that only talk: explain, list, new, check, --version; the reference page is current; every example is a good case."""

import shutil
import sys

from program import CASE, SOURCE, execute, fresh_folder


def check_words(folder):
    assert execute(folder, "--version", check=0)[1].startswith("corpuscle ")
    assert "mass of the whole charge" in execute(folder, "explain", "charge.mass", check=0)[1].lower()
    assert "'mass'" in execute(folder, "explain", "mas", check=2)[2]
    for kind, name in [("explosives", "tnt_paper"), ("materials", "rha_steel"), ("gases", "air"), ("fields", "plastic_strain")]:
        assert name in execute(folder, "list", kind, check=0)[1], kind
    assert "'gases'" in execute(folder, "list", "gasses", check=2)[2]
    execute(folder, check=2)
    execute(folder, "--help", check=0)


def check_new(folder):
    execute(folder, "new", "plate", check=0)
    execute(folder, "check", "plate.toml", check=0)
    assert "--force" in execute(folder, "new", "plate", check=2)[2]
    execute(folder, "new", "plate", "--force", check=0)
    assert "'plate'" in execute(folder, "new", "plat", check=2)[2]


def check_check(folder):
    (folder / "case.toml").write_text(CASE)
    said = execute(folder, "check", "case.toml", "--threads", "1", check=0)[1]
    for word in ["tnt", "air", "plate", "frame", "memory", "steps", "on 1 threads", "the case is good"]:
        assert word in said, word
    assert "0.25" in said  # a quarter of the charge's kilogram
    assert "0.5 " in execute(folder, "check", "case.toml", "--set", "charge.0.mass=2 kg", check=0)[1]


def check_presets(folder):
    """A folder of presets beside the case comes before the program's own."""
    (folder / "share/explosives").mkdir(parents=True)
    text = (SOURCE / "share/explosives/tnt.toml").read_text()
    assert "1630 kg/m3" in text
    (folder / "share/explosives/mine.toml").write_text(text)
    (folder / "case.toml").write_text(CASE.replace('"tnt"', '"mine"'))
    execute(folder, "check", "case.toml", check=0)


def check_examples(folder):
    cases = sorted(SOURCE.glob("examples/*/*.toml")) + sorted(SOURCE.glob("share/starters/*.toml"))
    assert len(cases) >= 2
    for case in cases:
        execute(folder, "check", str(case), check=0)


def check_reference(folder):
    page = execute(folder, "explain", "--markdown", check=0)[1]
    assert page == (SOURCE / "docs/reference/case.md").read_text(), "docs/reference/case.md is out of date: write it anew with corpuscle explain --markdown"


def main():
    folder = fresh_folder({})
    for check in [check_words, check_new, check_check, check_presets, check_examples, check_reference]:
        check(folder)
        print(f"{check.__name__}: as it should be")
    shutil.rmtree(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
