"""The reference of keys: every table of a scenario, campaign, mapping, fender or vessel file, from the JSON Schemas that the program prints.

The program makes these schemas from the tables with which it reads the files, so that this reference cannot differ from
what is read.
"""

import json
import subprocess

from markdown import table

FILES = {
    "scenario": ("Scenario files", [], "A scenario file is TOML. It describes one run: bodies, materials, fenders, vessels, loads and orders."),
    "fenders": ("Fender files", ["fenders"], "A fender file is TOML. It adds families of fenders to those of the library."),
    "campaign": ("Campaign files", ["campaign"], "A campaign file is TOML. It names a scenario and what differs from run to run."),
    "mapping": ("Mappings of measured berthings", ["mapping"], "A mapping is a TOML file. It says what the logs of `fenderline berthings` hold."),
    "vessels": ("Vessel files", ["vessels"], "A vessel file is TOML. It adds vessels to those of the library."),
}


def pages(program: str) -> dict[str, str]:
    return {f"reference/{name}_keys.md": page(program, *FILES[name]) for name in FILES}


def page(program: str, title: str, options: list[str], about: str) -> str:
    command = ["schema", *options]
    printed = subprocess.run([program, *command], check=True, capture_output=True, text=True).stdout
    schema = json.loads(printed)
    parts = [
        f"# {title}\n",
        f"{about} {schema['description']}\n",
        f"This page is made from what `fenderline {' '.join(command)}` prints.\n",
        "A plain number is in the unit of the column *unit*; a string carries its own unit, such as `\"4 kn\"`. "
        "Limits are in the unit of the column. A key that has no default and is not marked as required states in its "
        "meaning what holds without it, or when it is required.\n",
    ]
    tables(schema, "", parts, {})
    return "\n".join(parts)


def tables(schema: dict, path: str, parts: list[str], seen: dict[str, str]) -> None:
    """The table at `path`, and then those within it. A table that stands in two places is printed once."""
    fingerprint = json.dumps(schema, sort_keys=True)
    heading = f"`[{path}]`" if path else "The file itself"
    parts.append(f"## {heading}\n")
    if fingerprint in seen:
        parts.append(f"The same keys as `[{seen[fingerprint]}]`.\n")
        return
    seen[fingerprint] = path
    if path and schema.get("description"):
        parts.append(schema["description"] + "\n")
    required = set(schema.get("required", []))
    parts.append(table(
        ["key", "value", "unit", "limits", "default", "meaning"],
        [row(name, key, name in required) for name, key in schema["properties"].items()],
    ))
    for name, key in schema["properties"].items():
        inner = f"{path}.{name}" if path else name
        kind, within = contained(key)
        if within is not None:
            tables(within, {"table": inner, "named": f"{inner}.NAME", "list": f"[{inner}]"}[kind].replace("]]", "]"), parts, seen)


def contained(key: dict):
    """The table that a key holds, if any: the key is a table, a table of named tables, or a list of tables."""
    if key.get("type") == "object":
        if "properties" in key:
            return "table", key
        inner = key.get("additionalProperties")
        if isinstance(inner, dict) and "properties" in inner:
            return "named", inner
    if key.get("type") == "array" and isinstance(key.get("items"), dict) and "properties" in key["items"]:
        return "list", key["items"]
    return "", None


def row(name: str, key: dict, required: bool) -> list[str]:
    meaning, unit = split_unit(key.get("description", ""))
    choices = key.get("oneOf")
    if choices and all("const" in choice for choice in choices):
        meaning += " " + "; ".join(f"`{c['const']}`: {c.get('description', '')}" for c in choices) + "."
    default = "required" if required else code(key["default"]) if "default" in key else ""
    return [f"`{name}`", value_of(key), unit, limits(key), default, meaning]


def split_unit(description: str) -> tuple[str, str]:
    """A description ends in its unit in brackets, perhaps followed by what holds without the key, or when it is required."""
    before, bracket, rest = description.rpartition(" [")
    unit, closing, after = rest.partition("]")
    if not bracket or not closing or (after and not after.startswith((" Without it:", " Required unless"))):
        return description, ""
    return before + after, f"{unit}"


def value_of(key: dict) -> str:
    if "enum" in key:
        return "one of the words"
    if "anyOf" in key:
        return "number"
    kind = key.get("type")
    if kind == "string":
        return "text"
    if kind == "boolean":
        return "`true` or `false`"
    if kind == "object":
        return "table" if "properties" in key else "tables by name"
    if kind == "array":
        items = key.get("items", {})
        if "properties" in items:
            return "list of tables"
        if items.get("type") == "string":
            return "two names" if key.get("maxItems") == 2 else "list of texts"
        if items.get("type") == "array":
            return "list of rows" if "prefixItems" in items else "list of points"
        return "two numbers" if key.get("maxItems") == 2 else "list of numbers"
    return str(kind)


def number(key: dict) -> dict | None:
    """The schema of the number that a key holds, by itself or twice."""
    for choice in key.get("anyOf", []):
        if choice.get("type") == "number":
            return choice
    items = key.get("items")
    return number(items) if isinstance(items, dict) else None


def limits(key: dict) -> str:
    found = number(key)
    if not found or "minimum" not in found:
        return ""
    return f"{short(found['minimum'])} to {short(found['maximum'])}"


def short(value) -> str:
    return f"{value:g}" if isinstance(value, (int, float)) else str(value)


def code(value) -> str:
    return f"`{json.dumps(value)}`" if value not in ({}, []) else "empty"
