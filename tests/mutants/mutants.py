#!/usr/bin/env python3
"""Do the tests notice? Changes one operator, sign or constant of a module at a time, builds its
tests and runs them: mutants.py SOURCE BUILD [--seed 1] [--count 100] [--modules replay,motion]
[--fast] [--out mutants.jsonl]

SOURCE is a tree to change (a copy: it is put back, but not if the script is killed), BUILD its
configured build folder. The files of a module's tests run one after the other, those named like the
changed source first, until one fails, with all their random cases; --fast leaves out the files that
CMakeLists.txt calls slow, and takes a few random cases.
Prints a line for each mutant and the share that was killed; those that lived are to be read: either
a test is missing, or the change means nothing."""
import argparse
import json
import os
import pathlib
import random
import re
import subprocess
import sys

# The modules, and which of their sources are no logic of their own: tables of parameters and texts,
# files for other programs.
MODULES = {
    "replay": [], "collision": [], "motion": ["motion_options.cpp", "trajectory_csv.cpp"],
    "layers": ["vtp_writer.cpp"], "toolpath": ["options.cpp", "vtp_writer.cpp"], "together": [],
    "sliced": [], "milling": [], "record": [], "planar": [],
}

# What is no code to change: comments, texts, includes, and what only the compiler reads.
SKIPPED = re.compile(
    r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*'|^\s*#[^\n]*|static_assert\([^;]*;"
    r"|template\s*<[^>]*>|static_cast<[^>]*>|std::(?:vector|array|optional|pair|span|shared_ptr|"
    r"unique_ptr|function|make_shared|make_unique|numeric_limits|atomic_ref)<[^;(){]*>|operator[^(]+\("
    r"|base::require\([^;]*;|\.report\([^;]*;|reserve\([^;]*;",
    re.S | re.M)

SWAPS = {
    " + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " < ": " >= ", " > ": " <= ",
    " <= ": " > ", " >= ": " < ", " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && ",
    " += ": " -= ", " -= ": " += ", "std::min(": "std::max(", "std::max(": "std::min(",
    "true": "false", "false": "true", ".cwiseMin(": ".cwiseMax(", ".cwiseMax(": ".cwiseMin(",
}
NUMBER = re.compile(r"(?<![\w.])(\d+\.\d+|\d+)(f?)(?![\w.'])")


def places(text):
    """(begin, end, replacement) of every change that can be made."""
    blank = SKIPPED.sub(lambda m: re.sub(r"[^\n]", "\0", m.group()), text)
    found = []
    for word, other in SWAPS.items():
        pattern = re.escape(word) if not word.isalpha() else rf"\b{word}\b"
        found += [(m.start(), m.end(), other) for m in re.finditer(pattern, blank)]
    for m in NUMBER.finditer(blank):
        value = m.group(1)
        other = str(float(value) * 2 if float(value) else 1.0) if "." in value else str(int(value) + 1)
        found.append((m.start(), m.end(), other + m.group(2)))
    return sorted(found)


def run(command, seconds):
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=seconds).returncode
    except subprocess.TimeoutExpired:
        return "time"


def sources(tree, module):
    """The sources of a module to change, those of its folders too."""
    folder = tree / "core" / module
    return [file for file in sorted(folder.rglob("*.cpp")) if file.name not in MODULES[module]]


def tests(tree, module, fast):
    """Names of the files with the module's cases."""
    folder = tree / "tests" / module
    list_of_slow = re.search(r"\bSLOW\b([^)]*)\)", (folder / "CMakeLists.txt").read_text())
    slow = list_of_slow.group(1).split() if fast and list_of_slow else []
    return [file.name for file in sorted(folder.glob("*_test.cpp")) if file.name not in slow]


def killed_by(program, files, source):
    """The first of the files whose cases notice the change in `source`, or None."""
    words = set(source.stem.split("_"))
    likely = sorted(files, key=lambda name: -len(words & set(name.removesuffix("_test.cpp").split("_"))))
    for name in likely:
        if run([program, f"--source={name}", "--gtest_fail_fast"], 300) != 0:
            return name
    return None


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("source", type=pathlib.Path)
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--count", type=int, default=100)
    options.add_argument("--modules", default=",".join(MODULES))
    options.add_argument("--fast", action="store_true")
    options.add_argument("--out", type=pathlib.Path)
    given = options.parse_args()
    if not given.fast:
        os.environ["VOLUTA_ALL_SEEDS"] = "1"
    dice = random.Random(given.seed)
    candidates = []
    for module in given.modules.split(","):
        for file in sources(given.source, module):
            candidates += [(module, file, place) for place in places(file.read_text())]
    dice.shuffle(candidates)
    killed = lived = 0
    for module, file, (begin, end, other) in candidates:
        if killed + lived == given.count:
            break
        text = file.read_text()
        line = text.count("\n", 0, begin) + 1
        changed = text[:begin] + other + text[end:]
        file.write_text(changed)
        try:
            built = run(["cmake", "--build", given.build, "--target", f"test_{module}", "--", "-j1"], 900)
            if built != 0:
                continue  # the compiler notices: no mutant
            killer = killed_by(given.build / "bin" / f"test_{module}",
                               tests(given.source, module, given.fast), file)
        finally:
            file.write_text(text)
        killed += killer is not None
        lived += killer is None
        row = {"file": str(file.relative_to(given.source)), "line": line,
               "was": text.splitlines()[line - 1].strip(), "is": changed.splitlines()[line - 1].strip(),
               "killed": killer}
        if given.out:
            with given.out.open("a") as out:
                out.write(json.dumps(row) + "\n")
        print("killed" if killer else "LIVED ", f"{row['file']}:{line}: {row['was']}  ->  {row['is']}",
              flush=True)
    print(f"{killed} of {killed + lived} killed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
