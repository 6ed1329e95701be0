"""The reference of the live server's protocol, from the types of the pages, which are written from the server's messages."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
TYPE = re.compile(
    r"^(?:/\*\*(?P<doc>(?:(?!\*/).)*?)\*/\n)?(?P<code>export (?:type|interface|const) (?P<name>\w+).*?\n)(?=\n|/\*\*|export |\Z)",
    re.MULTILINE | re.DOTALL,
)
FROM_SERVER = ["Hello", "Frame", "FrameOfAll", "Past", "Reply"]
TO_SERVER = ["Command", "Orders", "RecordedAction", "Conduct", "TrialOrder"]


def page() -> str:
    types = {}
    for file in ["protocol.ts", "orders.ts"]:
        text = (ROOT / "web" / "src" / file).read_text(encoding="utf-8")
        for match in TYPE.finditer(text):
            if file == "protocol.ts" or match["name"] in TO_SERVER:
                types[match["name"]] = (match["doc"] or "", match["code"])
    missing = [name for name in [*FROM_SERVER, *TO_SERVER, "PROTOCOL"] if name not in types]
    if missing:
        raise SystemExit(f"web/src/protocol.ts and orders.ts have no types {missing}")
    parts = [
        "# Messages of the protocol\n",
        "This page is made from `web/src/protocol.ts` and `web/src/orders.ts`. A test compares the first with the messages of the "
        "server, and another the second with the table of orders. The types are written in TypeScript: `?` marks a field that may be "
        "missing, `null` a value that is not there. Units are SI. [The protocol](../../guides/protocol.md) says how to connect, and "
        "what the server does with a message that is wrong.\n",
        block(types["PROTOCOL"][1]),
        "## From the server\n",
        *(section(name, types) for name in FROM_SERVER),
        "## To the server\n",
        *(section(name, types) for name in TO_SERVER),
        "## Parts of messages\n",
        *(section(name, types) for name in types if name not in [*FROM_SERVER, *TO_SERVER, "PROTOCOL"]),
    ]
    return "\n".join(parts)


def section(name: str, types: dict[str, tuple[str, str]]) -> str:
    doc, code = types[name]
    text = " ".join(line.strip().removeprefix("*").strip() for line in doc.splitlines()).strip()
    return "\n".join([f"### `{name}`\n", *([f"{text}\n"] if text else []), block(code)])


def block(code: str) -> str:
    lines = (line for line in code.rstrip().splitlines() if line.strip() != "// prettier-ignore")
    return "\n".join(["```typescript", *lines, "```\n"])
