"""The reference of commands: what each prints with --help."""

import re
import subprocess


def page(program: str) -> str:
    parts = ["# Commands\n", "This page is made from what `fenderline COMMAND --help` prints.\n"]
    top = help_of(program, [])
    parts += ["## `fenderline`\n", block(top)]
    for name in subcommands(top):
        text = help_of(program, [name])
        parts += [f"## `fenderline {name}`\n", block(text)]
        for inner in subcommands(text):
            parts += [f"### `fenderline {name} {inner}`\n", block(help_of(program, [name, inner]))]
    return "\n".join(parts)


def help_of(program: str, names: list[str]) -> str:
    return subprocess.run([program, *names, "--help"], check=True, capture_output=True, text=True).stdout


def subcommands(text: str) -> list[str]:
    if "Commands:" not in text:
        return []
    listed = text.split("Commands:", 1)[1].split("\n\n", 1)[0]
    return [name for name in re.findall(r"^  (\S+)", listed, re.MULTILINE) if name != "help"]


def block(text: str) -> str:
    return f"```text\n{text.rstrip()}\n```\n"
