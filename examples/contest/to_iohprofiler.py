"""The CSV of a contest for the programs of IOHprofiler. Needs Python alone.

    python to_iohprofiler.py contest.csv contest-ioh 4000

Of each run the CSV has a row wherever the best J fell. The last number is the budget in drives, for how long the runs went on.

The folder contest-ioh is an experiment as IOHinspector reads it: of each run the rows of the CSV, and one at the budget.

contest-ioh-aligned.csv is for IOHanalyzer from 0.1.8.2 on: "Use custom csv format", then name the columns, which stand in the order
in which it asks for them (evaluation count drive, function values J, function ID function, algorithm ID contestant, problem
dimension dimension, run ID seed; no maximization), and "Process uploaded file with selected settings"; or in R

    read_pure_csv("contest-ioh-aligned.csv", "drive", "J", "function", "contestant", "dimension", "seed")

IOHanalyzer reads a CSV rightly only where all runs of a contestant have the same drives. So each run has a row, with its best J
until then, at every drive at which one of them fell, and at the budget: 12 MB for four contestants with 51 seeds and 4000 drives,
130 MB with 101 seeds and 20000.
"""

import csv
import json
import sys
from pathlib import Path


def runs_of(file):
    """For each contestant its runs by seed: where the best J fell, and to what."""
    contestants = {}
    with open(file, newline="", encoding="utf-8") as rows:
        for row in csv.DictReader(rows):
            runs = contestants.setdefault(row["contestant"], {})
            runs.setdefault(row["seed"], []).append((int(row["drive"]), row["J"]))
            # What is no number is not to be found out half way.
            int(row["seed"]), float(row["J"])
    return contestants


def asked(arguments):
    """The runs, the folder and the budget; or one sentence says what is wrong."""
    if len(arguments) != 3 or not arguments[2].isdecimal():
        sys.exit("usage: python to_iohprofiler.py contest.csv contest-ioh 4000")
    file, folder, budget = arguments
    try:
        contestants = runs_of(file)
    except OSError as error:
        sys.exit(f"{file} cannot be read: {error.strerror}.")
    except (KeyError, TypeError, ValueError, csv.Error):
        contestants = {}
    if not contestants or any(name == ".." or name != Path(name).name for name in contestants):
        sys.exit(f"{file} is not the CSV of a contest, which has the columns contestant, seed, drive and J.")
    return contestants, Path(folder), int(budget)


def write_text(path, text):
    """The same bytes on every system."""
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(text)


def write(contestant, runs, folder, budget):
    """A contestant's folder: what it is, and a block of rows for each run."""
    data = folder / contestant / "data_f1"
    data.mkdir(parents=True, exist_ok=True)
    path = f"data_f1/{contestant}_DIM3.dat"
    lines = []
    for falls in runs.values():
        lines += ["evaluations raw_y", *(f"{drive} {cost}" for drive, cost in falls)]
        # So that a run which has long stood still counts with all that it drove.
        if falls[-1][0] < budget:
            lines.append(f"{budget} {falls[-1][1]}")
    write_text(folder / contestant / path, "\n".join(lines) + "\n")
    told = {
        "version": "0.3.18",
        "suite": "ep-locomotion",
        "function_id": 1,
        "function_name": "J",
        "maximization": False,
        "algorithm": {"name": contestant, "info": "a contestant of ep-locomotion"},
        "attributes": ["evaluations", "raw_y"],
        "scenarios": [
            {
                "dimension": 3,
                "path": path,
                "runs": [
                    {
                        "instance": int(seed),
                        "evals": budget,
                        "best": {"evals": falls[-1][0], "y": float(falls[-1][1]), "x": []},
                    }
                    for seed, falls in runs.items()
                ],
            }
        ],
    }
    write_text(folder / contestant / "IOHprofiler_f1_J.json", json.dumps(told, indent=1))


def aligned(runs, budget):
    """For each run, at every drive at which one of them fell and at the budget: seed, drive, its best J until then."""
    drives = sorted({drive for falls in runs.values() for drive, _ in falls} | {budget})
    for seed, falls in runs.items():
        fell = dict(falls)
        best = "Inf"
        for drive in drives:
            best = fell.get(drive, best)
            yield seed, drive, best


def write_aligned(contestants, file, budget):
    """All runs as one CSV, its columns in the order in which IOHanalyzer asks for them."""
    with open(file, "w", newline="", encoding="utf-8") as rows:
        out = csv.writer(rows)
        out.writerow(["drive", "J", "function", "contestant", "dimension", "seed"])
        for contestant, runs in contestants.items():
            for seed, drive, best in aligned(runs, budget):
                out.writerow([drive, best, "J", contestant, 3, seed])


if __name__ == "__main__":
    contestants, folder, budget = asked(sys.argv[1:])
    last = max((falls[-1][0] for runs in contestants.values() for falls in runs.values()), default=0)
    if last > budget:
        sys.exit(f"A J fell at drive {last}: the budget is not {budget}.")
    for contestant, runs in contestants.items():
        write(contestant, runs, folder, budget)
    write_aligned(contestants, f"{folder}-aligned.csv", budget)
    print(f"{len(contestants)} contestants in {folder} and {folder}-aligned.csv")
