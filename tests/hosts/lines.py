"""What docs/guides/hosts.md shows stands in the programs that it names, line by line."""

import os
import re
import sys

GUIDES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../docs/guides")


def main():
    """See the top."""
    with open(os.path.join(GUIDES, "hosts.md"), encoding="utf-8") as page:
        parts = page.read().split("\n## ")[1:]
    missing, lines = [], 0
    for part in parts:
        programs = []
        for name in re.findall(r"\]\((\.\./[\w./]+\.\w+)\)", part):
            with open(os.path.join(GUIDES, name), encoding="utf-8") as program:
                programs.append(re.sub(r"[ \t]+", " ", program.read()))
        for block in re.findall(r"^```\w+\n(.*?)^```", part, re.M | re.S):
            wanted = re.sub(r"[ \t]+", " ", block)
            lines += wanted.count("\n")
            if not any(wanted.strip() in program for program in programs):
                missing.append(f"{part.splitlines()[0]}: not in its program:\n{block}")
    print(*missing, f"hosts: {lines} lines of docs/guides/hosts.md compared", sep="\n")
    return 1 if missing or lines < 30 else 0


if __name__ == "__main__":
    sys.exit(main())
