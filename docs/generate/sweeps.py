"""The chapter of sweeps, every force over its whole domain, from what `fenderline validate --sweeps --out` writes."""

import json
import shutil
from pathlib import Path

from markdown import cell, table


def page(sweeps_json: str, figures: Path) -> str:
    """The page; copies the pictures beside the JSON into `figures`."""
    found = json.loads(Path(sweeps_json).read_text(encoding="utf-8"))
    sweeps = found["sweeps"]
    for sweep in sweeps:
        shutil.copyfile(Path(sweeps_json).parent / sweep["picture"], figures / sweep["picture"])
    parts = [
        "# Every force over its whole domain\n",
        "This page is made by `fenderline validate --sweeps --out DIR`. Each curve is sampled along its whole axis: all angles, speeds from "
        "astern to full, depths from aground to deep, sizes. The command looks for a jump that halving the step does not lessen, compares "
        "the mirror image to rounding, and checks the signs that physics asks and the growth that the law allows. References are drawn "
        "beside ours, with their bands in the colour of the curve. Where none was found, the page says so: there nobody knows how good a "
        "force is.\n",
        f"{found['checks_that_hold']} of {found['checks']} checks hold. {found['references_within_their_band']} of {found['references']} "
        f"references are within their bands. {found['sweeps_without_reference']} of {len(sweeps)} sweeps have no reference. "
        "[How the references are described](validation/README.md) explains bands and standing.\n",
        "## Where we stand\n",
        table(
            ["force", "sweeps", "checks that hold", "references in their band", "sweeps without reference"],
            [standing(subject, [s for s in sweeps if s["subject"] == subject]) for subject in subjects(sweeps)],
        ),
    ]
    for subject in subjects(sweeps):
        parts.append(f"## {subject}\n")
        parts += [section(sweep) for sweep in sweeps if sweep["subject"] == subject]
    return "\n".join(parts)


def subjects(sweeps: list) -> list[str]:
    return list(dict.fromkeys(sweep["subject"] for sweep in sweeps))


def standing(subject: str, sweeps: list) -> list[str]:
    checks = [check for sweep in sweeps for check in sweep["checks"]]
    references = [reference for sweep in sweeps for reference in sweep["references"]]
    holds, within = sum(check["holds"] for check in checks), sum(reference["within"] for reference in references)
    without = sum(sweep["no_reference"] is not None for sweep in sweeps)
    return [subject, str(len(sweeps)), share(holds, len(checks)), share(within, len(references)), str(without)]


def share(some: int, all_of_them: int) -> str:
    """In bold where not all are good."""
    if all_of_them == 0:
        return "none found"
    text = f"{some} of {all_of_them}"
    return text if some == all_of_them else f"**{text}**"


def section(sweep: dict) -> str:
    parts = [f"![{cell(sweep['title'])}](figures/{sweep['picture']})\n"]
    if sweep["note"]:
        parts.append(sweep["note"] + "\n")
    checks = sweep["checks"]
    names = list(dict.fromkeys(check["check"] for check in checks))
    failing = [check for check in checks if not check["holds"]]
    text = f"Checks: {'; '.join(names)}. {len(checks) - len(failing)} of {len(checks)} hold."
    for check in failing:
        known = f" {check['known']}" if check["known"] else ""
        text += f" **{check['curve']}: {check['check']}: {check['found']}.**{known}"
    parts.append(text + "\n")
    if sweep["references"]:
        parts.append(table(
            ["curve", "reference", "standing", "ours over it", "band", "within", "source"],
            [[r["curve"], r["reference"], r["standing"], r["ratio"], f"±{100 * r['band']:.2g} %", "yes" if r["within"] else "**no**",
              " ".join(part for part in [r["citation"], r["known"]] if part)] for r in sweep["references"]],
        ))
    if sweep["no_reference"]:
        parts.append(f"**No reference found.** {sweep['no_reference']}\n")
    return "\n".join(parts)
