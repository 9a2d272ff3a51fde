#!/usr/bin/env python3
"""Do the tests notice? Changes one operator, sign or constant of a module at a time, builds its
tests and runs them: mutants.py SOURCE BUILD [--seed 1] [--count 100] [--modules replay,motion]
[--out mutants.jsonl]

SOURCE is a tree to change (a copy: it is put back, but not if the script is killed), BUILD its
configured build folder. Prints a line for each mutant and the share that was killed; those that
lived are to be read: either a test is missing, or the change means nothing."""
import argparse
import json
import pathlib
import random
import re
import subprocess
import sys

MODULES = ["replay", "collision", "motion", "layers"]

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


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("source", type=pathlib.Path)
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--count", type=int, default=100)
    options.add_argument("--modules", default=",".join(MODULES))
    options.add_argument("--out", type=pathlib.Path)
    given = options.parse_args()
    dice = random.Random(given.seed)
    candidates = []
    for module in given.modules.split(","):
        for file in sorted((given.source / "core" / module).glob("*.cpp")):
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
            result = run([given.build / "bin" / f"test_{module}", "--gtest_fail_fast"], 300)
        finally:
            file.write_text(text)
        killed += result != 0
        lived += result == 0
        row = {"file": str(file.relative_to(given.source)), "line": line,
               "was": text.splitlines()[line - 1].strip(), "is": changed.splitlines()[line - 1].strip(),
               "killed": result != 0}
        if given.out:
            with given.out.open("a") as out:
                out.write(json.dumps(row) + "\n")
        print("killed" if result != 0 else "LIVED ", f"{row['file']}:{line}: {row['was']}  ->  {row['is']}",
              flush=True)
    print(f"{killed} of {killed + lived} killed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
