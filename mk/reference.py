"""The reference of the C interface, from the header: reference.py HEADER FOLDER VERSION

FOLDER/html has a page for each part of the header and an index, FOLDER/man3 a manual page for
each function, type and group of constants. The header is made by cbindgen and regular: blocks
with a blank line between them, a comment before what it describes, tables by their columns.
"""
import re
import sys
from dataclasses import dataclass, field
from html import escape
from pathlib import Path

STYLE = """
:root { color-scheme: light dark }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 52rem; margin: 2rem auto; padding: 0 1rem }
pre, code { font: 14px/1.45 ui-monospace, monospace }
pre { padding: .6rem .8rem; overflow-x: auto; background: #8881; border-radius: 4px }
pre.text { padding: 0; background: none }
section { border-top: 1px solid #8886; margin-top: 1.5rem }
h2 { font-size: 1.1rem }
td { padding: .1rem 1rem .1rem 0; vertical-align: top }
"""


@dataclass
class Item:
    """What one comment describes."""
    part: str
    comment: list[str]
    code: str = ""
    names: list[str] = field(default_factory=list)

    def add(self, code):
        self.code += ("\n\n" if self.code else "") + code
        self.names += re.findall(r"^#define (\w+)", code, re.M)
        if code.startswith("typedef"):
            self.names += re.findall(r"\(\*(\w+)\)\(|(\w+);$", code)[0]
        elif not code.startswith(("#", "struct")):
            self.names.append(re.search(r"\w+(?=\()", code)[0])
        self.names = [name for name in self.names if name]

    def summary(self):
        """The first sentence; where there is but a table, the title of the part."""
        table, lines = self.paragraphs()[0]
        return self.part if table else re.split(r"[.:;](?: |$)", " ".join(lines))[0]

    @staticmethod
    def lists_statuses(lines):
        return bool(lines) and lines[0].startswith("V_ERR_")

    def paragraphs(self):
        """The comment as (is a table, lines): of tables the lines stay as they are."""
        found = [(False, [])]
        for line in self.comment:
            table = line.startswith(" ") or "  " in line
            if not line:
                found.append((False, []))
                continue
            statuses = line.startswith(("V_ERR_", "Any thread", "From the thread"))
            if table != found[-1][0] or statuses and not self.lists_statuses(found[-1][1]):
                found.append((table, []))
            found[-1][1].append(line)
        return [(table, lines) for table, lines in found if lines]


def uncommented(comment):
    text = comment.removeprefix("/*").removeprefix("*").removesuffix("*/")
    return re.sub(r"^ \* ?", "", text, flags=re.M).strip(" \n").split("\n")


def parsed(header):
    """What holds for all, as lines; the parts as (title, items)."""
    preface, parts = None, []
    for block in re.split(r"\n\n+", header):
        comment, code = re.match(r"(/\*.*?\*/)?\n?(.*)", block, re.S).groups()
        if heading := re.match(r"/\* -+ (.*?) -+ \*/", block):
            parts.append((heading[1], []))
        elif preface is None:
            # What holds for all functions is a list there.
            preface = [re.sub("^(- |  )", "", line) for line in
                       re.sub("^- ", "\n- ", "\n".join(uncommented(comment)), flags=re.M).split("\n")]
        elif comment and code:
            parts[-1][1].append(Item(parts[-1][0], uncommented(comment)))
            parts[-1][1][-1].add(code)
        elif code.startswith("typedef"):
            parts[-1][1][-1].add(code)
        elif not code.startswith("#"):
            sys.exit(f"reference.py: what is this?\n{block}")
    return preface, parts


# ---- Manual pages -----------------------------------------------------------------

def roff(text):
    text = text.replace("\\", "\\e")
    return "\\&" + text if text.startswith((".", "'")) else text


def roff_lines(lines):
    return [".nf", *(roff(line).replace("-", "\\-") for line in lines), ".fi"]


def manual(item, known, version):
    out = [f'.TH {item.names[0]} 3 "" "VIDES {version}" "Library Functions"', ".nh",
           ".SH NAME",
           f"{', '.join(item.names)} \\- {roff(item.summary())}", ".SH SYNOPSIS", ".nf",
           ".B #include <libvides.h>", ".sp", *roff_lines(item.code.split("\n"))[1:],
           ".SH DESCRIPTION"]
    for at, (table, lines) in enumerate(item.paragraphs()):
        out += ([".PP"] if at else []) + (roff_lines(lines) if table else [roff(line) for line in lines])
    mentioned = re.findall(r"\w+", "\n".join(item.comment) + item.code)
    others = {known[name] for name in mentioned if name in known} - {item.names[0]}
    pages = [f".BR {name} (3)" for name in ["libvides", *sorted(others)]]
    return "\n".join([*out, ".SH SEE ALSO", " ,\n".join(pages), ""])


# ---- HTML -------------------------------------------------------------------------

def page(title, body):
    return (f'<!DOCTYPE html>\n<html xmlns="http://www.w3.org/1999/xhtml" lang="en"><head>'
            f'<meta charset="utf-8"/><meta name="viewport" content="width=device-width"/>'
            f"<title>{escape(title)}</title><style>{STYLE}</style></head>\n"
            f"<body>{body}</body></html>\n")


def linked(text, places):
    def link(match):
        place = places.get(match[0])
        return f'<a href="{place}">{match[0]}</a>' if place else match[0]
    return re.sub(r"\b[vV]_\w+", link, escape(text, quote=False))


def prose(item, places):
    for table, lines in item.paragraphs():
        text = linked("\n".join(lines), places)
        yield f'<pre class="text">{text}</pre>' if table else f"<p>{text}</p>"


def part_page(title, items, places):
    body = [f'<p><a href="index.html">libvides</a></p><h1>{escape(title)}</h1>']
    for item in items:
        others = "".join(f'<a id="{name}"></a>' for name in item.names[1:])
        body.append(f'<section id="{item.names[0]}"><h2>{", ".join(item.names)}{others}</h2>'
                    f"<pre>{linked(item.code, places)}</pre>{''.join(prose(item, places))}</section>")
    return page(f"{title} – libvides", "\n".join(body))


def index(preface, parts, places, version):
    body = [f"<h1>libvides {version}</h1>", *prose(Item("", preface), places)]
    for title, items in parts:
        body.append(f'<h2><a href="{slug(title)}">{escape(title)}</a></h2><table>')
        body += [f'<tr><td><a href="{places[item.names[0]]}"><code>{item.names[0]}</code></a></td>'
                 f"<td>{escape(item.summary())}</td></tr>" for item in items]
        body.append("</table>")
    return page("libvides", "\n".join(body))


def slug(title):
    return re.sub(r"\W+", "-", title.lower()).strip("-") + ".html"


def main(header, folder, version):
    preface, parts = parsed(Path(header).read_text())
    items = [item for _, items in parts for item in items]
    known = {name: item.names[0] for item in items for name in item.names}
    places = {name: f"{slug(title)}#{name}"
              for title, items in parts for item in items for name in item.names}
    html, man = Path(folder, "html"), Path(folder, "man3")
    for kind in html, man:
        kind.mkdir(parents=True, exist_ok=True)
        for old in kind.iterdir():
            old.unlink()
    (html / "index.html").write_text(index(preface, parts, places, version))
    for title, of_part in parts:
        (html / slug(title)).write_text(part_page(title, of_part, places))
    for item in items:
        for name in item.names:
            text = manual(item, known, version)
            (man / f"{name}.3").write_text(text if name == item.names[0]
                                           else f".so man3/{item.names[0]}.3\n")
    print(f"{folder}: {len(parts) + 1} pages in html, {len(known)} in man3")


if __name__ == "__main__":
    main(*sys.argv[1:])
