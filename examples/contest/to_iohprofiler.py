"""The CSV of a contest as the folder of an IOHprofiler experiment, for IOHinspector and IOHanalyzer. Needs Python alone.

    python to_iohprofiler.py contest.csv contest-ioh 4000

Of each run the file has a row wherever the best J fell. The last number is the budget in drives, for how long the runs went on.
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
    return contestants


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
    (folder / contestant / path).write_text("\n".join(lines) + "\n", encoding="utf-8")
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
    name = folder / contestant / "IOHprofiler_f1_J.json"
    name.write_text(json.dumps(told, indent=1), encoding="utf-8")


if __name__ == "__main__":
    contestants = runs_of(sys.argv[1])
    for contestant, runs in contestants.items():
        write(contestant, runs, Path(sys.argv[2]), int(sys.argv[3]))
    print(f"{len(contestants)} contestants in {sys.argv[2]}")
