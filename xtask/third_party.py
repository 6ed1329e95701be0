"""Licences of everything that a package is linked with, and its bill of materials (CycloneDX 1.5, JSON).

    python3 xtask/third_party.py --package fenderline --out FOLDER TARGET...

Reads `cargo metadata` for each target triple. Build scripts, macros and tests are not in the result: they are in no program. Standard
library only. The output has no time and no random number: the same sources give the same bytes.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TEXTS = ("license", "licence", "copying", "notice", "unlicense", "copyright")


def metadata(target: str) -> dict:
    cargo = os.environ.get("CARGO", "cargo")
    command = [cargo, "metadata", "--format-version", "1", "--locked", "--filter-platform", target]
    return json.loads(subprocess.run(command, cwd=ROOT, check=True, capture_output=True).stdout)


def linked(data: dict, package: str) -> tuple[dict[str, dict], dict[str, set[str]]]:
    """Packages by identity, and the edges between them, from `package` by normal dependencies."""
    packages = {p["id"]: p for p in data["packages"]}
    nodes = {n["id"]: n for n in data["resolve"]["nodes"]}
    (root,) = [i for i, p in packages.items() if p["name"] == package]
    found: dict[str, dict] = {}
    edges: dict[str, set[str]] = {}
    left = [root]
    while left:
        identity = left.pop()
        if identity in found:
            continue
        found[identity] = packages[identity]
        edges[identity] = set()
        for dependency in nodes[identity]["deps"]:
            kinds = {kind["kind"] for kind in dependency["dep_kinds"]}
            is_macro = any("proc-macro" in t["kind"] for t in packages[dependency["pkg"]]["targets"])
            if None in kinds and not is_macro:
                edges[identity].add(dependency["pkg"])
                left.append(dependency["pkg"])
    return found, edges


def texts(package: dict) -> list[tuple[str, str]]:
    """Files with licence texts in the package's folder."""
    folder = Path(package["manifest_path"]).parent
    files = [file for file in sorted(folder.iterdir()) if file.name.lower().startswith(TEXTS) and file.is_file()]
    return [(file.name, file.read_text(encoding="utf-8", errors="replace").strip()) for file in files]


def pages() -> list[dict]:
    """The npm packages that reach a page: dependencies of `web`, not its tools."""
    lock = json.loads((ROOT / "web/package-lock.json").read_text())
    found = []
    for path, entry in sorted(lock["packages"].items()):
        if not path or entry.get("dev") or entry.get("link"):
            continue
        folder = ROOT / "web" / path
        license_files = sorted(folder.glob("LICEN[CS]E*")) if folder.is_dir() else []
        found.append(
            {
                "name": path.removeprefix("node_modules/"),
                "version": entry["version"],
                "license": entry.get("license", "unknown"),
                "texts": [(file.name, file.read_text().strip()) for file in license_files],
            }
        )
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--package", required=True, help="the package that is linked")
    parser.add_argument("--pages", action="store_true", help="with the npm packages of the pages")
    parser.add_argument("--out", required=True, type=Path, help="folder for the two files")
    parser.add_argument("targets", nargs="+", metavar="TARGET", help="target triple")
    arguments = parser.parse_args()

    found: dict[str, dict] = {}
    edges: dict[str, set[str]] = {}
    for target in arguments.targets:
        packages, more = linked(metadata(target), arguments.package)
        found |= packages
        for identity, to in more.items():
            edges.setdefault(identity, set()).update(to)
    lock = tomllib.loads((ROOT / "Cargo.lock").read_text())
    checksums = {(p["name"], p["version"]): p.get("checksum") for p in lock["package"]}
    (root,) = [p for p in found.values() if p["name"] == arguments.package]
    others = sorted((p for p in found.values() if p is not root), key=lambda p: (p["name"], p["version"]))
    web = pages() if arguments.pages else []

    without = [p["name"] for p in others if not p["license"] and not p["license_file"]]
    if without:
        sys.exit(f"packages without a licence: {', '.join(without)}")

    lines = [
        f"Licences of what {root['name']} {root['version']} is linked with.",
        "",
        "fenderline itself is under MIT or Apache-2.0, at your choice: LICENSE-MIT, LICENSE-APACHE.",
        "Where a package offers Apache-2.0 and has no text of its own, that of LICENSE-APACHE applies.",
        "",
    ]
    shown: dict[str, str] = {}

    def add(name: str, version: str, license_name: str, files: list[tuple[str, str]]) -> None:
        lines.extend(["=" * 100, f"{name} {version}: {license_name}", ""])
        if not files:
            lines.extend([f"(its package has no text of the licence {license_name})", ""])
        for file, text in files:
            if text in shown:
                lines.extend([f"{file}: as that of {shown[text]}", ""])
            else:
                shown[text] = f"{name}, {file}"
                lines.extend([f"-- {file}", "", text, ""])

    for package in others:
        if package["source"]:
            add(package["name"], package["version"], package["license"] or "see its text", texts(package))
    for package in web:
        add(f"{package['name']} (npm, in the pages)", package["version"], package["license"], package["texts"])

    def reference(package: dict) -> str:
        return f"pkg:cargo/{package['name']}@{package['version']}"

    def component(package: dict, kind: str) -> dict:
        entry = {
            "type": kind,
            "bom-ref": reference(package),
            "name": package["name"],
            "version": package["version"],
            "purl": reference(package),
        }
        if package["description"]:
            entry["description"] = " ".join(package["description"].split())
        if package["license"]:
            # The old form "MIT/Apache-2.0" is not an SPDX expression.
            entry["licenses"] = [{"expression": package["license"].replace("/", " OR ")}]
        checksum = checksums.get((package["name"], package["version"]))
        if checksum:
            entry["hashes"] = [{"alg": "SHA-256", "content": checksum}]
        return entry

    npm = [
        {
            "type": "library",
            "bom-ref": f"pkg:npm/{package['name']}@{package['version']}",
            "name": package["name"],
            "version": package["version"],
            "purl": f"pkg:npm/{package['name']}@{package['version']}",
            "licenses": [{"expression": package["license"]}],
        }
        for package in web
    ]
    by_identity = sorted(edges, key=lambda identity: reference(found[identity]))
    graph = []
    for identity in by_identity:
        to = [reference(found[other]) for other in edges[identity]]
        to += [entry["bom-ref"] for entry in npm] if found[identity]["name"] == "fenderline-serve" else []
        graph.append({"ref": reference(found[identity]), "dependsOn": sorted(to)})
    graph += [{"ref": entry["bom-ref"], "dependsOn": []} for entry in npm]
    is_program = any("bin" in t["kind"] for t in root["targets"])
    bom = {
        "$schema": "http://cyclonedx.org/schema/bom-1.5.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": component(root, "application" if is_program else "library")},
        "components": [component(package, "library") for package in others] + npm,
        "dependencies": graph,
    }
    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / "THIRD-PARTY-LICENSES.txt").write_text("\n".join(lines))
    name = f"{root['name']}-{root['version']}.cdx.json"
    (arguments.out / name).write_text(json.dumps(bom, indent=2) + "\n")
    silent = [p["name"] for p in others if p["source"] and not texts(p)]
    print(f"{root['name']}: {len(others)} crates and {len(web)} npm packages, {len(shown)} licence texts")
    if silent:
        print(f"without a text of their own: {', '.join(silent)}")


if __name__ == "__main__":
    main()
