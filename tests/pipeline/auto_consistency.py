#!/usr/bin/env python3
"""Checks that mode auto says one thing: auto_consistency.py [--again] VOLUTA_CLI PART...

Plans each part and compares what the command line prints, report.json and the project file say of
the way that was chosen. With --again the part is planned once more by hand with the values in
chosen{}: the programs must be the same to the byte. Prints one line a part; exit code 1 where
something does not fit together.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile


def plan(cli, part, folder, *options):
    done = subprocess.run([cli, "plan", part, "-o", folder, "--progress", "none", *options],
                          capture_output=True, text=True, check=False)
    report = json.loads((folder / "report.json").read_text())
    return done, report


def project_header(path):
    """The JSON header of a project file (docs/design.md, Project file)."""
    data = path.read_bytes()
    start = data.index(b"{")
    header, _ = json.JSONDecoder().raw_decode(data[start:].decode("utf-8", "replace"))
    return header


def programs(folder):
    kept = (".json", ".voluta", ".html", ".stl", ".dxf")
    return {f.name: f.read_bytes() for f in folder.iterdir() if not f.name.endswith(kept)}


def without_job(text):
    """A program without the lines that name its job, which holds the choices."""
    return b"\n".join(line for line in text.split(b"\n") if b"job" not in line.lower())


def problems_of(done, report, folder):
    chosen, tried = report["chosen"], report["tried"]
    found = []

    def check(holds, what):
        if not holds:
            found.append(what)

    taken = [row for row in tried if row["taken"]]
    check(len(taken) == 1, f"{len(taken)} rows of tried[] are taken")
    for key in ("way", "name", "mode", "platform"):
        check(taken and taken[0][key] == chosen[key], f"tried[].{key} is not chosen.{key}")
    check(report["decomposition"]["mode"] == chosen["mode"], "decomposition.mode is another one")
    passed = any(row["passed"] for row in tried)
    check(passed == (done.returncode == 0), f"exit code {done.returncode}, passed {passed}")
    check(passed == (taken and taken[0]["passed"]), "one passes and another is taken")
    lines = done.stdout.splitlines()
    said = [line for line in lines if line.startswith(("Chosen: ", "Nothing passes; "))]
    check(len(said) == 1, f"{len(said)} lines say what is chosen")
    if said:
        check(said[0].startswith("Chosen: ") == passed, f"it says: {said[0]}")
        check(chosen["name"] in said[0], "the line names another way")
        check(f"layer height {chosen['layerHeightMm']:g} mm" in said[0], "another layer height")
        check(not chosen["supports"] or f"supports: {chosen['supports']}" in said[0],
              "other supports")
    rejected = [line for line in lines if line.startswith("Rejected: ")]
    check(len(rejected) == len(tried) - 1, f"{len(rejected)} of {len(tried) - 1} rejected ways")
    check(all(row["taken"] or row["why"] for row in tried), "a way is rejected without a reason")
    choices = project_header(folder / "job.voluta").get("choices", {})
    check(choices.get("automaticWay", "") == chosen["way"], "the project names another way")
    check(choices.get("mode") == chosen["mode"], "the project has another mode")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--again", action="store_true")
    parser.add_argument("cli")
    parser.add_argument("parts", nargs="+")
    options = parser.parse_args()
    bad = 0
    for part in options.parts:
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary, "auto")
            done, report = plan(options.cli, part, folder)
            problems = problems_of(done, report, folder)
            chosen = report["chosen"]
            if options.again:
                hand = pathlib.Path(temporary, "hand")
                values = ["--set", f"layerHeightMm={chosen['layerHeightMm']!r}"]
                if chosen["supports"]:
                    values += ["--set", f"supports={chosen['supports']}"]
                plan(options.cli, part, hand, "--mode", chosen["mode"], "--platform",
                     chosen["platform"], *values)
                mine, other = programs(folder), programs(hand)
                if {n: without_job(t) for n, t in mine.items()} != \
                        {n: without_job(t) for n, t in other.items()}:
                    problems.append("planned by hand with these values the programs differ")
        print(f"{part}: {'; '.join(problems) or 'consistent'}: {chosen['name']}")
        bad += bool(problems)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
